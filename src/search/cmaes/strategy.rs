// SPDX-License-Identifier: MIT OR Apache-2.0
//! The constants of CMA-ES: Hansen, *The CMA Evolution Strategy: A Tutorial*, 2016 (arXiv:1604.00772),
//! Table 1. Names follow the tutorial.

/// Constants that follow from the number of coordinates n and the population λ.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strategy {
    /// Recombination weights by rank, best first: the positive sum to 1, the negative speed up the
    /// shrinking of bad directions (active update).
    pub(super) weights: Vec<f64>,
    /// Number of positive weights.
    pub(super) mu: usize,
    /// Variance-effective selection mass of the positive weights.
    pub(super) mu_eff: f64,
    /// Rate of the step-size path.
    pub(super) c_sigma: f64,
    /// Damping of the step size.
    pub(super) d_sigma: f64,
    /// Rate of the covariance path.
    pub(super) c_c: f64,
    /// Rate of the rank-one update.
    pub(super) c_1: f64,
    /// Rate of the rank-μ update.
    pub(super) c_mu: f64,
    /// Expected length of a standard normal vector.
    pub(super) chi_n: f64,
    /// Generations between two eigen decompositions.
    pub(super) eigen_gap: usize,
}

impl Strategy {
    /// The default population, ⌊4 + 3 ln n⌋.
    pub(super) fn default_population(n: usize) -> usize {
        (4.0 + 3.0 * (n as f64).ln()).floor() as usize
    }

    pub(super) fn new(n: usize, population: usize) -> Self {
        let dimension = n as f64;
        let lambda = population as f64;
        let raw: Vec<f64> =
            (1..=population).map(|rank| f64::midpoint(lambda, 1.0).ln() - (rank as f64).ln()).collect();
        let mu = population / 2;
        let (good, bad) = raw.split_at(mu);
        let (mu_eff, mu_eff_bad) = (selection_mass(good), selection_mass(bad));

        let c_sigma = (mu_eff + 2.0) / (dimension + mu_eff + 5.0);
        let d_sigma = 1.0 + 2.0 * (((mu_eff - 1.0) / (dimension + 1.0)).sqrt() - 1.0).max(0.0) + c_sigma;
        let c_c = (4.0 + mu_eff / dimension) / (dimension + 4.0 + 2.0 * mu_eff / dimension);
        let c_1 = 2.0 / ((dimension + 1.3).powi(2) + mu_eff);
        let rank_mu = 2.0 * (0.25 + mu_eff + 1.0 / mu_eff - 2.0) / ((dimension + 2.0).powi(2) + mu_eff);
        let c_mu = rank_mu.min(1.0 - c_1);

        // The negative weights sum to the least of: balance with the rank-one update, balance with their
        // own selection mass, and what keeps the covariance positive definite.
        let balance = 1.0 + c_1 / c_mu;
        let mass = 1.0 + 2.0 * mu_eff_bad / (mu_eff + 2.0);
        let definite = (1.0 - c_1 - c_mu) / (dimension * c_mu);
        let negative = balance.min(mass).min(definite);
        let (good_sum, bad_sum): (f64, f64) = (good.iter().sum(), bad.iter().map(|w| w.abs()).sum());
        let weights =
            raw.iter().map(|&w| if w >= 0.0 { w / good_sum } else { negative * w / bad_sum }).collect();

        Self {
            weights,
            mu,
            mu_eff,
            c_sigma,
            d_sigma,
            c_c,
            c_1,
            c_mu,
            chi_n: dimension.sqrt() * (1.0 - 1.0 / (4.0 * dimension) + 1.0 / (21.0 * dimension * dimension)),
            eigen_gap: (1.0 / ((c_1 + c_mu) * dimension * 10.0)).floor().max(1.0) as usize,
        }
    }
}

/// (Σw)² / Σw².
fn selection_mass(weights: &[f64]) -> f64 {
    weights.iter().sum::<f64>().powi(2) / weights.iter().map(|w| w * w).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn weights_fall_and_the_positive_ones_sum_to_one() {
        for n in 1..40 {
            for population in [4, 5, Strategy::default_population(n).max(4), 36, 200] {
                let strategy = Strategy::new(n, population);
                assert!(strategy.weights.is_sorted_by(|a, b| a >= b));
                assert_relative_eq!(
                    strategy.weights[..strategy.mu].iter().sum::<f64>(),
                    1.0,
                    epsilon = 1e-12
                );
                let bad: f64 = strategy.weights[strategy.mu..].iter().sum();
                let kept = 1.0 - strategy.c_1 - strategy.c_mu;
                assert!(kept + n as f64 * strategy.c_mu * bad >= -1e-12, "covariance can lose definiteness");
            }
        }
    }
}
