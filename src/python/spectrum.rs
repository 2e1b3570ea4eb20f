// SPDX-License-Identifier: MIT OR Apache-2.0
//! `spectrum_scores`.

use numpy::PyArray1;
use pyo3::prelude::*;

use super::arrays;
use super::errors::IntoPyErr;
use super::graph::PyMesh;
use super::guide::PyGuide;
use super::wording::Asked;
use crate::job;
use crate::render::{Backend, views_by_name};

/// Scores (k,) float64 of the shapes mesh + α·(vertices − mesh): mean cosine of every view before every background
/// with what is asked for.
///
/// `vertices`, (n, 3) float32: the outcome. `alphas`, (k,): 0 is the mesh, 1 the outcome.
#[pyfunction]
#[pyo3(signature = (mesh, vertices, prompt, guide, alphas, renderer="auto", views="paper"))]
#[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned sequences")]
#[expect(clippy::too_many_arguments, reason = "arguments of the Python surface")]
pub fn spectrum_scores<'py>(
    py: Python<'py>,
    mesh: &PyMesh,
    vertices: &Bound<'_, PyAny>,
    prompt: Asked<'_>,
    guide: &PyGuide,
    alphas: Vec<f32>,
    renderer: &str,
    views: &str,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let vertices = arrays::vectors(vertices, "vertices")?;
    let backend: Backend = renderer.parse().map_err(|e| IntoPyErr::into_py_err(&e))?;
    let views = views_by_name(views).map_err(|e| IntoPyErr::into_py_err(&e))?;
    let wording = prompt.wording();
    let scores =
        py.detach(|| job::spectrum_scores(&mesh.0, &vertices, &wording, &guide.0, &alphas, &views, backend));
    Ok(PyArray1::from_vec(py, scores.map_err(IntoPyErr::into_py_err)?))
}
