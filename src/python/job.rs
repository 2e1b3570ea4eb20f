// SPDX-License-Identifier: MIT OR Apache-2.0
//! `Job` and its `Result`.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::arrays;
use super::errors::IntoPyErr;
use super::graph::{PyBoxDefGraph, PyMesh};
use super::guide::PyGuide;
use super::wording::Asked;
use crate::guide::Guide;
use crate::job::{Job, JobSpec, Outcome};
use crate::search::{Budget, KeepPlace, KeepSize, Preset, SCALE_RANGE};

/// A deformation on a thread of its own; not started when made.
#[pyclass(frozen, name = "Job", module = "boxmorph")]
pub struct PyJob(Job);

#[pymethods]
impl PyJob {
    #[new]
    #[pyo3(signature = (mesh, prompt, guide=None, preset="standard", seed=0, *, splits=None, symmetry=None, boundary=None,
                        graph=None, locked=None, scale_range=SCALE_RANGE, shift_parts=false, renderer="auto", keep_size=None,
                        keep_place="bottom", points=None, variations=1, images=None, seconds=None, paper_loss=false))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of the Python surface")]
    #[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned values")]
    fn new(
        py: Python<'_>,
        mesh: &PyMesh,
        prompt: Asked<'_>,
        guide: Option<&PyGuide>,
        preset: &str,
        seed: u64,
        splits: Option<&Bound<'_, PyAny>>,
        symmetry: Option<&str>,
        boundary: Option<&str>,
        graph: Option<&PyBoxDefGraph>,
        locked: Option<&Bound<'_, PyAny>>,
        scale_range: (f32, f32),
        shift_parts: bool,
        renderer: &str,
        keep_size: Option<&str>,
        keep_place: &str,
        points: Option<&Bound<'_, PyAny>>,
        variations: i64,
        images: Option<i64>,
        seconds: Option<f64>,
        paper_loss: bool,
    ) -> PyResult<Self> {
        let preset = self::preset(preset, images, seconds)?;
        let guide = match guide {
            Some(guide) => guide.0.clone(),
            None => Arc::new(
                py.detach(|| Guide::open(None, None, None, None)).map_err(|e| IntoPyErr::into_py_err(&e))?,
            ),
        };
        let spec = JobSpec {
            mesh: mesh.0.as_ref().clone(),
            wording: prompt.wording(),
            guide,
            preset: if paper_loss { preset.with_paper_loss() } else { preset },
            seed,
            graph: graph.map(|graph| graph.0.clone()),
            locked: locked.map(|locked| arrays::flags(locked, "locked")).transpose()?,
            scale_range,
            shift_parts,
            splits: splits.map(self::splits).transpose()?.flatten(),
            symmetry: symmetry.map(str::parse).transpose().map_err(IntoPyErr::into_py_err)?,
            boundary: boundary.map(str::parse).transpose().map_err(IntoPyErr::into_py_err)?,
            backend: renderer.parse().map_err(|e| IntoPyErr::into_py_err(&e))?,
            keep_size: keep_size.map(self::keep_size).transpose()?,
            keep_place: self::keep_place(keep_place)?,
            // What is no count is refused as 0 is.
            variations: usize::try_from(variations).unwrap_or(0),
            points: points.map(|points| arrays::vectors(points, "points")).transpose()?,
        };
        Ok(Self(Job::new(spec).map_err(IntoPyErr::into_py_err)?))
    }

    fn start(&self) -> PyResult<()> {
        self.0.start().map_err(IntoPyErr::into_py_err)
    }

    fn progress<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let progress = self.0.progress();
        let dict = PyDict::new(py);
        dict.set_item("phase", progress.phase)?;
        dict.set_item("generation", progress.generation)?;
        dict.set_item("generations", progress.generations)?;
        dict.set_item("evaluations", progress.evaluations)?;
        dict.set_item("score_before", progress.score_before)?;
        dict.set_item("best_score", progress.best_score)?;
        dict.set_item("fraction", progress.fraction)?;
        dict.set_item("seconds", progress.seconds)?;
        dict.set_item("seconds_left", progress.seconds_left)?;
        dict.set_item("finished", progress.finished)?;
        Ok(dict)
    }

    fn best<'py>(&self, py: Python<'py>) -> PyResult<Option<(f64, Bound<'py, PyArray2<f32>>)>> {
        let best = py.detach(|| self.0.best());
        best.map(|(score, positions)| Ok((score, arrays::from_vectors(py, &positions)?))).transpose()
    }

    /// A picture of the best so far, (size, size, 4) uint8 RGBA; None before there is one.
    #[pyo3(signature = (size=96))]
    fn best_view<'py>(&self, py: Python<'py>, size: u32) -> PyResult<Option<Bound<'py, PyArray3<u8>>>> {
        let view = py.detach(|| self.0.best_view(size)).map_err(|e| IntoPyErr::into_py_err(&e))?;
        let side = size as usize;
        view.map(|bytes| PyArray1::from_vec(py, bytes).reshape([side, side, 4])).transpose()
    }

    fn cancel(&self) {
        self.0.cancel();
    }

    fn join(&self, py: Python<'_>) -> PyResult<()> {
        py.detach(|| self.0.join()).map_err(IntoPyErr::into_py_err)
    }

    fn result(&self) -> PyResult<PyResult_> {
        self.0.result().map(PyResult_).map_err(IntoPyErr::into_py_err)
    }
}

/// What a job found.
#[pyclass(frozen, name = "Result", module = "boxmorph")]
pub struct PyResult_(Arc<Outcome>);

#[pymethods]
impl PyResult_ {
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        arrays::from_vectors(py, &self.0.vertices)
    }

    /// Positions of the extra points; None where none were given.
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f32>>>> {
        self.0.points.as_ref().map(|points| arrays::from_vectors(py, points)).transpose()
    }

    #[getter]
    fn scales<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        arrays::from_vectors(py, &self.0.scales)
    }

    /// Shifts in object units; None where parts were not allowed to be shifted.
    #[getter]
    fn shifts<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f32>>>> {
        self.0.shifts.as_ref().map(|shifts| arrays::from_vectors(py, shifts)).transpose()
    }

    #[getter]
    fn score_before(&self) -> f64 {
        self.0.report.score_before
    }

    #[getter]
    fn score_after(&self) -> f64 {
        self.0.report.score_after
    }

    #[getter]
    fn evaluations(&self) -> usize {
        self.0.report.evaluations
    }

    #[getter]
    fn images_encoded(&self) -> usize {
        self.0.report.images_encoded
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.0.report.seconds
    }

    #[getter]
    fn graph(&self) -> PyBoxDefGraph {
        PyBoxDefGraph(self.0.graph.clone())
    }

    /// Lowest value of the slider.
    #[getter]
    fn slider_min(&self) -> f32 {
        self.0.slider.min
    }

    /// Highest value of the slider.
    #[getter]
    fn slider_max(&self) -> f32 {
        self.0.slider.max
    }

    /// This and the further outcomes, where more than one was asked for.
    #[getter]
    fn variations(&self) -> Vec<Self> {
        std::iter::once(&self.0).chain(&self.0.variations).cloned().map(Self).collect()
    }

    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let json = serde_json::to_string(&self.0.report).map_err(|e| PyValueError::new_err(e.to_string()))?;
        py.import("json")?.call_method1("loads", (json,))
    }

    fn __repr__(&self) -> String {
        let report = &self.0.report;
        format!("Result({:?}, score {:.3} → {:.3})", report.prompt, report.score_before, report.score_after)
    }
}

fn preset(name: &str, images: Option<i64>, seconds: Option<f64>) -> PyResult<Preset> {
    let preset = Preset::by_name(name).ok_or_else(|| {
        let names = Preset::ALL.map(|preset| format!("\"{}\"", preset.name)).join(" or ");
        PyValueError::new_err(format!("unknown preset \"{name}\": choose {names}"))
    })?;
    // What is no count is refused as 0 is.
    let images = images.map(|images| Budget::Images(usize::try_from(images).unwrap_or(0)));
    let budgets: Vec<Budget> = images.into_iter().chain(seconds.map(Budget::Seconds)).collect();
    match budgets[..] {
        [] => Ok(preset),
        [budget] => preset.with_budget(budget).map_err(|e| PyValueError::new_err(e.to_string())),
        _ => Err(PyValueError::new_err("give a budget in images or in seconds, not both")),
    }
}

fn splits(value: &Bound<'_, PyAny>) -> PyResult<Option<u32>> {
    if value.extract::<&str>().is_ok_and(|name| name == "auto") {
        return Ok(None);
    }
    let count: u32 = value
        .extract()
        .map_err(|_| PyTypeError::new_err("splits must be \"auto\" or a whole number from 1 to 8"))?;
    Ok(Some(count))
}

fn keep_size(name: &str) -> PyResult<KeepSize> {
    match name {
        "diagonal" => Ok(KeepSize::Diagonal),
        "height" => Ok(KeepSize::Height),
        "footprint" => Ok(KeepSize::Footprint),
        "off" => Ok(KeepSize::Off),
        _ => Err(PyValueError::new_err(format!(
            "unknown keep_size \"{name}\": choose \"diagonal\", \"height\", \"footprint\" or \"off\""
        ))),
    }
}

fn keep_place(name: &str) -> PyResult<KeepPlace> {
    match name {
        "bottom" => Ok(KeepPlace::BottomCenter),
        "off" => Ok(KeepPlace::Off),
        _ => {
            Err(PyValueError::new_err(format!("unknown keep_place \"{name}\": choose \"bottom\" or \"off\"")))
        }
    }
}
