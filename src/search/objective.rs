// SPDX-License-Identifier: MIT OR Apache-2.0
//! The objective: how little a candidate looks like the prompt, and how much its surface is bent (paper §4).

use std::sync::Arc;

use glam::Vec3;
use rayon::prelude::*;
use thiserror::Error;

use super::preset::{ImagePlan, NORMAL_WEIGHT, Preset};
use super::{Comparison, Novelty, Target};
use crate::boxdef::DeformField;
use crate::guide::{Guide, GuideError};
use crate::mesh::Mesh;
use crate::render::{self, BACKGROUNDS, Backend, RenderError, Renderer, View};

/// Why candidates cannot be evaluated.
#[derive(Debug, Error)]
pub enum ObjectiveError {
    /// The guide failed.
    #[error(transparent)]
    Guide(#[from] GuideError),
    /// The renderer failed.
    #[error(transparent)]
    Render(#[from] RenderError),
}

/// What one candidate is worth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// Mean cosine between its images and the prompt; higher is better.
    pub score: f64,
    /// Mean of 1 − cos between vertex normals before and after (paper §3.1).
    pub normal_error: f64,
    /// What the prompt's strongest rival takes from the score ([`Target`]), weighted by the preset.
    pub rivalry: f64,
    /// By how much it falls short of what a comparative in the prompt asks for, weighted by the preset.
    pub shortfall: f64,
    /// What it costs to be near to other outcomes, where it is to be far from them ([`Novelty`]).
    pub nearness: f64,
    /// `−score + rivalry + shortfall + nearness + 0.25 · normal error + weight · effort`; lower is better.
    pub loss: f64,
}

impl Evaluation {
    /// The score less rivalry and shortfall: what outcomes are chosen by.
    #[must_use]
    pub fn worth(&self) -> f64 {
        self.score - self.rivalry - self.shortfall
    }
}

/// Scores candidates of one field against one prompt.
pub struct Objective<'a> {
    mesh: &'a Mesh,
    field: Arc<DeformField>,
    guide: &'a Guide,
    target: &'a Target,
    comparison: Option<Comparison>,
    novelty: Option<Novelty<'a>>,
    renderer: Box<dyn Renderer>,
    preset: &'a Preset,
    rest_normals: Vec<Vec3>,
    rgba: Vec<u8>,
    rgb: Vec<u8>,
    images_encoded: usize,
}

impl<'a> Objective<'a> {
    /// Opens a renderer for the field. The preset says what counts in the loss and how much.
    pub fn new(
        mesh: &'a Mesh,
        field: Arc<DeformField>,
        guide: &'a Guide,
        target: &'a Target,
        backend: Backend,
        views: &[View],
        preset: &'a Preset,
    ) -> Result<Self, ObjectiveError> {
        let triangles = mesh.triangles().into();
        let renderer = render::open(backend, field.clone(), triangles, views, guide.image_size())?;
        let rest_normals = mesh.vertex_normals(mesh.vertices());
        Ok(Self {
            mesh,
            field,
            guide,
            target,
            comparison: Comparison::of(target.prompt(), mesh.vertices()),
            novelty: None,
            renderer,
            preset,
            rest_normals,
            rgba: Vec::new(),
            rgb: Vec::new(),
            images_encoded: 0,
        })
    }

    /// Has candidates keep away from other outcomes.
    #[must_use]
    pub fn away_from(self, novelty: Option<Novelty<'a>>) -> Self {
        Self { novelty, ..self }
    }

    /// Images encoded so far.
    #[must_use]
    pub fn images_encoded(&self) -> usize {
        self.images_encoded
    }

    /// The renderer's name.
    #[must_use]
    pub fn backend_name(&self) -> String {
        self.renderer.backend_name()
    }

    /// Evaluates a generation: the factors of each candidate.
    pub fn evaluate(
        &mut self,
        candidates: &[Vec<Vec3>],
        plan: ImagePlan,
    ) -> Result<Vec<Evaluation>, ObjectiveError> {
        let mut pairs = plan.pairs(self.renderer.views());
        let views = wanted_views(&mut pairs);
        self.renderer.render(candidates, &views, &mut self.rgba)?;
        self.composite(&pairs, views.len());
        let embeddings = self.guide.image_embeddings(&self.rgb)?;
        self.images_encoded += candidates.len() * pairs.len();
        let (mesh, field, rest) = (self.mesh, &*self.field, self.rest_normals.as_slice());
        let (comparison, novelty) = (self.comparison, self.novelty.as_ref());
        let measured: Vec<(f64, f64, f64)> = candidates
            .par_iter()
            .map(|factors| {
                let positions = field.deform(factors);
                let shortfall = comparison.map_or(0.0, |comparison| comparison.shortfall(&positions));
                let distance = novelty.map_or(0.0, |n| n.distance(&n.sketch.draw(&positions)));
                (normal_error(mesh, rest, &positions), shortfall, distance)
            })
            .collect();
        let per_candidate = pairs.len() * self.target.dimension();
        let appraisals = embeddings.chunks_exact(per_candidate).map(|images| self.target.appraise(images));
        let Preset { rival_weight, comparison_weight, effort_weight, .. } = self.preset;
        Ok(appraisals
            .zip(measured)
            .zip(candidates)
            .map(|(((score, rivalry), (normal_error, shortfall, distance)), factors)| {
                let (rivalry, shortfall) = (rival_weight * rivalry, comparison_weight * shortfall);
                let bent = NORMAL_WEIGHT * normal_error;
                let nearness = novelty.map_or(0.0, |n| n.cost(distance, score - rivalry - shortfall));
                let uneven = effort_weight * effort(factors, field.scale_rows());
                let loss = rivalry + shortfall - score + bent + uneven + nearness;
                Evaluation { score, normal_error, rivalry, shortfall, nearness, loss }
            })
            .collect())
    }

    /// Puts the `views` of every candidate before the backgrounds of `pairs`.
    fn composite(&mut self, pairs: &[(usize, usize)], views: usize) {
        let pixels = (self.renderer.size() as usize).pow(2);
        let candidate_bytes = views * pixels * 4;
        let candidates = self.rgba.len() / candidate_bytes;
        self.rgb.resize(candidates * pairs.len() * pixels * 3, 0);
        self.rgb
            .par_chunks_exact_mut(pairs.len() * pixels * 3)
            .zip(self.rgba.par_chunks_exact(candidate_bytes))
            .for_each(|(images, views)| {
                for (image, &(view, background)) in images.chunks_exact_mut(pixels * 3).zip(pairs) {
                    let rgba = &views[view * pixels * 4..(view + 1) * pixels * 4];
                    render::composite(rgba, BACKGROUNDS[background], image);
                }
            });
    }
}

/// The views that `pairs` name, ascending; each pair is made to name its view by its place among them.
fn wanted_views(pairs: &mut [(usize, usize)]) -> Vec<usize> {
    let mut views: Vec<usize> = pairs.iter().map(|pair| pair.0).collect();
    views.sort_unstable();
    views.dedup();
    for (view, _) in pairs {
        *view = views.partition_point(|wanted| wanted < view);
    }
    views
}

/// Mean of 1 − cos between vertex normals before and after (paper §3.1).
fn normal_error(mesh: &Mesh, rest_normals: &[Vec3], positions: &[Vec3]) -> f64 {
    let normals = mesh.vertex_normals(positions);
    // A vertex without a normal (its faces collapsed) counts as turned by a right angle.
    let cosine = |(a, b): (&Vec3, &Vec3)| if a.is_finite() { f64::from(a.dot(*b)) } else { 0.0 };
    let total: f64 =
        normals.iter().zip(rest_normals).filter(|(_, b)| b.is_finite()).map(|n| 1.0 - cosine(n)).sum();
    total / normals.len() as f64
}

/// Variance of the logarithms of the scale factors, how unevenly the parts were scaled, and mean square of the
/// shifts. What the score does not ask for stays as it was; scaling everything alike costs nothing.
fn effort(factors: &[Vec3], scale_rows: usize) -> f64 {
    let (scales, shifts) = factors.split_at(scale_rows);
    let logs = || scales.iter().flat_map(Vec3::to_array).map(|c| f64::from(c).ln());
    let count = logs().count() as f64;
    let mean = logs().sum::<f64>() / count;
    let shifts = shifts.iter().flat_map(Vec3::to_array).map(|c| (f64::from(c) - 1.0).powi(2));
    (logs().map(|log| (log - mean).powi(2)).sum::<f64>() + shifts.sum::<f64>()) / count
}
