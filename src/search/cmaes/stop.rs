// SPDX-License-Identifier: MIT OR Apache-2.0
//! When a search is over, and why. The rules are those of Hansen's tutorial (arXiv:1604.00772), B.3.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::exact;

/// Generations without any difference between scores before the search gives up.
const FLAT_GENERATIONS: usize = 10;
/// How many generations are remembered at most.
const LONGEST_HISTORY: usize = 20_000;
/// Growth of the widest deviation over the first step at which the search counts as diverged.
pub(super) const DIVERGED: f64 = 1e4;

/// Why a search stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum StopReason {
    /// The scores of many generations differ by less than `tol_fun`.
    TolFun,
    /// The steps are shorter than `tol_x` in every coordinate.
    TolX,
    /// `max_generations` are done.
    MaxGenerations,
    /// Another generation would go beyond `max_evaluations`.
    MaxEvaluations,
    /// The covariance is too ill-conditioned to go on.
    Condition,
    /// Neither the best nor the median score has improved for long.
    Stagnation,
    /// Every score of many generations was the same, or none was a number.
    FlatFitness,
    /// The steps grow without end.
    Diverged,
}

impl fmt::Display for StopReason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::TolFun => "The scores no longer change.",
            Self::TolX => "The steps have become too small to matter.",
            Self::MaxGenerations => "The limit on generations is reached.",
            Self::MaxEvaluations => "The limit on evaluations is reached.",
            Self::Condition => "The search has become too lopsided to go on.",
            Self::Stagnation => "The scores have not improved for many generations.",
            Self::FlatFitness => "All candidates score the same.",
            Self::Diverged => "The steps grow without end; the score has no optimum in reach.",
        })
    }
}

/// Best and median scores of past generations.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct History {
    #[serde(with = "exact")]
    best: Vec<f64>,
    #[serde(with = "exact")]
    median: Vec<f64>,
    flat: usize,
}

impl History {
    /// Notes a generation; `ranked` holds its scores in rising order.
    pub(super) fn record(&mut self, ranked: &[f64]) {
        if self.best.len() == LONGEST_HISTORY {
            self.best.remove(0);
            self.median.remove(0);
        }
        self.best.push(ranked[0]);
        self.median.push(ranked[ranked.len() / 2]);
        self.flat = if is_flat(ranked) { self.flat + 1 } else { 0 };
    }

    /// Whether there is a median for every best score.
    pub(super) fn is_whole(&self) -> bool {
        self.best.len() == self.median.len()
    }

    pub(super) fn is_flat_for_long(&self) -> bool {
        self.flat >= FLAT_GENERATIONS
    }

    /// Whether the scores of this generation, and the best ones of the last 10 + ⌈30n/λ⌉, span less than
    /// `tol_fun`.
    pub(super) fn within_tolerance(&self, ranked: &[f64], n: usize, tol_fun: f64) -> bool {
        let window = 10 + (30 * n).div_ceil(ranked.len());
        self.best.len() >= window
            && ranked[ranked.len() - 1] - ranked[0] < tol_fun
            && span(&self.best[self.best.len() - window..]) < tol_fun
    }

    /// Whether, over the last fifth of the search and at least 120 + 30n/λ generations, neither the best
    /// nor the median score of the newer 30 % is better than that of the older 30 %.
    pub(super) fn is_stagnant(&self, generation: usize, n: usize, population: usize) -> bool {
        let window = (120 + 30 * n / population).max(generation / 5).min(LONGEST_HISTORY);
        let worse = |scores: &[f64]| {
            let recent = &scores[scores.len() - window..];
            let part = window * 3 / 10;
            middle(&recent[window - part..]) >= middle(&recent[..part])
        };
        self.best.len() >= window && worse(&self.best) && worse(&self.median)
    }
}

/// Whether all of `ranked`, in rising order, are the same.
pub(super) fn is_flat(ranked: &[f64]) -> bool {
    ranked[0].total_cmp(&ranked[ranked.len() - 1]).is_eq()
}

/// Greatest minus least; NaN, and so within no tolerance, where no score was a number.
fn span(scores: &[f64]) -> f64 {
    let least = scores.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = scores.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    greatest - least
}

fn middle(scores: &[f64]) -> f64 {
    let mut sorted = scores.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
