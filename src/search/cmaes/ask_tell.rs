// SPDX-License-Identifier: MIT OR Apache-2.0
//! CMA-ES with ask and tell: a search without derivatives that learns the shape of its landscape.
//!
//! A generation of candidates is drawn from a normal distribution; their ranks move its mean, its step
//! size σ and its covariance. The update is that of Hansen's *The CMA Evolution Strategy: A Tutorial*,
//! 2016 (arXiv:1604.00772), with negative weights (active update); bounds follow pycma's idea of a smooth
//! change of coordinates (see `bounds`). Only ranks count, so any rising function of the scores gives
//! the same search; only the stop rule `tol_fun` looks at the scores themselves.
//!
//! The same options and scores give the same candidates to the bit. Serialised with serde, a search
//! resumes where it stood, between `ask` and `tell` too.
//!
//! ```
//! use boxmorph::search::{Bounds, CmaEs, CmaEsOptions};
//!
//! let options = CmaEsOptions {
//!     start: vec![0.0; 3],
//!     bounds: Bounds::Same(-1.0, 3.0),
//!     ..CmaEsOptions::default()
//! };
//! let mut search = CmaEs::new(options)?;
//! while search.stop_reason().is_none() {
//!     let scores: Vec<f64> =
//!         search.ask().iter().map(|x| x.iter().map(|v| (v - 5.0).powi(2)).sum()).collect();
//!     search.tell(&scores)?;
//! }
//! let (x, _) = search.best().expect("scores were told");
//! assert!(x.iter().all(|v| (v - 3.0).abs() < 1e-6));
//! # Ok::<(), boxmorph::search::SearchError>(())
//! ```

use nalgebra::DVector;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rand_distr::{Distribution as _, StandardNormal};
use serde::{Deserialize, Serialize};

use super::{
    bounds::BoundTransform,
    distribution::{Distribution, Step},
    error::SearchError,
    exact,
    options::CmaEsOptions,
    stop::{DIVERGED, History, StopReason, is_flat},
    strategy::Strategy,
};

/// A candidate that waits for its score.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Candidate {
    /// Where it is scored, within the bounds.
    #[serde(with = "exact")]
    pub(super) x: Vec<f64>,
    /// How it came about.
    pub(super) step: Step,
}

/// A search under way.
#[derive(Debug, Clone)]
pub struct CmaEs {
    pub(super) options: CmaEsOptions,
    pub(super) strategy: Strategy,
    pub(super) transform: BoundTransform,
    pub(super) rng: ChaCha8Rng,
    pub(super) distribution: Distribution,
    pub(super) generation: usize,
    pub(super) evaluations: usize,
    /// Candidates asked for and not yet told.
    pub(super) pending: Vec<Candidate>,
    /// Candidates to be put into the next generation.
    pub(super) injected: Vec<Vec<f64>>,
    pub(super) best: Option<(Vec<f64>, f64)>,
    pub(super) history: History,
    pub(super) stop: Option<StopReason>,
}

impl CmaEs {
    /// Sets up a search.
    pub fn new(options: CmaEsOptions) -> Result<Self, SearchError> {
        let population = options.checked_population()?;
        let n = options.coordinates();
        let transform = BoundTransform::new(&options.bounds, n)?;
        if let Some((coordinate, lower, upper)) = transform.first_outside(&options.start) {
            let value = options.start[coordinate];
            return Err(SearchError::StartOutside { coordinate, value, lower, upper });
        }
        let mut search = Self {
            strategy: Strategy::new(n, population),
            rng: ChaCha8Rng::seed_from_u64(options.seed),
            distribution: Distribution::new(transform.inner(&options.start), options.sigma),
            transform,
            generation: 0,
            evaluations: 0,
            pending: Vec::new(),
            injected: Vec::new(),
            best: None,
            history: History::default(),
            stop: None,
            options,
        };
        search.hold_within_bounds();
        search.stop = search.budget_spent();
        Ok(search)
    }

    /// The candidates of the next generation, each n coordinates within the bounds. Until scores are
    /// told, the same ones again.
    pub fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.pending.is_empty() {
            let injected = std::mem::take(&mut self.injected);
            self.pending = injected.iter().map(|x| self.placed(x)).collect();
            while self.pending.len() < self.population() {
                let candidate = self.drawn();
                self.pending.push(candidate);
            }
        }
        self.pending.iter().map(|candidate| candidate.x.clone()).collect()
    }

    /// Takes the scores of the candidates last asked for, in their order; lower is better, and anything
    /// that is not a finite number is worst. Of equal scores the earlier candidate ranks first.
    pub fn tell(&mut self, scores: &[f64]) -> Result<(), SearchError> {
        if self.pending.is_empty() {
            return Err(SearchError::NothingAsked);
        }
        if scores.len() != self.pending.len() {
            return Err(SearchError::ScoreCount { expected: self.pending.len(), got: scores.len() });
        }
        let score_of = |i: usize| if scores[i].is_finite() { scores[i] } else { f64::INFINITY };
        let mut order: Vec<usize> = (0..scores.len()).collect();
        order.sort_by(|&a, &b| score_of(a).total_cmp(&score_of(b)));
        let ranked: Vec<f64> = order.iter().map(|&i| score_of(i)).collect();
        let candidates = std::mem::take(&mut self.pending);

        self.generation += 1;
        self.evaluations += scores.len();
        self.history.record(&ranked);
        if ranked[0].is_finite() && self.best.as_ref().is_none_or(|(_, best)| ranked[0] < *best) {
            self.best = Some((candidates[order[0]].x.clone(), ranked[0]));
        }
        if is_flat(&ranked) {
            // Ranks mean nothing here: only look further around.
            self.distribution.widen(&self.strategy);
        } else {
            let steps: Vec<&Step> = order.iter().map(|&i| &candidates[i].step).collect();
            self.distribution.update(&self.strategy, self.generation, &steps);
        }
        self.hold_within_bounds();
        if self.stop.is_none() {
            self.stop = self.reason_to_stop(&ranked);
        }
        Ok(())
    }

    /// Puts `x`, n finite coordinates within the bounds, among the next generation's candidates, moved
    /// towards the mean where the distribution would hardly ever have drawn it. At most a generation's
    /// worth is taken; what is injected beyond that is left out.
    pub fn inject(&mut self, x: &[f64]) -> Result<(), SearchError> {
        let expected = self.options.coordinates();
        let finite = x.iter().all(|value| value.is_finite());
        if x.len() != expected || !finite || self.transform.first_outside(x).is_some() {
            return Err(SearchError::Injected { expected });
        }
        if self.injected.len() < self.population() {
            self.injected.push(x.to_vec());
        }
        Ok(())
    }

    /// Why the search should stop, once it should.
    #[must_use]
    pub fn stop_reason(&self) -> Option<StopReason> {
        self.stop
    }

    /// The best candidate ever told, with its score; `None` before the first finite score.
    #[must_use]
    pub fn best(&self) -> Option<(&[f64], f64)> {
        self.best.as_ref().map(|(x, score)| (x.as_slice(), *score))
    }

    /// Generations told.
    #[must_use]
    pub fn generation(&self) -> usize {
        self.generation
    }

    /// Scores told.
    #[must_use]
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// Candidates in a generation.
    #[must_use]
    pub fn population(&self) -> usize {
        self.strategy.weights.len()
    }

    /// The step size σ.
    #[must_use]
    pub fn sigma(&self) -> f64 {
        self.distribution.sigma()
    }

    /// The centre of the distribution, within the bounds; never itself scored.
    #[must_use]
    pub fn mean(&self) -> Vec<f64> {
        self.transform.outer(self.distribution.mean())
    }

    /// The coordinates of `x`, within the bounds, in which the distribution is round and of unit width.
    pub(in crate::search) fn whitened(&self, x: &[f64]) -> DVector<f64> {
        self.distribution.whitened(self.transform.inner(x))
    }

    /// The point of these coordinates.
    pub(in crate::search) fn unwhitened(&self, z: &DVector<f64>) -> Vec<f64> {
        self.transform.outer(&self.distribution.at(&self.distribution.step(z)))
    }

    /// A candidate drawn from the distribution.
    fn drawn(&mut self) -> Candidate {
        let rng = &mut self.rng;
        let normal = DVector::from_fn(self.options.coordinates(), |_, _| StandardNormal.sample(rng));
        let step = self.distribution.step(&normal);
        Candidate { x: self.transform.outer(&self.distribution.at(&step)), step }
    }

    /// The candidate for an injected `x`.
    fn placed(&self, x: &[f64]) -> Candidate {
        let (step, shortened) = self.distribution.step_to(self.transform.inner(x));
        let x = if shortened { self.transform.outer(&self.distribution.at(&step)) } else { x.to_vec() };
        Candidate { x, step }
    }

    fn hold_within_bounds(&mut self) {
        let transform = &self.transform;
        self.distribution.hold_under(self.generation, |i| transform.greatest_deviation(i));
    }

    fn budget_spent(&self) -> Option<StopReason> {
        if self.generation >= self.options.max_generations {
            Some(StopReason::MaxGenerations)
        } else if self.evaluations.saturating_add(self.population()) > self.options.max_evaluations {
            Some(StopReason::MaxEvaluations)
        } else {
            None
        }
    }

    fn reason_to_stop(&self, ranked: &[f64]) -> Option<StopReason> {
        let n = self.options.coordinates();
        let spread = &self.distribution;
        if self.history.within_tolerance(ranked, n, self.options.tol_fun) {
            Some(StopReason::TolFun)
        } else if spread.is_within(self.options.tol_x) {
            Some(StopReason::TolX)
        } else if self.history.is_flat_for_long() {
            Some(StopReason::FlatFitness)
        } else if spread.condition() > self.options.max_condition {
            Some(StopReason::Condition)
        } else if spread.widest() > DIVERGED * self.options.sigma || spread.widest().is_nan() {
            Some(StopReason::Diverged)
        } else if self.history.is_stagnant(self.generation, n, ranked.len()) {
            Some(StopReason::Stagnation)
        } else {
            self.budget_spent()
        }
    }
}
