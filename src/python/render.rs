// SPDX-License-Identifier: MIT OR Apache-2.0
//! `render`.

use numpy::{PyArray1, PyArray4, PyArrayMethods};
use pyo3::prelude::*;

use super::arrays;
use super::errors::IntoPyErr;
use crate::render::{Backend, RenderError, real_gpu, render_colored, render_positions, views_by_name};

/// The name of the graphics card that the renderer "auto" takes; None where there is no real one. Asking opens
/// the drivers, once.
#[pyfunction]
pub fn graphics_adapter(py: Python<'_>) -> Option<&'static str> {
    py.detach(real_gpu)
}

/// Renders a mesh as the guide sees it: RGBA with straight alpha, (views, size, size, 4) uint8.
///
/// `colors`, (m, 3) uint8: each triangle is drawn in its color, lighter or darker by the light on it; None draws
/// grey.
#[pyfunction]
#[pyo3(signature = (vertices, triangles, size=224, views="paper", renderer="auto", colors=None))]
pub fn render<'py>(
    py: Python<'py>,
    vertices: &Bound<'_, PyAny>,
    triangles: &Bound<'_, PyAny>,
    size: u32,
    views: &str,
    renderer: &str,
    colors: Option<&Bound<'_, PyAny>>,
) -> PyResult<Bound<'py, PyArray4<u8>>> {
    let vertices = arrays::vectors(vertices, "vertices")?;
    let triangles = arrays::triangles(triangles, "triangles")?;
    let colors = colors.map(|colors| arrays::colors(colors, "colors")).transpose()?;
    let images = py.detach(|| -> Result<_, RenderError> {
        let views = views_by_name(views)?;
        let backend: Backend = renderer.parse()?;
        let images = match colors {
            None => render_positions(backend, &vertices, &triangles, &views, size)?,
            Some(colors) => render_colored(backend, &vertices, &triangles, &colors, &views, size)?,
        };
        Ok((views.len(), images))
    });
    let (views, bytes) = images.map_err(|e| IntoPyErr::into_py_err(&e))?;
    PyArray1::from_vec(py, bytes).reshape([views, size as usize, size as usize, 4])
}
