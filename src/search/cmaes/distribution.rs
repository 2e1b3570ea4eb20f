// SPDX-License-Identifier: MIT OR Apache-2.0
//! The normal distribution that candidates are drawn from, N(mean, σ²·C), and how ranks move it.

use nalgebra::DVector;
use serde::{Deserialize, Serialize};

use super::{covariance::Covariance, exact, strategy::Strategy};

/// A step from the mean, in inner coordinates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Step {
    /// The step, divided by σ.
    #[serde(with = "exact")]
    direction: DVector<f64>,
    /// Its length as the covariance measures it.
    #[serde(with = "exact")]
    length: f64,
}

/// The distribution with its memory of past steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Distribution {
    #[serde(with = "exact")]
    mean: DVector<f64>,
    #[serde(with = "exact")]
    sigma: f64,
    covariance: Covariance,
    /// Path of the step size, whitened.
    #[serde(with = "exact")]
    sigma_path: DVector<f64>,
    /// Path of the covariance.
    #[serde(with = "exact")]
    path: DVector<f64>,
}

impl Step {
    /// Whether it has `n` coordinates.
    pub(super) fn fits(&self, n: usize) -> bool {
        self.direction.len() == n
    }
}

impl Distribution {
    /// A round one.
    pub(super) fn new(mean: Vec<f64>, sigma: f64) -> Self {
        let n = mean.len();
        Self {
            mean: DVector::from_vec(mean),
            sigma,
            covariance: Covariance::new(n),
            sigma_path: DVector::zeros(n),
            path: DVector::zeros(n),
        }
    }

    /// Whether every part has `n` coordinates.
    pub(super) fn fits(&self, n: usize) -> bool {
        let vectors = [&self.mean, &self.sigma_path, &self.path];
        vectors.iter().all(|vector| vector.len() == n) && self.covariance.fits(n)
    }

    pub(super) fn mean(&self) -> &[f64] {
        self.mean.as_slice()
    }

    pub(super) fn sigma(&self) -> f64 {
        self.sigma
    }

    /// The step that a standard normal vector stands for.
    pub(super) fn step(&self, normal: &DVector<f64>) -> Step {
        Step { direction: self.covariance.shape(normal), length: normal.norm() }
    }

    /// The step to `inner`, shortened (then `true`) where it would hardly ever have been drawn: Hansen,
    /// *Injecting External Solutions Into CMA-ES*, 2011 (arXiv:1110.4181).
    pub(super) fn step_to(&self, inner: Vec<f64>) -> (Step, bool) {
        let direction = (DVector::from_vec(inner) - &self.mean) / self.sigma;
        let length = self.covariance.whiten(&direction).norm();
        let n = self.mean.len() as f64;
        let longest = n.sqrt() + 2.0 * n / (n + 2.0);
        if length > longest {
            (Step { direction: direction * (longest / length), length: longest }, true)
        } else {
            (Step { direction, length }, false)
        }
    }

    /// The standard normal vector that leads to `inner`.
    pub(super) fn whitened(&self, inner: Vec<f64>) -> DVector<f64> {
        self.covariance.unshape(&((DVector::from_vec(inner) - &self.mean) / self.sigma))
    }

    /// Where a step leads, in inner coordinates.
    pub(super) fn at(&self, step: &Step) -> Vec<f64> {
        (&self.mean + self.sigma * &step.direction).as_slice().to_vec()
    }

    /// Moves mean, step size and covariance by the steps of a generation, best first.
    pub(super) fn update(&mut self, strategy: &Strategy, generation: usize, ranked: &[&Step]) {
        let n = self.mean.len() as f64;
        let Strategy { weights, mu, mu_eff, c_sigma, d_sigma, c_c, c_1, c_mu, chi_n, eigen_gap } = strategy;

        let mut mean_step = DVector::zeros(self.mean.len());
        for (weight, step) in weights.iter().zip(ranked).take(*mu) {
            mean_step.axpy(*weight, &step.direction, 1.0);
        }
        self.mean.axpy(self.sigma, &mean_step, 1.0);

        self.sigma_path *= 1.0 - c_sigma;
        let share = (c_sigma * (2.0 - c_sigma) * mu_eff).sqrt();
        self.sigma_path.axpy(share, &self.covariance.whiten(&mean_step), 1.0);
        let length = self.sigma_path.norm();

        // While σ is still catching up, the covariance path would only learn its length.
        let settled = (1.0 - (1.0 - c_sigma).powf(2.0 * generation as f64)).sqrt();
        let hold = if length / settled < (1.4 + 2.0 / (n + 1.0)) * chi_n { 1.0 } else { 0.0 };
        self.path *= 1.0 - c_c;
        self.path.axpy(hold * (c_c * (2.0 - c_c) * mu_eff).sqrt(), &mean_step, 1.0);

        let lost = (1.0 - hold) * c_c * (2.0 - c_c);
        let keep = 1.0 + c_1 * lost - c_1 - c_mu * weights.iter().sum::<f64>();
        let rank_mu = weights.iter().zip(ranked).map(|(&weight, step)| {
            // A bad step counts by its direction alone, so that C stays positive definite.
            let scale = if weight < 0.0 { n / step.length.powi(2).max(f64::MIN_POSITIVE) } else { 1.0 };
            (c_mu * weight * scale, &step.direction)
        });
        self.covariance.update(keep, std::iter::once((*c_1, &self.path)).chain(rank_mu));

        self.sigma *= (c_sigma / d_sigma * (length / chi_n - 1.0)).min(1.0).exp();

        if generation >= self.covariance.decomposed_at() + eigen_gap {
            self.decompose(generation);
        }
    }

    /// Widens the step size where a generation has taught nothing.
    pub(super) fn widen(&mut self, strategy: &Strategy) {
        self.sigma *= (0.2 + strategy.c_sigma / strategy.d_sigma).exp();
    }

    /// Narrows every coordinate whose standard deviation is above its `greatest`.
    pub(super) fn hold_under(&mut self, generation: usize, greatest: impl Fn(usize) -> f64) {
        let mut narrowed = false;
        for i in 0..self.mean.len() {
            let factor = greatest(i) / (self.sigma * self.covariance.deviation(i));
            if factor < 1.0 {
                self.covariance.narrow(i, factor);
                self.path[i] *= factor;
                narrowed = true;
            }
        }
        if narrowed {
            self.decompose(generation);
        }
    }

    /// Whether steps are below `tolerance`, or below what the mean can resolve, in every coordinate.
    pub(super) fn is_within(&self, tolerance: f64) -> bool {
        (0..self.mean.len()).all(|i| {
            let step = self.sigma * self.covariance.deviation(i).max(self.path[i].abs());
            step < tolerance || 0.2 * step < f64::EPSILON * self.mean[i].abs()
        })
    }

    /// The greatest standard deviation along any axis.
    pub(super) fn widest(&self) -> f64 {
        self.sigma * self.covariance.longest()
    }

    /// Condition number of the covariance.
    pub(super) fn condition(&self) -> f64 {
        self.covariance.condition()
    }

    fn decompose(&mut self, generation: usize) {
        if !self.covariance.decompose(generation) {
            self.path.fill(0.0);
            self.sigma_path.fill(0.0);
        }
    }
}
