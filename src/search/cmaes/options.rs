// SPDX-License-Identifier: MIT OR Apache-2.0
//! How a search starts and when it ends.

use serde::{Deserialize, Serialize};

use super::{bounds::Bounds, error::SearchError, exact, strategy::Strategy};

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

impl CmaEsOptions {
    /// Number of coordinates, n.
    pub(super) fn coordinates(&self) -> usize {
        self.start.len()
    }

    /// Checks all but the bounds; returns the population.
    pub(super) fn checked_population(&self) -> Result<usize, SearchError> {
        let n = self.coordinates();
        if n == 0 {
            return Err(SearchError::NoCoordinates);
        }
        if let Some(coordinate) = self.start.iter().position(|value| !value.is_finite()) {
            return Err(SearchError::StartNotFinite { coordinate, value: self.start[coordinate] });
        }
        if !(self.sigma > 0.0 && self.sigma.is_finite()) {
            return Err(SearchError::Sigma(self.sigma));
        }
        match self.population {
            None => Ok(Strategy::default_population(n).max(LEAST_POPULATION)),
            Some(population) if population >= LEAST_POPULATION => Ok(population),
            Some(population) => Err(SearchError::Population(population)),
        }
    }
}
