// SPDX-License-Identifier: MIT OR Apache-2.0
//! `Mesh` and `BoxDefGraph`.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;

use super::arrays;
use super::errors::IntoPyErr;
use crate::boxdef::{self, BoxDefGraph, DeformField, Parts, Symmetry};
use crate::mesh::Mesh;

/// A triangle mesh: vertices (n, 3) float32, triangles (m, 3) uint32 or int32; copied.
#[pyclass(frozen, name = "Mesh", module = "boxmorph")]
pub struct PyMesh(pub Arc<Mesh>);

#[pymethods]
impl PyMesh {
    #[new]
    fn new(vertices: &Bound<'_, PyAny>, triangles: &Bound<'_, PyAny>) -> PyResult<Self> {
        let vertices = arrays::vectors(vertices, "vertices")?;
        let triangles = arrays::triangles(triangles, "triangles")?;
        Ok(Self(Arc::new(Mesh::new(vertices, triangles).map_err(IntoPyErr::into_py_err)?)))
    }

    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        arrays::from_vectors(py, self.0.vertices())
    }

    #[getter]
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let triangles = self.0.triangles();
        PyArray1::from_vec(py, triangles.concat()).reshape([triangles.len(), 3])
    }

    fn __repr__(&self) -> String {
        format!("Mesh({} vertices, {} triangles)", self.0.vertices().len(), self.0.triangles().len())
    }
}

/// Part boxes of a mesh and the constraints between them.
#[pyclass(frozen, name = "BoxDefGraph", module = "boxmorph")]
pub struct PyBoxDefGraph(pub Arc<BoxDefGraph>);

#[pymethods]
impl PyBoxDefGraph {
    #[staticmethod]
    #[pyo3(signature = (mesh, splits=3, symmetry="auto", boundary="smooth"))]
    fn build(py: Python<'_>, mesh: &PyMesh, splits: u32, symmetry: &str, boundary: &str) -> PyResult<Self> {
        let symmetry = symmetry.parse().map_err(IntoPyErr::into_py_err)?;
        let boundary = boundary.parse().map_err(IntoPyErr::into_py_err)?;
        let graph = py.detach(|| BoxDefGraph::build(&mesh.0, splits, symmetry, boundary));
        Ok(Self(Arc::new(graph.map_err(IntoPyErr::into_py_err)?)))
    }

    #[staticmethod]
    #[pyo3(signature = (mesh, box_center, box_half_size, symmetry="auto", boundary="smooth"))]
    fn from_boxes(
        py: Python<'_>,
        mesh: &PyMesh,
        box_center: &Bound<'_, PyAny>,
        box_half_size: &Bound<'_, PyAny>,
        symmetry: &str,
        boundary: &str,
    ) -> PyResult<Self> {
        let center = arrays::vectors(box_center, "box_center")?;
        let half_size = arrays::vectors(box_half_size, "box_half_size")?;
        let symmetry = symmetry.parse().map_err(IntoPyErr::into_py_err)?;
        let boundary = boundary.parse().map_err(IntoPyErr::into_py_err)?;
        let graph = py.detach(|| BoxDefGraph::from_boxes(&mesh.0, &center, &half_size, symmetry, boundary));
        Ok(Self(Arc::new(graph.map_err(IntoPyErr::into_py_err)?)))
    }

    #[staticmethod]
    #[pyo3(signature = (mesh, box_center, box_half_size, box_side, assignment, tree_edges, tree_parent_point,
                        tree_child_point, edges, boundary="paper", box_row=None))]
    #[expect(clippy::too_many_arguments, reason = "the arrays of the reference data, by their names")]
    fn from_parts(
        mesh: &PyMesh,
        box_center: &Bound<'_, PyAny>,
        box_half_size: &Bound<'_, PyAny>,
        box_side: &Bound<'_, PyAny>,
        assignment: &Bound<'_, PyAny>,
        tree_edges: &Bound<'_, PyAny>,
        tree_parent_point: &Bound<'_, PyAny>,
        tree_child_point: &Bound<'_, PyAny>,
        edges: &Bound<'_, PyAny>,
        boundary: &str,
        box_row: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let boundary = boundary.parse().map_err(IntoPyErr::into_py_err)?;
        let side = |s: i32| i8::try_from(s).unwrap_or(i8::MAX);
        let box_side: Vec<i8> = arrays::integers(box_side, "box_side")?.into_iter().map(side).collect();
        let box_row = match box_row {
            Some(rows) => arrays::integers(rows, "box_row")?,
            None => Parts::rows_of_twins(&box_side).map_err(IntoPyErr::into_py_err)?,
        };
        let parts = Parts {
            box_center: arrays::vectors(box_center, "box_center")?,
            box_half_size: arrays::vectors(box_half_size, "box_half_size")?,
            box_side,
            box_row,
            assignment: arrays::integers(assignment, "assignment")?,
            tree_edges: arrays::pairs(tree_edges, "tree_edges")?,
            tree_parent_point: arrays::vectors(tree_parent_point, "tree_parent_point")?,
            tree_child_point: arrays::vectors(tree_child_point, "tree_child_point")?,
            edges: arrays::pairs(edges, "edges")?,
        };
        let graph = BoxDefGraph::from_parts(&mesh.0, parts, boundary).map_err(IntoPyErr::into_py_err)?;
        Ok(Self(Arc::new(graph)))
    }

    #[getter]
    fn box_center<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        arrays::from_vectors(py, self.0.box_center())
    }

    #[getter]
    fn box_half_size<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        arrays::from_vectors(py, self.0.box_half_size())
    }

    #[getter]
    fn box_side<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i8>> {
        PyArray1::from_slice(py, self.0.box_side())
    }

    #[getter]
    fn assignment<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        PyArray1::from_slice(py, self.0.assignment())
    }

    #[getter]
    fn tree_edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        arrays::from_pairs(py, self.0.tree_edges())
    }

    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        arrays::from_pairs(py, self.0.edges())
    }

    #[getter]
    fn parameter_rows(&self) -> usize {
        self.0.parameter_rows()
    }

    #[getter]
    fn parameter_row_of_box<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        PyArray1::from_iter(py, self.0.parameter_row_of_box().iter().map(|&row| row as i32))
    }

    /// The symmetry, "x", "y", "z" or "xy"; None where there is none.
    #[getter]
    fn symmetry(&self) -> Option<&'static str> {
        let symmetry = self.0.symmetry();
        (symmetry != Symmetry::None).then(|| symmetry.name())
    }

    #[pyo3(signature = (scales, shifts=None))]
    fn deform<'py>(
        &self,
        py: Python<'py>,
        scales: &Bound<'_, PyAny>,
        shifts: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let scales = arrays::vectors(scales, "scales")?;
        let positions = match shifts {
            Some(shifts) => self.0.deform_shifted(&scales, &arrays::vectors(shifts, "shifts")?),
            None => self.0.deform(&scales),
        };
        arrays::from_vectors(py, &positions.map_err(IntoPyErr::into_py_err)?)
    }

    #[pyo3(signature = (with_shifts=false))]
    fn field<'py>(&self, py: Python<'py>, with_shifts: bool) -> PyResult<Bound<'py, PyArray3<f32>>> {
        if with_shifts {
            self.planes(py, &self.0.field_with_shifts())
        } else {
            self.planes(py, self.0.field())
        }
    }

    /// The field at other points (k, 3).
    #[pyo3(signature = (points, with_shifts=false))]
    fn field_at<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'_, PyAny>,
        with_shifts: bool,
    ) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let points = arrays::vectors(points, "points")?;
        let field = py.detach(|| {
            let own = if with_shifts { Arc::new(self.0.field_with_shifts()) } else { self.0.shared_field() };
            self.0.field_at(&own, &points)
        });
        self.planes(py, &field.map_err(IntoPyErr::into_py_err)?)
    }

    /// Least and greatest shift of each parameter row along each axis, (P, 3, 2), in object units.
    fn shift_room<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let room = self.0.shift_room();
        let flat = room.iter().flatten().flat_map(|&(least, most)| [least, most]);
        PyArray1::from_iter(py, flat).reshape([room.len(), 3, 2])
    }

    fn __repr__(&self) -> String {
        format!(
            "BoxDefGraph({} boxes, {} parameter rows)",
            self.0.box_center().len(),
            self.0.parameter_rows()
        )
    }
}

impl PyBoxDefGraph {
    /// The basis of a field as (3, rows, points), what is shifted by object unit.
    fn planes<'py>(&self, py: Python<'py>, field: &DeformField) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let (rows, count) = (field.parameter_rows(), field.vertex_count());
        let mut basis = field.basis().to_vec();
        for axis in basis.chunks_exact_mut((rows * count).max(1)) {
            for value in &mut axis[field.scale_rows() * count..] {
                *value /= self.0.reach();
            }
        }
        PyArray1::from_vec(py, basis).reshape([3, rows, count])
    }
}

/// The angle about z, in radians, by which to turn a mesh so that its own axes lie along x and y.
#[pyfunction]
pub fn own_turn(py: Python<'_>, mesh: &PyMesh) -> f64 {
    py.detach(|| boxdef::own_turn(&mesh.0))
}
