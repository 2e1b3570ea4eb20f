// SPDX-License-Identifier: MIT OR Apache-2.0
//! The triangle mesh that everything starts from.

use glam::{DVec3, Vec3};
use thiserror::Error;

/// Why arrays do not make a mesh.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
pub enum MeshError {
    /// There is nothing to deform.
    #[error("the mesh has no vertices; give an object with some geometry")]
    NoVertices,
    /// There are points, but no surface.
    #[error("the mesh has no faces; give an object with a surface, not only points or edges")]
    NoTriangles,
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not a finite number; repair or delete it")]
    NotFinite {
        /// Index of the first such vertex.
        vertex: usize,
    },
    /// A coordinate or an extent overflows single precision in what follows.
    #[error("vertex {vertex} lies beyond 1e15 units from the origin; scale the object down")]
    TooFar {
        /// Index of the first such vertex.
        vertex: usize,
    },
    /// A triangle names a vertex that is not there.
    #[error(
        "triangle {triangle} uses vertex {vertex}, but there are only {count} vertices; check the indices"
    )]
    IndexOutOfRange {
        /// Index of the first such triangle.
        triangle: usize,
        /// The index that it names.
        vertex: u32,
        /// Number of vertices.
        count: usize,
    },
    /// All vertices of the surface lie in one point.
    #[error("all faces of the mesh lie in one point; give an object with some size")]
    NoExtent,
    /// The surface has no area: all triangles are points or lines.
    #[error("all faces of the mesh have zero area; give an object with a surface")]
    NoArea,
}

/// The farthest coordinate accepted: squares of lengths stay well inside single precision.
const FARTHEST: f32 = 1e15;

/// A triangle mesh in object coordinates: any unit, z up. Checked when made, never changed.
///
/// Every coordinate is finite, every index valid, and at least one triangle has an area. Vertices that no
/// triangle uses, duplicate vertices and single triangles without area are allowed.
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
        if triangles.is_empty() {
            return Err(MeshError::NoTriangles);
        }
        if let Some(vertex) = vertices.iter().position(|v| !v.is_finite()) {
            return Err(MeshError::NotFinite { vertex });
        }
        if let Some(vertex) = vertices.iter().position(|v| v.abs().max_element() > FARTHEST) {
            return Err(MeshError::TooFar { vertex });
        }
        let count = vertices.len();
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&i| i as usize >= count) {
                return Err(MeshError::IndexOutOfRange { triangle, vertex, count });
            }
        }
        let mesh = Self { vertices, triangles };
        let (low, high) = mesh.surface_bounds();
        let extent = (high - low).max_element();
        if extent == 0.0 {
            return Err(MeshError::NoExtent);
        }
        // Relative to the size, so that the check does not depend on the unit; 1e-12 is far below what a
        // triangle of single-precision corners can mean.
        let least = 1e-12 * extent * extent;
        if !mesh.triangles.iter().any(|&t| face_cross(&mesh.vertices, t).length() > least) {
            return Err(MeshError::NoArea);
        }
        Ok(mesh)
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

    /// Lowest and highest corner of the box around the vertices that triangles use, in double precision.
    ///
    /// Stray vertices are left out: they are not part of what is seen.
    #[must_use]
    pub fn surface_bounds(&self) -> (DVec3, DVec3) {
        let corners = self.triangles.iter().flatten().map(|&i| self.vertices[i as usize]);
        let (low, high) =
            corners.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        (low.as_dvec3(), high.as_dvec3())
    }

    /// Vertex normals of this topology at other `positions` (n): the unweighted mean of the unit normals
    /// of a vertex's triangles, of unit length.
    ///
    /// Triangles without area are left out; a vertex without any other triangle gets NaN.
    ///
    /// # Panics
    /// If `positions` has not one position per vertex.
    #[must_use]
    pub fn vertex_normals(&self, positions: &[Vec3]) -> Vec<Vec3> {
        let mut sums = Vec::new();
        self.normals_at(positions, &mut sums).collect()
    }

    /// The same, one after another; `sums` is working memory.
    pub(crate) fn normals_at(&self, positions: &[Vec3], sums: &mut Vec<DVec3>) -> impl Iterator<Item = Vec3> {
        assert_eq!(positions.len(), self.vertices.len(), "one position per vertex");
        sums.clear();
        sums.resize(positions.len(), DVec3::ZERO);
        for &triangle in &self.triangles {
            if let Some(normal) = face_cross(positions, triangle).try_normalize() {
                for i in triangle {
                    sums[i as usize] += normal;
                }
            }
        }
        sums.iter().map(|sum| sum.try_normalize().unwrap_or(DVec3::NAN).as_vec3())
    }
}

/// Twice the area of a triangle, along its normal.
fn face_cross(positions: &[Vec3], [a, b, c]: [u32; 3]) -> DVec3 {
    let corner = |i: u32| positions[i as usize].as_dvec3();
    (corner(b) - corner(a)).cross(corner(c) - corner(a))
}
