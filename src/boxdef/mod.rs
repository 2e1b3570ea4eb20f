// SPDX-License-Identifier: MIT OR Apache-2.0
//! Mesh to deformation field: occupancy, part boxes, `BoxDefGraph`, field (paper §3).

mod error;
mod field;
mod frame;
mod graph;
mod nearest;
mod parts;
mod propagate;

pub use error::BoxDefError;
pub use field::DeformField;
pub use graph::BoxDefGraph;
pub use parts::Parts;
