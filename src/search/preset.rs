// SPDX-License-Identifier: MIT OR Apache-2.0
//! Presets: how much is spent on the search, and where.

use crate::boxdef::{Boundary, Symmetry};
use crate::render::BACKGROUNDS;

/// Weight of the normal error in the loss.
pub const NORMAL_WEIGHT: f64 = 0.25;

/// The images that score one candidate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImagePlan {
    /// Every view before every background, as in the paper.
    All,
    /// Every view once, the backgrounds taken in turn: a third of the images, and no background favoured.
    InTurn,
}

impl ImagePlan {
    /// The (view, background) pairs of one candidate.
    #[must_use]
    pub fn pairs(self, views: usize) -> Vec<(usize, usize)> {
        match self {
            Self::All => (0..views).flat_map(|v| (0..BACKGROUNDS.len()).map(move |b| (v, b))).collect(),
            Self::InTurn => (0..views).map(|v| (v, v % BACKGROUNDS.len())).collect(),
        }
    }
}

/// A budget for the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// Split counts tried, one after another; the best by all images is kept.
    pub splits: &'static [u32],
    /// Symmetry of the part boxes.
    pub symmetry: Symmetry,
    /// How parts follow each other where they meet.
    pub boundary: Boundary,
    /// Candidates a generation: `base + per_log · ln(dimensions)`.
    pub population: (f64, f64),
    /// First step size, in units of x.
    pub sigma: f64,
    /// Whether later split counts start from the best so far ([`super::inherit`]) instead of from scratch.
    pub inherit: bool,
    /// Further searches, from scratch and with wide steps, as long as the prompt is not clear of its rivals or the
    /// outcome crosses itself.
    pub restarts: usize,
    /// Share of the triangles that may cross others in an outcome over those of the mesh; one that has more is
    /// kept only for want of another.
    pub max_crossing: Option<f64>,
    /// Generations at most, a search.
    pub max_generations: usize,
    /// Stops when the loss changes less than this.
    pub tol_fun: f64,
    /// Images that score a candidate during the search.
    pub images: ImagePlan,
    /// Weight, in the loss, of looking like another name the guide was taught ([`super::Target`]).
    pub rival_weight: f64,
    /// Weight, in the loss, of falling short of what a comparative asks for ([`super::Comparison`]).
    pub comparison_weight: f64,
    /// Weight, in the loss, of scaling the parts unevenly.
    pub effort_weight: f64,
    /// Whether parts that stand on the floor together stay so ([`super::Footing`]).
    pub footing: bool,
}

impl Preset {
    /// The protocol of the reference program, to the letter.
    pub const PAPER: Self = Self {
        name: "paper",
        splits: &[2, 3, 4],
        symmetry: Symmetry::X,
        boundary: Boundary::Paper,
        population: (12.0, 9.0),
        sigma: 1.0,
        inherit: false,
        restarts: 0,
        max_crossing: None,
        max_generations: 80,
        tol_fun: 1e-4,
        images: ImagePlan::All,
        rival_weight: 0.0,
        comparison_weight: 0.0,
        effort_weight: 0.0,
        footing: false,
    };

    /// A result in seconds.
    pub const STANDARD: Self = Self {
        name: "standard",
        splits: &[2, 3, 4],
        symmetry: Symmetry::Auto,
        boundary: Boundary::Smooth,
        population: (4.0, 3.5),
        sigma: 0.5,
        inherit: true,
        restarts: 1,
        max_crossing: Some(0.015),
        max_generations: 36,
        tol_fun: 1e-4,
        images: ImagePlan::InTurn,
        rival_weight: 1.0,
        comparison_weight: 1.0,
        effort_weight: 0.05,
        footing: true,
    };

    /// All presets.
    pub const ALL: [Self; 2] = [Self::STANDARD, Self::PAPER];

    /// The preset of this name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|preset| preset.name == name)
    }

    /// Candidates a generation for `dimensions` search variables.
    #[must_use]
    pub fn population(&self, dimensions: usize) -> usize {
        (self.population.0 + self.population.1 * (dimensions as f64).ln()).floor() as usize
    }
}
