// SPDX-License-Identifier: MIT OR Apache-2.0
//! One search: CMA-ES over the box scales of one graph, and over shifts where parts may be shifted.

use glam::Vec3;

use super::cmaes::{CmaEs, CmaEsOptions};
use super::{Evaluation, Footing, Objective, ObjectiveError, Preset, SearchError, SearchSpace, StopReason};

/// What is known after each generation.
#[derive(Debug)]
pub struct Generation<'a> {
    /// Generations done.
    pub number: usize,
    /// Candidates evaluated.
    pub evaluations: usize,
    /// Score of the best candidate (that of least loss) so far.
    pub best_score: f64,
    /// Its factors.
    pub best_factors: &'a [Vec3],
    /// Factors of this generation's candidates.
    pub candidates: &'a [Vec<Vec3>],
    /// What each of them is worth.
    pub worth: &'a [Evaluation],
}

/// The end of a search.
#[derive(Debug)]
pub struct Found {
    /// Factors of least loss.
    pub factors: Vec<Vec3>,
    /// Factors of the highest score, whatever their loss.
    pub highest: Vec<Vec3>,
    /// Generations done.
    pub generations: usize,
    /// Candidates evaluated.
    pub evaluations: usize,
    /// Why it ended.
    pub stop: StopReason,
}

/// Where a search starts.
#[derive(Debug, Clone)]
pub struct Start {
    /// Factors.
    pub factors: Vec<Vec3>,
    /// First step size, in units of the search variable.
    pub sigma: f64,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// Minimises the objective's loss over a space from the `start`. A `footing` levels the feet of every candidate
/// before it is evaluated. `each_generation` may end the search with its own error.
pub fn search<E: From<SearchError> + From<ObjectiveError>>(
    objective: &mut Objective<'_>,
    space: &SearchSpace,
    footing: Option<&Footing>,
    preset: &Preset,
    start: &Start,
    mut each_generation: impl FnMut(&Generation<'_>) -> Result<(), E>,
) -> Result<Found, E> {
    let mut cma = CmaEs::new(CmaEsOptions {
        start: space.point(&start.factors),
        sigma: start.sigma,
        bounds: space.bounds(),
        population: Some(preset.population(space.dimensions())),
        seed: start.seed,
        max_generations: preset.max_generations,
        tol_fun: preset.tol_fun,
        ..CmaEsOptions::default()
    })?;
    let mut best = (f64::INFINITY, f64::NEG_INFINITY, vec![Vec3::ONE; start.factors.len()]);
    let mut highest = (f64::NEG_INFINITY, best.2.clone());
    loop {
        let mut candidates: Vec<Vec<Vec3>> = cma.ask().iter().map(|x| space.factors(x)).collect();
        if let Some(footing) = footing {
            for factors in &mut candidates {
                footing.level(factors, space.range());
            }
        }
        let evaluations = objective.evaluate(&candidates, preset.images)?;
        for (evaluation, factors) in evaluations.iter().zip(&candidates) {
            if evaluation.loss < best.0 {
                best = (evaluation.loss, evaluation.score, factors.clone());
            }
            if evaluation.score > highest.0 {
                highest = (evaluation.score, factors.clone());
            }
        }
        let losses: Vec<f64> = evaluations.iter().map(|e| e.loss).collect();
        cma.tell(&losses)?;
        each_generation(&Generation {
            number: cma.generation(),
            evaluations: cma.evaluations(),
            best_score: best.1,
            best_factors: &best.2,
            candidates: &candidates,
            worth: evaluations,
        })?;
        if let Some(stop) = cma.stop_reason() {
            let (generations, evaluations) = (cma.generation(), cma.evaluations());
            return Ok(Found { factors: best.2, highest: highest.1, generations, evaluations, stop });
        }
    }
}
