// SPDX-License-Identifier: MIT OR Apache-2.0
//! The search for box scales: objective, CMA-ES with ask and tell, and the gauge that pins its outcome (paper §4).

mod bounds;
mod cmaes;
mod covariance;
mod error;
mod exact;
mod gauge;
mod objective;
mod preset;
mod run;
mod saved;
mod stop;
mod strategy;

pub use bounds::Bounds;
pub use cmaes::{CmaEs, CmaEsOptions};
pub use error::SearchError;
pub use gauge::{Gauge, KeepPlace, KeepSize};
pub use objective::{Evaluation, Objective, ObjectiveError};
pub use preset::{ImagePlan, NORMAL_WEIGHT, Preset};
pub use run::{Found, Generation, search};
pub use stop::StopReason;
