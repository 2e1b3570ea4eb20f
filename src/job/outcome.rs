// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a job found: scales, positions and the record of how they came about.

use std::sync::Arc;

use glam::Vec3;

use super::JobSpec;
use super::proxy::Proxy;
use crate::boxdef::{BoxDefError, BoxDefGraph, DeformField};
use crate::render::{self, Backend, RenderError};
use crate::report::Report;
use crate::search::Gauge;
use crate::spectrum::SliderLimits;

/// A graph with its field on the mesh, on what is scored of it, and on the extra points where there are any.
#[derive(Debug)]
pub struct Stage {
    pub splits: Option<u32>,
    pub graph: Arc<BoxDefGraph>,
    pub whole: Arc<DeformField>,
    pub scored: Arc<DeformField>,
    /// Triangles of what is scored.
    pub triangles: Arc<[[u32; 3]]>,
    pub points_field: Option<DeformField>,
}

impl Stage {
    /// Computes the fields that the job asks for.
    pub fn new(
        splits: Option<u32>,
        graph: Arc<BoxDefGraph>,
        proxy: &Proxy<'_>,
        spec: &JobSpec,
    ) -> Result<Self, BoxDefError> {
        let whole = if spec.shift_parts { Arc::new(graph.field_with_shifts()) } else { graph.shared_field() };
        let scored = proxy.field(whole.clone());
        let triangles = proxy.mesh().triangles().into();
        let points_field = spec.points.as_ref().map(|points| graph.field_at(&whole, points)).transpose()?;
        Ok(Self { splits, graph, whole, scored, triangles, points_field })
    }
}

/// A candidate worth showing.
#[derive(Debug, Clone)]
pub struct Best {
    pub score: f64,
    pub factors: Vec<Vec3>,
    pub stage: Arc<Stage>,
}

impl Best {
    /// Positions with the gauge applied: of the extra points where there are any, else of the mesh.
    pub fn positions(&self, spec: &JobSpec) -> Vec<Vec3> {
        let (gauge, vertices) = self.gauged(spec);
        self.points(gauge).unwrap_or(vertices)
    }

    /// A picture from the front right: RGBA8 with straight alpha, size × size × 4.
    pub fn view(&self, size: u32) -> Result<Vec<u8>, RenderError> {
        let positions = self.stage.scored.deform(&self.factors);
        let views = render::views_by_name("paper")?;
        render::render_positions(Backend::Cpu, &positions, &self.stage.triangles, &views[..1], size)
    }

    /// Scale factors, a row a parameter row.
    pub fn scales(&self) -> &[Vec3] {
        &self.factors[..self.stage.whole.scale_rows()]
    }

    /// Shifts in object units, a row a parameter row; none where parts may not be shifted.
    pub fn shifts(&self) -> Option<Vec<Vec3>> {
        let shifts = &self.factors[self.stage.whole.scale_rows()..];
        let reach = self.stage.graph.reach();
        (!shifts.is_empty()).then(|| shifts.iter().map(|&factor| (factor - 1.0) * reach).collect())
    }

    /// The gauge and the mesh's positions under it.
    pub fn gauged(&self, spec: &JobSpec) -> (Gauge, Vec<Vec3>) {
        let mut vertices = self.stage.whole.deform(&self.factors);
        let gauge = Gauge::new(spec.mesh.vertices(), &vertices, spec.kept_size(), spec.keep_place);
        gauge.apply(&mut vertices);
        (gauge, vertices)
    }

    /// The extra points' positions under a gauge.
    pub fn points(&self, gauge: Gauge) -> Option<Vec<Vec3>> {
        let mut points = self.stage.points_field.as_ref()?.deform(&self.factors);
        gauge.apply(&mut points);
        Some(points)
    }
}

/// A finished job's result.
#[derive(Debug)]
pub struct Outcome {
    /// Positions of the mesh, gauge applied.
    pub vertices: Vec<Vec3>,
    /// Positions of the extra points, gauge applied, where points were given.
    pub points: Option<Vec<Vec3>>,
    /// Scale factors, one row per parameter row of the graph. `graph.deform(scales)`, or `deform_shifted` where parts
    /// were shifted, is `vertices` but for the gauge.
    pub scales: Vec<Vec3>,
    /// Shifts in object units, one row per parameter row, where parts may be shifted.
    pub shifts: Option<Vec<Vec3>>,
    /// The part graph of the winning split count.
    pub graph: Arc<BoxDefGraph>,
    /// The range of the slider.
    pub slider: SliderLimits,
    /// Further outcomes, best first, where variations were asked for: as many as that, or as there are.
    pub variations: Vec<Arc<Outcome>>,
    /// The record.
    pub report: Report,
}
