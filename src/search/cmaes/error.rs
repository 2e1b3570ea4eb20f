// SPDX-License-Identifier: MIT OR Apache-2.0
//! Why a search cannot be set up, fed or resumed.

use thiserror::Error;

/// Why a search cannot be set up, fed or resumed.
#[derive(Debug, Error, Clone, PartialEq)]
pub enum SearchError {
    /// There is nothing to search.
    #[error("the search has no coordinates; give a start with at least one")]
    NoCoordinates,
    /// A start coordinate is NaN or infinite.
    #[error("coordinate {coordinate} of the start is {value}; give a finite number")]
    StartNotFinite {
        /// Index of the coordinate.
        coordinate: usize,
        /// Its value.
        value: f64,
    },
    /// A start coordinate lies outside its bounds.
    #[error("coordinate {coordinate} of the start, {value}, lies outside [{lower}, {upper}]; move it inside")]
    StartOutside {
        /// Index of the coordinate.
        coordinate: usize,
        /// Its value.
        value: f64,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// The first step is not a positive number.
    #[error("the first step size is {0}; give a finite number above 0")]
    Sigma(f64),
    /// A pair of bounds leaves no room.
    #[error("the bounds [{lower}, {upper}] leave no room; the lower must be less than the upper")]
    EmptyBounds {
        /// The lower bound.
        lower: f64,
        /// The upper bound.
        upper: f64,
    },
    /// There are not as many bounds as coordinates.
    #[error("there are {got} pairs of bounds for {expected} coordinates; give one pair for each")]
    BoundsCount {
        /// Number of coordinates.
        expected: usize,
        /// Number of pairs of bounds.
        got: usize,
    },
    /// The population is too small to rank.
    #[error("a population of {0} is too small; give at least 4")]
    Population(usize),
    /// Scores came before candidates.
    #[error("scores were told before any candidate was asked for; call ask first")]
    NothingAsked,
    /// There are not as many scores as candidates.
    #[error("{got} scores were told for {expected} candidates; tell one score for each, in their order")]
    ScoreCount {
        /// Number of candidates.
        expected: usize,
        /// Number of scores.
        got: usize,
    },
    /// An injected candidate does not fit the search.
    #[error("the injected candidate does not fit; give {expected} finite numbers, each within its bounds")]
    Injected {
        /// Number of coordinates.
        expected: usize,
    },
    /// A saved state contradicts itself.
    #[error("the saved search is damaged ({0}); start the search anew")]
    DamagedState(&'static str),
}
