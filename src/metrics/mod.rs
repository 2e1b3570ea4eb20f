// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a deformation did to a surface: curvature, normals, self-intersections (paper §5).

mod curvature;
mod intersection;
mod normals;
mod overlaps;
mod triangles;

pub use curvature::gaussian_curvature_change;
pub use intersection::self_intersection_ratio;
pub use normals::normal_error;

use glam::Vec3;
use thiserror::Error;

use crate::mesh::Mesh;

/// Why positions cannot be compared with a mesh.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
pub enum MetricsError {
    /// The positions are not those of the mesh's vertices.
    #[error("there are {found} positions for {expected} vertices; give one for each vertex of the mesh")]
    Length {
        /// Positions given.
        found: usize,
        /// Vertices of the mesh.
        expected: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("position {vertex} has a coordinate that is not a finite number")]
    NotFinite {
        /// First such position.
        vertex: usize,
    },
}

fn check(mesh: &Mesh, vertices: &[Vec3]) -> Result<(), MetricsError> {
    let (found, expected) = (vertices.len(), mesh.vertices().len());
    if found != expected {
        return Err(MetricsError::Length { found, expected });
    }
    match vertices.iter().position(|v| !v.is_finite()) {
        Some(vertex) => Err(MetricsError::NotFinite { vertex }),
        None => Ok(()),
    }
}
