// SPDX-License-Identifier: MIT OR Apache-2.0
//! CMA-ES with ask and tell (Hansen, arXiv:1604.00772). Knows nothing of meshes or guides.

mod ask_tell;
mod bounds;
mod covariance;
mod distribution;
mod error;
mod exact;
mod options;
mod saved;
mod stop;
mod strategy;

pub use ask_tell::CmaEs;
pub use bounds::Bounds;
pub use error::SearchError;
pub use options::CmaEsOptions;
pub use stop::StopReason;
