// SPDX-License-Identifier: MIT OR Apache-2.0
//! The search for box scales: CMA-ES with ask and tell, and the gauge that pins its outcome (paper §4).

mod bounds;
mod cmaes;
mod covariance;
mod distribution;
mod error;
mod exact;
mod gauge;
mod options;
mod saved;
mod stop;
mod strategy;

pub use bounds::Bounds;
pub use cmaes::CmaEs;
pub use error::SearchError;
pub use gauge::{Gauge, KeepPlace, KeepSize};
pub use options::CmaEsOptions;
pub use stop::StopReason;
