// SPDX-License-Identifier: MIT OR Apache-2.0
//! The job's work: a graph and a search per split count, the best of all judged by every image.

use std::sync::Arc;

use glam::Vec3;

use super::outcome::{Best, Outcome, Stage};
use super::progress::Harness;
use super::{JobError, JobSpec};
use crate::boxdef::BoxDefGraph;
use crate::mesh::Mesh;
use crate::metrics;
use crate::render::{self, View};
use crate::report::{GuideRecord, Report};
use crate::search::{
    self, Evaluation, Footing, ImagePlan, Objective, SearchSpace, Start, StopReason, Target,
};
use crate::spectrum::{DEFAULT_RANGE, slider_limits};

/// Between the seeds of searches of the same boxes; far from the small seeds that people choose.
const AGAIN: u64 = 0x9e37_79b9;

/// Share of the triangles that an outcome may have crossing over those of the mesh.
const CROSSED: f64 = 0.015;

/// Triangles up to which outcomes are asked whether they cross themselves.
const MEASURED: usize = 200_000;

/// First step size of a restart, in units of the search variable.
const WIDE: f64 = 1.0;

/// The winner of one split count, judged by every image.
struct Finalist {
    best: Best,
    before: Evaluation,
    after: Evaluation,
    /// Whether it is another shape than what was given.
    improved: bool,
    /// Whether it crosses itself hardly more than the mesh did.
    sound: bool,
    stop: StopReason,
}

/// Sums over all split counts, for the record.
#[derive(Default)]
struct Spent {
    generations: usize,
    /// Generations that the searches so far might have taken.
    reserved: usize,
    evaluations: usize,
    images: usize,
    renderer: String,
}

pub fn run(spec: &JobSpec, harness: &Harness) -> Result<Outcome, JobError> {
    harness.update(|p| p.phase = "Reading the prompt".into());
    let target = Target::new(&spec.guide, &spec.prompt)?;
    let views = render::views_by_name("paper")?;
    harness.update(|p| p.phase = "Finding the parts".into());
    let stages = stages(spec, harness)?;
    let searches = stages.len() + spec.preset.restarts;
    harness.update(|p| p.generations = searches * spec.preset.max_generations);
    let mut spent = Spent::default();
    let mut winner: Option<Finalist> = None;
    for (index, stage) in stages.iter().enumerate() {
        let again = stages[..index].iter().filter(|earlier| Arc::ptr_eq(earlier, stage)).count();
        let seed = spec.seed.wrapping_add(again as u64 * AGAIN);
        let scales = match &winner {
            Some(w) if spec.preset.inherit => {
                search::inherit(&stage.graph, &w.best.stage.field.deform(&w.best.scales))
            }
            _ => vec![Vec3::ONE; stage.graph.parameter_rows()],
        };
        let start = Start { scales, sigma: spec.preset.sigma, seed };
        let finalist =
            search_stage(spec, harness, stage, &start, &target, &views, &mut spent, winner.as_ref())?;
        keep_better(&mut winner, finalist);
    }
    for restart in 1..=spec.preset.restarts {
        let (Some(stage), Some(true)) =
            (stages.last(), winner.as_ref().map(|w| w.after.rivalry > 0.0 || !w.sound))
        else {
            break;
        };
        let scales = vec![Vec3::ONE; stage.graph.parameter_rows()];
        let seed = spec.seed.wrapping_sub(restart as u64 * AGAIN);
        let start = Start { scales, sigma: WIDE, seed };
        let finalist =
            search_stage(spec, harness, stage, &start, &target, &views, &mut spent, winner.as_ref())?;
        keep_better(&mut winner, finalist);
    }
    let winner = winner.ok_or(JobError::NotFinished)?;
    Ok(outcome(spec, harness, winner, spent))
}

/// The graphs to search. A split count that gives the boxes of an earlier one shares its graph: the boxes are
/// then searched again, from another seed.
fn stages(spec: &JobSpec, harness: &Harness) -> Result<Vec<Arc<Stage>>, JobError> {
    if let Some(graph) = &spec.graph {
        return Ok(vec![Arc::new(Stage::new(None, graph.clone(), spec.points.as_deref())?)]);
    }
    let counts = spec.splits.map_or_else(|| spec.preset.splits.to_vec(), |splits| vec![splits]);
    let boundary = spec.boundary.unwrap_or(spec.preset.boundary);
    let mut stages: Vec<Arc<Stage>> = Vec::new();
    for splits in counts {
        check(harness)?;
        let graph = Arc::new(BoxDefGraph::build(&spec.mesh, splits, spec.symmetry, boundary)?);
        let known = |stage: &Arc<Stage>| {
            stage.graph.box_center() == graph.box_center() && stage.graph.assignment() == graph.assignment()
        };
        if let Some(same) = stages.iter().find(|stage| known(stage)) {
            stages.push(same.clone());
            continue;
        }
        stages.push(Arc::new(Stage::new(Some(splits), graph, spec.points.as_deref())?));
    }
    Ok(stages)
}

/// Whether positions cross each other hardly more than the mesh itself does; not asked of very large meshes,
/// where it would take longer than the search.
fn is_sound(mesh: &Mesh, positions: &[Vec3]) -> bool {
    if mesh.triangles().len() > MEASURED {
        return true;
    }
    let ratio = |positions| metrics::self_intersection_ratio(mesh, positions);
    matches!((ratio(positions), ratio(mesh.vertices())), (Ok(after), Ok(before)) if after <= before + CROSSED)
}

/// Keeps a sound outcome before one that crosses itself, then the one of greater worth; and any before none.
fn keep_better(winner: &mut Option<Finalist>, finalist: Finalist) {
    let better = |w: &Finalist| {
        (finalist.improved, finalist.sound, finalist.after.worth()) > (w.improved, w.sound, w.after.worth())
    };
    if winner.as_ref().is_none_or(better) {
        *winner = Some(finalist);
    }
}

#[expect(clippy::too_many_arguments, reason = "two calls; a struct would only rename the arguments")]
fn search_stage(
    spec: &JobSpec,
    harness: &Harness,
    stage: &Arc<Stage>,
    start: &Start,
    target: &Target,
    views: &[View],
    spent: &mut Spent,
    winner: Option<&Finalist>,
) -> Result<Finalist, JobError> {
    let mut objective = Objective::new(
        &spec.mesh,
        stage.field.clone(),
        &spec.guide,
        target,
        spec.backend,
        views,
        &spec.preset,
    )?;
    let unchanged = vec![Vec3::ONE; stage.graph.parameter_rows()];
    let before = objective.evaluate(std::slice::from_ref(&unchanged), ImagePlan::All)?[0];
    spent.evaluations += 1;
    let phase = format!("Searching with {} part boxes", stage.graph.box_center().len());
    harness.update(|p| {
        p.phase = phase;
        p.score_before = Some(before.score);
    });
    let total = harness.progress().generations.max(1);
    let (generations_before, evaluations_before) = (spent.reserved, spent.evaluations);
    spent.reserved += spec.preset.max_generations;
    let mut shown = winner.map_or(f64::NEG_INFINITY, |w| w.after.score);
    let space = SearchSpace::new(stage.graph.parameter_rows(), spec.locked.as_deref(), spec.scale_range)?;
    let footing = spec.preset.footing.then(|| Footing::of(&stage.graph, &space)).flatten();
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
                let scales = generation.best_scales.to_vec();
                harness.set_best(Best { score: shown, scales, stage: stage.clone() });
            }
            check(harness)
        })?;
    spent.generations += found.generations;
    spent.evaluations += found.evaluations;
    // Where what the loss likes best is no more like the prompt, the candidate most like it.
    let finalists = [found.scales, found.highest];
    let judged = objective.evaluate(&finalists, ImagePlan::All)?;
    spent.evaluations += judged.len();
    spent.images += objective.images_encoded();
    spent.renderer = objective.backend_name();
    // The unchanged object competes too: an outcome is never worse than what was given. Only where a
    // comparative asks for more than the pictures reward, the score may fall.
    let improves = |after: &Evaluation| {
        let asked = after.shortfall < before.shortfall && after.worth() >= before.worth();
        asked || after.score > before.score
    };
    let better = judged.iter().zip(finalists).find(|(after, _)| improves(after));
    let improved = better.is_some();
    let (after, scales) = better.map_or((before, unchanged), |(after, scales)| (*after, scales));
    let best = Best { score: after.score, scales, stage: stage.clone() };
    let sound = is_sound(&spec.mesh, &stage.field.deform(&best.scales));
    Ok(Finalist { best, before, after, improved, sound, stop: found.stop })
}

fn outcome(spec: &JobSpec, harness: &Harness, winner: Finalist, spent: Spent) -> Outcome {
    let Finalist { best, before, after, stop, .. } = winner;
    let (gauge, vertices) = best.gauged(spec);
    let points = best.points(gauge);
    let slider = slider_limits(&best.scales, gauge.scale, DEFAULT_RANGE);
    let graph = best.stage.graph.clone();
    harness.update(|p| p.phase = "Done".into());
    harness.set_best(best.clone());
    let report = Report {
        boxmorph: env!("CARGO_PKG_VERSION").into(),
        prompt: spec.prompt.clone(),
        unknown_words: spec.guide.unknown_words(&spec.prompt).unwrap_or_default(),
        guide: GuideRecord { name: spec.guide.name().into(), sha256: spec.guide.hash().into() },
        preset: spec.preset.name.into(),
        seed: spec.seed,
        splits: best.stage.splits,
        locked: spec.locked.clone(),
        scale_range: spec.scale_range.into(),
        symmetry: graph.symmetry_axis().map(|axis| ["x", "y", "z"][axis].into()),
        boundary: graph.boundary().name().into(),
        renderer: spent.renderer,
        vertices: spec.mesh.vertices().len(),
        triangles: spec.mesh.triangles().len(),
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
        scales: best.scales.iter().map(Vec3::to_array).collect(),
        gauge_scale: gauge.scale,
        gauge_shift: gauge.shift.to_array(),
        slider_min: slider.min,
        slider_max: slider.max,
    };
    Outcome { vertices, points, scales: best.scales, graph, slider, report }
}

fn check(harness: &Harness) -> Result<(), JobError> {
    if harness.is_cancelled() { Err(JobError::Cancelled) } else { Ok(()) }
}
