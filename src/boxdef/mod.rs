// SPDX-License-Identifier: MIT OR Apache-2.0
//! Mesh to deformation field: occupancy, part boxes, `BoxDefGraph`, field (paper §3).

mod assign;
mod boundary;
mod boxes;
mod connect;
mod crowd;
mod error;
mod field;
mod frame;
mod given;
mod graph;
mod ground;
mod hollow;
mod islands;
mod layout;
mod nearest;
mod occupancy;
mod openings;
mod parts;
mod profile;
mod propagate;
mod room;
mod split;
mod symmetry;
mod transfer;
mod turn;

pub use boundary::Boundary;
pub use error::BoxDefError;
pub use field::DeformField;
pub use graph::BoxDefGraph;
pub use ground::Ground;
pub use parts::Parts;
pub use symmetry::Symmetry;
pub use turn::{own_turn, turned};
