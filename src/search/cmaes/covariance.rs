// SPDX-License-Identifier: MIT OR Apache-2.0
//! The covariance of the search distribution and its decomposition C = B·D²·Bᵀ, renewed only when due.
//!
//! Products are plain loops in a fixed order: the matrices are small, and the same bytes come out on any
//! number of threads.

use nalgebra::{DMatrix, DVector, Matrix, SymmetricEigen};
use serde::{Deserialize, Serialize};

use super::exact;

/// Rounds of the eigen decomposition for each coordinate before it is given up.
const ROUNDS_PER_COORDINATE: usize = 100;

/// The covariance and its last decomposition.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Covariance {
    /// C, exactly symmetric.
    #[serde(with = "exact")]
    matrix: DMatrix<f64>,
    /// B: one unit axis a column.
    #[serde(with = "exact")]
    axes: DMatrix<f64>,
    /// D: standard deviation along each axis, before σ.
    #[serde(with = "exact")]
    lengths: DVector<f64>,
    /// Generation of the decomposition.
    decomposed_at: usize,
}

impl Covariance {
    /// The identity.
    pub(super) fn new(n: usize) -> Self {
        Self {
            matrix: DMatrix::identity(n, n),
            axes: DMatrix::identity(n, n),
            lengths: DVector::from_element(n, 1.0),
            decomposed_at: 0,
        }
    }

    /// Whether every part has `n` coordinates.
    pub(super) fn fits(&self, n: usize) -> bool {
        self.matrix.nrows() == n && self.axes.nrows() == n && self.lengths.len() == n
    }

    /// Generation of the last decomposition.
    pub(super) fn decomposed_at(&self) -> usize {
        self.decomposed_at
    }

    /// B·D·z: a sample of N(0, C) from one of N(0, I).
    pub(super) fn shape(&self, z: &DVector<f64>) -> DVector<f64> {
        let mut sample = DVector::zeros(z.len());
        for (axis, column) in self.axes.column_iter().enumerate() {
            sample.axpy(self.lengths[axis] * z[axis], &column, 1.0);
        }
        sample
    }

    /// D⁻¹·Bᵀ·y: what [`Covariance::shape`] makes y of.
    pub(super) fn unshape(&self, y: &DVector<f64>) -> DVector<f64> {
        self.axes.tr_mul(y).component_div(&self.lengths)
    }

    /// C^(−1/2)·y, by the last decomposition.
    pub(super) fn whiten(&self, y: &DVector<f64>) -> DVector<f64> {
        let mut white = DVector::zeros(y.len());
        for (axis, column) in self.axes.column_iter().enumerate() {
            white.axpy(column.dot(y) / self.lengths[axis], &column, 1.0);
        }
        white
    }

    /// Standard deviation in coordinate `i`, before σ.
    pub(super) fn deviation(&self, i: usize) -> f64 {
        self.matrix[(i, i)].sqrt()
    }

    /// C ← keep·C + Σ weight·y·yᵀ.
    pub(super) fn update<'a>(&mut self, keep: f64, terms: impl Iterator<Item = (f64, &'a DVector<f64>)>) {
        self.matrix *= keep;
        for (weight, y) in terms {
            for column in 0..y.len() {
                for row in 0..=column {
                    self.matrix[(row, column)] += weight * y[row] * y[column];
                }
            }
        }
        self.matrix.fill_lower_triangle_with_upper_triangle();
    }

    /// Narrows coordinate `i` by `factor`.
    pub(super) fn narrow(&mut self, i: usize, factor: f64) {
        self.matrix.row_mut(i).scale_mut(factor);
        self.matrix.column_mut(i).scale_mut(factor);
    }

    /// Decomposes C. Where that fails, C goes back to the last decomposition and `false` is returned.
    pub(super) fn decompose(&mut self, generation: usize) -> bool {
        self.decomposed_at = generation;
        let rounds = ROUNDS_PER_COORDINATE * self.matrix.nrows();
        let finite = self.matrix.iter().all(|value| value.is_finite());
        let eigen =
            finite.then(|| SymmetricEigen::try_new(self.matrix.clone(), f64::EPSILON, rounds)).flatten();
        match eigen {
            Some(eigen) if eigen.eigenvalues.iter().all(|&value| value > 0.0 && value.is_finite()) => {
                self.lengths = eigen.eigenvalues.map(f64::sqrt);
                self.axes = eigen.eigenvectors;
                true
            }
            _ => {
                self.matrix.fill(0.0);
                let axes: Vec<DVector<f64>> = self.axes.column_iter().map(Matrix::into_owned).collect();
                let squares: Vec<f64> = self.lengths.iter().map(|length| length * length).collect();
                self.update(1.0, squares.into_iter().zip(&axes));
                false
            }
        }
    }

    /// The greatest standard deviation along any axis, before σ.
    pub(super) fn longest(&self) -> f64 {
        self.lengths.max()
    }

    /// Condition number of C by the last decomposition.
    pub(super) fn condition(&self) -> f64 {
        (self.lengths.max() / self.lengths.min()).powi(2)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn stretched() -> Covariance {
        let mut covariance = Covariance::new(3);
        let along = DVector::from_vec(vec![1.0, 2.0, -1.0]);
        covariance.update(0.5, [(2.0, &along)].into_iter());
        covariance
    }

    #[test]
    fn whitening_undoes_shaping_up_to_a_rotation() {
        let mut covariance = stretched();
        assert!(covariance.decompose(1));
        let z = DVector::from_vec(vec![0.3, -1.2, 0.7]);
        assert_relative_eq!(covariance.whiten(&covariance.shape(&z)).norm(), z.norm(), epsilon = 1e-12);
        assert_relative_eq!(covariance.unshape(&covariance.shape(&z)), z, epsilon = 1e-12);
    }

    #[test]
    fn a_failed_decomposition_goes_back_to_the_last_good_one() {
        let mut covariance = stretched();
        covariance.decompose(1);
        let good = covariance.clone();
        for bad in [f64::NAN, f64::INFINITY, -5.0] {
            covariance.matrix[(0, 0)] = bad;
            assert!(!covariance.decompose(2));
            assert_relative_eq!(covariance.matrix, good.matrix, epsilon = 1e-12);
            assert_eq!(covariance.axes, good.axes);
        }
    }
}
