// SPDX-License-Identifier: MIT OR Apache-2.0
//! The deformation field: a deformation as one small matrix product.

use glam::Vec3;

/// The linear map from scale factors to vertex positions.
///
/// With `c` the scale factors (one row of three per parameter row, 1 = unchanged),
/// `V_a(c) = V_a + Σ_p (c[p,a] − 1) · B[a,p]` for each axis `a`: nothing crosses axes.
#[derive(Debug, Clone, PartialEq)]
pub struct DeformField {
    rest: Vec<Vec3>,
    parameter_rows: usize,
    basis: Vec<f32>,
}

impl DeformField {
    /// Takes the undeformed positions and the basis, `3 × parameter_rows × vertices` row-major
    /// (axis, parameter row, vertex).
    ///
    /// # Panics
    /// If the basis has another length.
    #[must_use]
    pub fn new(rest: Vec<Vec3>, parameter_rows: usize, basis: Vec<f32>) -> Self {
        assert_eq!(basis.len(), 3 * parameter_rows * rest.len(), "basis is 3 × P × n");
        Self { rest, parameter_rows, basis }
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

    /// Number of parameter rows, P.
    #[must_use]
    pub fn parameter_rows(&self) -> usize {
        self.parameter_rows
    }

    /// The basis, `3 × P × n` row-major.
    #[must_use]
    pub fn basis(&self) -> &[f32] {
        &self.basis
    }

    /// Writes the positions for `scales` (P scale factors an axis, 1 = unchanged) into `out` (n).
    ///
    /// # Panics
    /// If a length differs.
    pub fn deform_into(&self, scales: &[Vec3], out: &mut [Vec3]) {
        assert_eq!(scales.len(), self.parameter_rows, "one row of scales per parameter row");
        out.copy_from_slice(&self.rest);
        let n = self.rest.len();
        for axis in 0..3 {
            for (row, scale) in scales.iter().enumerate() {
                let change = scale[axis] - 1.0;
                if change == 0.0 {
                    continue;
                }
                let start = (axis * self.parameter_rows + row) * n;
                for (position, b) in out.iter_mut().zip(&self.basis[start..start + n]) {
                    position[axis] += change * b;
                }
            }
        }
    }

    /// The positions for `scales`, as a new vector.
    #[must_use]
    pub fn deform(&self, scales: &[Vec3]) -> Vec<Vec3> {
        let mut out = vec![Vec3::ZERO; self.rest.len()];
        self.deform_into(scales, &mut out);
        out
    }
}
