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
use rand_distr::{Distribution, StandardNormal};
use serde::{Deserialize, Serialize};

use super::{
    bounds::{BoundTransform, Bounds},
    covariance::Covariance,
    error::SearchError,
    exact,
    saved::Saved,
    stop::{DIVERGED, History, StopReason, is_flat},
    strategy::Strategy,
};

/// The smallest population that leaves two candidates to recombine and two to avoid.
const LEAST_POPULATION: usize = 4;

/// How a search starts and when it ends. Lower scores are better.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CmaEsOptions {
    /// Where the first generation is centred, n ≥ 1 coordinates, within the bounds.
    #[serde(with = "exact")]
    pub start: Vec<f64>,
    /// First standard deviation in every coordinate; a third of the expected distance to the optimum
    /// is a good choice.
    #[serde(with = "exact")]
    pub sigma: f64,
    /// Where candidates may lie. Between finite bounds, σ is held under a third of their range.
    pub bounds: Bounds,
    /// Candidates in a generation, at least 4; `None`: ⌊4 + 3 ln n⌋.
    pub population: Option<usize>,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Generations at most.
    pub max_generations: usize,
    /// Evaluations at most; a generation that would go beyond is not begun.
    pub max_evaluations: usize,
    /// Stop once scores span less than this, over a generation and over the best of many.
    #[serde(with = "exact")]
    pub tol_fun: f64,
    /// Stop once steps are shorter than this in every coordinate.
    #[serde(with = "exact")]
    pub tol_x: f64,
    /// Stop once the covariance's condition number is above this.
    #[serde(with = "exact")]
    pub max_condition: f64,
}

impl Default for CmaEsOptions {
    /// No start: give one. σ = 1, no bounds, seed 0, no limits, tolerances of 1e-11, condition 1e14.
    fn default() -> Self {
        Self {
            start: Vec::new(),
            sigma: 1.0,
            bounds: Bounds::None,
            population: None,
            seed: 0,
            max_generations: usize::MAX,
            max_evaluations: usize::MAX,
            tol_fun: 1e-11,
            tol_x: 1e-11,
            max_condition: 1e14,
        }
    }
}

/// A candidate that waits for its score.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Candidate {
    /// Where it is scored, within the bounds.
    #[serde(with = "exact")]
    pub(super) x: Vec<f64>,
    /// Its step from the mean in inner coordinates, divided by σ.
    #[serde(with = "exact")]
    pub(super) step: DVector<f64>,
    /// Length of the step as the covariance measures it.
    #[serde(with = "exact")]
    pub(super) length: f64,
}

/// A search under way.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "Saved", into = "Saved")]
pub struct CmaEs {
    pub(super) options: CmaEsOptions,
    pub(super) strategy: Strategy,
    pub(super) transform: BoundTransform,
    pub(super) rng: ChaCha8Rng,
    /// Mean, in inner coordinates.
    pub(super) mean: DVector<f64>,
    pub(super) sigma: f64,
    pub(super) covariance: Covariance,
    /// Path of the step size, whitened.
    pub(super) sigma_path: DVector<f64>,
    /// Path of the covariance.
    pub(super) path: DVector<f64>,
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
        let n = options.start.len();
        if n == 0 {
            return Err(SearchError::NoCoordinates);
        }
        if let Some(coordinate) = options.start.iter().position(|value| !value.is_finite()) {
            return Err(SearchError::StartNotFinite { coordinate, value: options.start[coordinate] });
        }
        if !(options.sigma > 0.0 && options.sigma.is_finite()) {
            return Err(SearchError::Sigma(options.sigma));
        }
        let population =
            options.population.unwrap_or_else(|| Strategy::default_population(n).max(LEAST_POPULATION));
        if population < LEAST_POPULATION {
            return Err(SearchError::Population(population));
        }
        let transform = BoundTransform::new(&options.bounds, n)?;
        if let Some((coordinate, lower, upper)) = transform.first_outside(&options.start) {
            let value = options.start[coordinate];
            return Err(SearchError::StartOutside { coordinate, value, lower, upper });
        }
        let mut search = Self {
            strategy: Strategy::new(n, population),
            rng: ChaCha8Rng::seed_from_u64(options.seed),
            mean: DVector::from_vec(transform.inner(&options.start)),
            transform,
            sigma: options.sigma,
            covariance: Covariance::new(n),
            sigma_path: DVector::zeros(n),
            path: DVector::zeros(n),
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
            self.sigma *= (0.2 + self.strategy.c_sigma / self.strategy.d_sigma).exp();
        } else {
            self.update(&order.iter().map(|&i| &candidates[i]).collect::<Vec<_>>());
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
        let expected = self.options.start.len();
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
        self.sigma
    }

    /// The centre of the distribution, within the bounds; never itself scored.
    #[must_use]
    pub fn mean(&self) -> Vec<f64> {
        self.transform.outer(self.mean.as_slice())
    }

    /// A candidate drawn from the distribution.
    fn drawn(&mut self) -> Candidate {
        let rng = &mut self.rng;
        let normal = DVector::from_fn(self.mean.len(), |_, _| StandardNormal.sample(rng));
        self.stepped(self.covariance.shape(&normal), normal.norm())
    }

    /// The candidate for an injected `x`: Hansen, *Injecting External Solutions Into CMA-ES*, 2011
    /// (arXiv:1110.4181).
    fn placed(&self, x: &[f64]) -> Candidate {
        let step = (DVector::from_vec(self.transform.inner(x)) - &self.mean) / self.sigma;
        let length = self.covariance.whiten(&step).norm();
        let n = self.mean.len() as f64;
        let longest = n.sqrt() + 2.0 * n / (n + 2.0);
        if length > longest {
            self.stepped(step * (longest / length), longest)
        } else {
            Candidate { x: x.to_vec(), step, length }
        }
    }

    fn stepped(&self, step: DVector<f64>, length: f64) -> Candidate {
        let x = self.transform.outer((&self.mean + self.sigma * &step).as_slice());
        Candidate { x, step, length }
    }

    /// Moves mean, step size and covariance by the candidates, best first.
    fn update(&mut self, ranked: &[&Candidate]) {
        let n = self.mean.len() as f64;
        let Strategy { weights, mu, mu_eff, c_sigma, d_sigma, c_c, c_1, c_mu, chi_n, eigen_gap } =
            &self.strategy;

        let mut mean_step = DVector::zeros(self.mean.len());
        for (weight, candidate) in weights.iter().zip(ranked).take(*mu) {
            mean_step.axpy(*weight, &candidate.step, 1.0);
        }
        self.mean.axpy(self.sigma, &mean_step, 1.0);

        self.sigma_path *= 1.0 - c_sigma;
        let share = (c_sigma * (2.0 - c_sigma) * mu_eff).sqrt();
        self.sigma_path.axpy(share, &self.covariance.whiten(&mean_step), 1.0);
        let length = self.sigma_path.norm();

        // While σ is still catching up, the covariance path would only learn its length.
        let settled = (1.0 - (1.0 - c_sigma).powi(2 * self.generation.min(1 << 20) as i32)).sqrt();
        let hold = if length / settled < (1.4 + 2.0 / (n + 1.0)) * chi_n { 1.0 } else { 0.0 };
        self.path *= 1.0 - c_c;
        self.path.axpy(hold * (c_c * (2.0 - c_c) * mu_eff).sqrt(), &mean_step, 1.0);

        let lost = (1.0 - hold) * c_c * (2.0 - c_c);
        let keep = 1.0 + c_1 * lost - c_1 - c_mu * weights.iter().sum::<f64>();
        let rank_mu = weights.iter().zip(ranked).map(|(&weight, candidate)| {
            // A bad candidate counts by its direction alone, so that C stays positive definite.
            let scale = if weight < 0.0 { n / candidate.length.powi(2).max(f64::MIN_POSITIVE) } else { 1.0 };
            (c_mu * weight * scale, &candidate.step)
        });
        self.covariance.update(keep, std::iter::once((*c_1, &self.path)).chain(rank_mu));

        self.sigma *= (c_sigma / d_sigma * (length / chi_n - 1.0)).min(1.0).exp();

        if self.generation >= self.covariance.decomposed_at + eigen_gap {
            self.decompose();
        }
    }

    fn decompose(&mut self) {
        if !self.covariance.decompose(self.generation) {
            self.path.fill(0.0);
            self.sigma_path.fill(0.0);
        }
    }

    /// Narrows the distribution where it is too wide for the bounds.
    fn hold_within_bounds(&mut self) {
        let mut narrowed = false;
        for i in 0..self.mean.len() {
            let deviation = self.sigma * self.covariance.deviation(i);
            let greatest = self.transform.greatest_deviation(i);
            if deviation > greatest {
                self.covariance.narrow(i, greatest / deviation);
                self.path[i] *= greatest / deviation;
                narrowed = true;
            }
        }
        if narrowed {
            self.decompose();
        }
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
        let n = self.mean.len();
        let widest = self.sigma * self.covariance.lengths.max();
        if self.history.within_tolerance(ranked, n, self.options.tol_fun) {
            Some(StopReason::TolFun)
        } else if (0..n).all(|i| self.is_short(i)) {
            Some(StopReason::TolX)
        } else if self.history.is_flat_for_long() {
            Some(StopReason::FlatFitness)
        } else if self.covariance.condition() > self.options.max_condition {
            Some(StopReason::Condition)
        } else if !(widest <= DIVERGED * self.options.sigma) {
            Some(StopReason::Diverged)
        } else if self.history.is_stagnant(self.generation, n, ranked.len()) {
            Some(StopReason::Stagnation)
        } else {
            self.budget_spent()
        }
    }

    /// Whether steps in coordinate `i` are below the tolerance, or below what the mean can resolve.
    fn is_short(&self, i: usize) -> bool {
        let step = self.sigma * self.covariance.deviation(i).max(self.path[i].abs());
        step < self.options.tol_x || self.mean[i] + 0.2 * step == self.mean[i]
    }
}
