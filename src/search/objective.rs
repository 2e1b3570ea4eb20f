// SPDX-License-Identifier: MIT OR Apache-2.0
//! The objective: how little a candidate looks like the prompt, and how much its surface is bent (paper §4).

use std::sync::Arc;

use glam::{DVec3, Vec3};
use rayon::prelude::*;
use thiserror::Error;

use super::images::{ImagePlan, Views};
use super::preset::{NORMAL_WEIGHT, Preset};
use super::{Comparison, Novelty, Target};
use crate::boxdef::{DeformField, Symmetry};
use crate::guide::{Guide, GuideError};
use crate::mesh::Mesh;
use crate::render::{self, BACKGROUNDS, Backend, RenderError, Renderer, View};
use crate::spare::Spare;

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
#[derive(Debug, Clone, Copy, Default, PartialEq)]
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
    directions: &'a [View],
    views: Views,
    /// Generations seen by distinct images.
    generation: usize,
    preset: &'a Preset,
    rest_normals: Vec<Vec3>,
    /// The views of a generation, where all are drawn in one call.
    drawn: Vec<u8>,
    scratch: Spare<Scratch>,
    evaluations: Vec<Evaluation>,
    images_encoded: usize,
}

/// Working memory of the candidates that share a run of the guide.
#[derive(Debug, Default)]
struct Scratch {
    rgba: Vec<u8>,
    embeddings: Vec<f32>,
    positions: Vec<Vec3>,
    normals: Vec<DVec3>,
}

/// The images of a candidate: each view before `per_view` of the backgrounds, one view after the other.
struct Shots {
    views: Vec<usize>,
    backgrounds: Vec<[u8; 3]>,
    per_view: usize,
}

impl Shots {
    fn of(mut pairs: Vec<(usize, usize)>) -> Self {
        pairs.sort_unstable();
        let mut views: Vec<usize> = pairs.iter().map(|pair| pair.0).collect();
        views.dedup();
        let per_view = pairs.len() / views.len().max(1);
        if pairs.chunk_by(|a, b| a.0 == b.0).any(|view| view.len() != per_view) {
            // Drawn anew for each background; no plan of ours has this.
            views = pairs.iter().map(|pair| pair.0).collect();
        }
        let per_view = pairs.len() / views.len().max(1);
        let backgrounds = pairs.iter().map(|pair| BACKGROUNDS[pair.1]).collect();
        Self { views, backgrounds, per_view }
    }
}

impl<'a> Objective<'a> {
    /// Opens a renderer for the field. The preset says what counts in the loss and how much.
    pub fn new(
        mesh: &'a Mesh,
        field: Arc<DeformField>,
        guide: &'a Guide,
        target: &'a Target,
        backend: Backend,
        views: &'a [View],
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
            directions: views,
            views: Views::of(views, Symmetry::None),
            generation: 0,
            preset,
            rest_normals,
            drawn: Vec::new(),
            scratch: Spare::default(),
            evaluations: Vec::new(),
            images_encoded: 0,
        })
    }

    /// Has candidates that are symmetric seen from one side alone, where the plan says so.
    #[must_use]
    pub fn symmetric(self, symmetry: Symmetry) -> Self {
        Self { views: Views::of(self.directions, symmetry), ..self }
    }

    /// Has candidates keep away from other outcomes.
    #[must_use]
    pub fn away_from(self, novelty: Option<Novelty<'a>>) -> Self {
        Self { novelty, ..self }
    }

    /// Number of the images that the next generation is seen by, the same for the same images.
    #[must_use]
    pub fn images_number(&self, plan: ImagePlan) -> usize {
        self.generation % self.views.period(plan)
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
    ///
    /// The candidates of one run of the guide are a task of their own: while some are encoded others are drawn, and
    /// what is drawn is encoded while it is still in the cache. Which candidates share a run depends on the plan
    /// alone, so that no result depends on the number of threads.
    pub fn evaluate(
        &mut self,
        candidates: &[Vec<Vec3>],
        plan: ImagePlan,
    ) -> Result<&[Evaluation], ObjectiveError> {
        let shots = Shots::of(self.views.pairs(plan, self.generation));
        self.generation += usize::from(plan == ImagePlan::Distinct);
        if self.renderer.draws_generations() {
            self.renderer.render(candidates, &shots.views, &mut self.drawn)?;
            render::premultiply(&mut self.drawn);
        }
        let images = shots.backgrounds.len();
        let run = self.guide.images_a_run().div_ceil(images.max(1));
        let mut evaluations = std::mem::take(&mut self.evaluations);
        evaluations.resize(candidates.len(), Evaluation::default());
        let this = &*self;
        // Of several errors the first candidate's is told.
        let error = evaluations
            .par_chunks_mut(run)
            .zip(candidates.par_chunks(run))
            .enumerate()
            .with_max_len(1)
            .filter_map(|(number, (evaluations, candidates))| {
                this.scratch
                    .with(|scratch| this.evaluate_run(number * run, candidates, &shots, scratch, evaluations))
                    .err()
            })
            .find_first(|_| true);
        self.evaluations = evaluations;
        self.images_encoded += candidates.len() * images;
        error.map_or(Ok(&self.evaluations), Err)
    }

    /// Evaluates the candidates from number `first` on that share a run of the guide.
    fn evaluate_run(
        &self,
        first: usize,
        candidates: &[Vec<Vec3>],
        shots: &Shots,
        scratch: &mut Scratch,
        evaluations: &mut [Evaluation],
    ) -> Result<(), ObjectiveError> {
        let Scratch { rgba, embeddings, positions, normals } = scratch;
        let views = if self.renderer.draws_generations() {
            let bytes = shots.views.len() * (self.renderer.size() as usize).pow(2) * 4;
            &self.drawn[first * bytes..(first + candidates.len()) * bytes]
        } else {
            let drawn = self.renderer.render(candidates, &shots.views, rgba);
            drawn.map_err(|error| error.counted_from(first))?;
            render::premultiply(rgba);
            rgba
        };
        self.guide.view_embeddings(views, &shots.backgrounds, shots.per_view, embeddings)?;
        positions.resize(self.field.vertex_count(), Vec3::ZERO);
        let images = embeddings.chunks_exact(shots.backgrounds.len() * self.target.dimension());
        for ((factors, images), evaluation) in candidates.iter().zip(images).zip(evaluations) {
            let (score, rivalry) = self.target.appraise(images);
            self.field.deform_into(factors, positions);
            *evaluation = self.weigh(factors, positions, normals, score, rivalry);
        }
        Ok(())
    }

    /// The evaluation of a candidate with these positions, score and rivalry; `normals` is working memory.
    fn weigh(
        &self,
        factors: &[Vec3],
        positions: &[Vec3],
        normals: &mut Vec<DVec3>,
        score: f64,
        rivalry: f64,
    ) -> Evaluation {
        let Preset { rival_weight, comparison_weight, effort_weight, .. } = self.preset;
        let shortfall = self.comparison.map_or(0.0, |comparison| comparison.shortfall(positions));
        let (rivalry, shortfall) = (rival_weight * rivalry, comparison_weight * shortfall);
        let nearness = self.novelty.as_ref().map_or(0.0, |novelty| {
            let distance = novelty.distance(&novelty.sketch.draw(positions));
            novelty.cost(distance, score - rivalry - shortfall)
        });
        let normal_error = normal_error(self.mesh.normals_at(positions, normals), &self.rest_normals);
        let bent = NORMAL_WEIGHT * normal_error;
        let uneven = effort_weight * effort(factors, self.field.scale_rows());
        let loss = rivalry + shortfall - score + bent + uneven + nearness;
        Evaluation { score, normal_error, rivalry, shortfall, nearness, loss }
    }
}

/// Mean of 1 − cos between vertex normals and those before (paper §3.1).
fn normal_error(normals: impl Iterator<Item = Vec3>, rest_normals: &[Vec3]) -> f64 {
    // A vertex without a normal (its faces collapsed) counts as turned by a right angle.
    let cosine = |(a, b): (Vec3, &Vec3)| if a.is_finite() { f64::from(a.dot(*b)) } else { 0.0 };
    let pairs = normals.zip(rest_normals).filter(|(_, b)| b.is_finite());
    pairs.map(|pair| 1.0 - cosine(pair)).sum::<f64>() / rest_normals.len() as f64
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
