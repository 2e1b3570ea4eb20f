// SPDX-License-Identifier: MIT OR Apache-2.0
//! `metrics`: how much a deformation bent and broke.

use pyo3::prelude::*;

/// How much a deformation bent and broke: (n, 3) float32 positions against the mesh's own.
#[pymodule]
pub mod metrics {
    use pyo3::prelude::*;

    use crate::metrics as core;
    use crate::python::arrays;
    use crate::python::errors::IntoPyErr;
    use crate::python::graph::PyMesh;

    /// Mean absolute change of the vertices' angle deficit, in radians.
    #[pyfunction]
    fn gaussian_curvature_change(mesh: &PyMesh, vertices: &Bound<'_, PyAny>) -> PyResult<f64> {
        let vertices = arrays::vectors(vertices, "vertices")?;
        core::gaussian_curvature_change(&mesh.0, &vertices).map_err(IntoPyErr::into_py_err)
    }

    /// Share of the faces that cut another face they do not touch.
    #[pyfunction]
    fn self_intersection_ratio(mesh: &PyMesh, vertices: &Bound<'_, PyAny>) -> PyResult<f64> {
        let vertices = arrays::vectors(vertices, "vertices")?;
        core::self_intersection_ratio(&mesh.0, &vertices).map_err(IntoPyErr::into_py_err)
    }

    /// Mean of 1 − cos between vertex normals before and after.
    #[pyfunction]
    fn normal_error(mesh: &PyMesh, vertices: &Bound<'_, PyAny>) -> PyResult<f64> {
        let vertices = arrays::vectors(vertices, "vertices")?;
        core::normal_error(&mesh.0, &vertices).map_err(IntoPyErr::into_py_err)
    }
}
