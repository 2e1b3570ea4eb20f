// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a job found: scales, positions and the record of how they came about.

use std::sync::Arc;

use glam::Vec3;

use super::JobSpec;
use super::proxy::Proxy;
use crate::boxdef::{BoxDefError, BoxDefGraph, DeformField};
use crate::report::Report;
use crate::search::Gauge;
use crate::spectrum::SliderLimits;

/// A graph with its field on the mesh, on what is scored of it, and on the extra points where there are any.
#[derive(Debug)]
pub struct Stage {
    pub splits: Option<u32>,
    pub graph: Arc<BoxDefGraph>,
    pub scored: Arc<DeformField>,
    pub points_field: Option<DeformField>,
}

impl Stage {
    /// Computes the fields.
    pub fn new(
        splits: Option<u32>,
        graph: Arc<BoxDefGraph>,
        proxy: &Proxy<'_>,
        points: Option<&[Vec3]>,
    ) -> Result<Self, BoxDefError> {
        let scored = proxy.field(graph.shared_field());
        let points_field = points.map(|points| graph.field_at(points)).transpose()?;
        Ok(Self { splits, graph, scored, points_field })
    }

    /// Scale factors that change nothing.
    pub fn unchanged(&self) -> Vec<Vec3> {
        vec![Vec3::ONE; self.graph.parameter_rows()]
    }
}

/// A candidate worth showing.
#[derive(Debug, Clone)]
pub struct Best {
    pub score: f64,
    pub scales: Vec<Vec3>,
    pub stage: Arc<Stage>,
}

impl Best {
    /// Positions with the gauge applied: of the extra points where there are any, else of the mesh.
    pub fn positions(&self, spec: &JobSpec) -> Vec<Vec3> {
        let (gauge, vertices) = self.gauged(spec);
        self.points(gauge).unwrap_or(vertices)
    }

    /// The gauge and the mesh's positions under it.
    pub fn gauged(&self, spec: &JobSpec) -> (Gauge, Vec<Vec3>) {
        let mut vertices = self.stage.graph.field().deform(&self.scales);
        let gauge = Gauge::new(spec.mesh.vertices(), &vertices, spec.kept_size(), spec.keep_place);
        gauge.apply(&mut vertices);
        (gauge, vertices)
    }

    /// The extra points' positions under a gauge.
    pub fn points(&self, gauge: Gauge) -> Option<Vec<Vec3>> {
        let mut points = self.stage.points_field.as_ref()?.deform(&self.scales);
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
    /// Scale factors, one row per parameter row of the graph. `graph.deform(scales)` is `vertices` but for the gauge.
    pub scales: Vec<Vec3>,
    /// The part graph of the winning split count.
    pub graph: Arc<BoxDefGraph>,
    /// The range of the slider.
    pub slider: SliderLimits,
    /// The record.
    pub report: Report,
}
