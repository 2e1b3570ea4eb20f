// SPDX-License-Identifier: MIT OR Apache-2.0
//! What of a search is written down, and how it is taken up again.

use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use super::{
    cmaes::{Candidate, CmaEs, CmaEsOptions},
    covariance::Covariance,
    error::SearchError,
    exact,
    stop::{History, StopReason},
};

/// A search at rest: all that does not follow from its options.
#[derive(Serialize, Deserialize)]
pub(super) struct Saved {
    options: CmaEsOptions,
    /// Random words drawn so far.
    drawn: u64,
    #[serde(with = "exact")]
    mean: DVector<f64>,
    #[serde(with = "exact")]
    sigma: f64,
    #[serde(with = "exact")]
    covariance: DMatrix<f64>,
    #[serde(with = "exact")]
    axes: DMatrix<f64>,
    #[serde(with = "exact")]
    lengths: DVector<f64>,
    decomposed_at: usize,
    #[serde(with = "exact")]
    sigma_path: DVector<f64>,
    #[serde(with = "exact")]
    path: DVector<f64>,
    generation: usize,
    evaluations: usize,
    pending: Vec<Candidate>,
    #[serde(with = "exact")]
    injected: Vec<Vec<f64>>,
    #[serde(with = "exact")]
    best: Option<(Vec<f64>, f64)>,
    history: History,
    stop: Option<StopReason>,
}

impl From<CmaEs> for Saved {
    fn from(search: CmaEs) -> Self {
        Self {
            drawn: search.rng.get_word_pos() as u64,
            options: search.options,
            mean: search.mean,
            sigma: search.sigma,
            covariance: search.covariance.matrix,
            axes: search.covariance.axes,
            lengths: search.covariance.lengths,
            decomposed_at: search.covariance.decomposed_at,
            sigma_path: search.sigma_path,
            path: search.path,
            generation: search.generation,
            evaluations: search.evaluations,
            pending: search.pending,
            injected: search.injected,
            best: search.best,
            history: search.history,
            stop: search.stop,
        }
    }
}

impl TryFrom<Saved> for CmaEs {
    type Error = SearchError;

    fn try_from(saved: Saved) -> Result<Self, SearchError> {
        let mut search = Self::new(saved.options)?;
        let n = search.mean.len();
        let vectors = [&saved.mean, &saved.lengths, &saved.sigma_path, &saved.path];
        let matrices = [&saved.covariance, &saved.axes];
        if vectors.iter().any(|v| v.len() != n) || matrices.iter().any(|m| m.nrows() != n) {
            return Err(SearchError::DamagedState("its arrays do not fit its start"));
        }
        let fits = |candidate: &Candidate| candidate.x.len() == n && candidate.step.len() == n;
        let told = saved.pending.is_empty() || saved.pending.len() == search.population();
        if !told || !saved.pending.iter().all(fits) {
            return Err(SearchError::DamagedState("its candidates do not fit its start"));
        }
        if saved.injected.len() > search.population() || saved.injected.iter().any(|x| x.len() != n) {
            return Err(SearchError::DamagedState("its injected candidates do not fit its start"));
        }
        if saved.best.as_ref().is_some_and(|(x, _)| x.len() != n) {
            return Err(SearchError::DamagedState("its best candidate does not fit its start"));
        }
        if !saved.history.is_whole() {
            return Err(SearchError::DamagedState("its history has gaps"));
        }
        search.rng.set_word_pos(u128::from(saved.drawn));
        search.mean = saved.mean;
        search.sigma = saved.sigma;
        search.covariance = Covariance {
            matrix: saved.covariance,
            axes: saved.axes,
            lengths: saved.lengths,
            decomposed_at: saved.decomposed_at,
        };
        search.sigma_path = saved.sigma_path;
        search.path = saved.path;
        search.generation = saved.generation;
        search.evaluations = saved.evaluations;
        search.pending = saved.pending;
        search.injected = saved.injected;
        search.best = saved.best;
        search.history = saved.history;
        search.stop = saved.stop;
        Ok(search)
    }
}
