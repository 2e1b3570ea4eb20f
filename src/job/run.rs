// SPDX-License-Identifier: MIT OR Apache-2.0
//! The job's work: the graphs to search, the searches under way, and the outcome of the best.

use std::sync::Arc;

use glam::Vec3;

use super::entrant::Entrant;
use super::finalist::Finalist;
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
    Budget, Footing, Novelty, Objective, Preset, Search, SearchSpace, Sketch, Start, StopReason, Target,
};
use crate::spectrum::{DEFAULT_RANGE, slider_limits};

/// Between the seeds of searches of the same boxes; far from the small seeds that people choose.
pub const AGAIN: u64 = 0x9e37_79b9;

/// What a variation takes, as a share of the usual search.
const VARIATION: f64 = 0.33;

/// Sums over all searches, for the record.
#[derive(Default)]
pub struct Spent {
    generations: usize,
    evaluations: usize,
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
    let sketch = Sketch::of(proxy.mesh());
    let (again, variation) = (spec.preset.for_score_alone(), spec.preset.for_variations());
    let unrivalled = spec.preset.without_rivals();
    let mut run = Run {
        spec,
        harness,
        target: &target,
        views: &views,
        proxy: &proxy,
        soundness: Soundness::new(proxy.mesh(), spec.preset.max_crossing),
        spent: Spent::default(),
        budget: 0,
        shown: f64::NEG_INFINITY,
        winner: None,
        pool: Pool::default(),
        sketch: &sketch,
        unrivalled: &unrivalled,
        again: &again,
        variation: &variation,
    };
    match spec.preset.budget {
        Some(budget) => run.coarse_to_fine(&stages, budget)?,
        None => run.each_in_full(&stages)?,
    }
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
    pub spent: Spent,
    /// Images that may be encoded, in a search on a budget.
    pub budget: usize,
    /// Score of the best candidate that was shown.
    shown: f64,
    pub winner: Option<Finalist>,
    /// What variations are chosen from, where there are to be any,
    pub pool: Pool,
    /// and by what they are compared.
    pub sketch: &'a Sketch<'a>,
    /// How to search where a rival leads away,
    pub unrivalled: &'a Preset,
    /// once more where nothing was found,
    pub again: &'a Preset,
    /// and for variations.
    pub variation: &'a Preset,
}

impl<'a> Run<'a> {
    /// Sets up a search of a stage as the preset says: for the best there or, with `novelty`, for a variation.
    pub fn enter(
        &mut self,
        stage: &Arc<Stage>,
        preset: &'a Preset,
        start: &Start,
        novelty: Option<Novelty<'a>>,
    ) -> Result<Entrant<'a>, JobError> {
        let (spec, graph) = (self.spec, &*stage.graph);
        let objective = Objective::new(
            self.proxy.mesh(),
            stage.scored.clone(),
            &spec.guide,
            self.target,
            spec.backend,
            self.views,
            preset,
        )?
        .symmetric(graph.symmetry())
        .away_from(novelty);
        let mut space = SearchSpace::new(graph.parameter_rows(), spec.locked.as_deref(), spec.scale_range)?;
        if spec.shift_parts {
            space = space.with_shifts(&graph.shift_room(), graph.reach());
        }
        let footing = preset.footing.then(|| Footing::of(graph, &stage.whole, &space)).flatten();
        self.spent.renderer = objective.backend_name();
        let search = Search::new(objective, space, footing, preset, start)?;
        let mut entrant = Entrant::new(stage.clone(), search)?;
        self.count(&mut entrant, 1);
        let before = entrant.before.score;
        self.harness.update(|p| p.score_before = Some(before));
        Ok(entrant)
    }

    /// One generation of a search.
    pub fn step(&mut self, entrant: &mut Entrant<'a>) -> Result<(), JobError> {
        check(self.harness)?;
        entrant.search.step::<JobError>()?;
        let (candidates, evaluations) = entrant.search.generation();
        if self.spec.variations > 1 {
            self.pool.add(&entrant.stage, candidates, evaluations);
        }
        let count = candidates.len();
        self.spent.generations += 1;
        self.count(entrant, count);
        let (generation, evaluations) = (self.spent.generations, self.spent.evaluations);
        self.harness.update(|p| (p.generation, p.evaluations) = (generation, evaluations));
        Ok(())
    }

    /// Tells those who watch what is searched.
    pub fn tell(&self, stage: &Stage) {
        let phase = format!("Searching with {} part boxes", stage.graph.box_center().len());
        self.harness.update(|p| p.phase = phase);
    }

    /// Tells what share of the usual search is done, or, above 1, how many variations besides.
    pub fn tell_share(&self, share: f64) {
        let whole = 1.0 + VARIATION * (self.spec.variations - 1) as f64;
        let done = share.min(1.0) + VARIATION * (share - 1.0).max(0.0);
        self.harness.update(|p| p.fraction = p.fraction.max((done / whole).min(1.0)));
    }

    /// Shows a candidate to those who watch, if none with a higher score was shown.
    pub fn show(&mut self, stage: &Arc<Stage>, score: f64, factors: &[Vec3]) {
        if score > self.shown {
            self.shown = score;
            self.harness.set_best(Best { score, factors: factors.to_vec(), stage: stage.clone() });
        }
    }

    /// Adds what an entrant has spent on so many candidates to what the run has.
    pub fn count(&mut self, entrant: &mut Entrant<'a>, candidates: usize) {
        self.spent.evaluations += candidates;
        self.spent.images += entrant.images_not_counted();
    }

    /// Ends a search with the `chosen` factors, and keeps what it found if that beats the winner so far.
    pub fn conclude(
        &mut self,
        entrant: &mut Entrant<'a>,
        chosen: Vec<Vec3>,
        stop: StopReason,
    ) -> Result<(), JobError> {
        let (finalist, judged) = entrant.finish(chosen, &self.soundness, stop)?;
        self.count(entrant, judged);
        if self.winner.as_ref().is_none_or(|winner| finalist.beats(winner)) {
            self.winner = Some(finalist);
        }
        Ok(())
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
                precision: spec.guide.precision().into(),
                provider: spec.guide.provider().name().into(),
            },
            preset: spec.preset.name.into(),
            paper_loss: spec.preset.has_paper_loss(),
            image_budget: spec.preset.budget.map(|_| self.budget),
            seconds_budget: match spec.preset.budget {
                Some(Budget::Seconds(seconds)) => Some(seconds),
                _ => None,
            },
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
