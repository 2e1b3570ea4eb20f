// SPDX-License-Identifier: MIT OR Apache-2.0
//! The deformation field: a deformation as one small matrix product.

use glam::Vec3;
use rayon::prelude::*;

/// Vertices that are deformed at a time.
const PIECE: usize = 16_384;

/// The linear map from factors to vertex positions.
///
/// *Factors* are rows of three, one for each parameter row: P scale factors and, where parts may be shifted, P
/// shifts, as 1 + shift over the object's reach. A row of ones changes nothing. With `c` the factors,
/// `V_a(c) = V_a + Σ_p (c[p,a] − 1) · B[a,p]` for each axis `a`: nothing crosses axes.
#[derive(Debug, Clone, PartialEq)]
pub struct DeformField {
    rest: Vec<Vec3>,
    scale_rows: usize,
    shift_rows: usize,
    basis: Vec<f32>,
}

impl DeformField {
    /// Takes the undeformed positions and the basis of scale factors, `3 × scale_rows × vertices` row-major
    /// (axis, parameter row, vertex).
    ///
    /// # Panics
    /// If the basis has another length.
    #[must_use]
    pub fn new(rest: Vec<Vec3>, scale_rows: usize, basis: Vec<f32>) -> Self {
        Self::with_shifts(rest, scale_rows, 0, basis)
    }

    /// The same with rows for shifts after those for scale factors.
    ///
    /// # Panics
    /// If the basis has another length than `3 × (scale_rows + shift_rows) × vertices`.
    #[must_use]
    pub fn with_shifts(rest: Vec<Vec3>, scale_rows: usize, shift_rows: usize, basis: Vec<f32>) -> Self {
        assert_eq!(basis.len(), 3 * (scale_rows + shift_rows) * rest.len(), "basis is 3 × rows × n");
        Self { rest, scale_rows, shift_rows, basis }
    }

    /// Undeformed positions.
    #[must_use]
    pub fn rest(&self) -> &[Vec3] {
        &self.rest
    }

    /// Number of vertices, n.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.rest.len()
    }

    /// Number of rows of factors.
    #[must_use]
    pub fn parameter_rows(&self) -> usize {
        self.scale_rows + self.shift_rows
    }

    /// Number of the rows that are scale factors, P; the others are shifts.
    #[must_use]
    pub fn scale_rows(&self) -> usize {
        self.scale_rows
    }

    /// Factors that change nothing.
    #[must_use]
    pub fn unchanged(&self) -> Vec<Vec3> {
        vec![Vec3::ONE; self.parameter_rows()]
    }

    /// The basis, `3 × rows × n` row-major.
    #[must_use]
    pub fn basis(&self) -> &[f32] {
        &self.basis
    }

    /// Writes the positions for `factors` into `out` (n).
    ///
    /// # Panics
    /// If a length differs.
    pub fn deform_into(&self, factors: &[Vec3], out: &mut [Vec3]) {
        assert_eq!(factors.len(), self.parameter_rows(), "one row of factors per parameter row");
        assert_eq!(out.len(), self.rest.len(), "one position per vertex");
        let n = self.rest.len();
        // Piece by piece, so that positions stay in the cache while the rows pass.
        out.par_chunks_mut(PIECE).enumerate().for_each(|(piece, out)| {
            let first = piece * PIECE;
            out.copy_from_slice(&self.rest[first..first + out.len()]);
            for axis in 0..3 {
                for (row, factor) in factors.iter().enumerate() {
                    let change = factor[axis] - 1.0;
                    if change == 0.0 {
                        continue;
                    }
                    let start = (axis * factors.len() + row) * n + first;
                    for (position, b) in out.iter_mut().zip(&self.basis[start..]) {
                        position[axis] += change * b;
                    }
                }
            }
        });
    }

    /// The field of some of the vertices, in the order in which they are named.
    ///
    /// # Panics
    /// If a vertex is not there.
    #[must_use]
    pub fn select(&self, vertices: &[u32]) -> Self {
        let rest = vertices.iter().map(|&v| self.rest[v as usize]).collect();
        let planes = self.basis.chunks_exact(self.rest.len().max(1));
        let basis = planes.flat_map(|plane| vertices.iter().map(|&v| plane[v as usize])).collect();
        Self { rest, basis, ..*self }
    }

    /// The positions for `factors`, as a new vector.
    #[must_use]
    pub fn deform(&self, factors: &[Vec3]) -> Vec<Vec3> {
        let mut out = vec![Vec3::ZERO; self.rest.len()];
        self.deform_into(factors, &mut out);
        out
    }
}
