// SPDX-License-Identifier: MIT OR Apache-2.0
//! The job's work: a graph and a search per split count, the best of all judged by every image.

use std::sync::Arc;

use glam::Vec3;

use super::finalist::{Finalist, improves};
use super::outcome::{Best, Outcome, Stage};
use super::pool::Pool;
use super::progress::Harness;
use super::proxy::Proxy;
use super::soundness::Soundness;
use super::{JobError, JobSpec};
use crate::boxdef::{BoxDefGraph, Ground};
use crate::render::{self, View};
use crate::report::{GuideRecord, Report};
use crate::search::{
    self, Evaluation, Footing, Found, ImagePlan, Novelty, Objective, SearchSpace, Sketch, Start, Target,
};
use crate::spectrum::{DEFAULT_RANGE, slider_limits};

/// Between the seeds of searches of the same boxes; far from the small seeds that people choose.
pub const AGAIN: u64 = 0x9e37_79b9;

/// First step size of a search that is to look farther, in units of the search variable.
pub const WIDE: f64 = 1.0;

/// Sums over all searches, for the record.
#[derive(Default)]
pub struct Spent {
    generations: usize,
    pub evaluations: usize,
    pub images: usize,
    renderer: String,
}

pub fn run(spec: &JobSpec, harness: &Harness) -> Result<Outcome, JobError> {
    harness.update(|p| p.phase = "Reading the prompt".into());
    let target = Target::new(&spec.guide, &spec.resolved_wording())?;
    let views = render::views_by_name("paper")?;
    harness.update(|p| p.phase = "Finding the parts".into());
    let proxy = Proxy::of(&spec.mesh);
    let stages = stages(spec, &proxy, harness)?;
    let searches = stages.len() + spec.preset.restarts + spec.variations - 1;
    harness.update(|p| p.generations = searches * spec.preset.max_generations);
    let sketch = Sketch::of(proxy.mesh());
    let mut run = Run {
        spec,
        harness,
        target: &target,
        views: &views,
        proxy: &proxy,
        soundness: Soundness::new(proxy.mesh(), spec.preset.max_crossing),
        searches: 0,
        spent: Spent::default(),
        winner: None,
        pool: Pool::default(),
        sketch: &sketch,
    };
    for (index, stage) in stages.iter().enumerate() {
        let again = stages[..index].iter().filter(|earlier| Arc::ptr_eq(earlier, stage)).count();
        let seed = spec.seed.wrapping_add(again as u64 * AGAIN);
        run.search(stage, &Start { factors: run.start_of(stage), sigma: spec.preset.sigma, seed })?;
    }
    if let Some(stage) = stages.last() {
        for restart in 1..=spec.preset.restarts {
            if !run.winner.as_ref().is_some_and(Finalist::falls_short) {
                break;
            }
            let seed = spec.seed.wrapping_sub(restart as u64 * AGAIN);
            run.search(stage, &Start { factors: stage.whole.unchanged(), sigma: WIDE, seed })?;
        }
    }
    run.searches = stages.len() + spec.preset.restarts;
    let variations = run.vary()?;
    run.outcome(variations)
}

/// The graphs to search. A split count that gives the boxes of an earlier one shares its graph: the boxes are
/// then searched again, from another seed.
fn stages(spec: &JobSpec, proxy: &Proxy<'_>, harness: &Harness) -> Result<Vec<Arc<Stage>>, JobError> {
    if let Some(graph) = &spec.graph {
        return Ok(vec![Arc::new(Stage::new(None, graph.clone(), proxy, spec)?)]);
    }
    let counts = spec.splits.map_or_else(|| spec.preset.splits.to_vec(), |splits| vec![splits]);
    let symmetry = spec.symmetry.unwrap_or(spec.preset.symmetry);
    let boundary = spec.boundary.unwrap_or(spec.preset.boundary);
    let ground = Ground::of(&spec.mesh, symmetry);
    let mut stages: Vec<Arc<Stage>> = Vec::new();
    for splits in counts {
        check(harness)?;
        let graph = Arc::new(BoxDefGraph::on(&ground, splits, boundary)?);
        let known = |stage: &Arc<Stage>| {
            stage.graph.box_center() == graph.box_center() && stage.graph.assignment() == graph.assignment()
        };
        if let Some(same) = stages.iter().find(|stage| known(stage)) {
            stages.push(same.clone());
            continue;
        }
        stages.push(Arc::new(Stage::new(Some(splits), graph, proxy, spec)?));
    }
    Ok(stages)
}

/// A run under way.
pub struct Run<'a> {
    pub spec: &'a JobSpec,
    pub harness: &'a Harness,
    target: &'a Target,
    views: &'a [View],
    /// What is scored of the mesh.
    proxy: &'a Proxy<'a>,
    pub soundness: Soundness<'a>,
    /// Searches done.
    searches: usize,
    pub spent: Spent,
    pub winner: Option<Finalist>,
    /// What variations are chosen from, where there are to be any,
    pub pool: Pool,
    /// and by what they are compared.
    pub sketch: &'a Sketch<'a>,
}

/// A search that was made, and what evaluates its candidates.
pub struct Hunt<'a> {
    pub objective: Objective<'a>,
    /// The unchanged object.
    before: Evaluation,
    pub found: Found,
}

impl<'a> Run<'a> {
    /// Where the first search of a stage starts: at the best so far, if the preset has it so.
    fn start_of(&self, stage: &Stage) -> Vec<Vec3> {
        let mut factors = stage.whole.unchanged();
        if let (Some(w), true) = (&self.winner, self.spec.preset.inherit) {
            let scales = search::inherit(&stage.graph, &w.best.stage.whole.deform(&w.best.factors));
            factors[..scales.len()].copy_from_slice(&scales);
        }
        factors
    }

    /// Searches a stage, and keeps what it finds if it beats the winner so far.
    fn search(&mut self, stage: &Arc<Stage>, start: &Start) -> Result<(), JobError> {
        let Hunt { mut objective, before, found } = self.hunt(stage, start, None)?;
        let (mut after, mut factors, mut improved) = (before, stage.whole.unchanged(), false);
        // Where what the loss likes best is no more like the prompt, the candidate that is most like it.
        for candidate in [found.factors, found.highest] {
            let judged = objective.evaluate(std::slice::from_ref(&candidate), ImagePlan::All)?[0];
            self.spent.evaluations += 1;
            if improves(&judged, &before) {
                (after, factors, improved) = (judged, candidate, true);
                break;
            }
        }
        self.spent.images += objective.images_encoded();
        self.spent.renderer = objective.backend_name();
        let sound = self.soundness.holds(&stage.scored.deform(&factors));
        let best = Best { score: after.score, factors, stage: stage.clone() };
        let finalist = Finalist { best, before, after, improved, sound, stop: found.stop };
        if self.winner.as_ref().is_none_or(|winner| finalist.beats(winner)) {
            self.winner = Some(finalist);
        }
        Ok(())
    }

    /// Searches a stage: for the best there or, with `novelty`, for a variation.
    pub fn hunt(
        &mut self,
        stage: &Arc<Stage>,
        start: &Start,
        novelty: Option<Novelty<'a>>,
    ) -> Result<Hunt<'a>, JobError> {
        let (spec, harness) = (self.spec, self.harness);
        let phase = match &novelty {
            Some(_) => "Searching variations".into(),
            None => format!("Searching with {} part boxes", stage.graph.box_center().len()),
        };
        let varies = novelty.is_some();
        let mut objective = Objective::new(
            self.proxy.mesh(),
            stage.scored.clone(),
            &spec.guide,
            self.target,
            spec.backend,
            self.views,
            &spec.preset,
        )?
        .away_from(novelty);
        let before = objective.evaluate(&[stage.whole.unchanged()], ImagePlan::All)?[0];
        self.spent.evaluations += 1;
        harness.update(|p| {
            p.phase = phase;
            p.score_before = Some(before.score);
        });
        let total = harness.progress().generations.max(1);
        let generations_before = self.searches * spec.preset.max_generations;
        let evaluations_before = self.spent.evaluations;
        let mut shown = self.winner.as_ref().map_or(f64::NEG_INFINITY, |w| w.after.score);
        let graph = &*stage.graph;
        let mut space = SearchSpace::new(graph.parameter_rows(), spec.locked.as_deref(), spec.scale_range)?;
        if spec.shift_parts {
            space = space.with_shifts(&graph.shift_room(), graph.reach());
        }
        let footing = spec.preset.footing.then(|| Footing::of(graph, &stage.whole, &space)).flatten();
        let found =
            search::search(&mut objective, &space, footing.as_ref(), &spec.preset, start, |generation| {
                let done = generations_before + generation.number;
                harness.update(|p| {
                    p.generation = done;
                    p.evaluations = evaluations_before + generation.evaluations;
                    p.fraction = done as f64 / total as f64;
                });
                if spec.variations > 1 {
                    self.pool.add(stage, generation.candidates, generation.worth);
                }
                // Until all have been found the best is shown, not a variation on the way.
                if !varies && generation.best_score > shown {
                    shown = generation.best_score;
                    let factors = generation.best_factors.to_vec();
                    harness.set_best(Best { score: shown, factors, stage: stage.clone() });
                }
                check(harness)
            })?;
        self.spent.generations += found.generations;
        self.spent.evaluations += found.evaluations;
        self.searches += 1;
        Ok(Hunt { objective, before, found })
    }

    /// The winner under its gauge, with its record.
    fn outcome(mut self, others: Vec<(f64, Finalist)>) -> Result<Outcome, JobError> {
        let winner = self.winner.take().ok_or(JobError::NotFinished)?;
        self.harness.update(|p| p.phase = "Done".into());
        self.harness.set_best(winner.best.clone());
        let others = others.into_iter().enumerate();
        let variations =
            others.map(|(i, (d, other))| Arc::new(self.told(other, i + 1, d, Vec::new()))).collect();
        Ok(self.told(winner, 0, 0.0, variations))
    }

    fn told(
        &self,
        finalist: Finalist,
        variation: usize,
        distance: f64,
        variations: Vec<Arc<Outcome>>,
    ) -> Outcome {
        let Self { spec, harness, proxy, spent, .. } = self;
        let Finalist { best, before, after, stop, .. } = finalist;
        let (gauge, vertices) = best.gauged(spec);
        let points = best.points(gauge);
        let slider = slider_limits(best.scales(), gauge.scale, DEFAULT_RANGE);
        let graph = best.stage.graph.clone();
        let shifts = best.shifts();
        let report = Report {
            boxmorph: env!("CARGO_PKG_VERSION").into(),
            prompt: spec.wording.prompt.clone(),
            negative: spec.wording.negative.clone(),
            source: spec.wording.source.clone(),
            templates: spec.resolved_wording().templates == Some(true),
            unknown_words: spec.wording.unknown_words(&spec.guide).unwrap_or_default(),
            guide: GuideRecord {
                name: spec.guide.name().into(),
                sha256: spec.guide.hash().into(),
                provider: spec.guide.provider().name().into(),
            },
            preset: spec.preset.name.into(),
            seed: spec.seed,
            splits: best.stage.splits,
            locked: spec.locked.clone(),
            scale_range: spec.scale_range.into(),
            symmetry: graph.symmetry().name().into(),
            boundary: graph.boundary().name().into(),
            renderer: spent.renderer.clone(),
            variations_asked: spec.variations,
            variation,
            distance,
            vertices: spec.mesh.vertices().len(),
            triangles: spec.mesh.triangles().len(),
            scored_triangles: proxy.mesh().triangles().len(),
            boxes: graph.box_center().len(),
            parameter_rows: graph.parameter_rows(),
            score_before: before.score,
            score_after: after.score,
            normal_error: after.normal_error,
            generations: spent.generations,
            evaluations: spent.evaluations,
            images_encoded: spent.images,
            seconds: harness.seconds(),
            stop_reason: stop.to_string(),
            scales: best.scales().iter().map(Vec3::to_array).collect(),
            shifts: shifts.as_ref().map(|rows| rows.iter().map(Vec3::to_array).collect()),
            gauge_scale: gauge.scale,
            gauge_shift: gauge.shift.to_array(),
            slider_min: slider.min,
            slider_max: slider.max,
        };
        let scales = best.scales().to_vec();
        Outcome { vertices, points, scales, shifts, graph, slider, variations, report }
    }
}

pub fn check(harness: &Harness) -> Result<(), JobError> {
    if harness.is_cancelled() { Err(JobError::Cancelled) } else { Ok(()) }
}
