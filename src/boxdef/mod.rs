// SPDX-License-Identifier: MIT OR Apache-2.0
//! Mesh to deformation field: occupancy, part boxes, `BoxDefGraph`, field (paper §3).

mod field;

pub use field::DeformField;
