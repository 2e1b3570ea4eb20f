// SPDX-License-Identifier: MIT OR Apache-2.0
//! Presets: how much is spent on the search, and where.

use thiserror::Error;

use super::ImagePlan;
use super::target::MARGIN;
use crate::boxdef::{Boundary, Symmetry};

/// Weight of the normal error in the loss.
pub const NORMAL_WEIGHT: f64 = 0.25;

/// What a search from coarse to fine may cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Budget {
    /// Images encoded.
    Images(usize),
    /// Seconds from the start of the job.
    Seconds(f64),
}

/// The least and the most that a budget can be, in images and in seconds.
const IMAGES: (usize, usize) = (100, 10_000_000);
const SECONDS: (f64, f64) = (0.5, 86_400.0);

/// A budget that cannot be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum BudgetError {
    /// Too few images, or too many.
    #[error("a budget of images is from {} to {}", IMAGES.0, IMAGES.1)]
    Images,
    /// Too little time, or too much.
    #[error("a budget of seconds is from {} to {}", SECONDS.0, SECONDS.1)]
    Seconds,
    /// The preset takes what it takes.
    #[error("preset \"{0}\" takes no budget: choose another preset, or give no budget")]
    Preset(&'static str),
}

/// How to search, and what counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// What may be spent on a search from coarse to fine; `None` searches each split count from scratch and to its
    /// end.
    pub budget: Option<Budget>,
    /// Split counts tried, one after another, from few parts to many; the best by all images is kept.
    pub splits: &'static [u32],
    /// Symmetry of the part boxes.
    pub symmetry: Symmetry,
    /// How parts follow each other where they meet.
    pub boundary: Boundary,
    /// Candidates a generation: `base + per_log · ln(dimensions)`.
    pub population: (f64, f64),
    /// First step size, in units of x.
    pub sigma: f64,
    /// Share of the triangles that may cross others in an outcome over those of the mesh; one that has more goes
    /// back towards the mesh until it has not, or is kept for want of another.
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
        budget: None,
        splits: &[2, 3, 4],
        symmetry: Symmetry::X,
        boundary: Boundary::Paper,
        population: (12.0, 9.0),
        sigma: 1.0,
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
        budget: Some(Budget::Images(4400)),
        splits: &[2, 3, 4],
        symmetry: Symmetry::Auto,
        boundary: Boundary::Smooth,
        population: (6.0, 2.0),
        sigma: 1.0,
        max_crossing: Some(0.015),
        max_generations: usize::MAX,
        tol_fun: 1e-4,
        images: ImagePlan::Distinct,
        rival_weight: 1.5,
        comparison_weight: 1.0,
        effort_weight: 0.02,
        footing: true,
    };

    /// A first look.
    pub const DRAFT: Self = Self { name: "draft", budget: Some(Budget::Images(1400)), ..Self::STANDARD };

    /// As good as it gets.
    pub const BEST: Self = Self { name: "best", budget: Some(Budget::Images(22_500)), ..Self::STANDARD };

    /// All presets, the cheapest first.
    pub const ALL: [Self; 4] = [Self::DRAFT, Self::STANDARD, Self::BEST, Self::PAPER];

    /// The preset of this name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|preset| preset.name == name)
    }

    /// This preset with another budget.
    pub fn with_budget(self, budget: Budget) -> Result<Self, BudgetError> {
        let (least, most) = IMAGES;
        let (shortest, longest) = SECONDS;
        match budget {
            _ if self.budget.is_none() => Err(BudgetError::Preset(self.name)),
            Budget::Images(images) if !(least..=most).contains(&images) => Err(BudgetError::Images),
            Budget::Seconds(s) if !(shortest..=longest).contains(&s) => Err(BudgetError::Seconds),
            budget => Ok(Self { budget: Some(budget), ..self }),
        }
    }

    /// This preset with the loss of the paper: the score and the normal error, and nothing else.
    #[must_use]
    pub fn with_paper_loss(self) -> Self {
        let Self { max_crossing, rival_weight, comparison_weight, effort_weight, footing, .. } = Self::PAPER;
        Self { max_crossing, rival_weight, comparison_weight, effort_weight, footing, ..self }
    }

    /// Whether its loss is the paper's.
    #[must_use]
    pub fn has_paper_loss(&self) -> bool {
        *self == self.with_paper_loss()
    }

    /// For a search in which candidates of different generations are compared: all are seen by the same images.
    #[must_use]
    pub fn for_variations(self) -> Self {
        Self { max_generations: 36, images: ImagePlan::InTurn, population: (4.0, 3.5), ..self }
    }

    /// Without rivals, for a search on the way to another.
    #[must_use]
    pub fn without_rivals(self) -> Self {
        Self { rival_weight: 0.0, ..self }
    }

    /// For a search in which nothing counts but the score and what was asked for, where another found nothing.
    #[must_use]
    pub fn for_score_alone(self) -> Self {
        Self { rival_weight: 0.0, effort_weight: 0.0, ..self.for_variations() }
    }

    /// Rivalry, as weighted, of a shape that looks as much like another name as like the prompt.
    #[must_use]
    pub fn tie(&self) -> f64 {
        self.rival_weight * MARGIN
    }

    /// Candidates a generation for `dimensions` search variables.
    #[must_use]
    pub fn population(&self, dimensions: usize) -> usize {
        (self.population.0 + self.population.1 * (dimensions as f64).ln()).floor() as usize
    }
}
