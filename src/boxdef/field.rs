// SPDX-License-Identifier: MIT OR Apache-2.0
//! The deformation field: a deformation as one small matrix product.

use glam::Vec3;

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
        out.copy_from_slice(&self.rest);
        let n = self.rest.len();
        for axis in 0..3 {
            for (row, factor) in factors.iter().enumerate() {
                let change = factor[axis] - 1.0;
                if change == 0.0 {
                    continue;
                }
                let start = (axis * factors.len() + row) * n;
                for (position, b) in out.iter_mut().zip(&self.basis[start..start + n]) {
                    position[axis] += change * b;
                }
            }
        }
    }

    /// The positions for `factors`, as a new vector.
    #[must_use]
    pub fn deform(&self, factors: &[Vec3]) -> Vec<Vec3> {
        let mut out = vec![Vec3::ZERO; self.rest.len()];
        self.deform_into(factors, &mut out);
        out
    }
}
