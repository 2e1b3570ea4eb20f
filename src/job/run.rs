// SPDX-License-Identifier: MIT OR Apache-2.0
//! The job's work: a graph and a search per split count, the best of all judged by every image.

use std::sync::Arc;

use glam::Vec3;

use super::outcome::{Best, Outcome, Stage};
use super::progress::Harness;
use super::proxy::Proxy;
use super::soundness::Soundness;
use super::{JobError, JobSpec};
use crate::boxdef::{BoxDefGraph, Ground};
use crate::render::{self, View};
use crate::report::{GuideRecord, Report};
use crate::search::{
    self, Evaluation, Footing, ImagePlan, Objective, SearchSpace, Start, StopReason, Target,
};
use crate::spectrum::{DEFAULT_RANGE, slider_limits};

/// Between the seeds of searches of the same boxes; far from the small seeds that people choose.
const AGAIN: u64 = 0x9e37_79b9;

/// First step size of a restart, in units of the search variable.
const WIDE: f64 = 1.0;

/// What one search found, judged by every image.
struct Finalist {
    best: Best,
    before: Evaluation,
    after: Evaluation,
    /// Whether it is another shape than what was given.
    improved: bool,
    sound: bool,
    stop: StopReason,
}

impl Finalist {
    /// Another shape goes before what was given, a sound one before one that crosses itself, then that of
    /// greater worth.
    fn beats(&self, other: &Self) -> bool {
        let rank = |f: &Self| (f.improved, f.sound, f.after.worth());
        rank(self) > rank(other)
    }

    /// Whether another search might do better: a rival is near, or the shape crosses itself.
    fn falls_short(&self) -> bool {
        self.after.rivalry > 0.0 || !self.sound
    }
}

/// Sums over all searches, for the record.
#[derive(Default)]
struct Spent {
    generations: usize,
    evaluations: usize,
    images: usize,
    renderer: String,
}

pub fn run(spec: &JobSpec, harness: &Harness) -> Result<Outcome, JobError> {
    harness.update(|p| p.phase = "Reading the prompt".into());
    let target = Target::new(&spec.guide, &spec.prompt)?;
    let views = render::views_by_name("paper")?;
    harness.update(|p| p.phase = "Finding the parts".into());
    let proxy = Proxy::of(&spec.mesh);
    let stages = stages(spec, &proxy, harness)?;
    let searches = stages.len() + spec.preset.restarts;
    harness.update(|p| p.generations = searches * spec.preset.max_generations);
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
    run.outcome()
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
struct Run<'a> {
    spec: &'a JobSpec,
    harness: &'a Harness,
    target: &'a Target,
    views: &'a [View],
    /// What is scored of the mesh.
    proxy: &'a Proxy<'a>,
    soundness: Soundness<'a>,
    /// Searches done.
    searches: usize,
    spent: Spent,
    winner: Option<Finalist>,
}

impl Run<'_> {
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
        let (spec, harness) = (self.spec, self.harness);
        let mut objective = Objective::new(
            self.proxy.mesh(),
            stage.scored.clone(),
            &spec.guide,
            self.target,
            spec.backend,
            self.views,
            &spec.preset,
        )?;
        let before = objective.evaluate(&[stage.whole.unchanged()], ImagePlan::All)?[0];
        self.spent.evaluations += 1;
        harness.update(|p| {
            p.phase = format!("Searching with {} part boxes", stage.graph.box_center().len());
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
                if generation.best_score > shown {
                    shown = generation.best_score;
                    let factors = generation.best_factors.to_vec();
                    harness.set_best(Best { score: shown, factors, stage: stage.clone() });
                }
                check(harness)
            })?;
        self.spent.generations += found.generations;
        self.spent.evaluations += found.evaluations;
        // The unchanged object competes too: an outcome is never worse than what was given. Only where a
        // comparative asks for more than the pictures reward, the score may fall.
        let improves = |after: &Evaluation| {
            let asked = after.shortfall < before.shortfall && after.worth() >= before.worth();
            asked || after.score > before.score
        };
        let (mut after, mut factors, mut improved) = (before, stage.whole.unchanged(), false);
        // Where what the loss likes best is no more like the prompt, the candidate that is most like it.
        for candidate in [found.factors, found.highest] {
            let judged = objective.evaluate(std::slice::from_ref(&candidate), ImagePlan::All)?[0];
            self.spent.evaluations += 1;
            if improves(&judged) {
                (after, factors, improved) = (judged, candidate, true);
                break;
            }
        }
        self.searches += 1;
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

    /// The winner under its gauge, with its record.
    fn outcome(self) -> Result<Outcome, JobError> {
        let Self { spec, harness, proxy, spent, winner, .. } = self;
        let Finalist { best, before, after, stop, .. } = winner.ok_or(JobError::NotFinished)?;
        let (gauge, vertices) = best.gauged(spec);
        let points = best.points(gauge);
        let slider = slider_limits(best.scales(), gauge.scale, DEFAULT_RANGE);
        let graph = best.stage.graph.clone();
        let shifts = best.shifts();
        harness.update(|p| p.phase = "Done".into());
        harness.set_best(best.clone());
        let report = Report {
            boxmorph: env!("CARGO_PKG_VERSION").into(),
            prompt: spec.prompt.clone(),
            unknown_words: spec.guide.unknown_words(&spec.prompt).unwrap_or_default(),
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
            renderer: spent.renderer,
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
        Ok(Outcome { vertices, points, scales, shifts, graph, slider, report })
    }
}

fn check(harness: &Harness) -> Result<(), JobError> {
    if harness.is_cancelled() { Err(JobError::Cancelled) } else { Ok(()) }
}
