// SPDX-License-Identifier: MIT OR Apache-2.0
//! What of a search is written down, and how it is taken up again.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{
    ask_tell::{Candidate, CmaEs},
    distribution::Distribution,
    error::SearchError,
    exact,
    options::CmaEsOptions,
    stop::{History, StopReason},
};

/// A search at rest: all that does not follow from its options.
#[derive(Serialize, Deserialize)]
struct Saved {
    options: CmaEsOptions,
    /// Random words drawn so far.
    drawn: u64,
    distribution: Distribution,
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

impl Serialize for CmaEs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Saved::from(self.clone()).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for CmaEs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Saved::deserialize(deserializer)?.try_into().map_err(D::Error::custom)
    }
}

impl From<CmaEs> for Saved {
    fn from(search: CmaEs) -> Self {
        Self {
            drawn: search.rng.get_word_pos() as u64,
            options: search.options,
            distribution: search.distribution,
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
        let n = search.options.coordinates();
        if !saved.distribution.fits(n) {
            return Err(SearchError::DamagedState("its arrays do not fit its start"));
        }
        let fits = |candidate: &Candidate| candidate.x.len() == n && candidate.step.fits(n);
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
        search.distribution = saved.distribution;
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
