// SPDX-License-Identifier: MIT OR Apache-2.0
//! The search for box scales: objective, presets, CMA-ES, and the gauge that pins the outcome (paper §4).

mod cmaes;
mod comparison;
mod footing;
mod gauge;
mod images;
mod inherit;
mod novelty;
mod objective;
mod preset;
mod prompt;
mod run;
mod space;
mod surrogate;
mod target;

pub use cmaes::{Bounds, CmaEs, CmaEsOptions, SearchError, StopReason};
pub use comparison::Comparison;
pub use footing::Footing;
pub use gauge::{Gauge, KeepPlace, KeepSize};
pub use images::{ImagePlan, Views};
pub use inherit::inherit;
pub use novelty::{Novelty, Sketch};
pub use objective::{Evaluation, Objective, ObjectiveError};
pub use preset::{Budget, BudgetError, Preset};
pub use prompt::{Part, PromptError, TEMPLATES, Wording, parts};
pub use run::{Search, Start};
pub use space::{SCALE_RANGE, SearchSpace, SpaceError};
pub use target::Target;
