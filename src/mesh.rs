// SPDX-License-Identifier: MIT OR Apache-2.0
//! The triangle mesh that everything starts from.

use glam::Vec3;
use thiserror::Error;

/// Why arrays do not make a mesh.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
pub enum MeshError {
    /// There is nothing to deform.
    #[error("the mesh has no vertices; give an object with some geometry")]
    NoVertices,
}

/// A triangle mesh in object coordinates: any unit, z up. Checked when made, never changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// Checks and takes the arrays.
    pub fn new(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if vertices.is_empty() {
            return Err(MeshError::NoVertices);
        }
        Ok(Self { vertices, triangles })
    }

    /// Positions, one per vertex.
    #[must_use]
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// Vertex indices, three per triangle.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }
}
