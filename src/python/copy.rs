// SPDX-License-Identifier: MIT OR Apache-2.0
//! `EightBitCopy`.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::errors::IntoPyErr;
use crate::guide::{CopyStep, EightBitCopy};
use crate::job::{CopyJob, CopySpec};

/// A copy of a guide in eight bits, made on a thread of its own; not started when made.
#[pyclass(frozen, name = "EightBitCopy", module = "boxmorph")]
pub struct PyEightBitCopy(CopyJob);

#[pymethods]
impl PyEightBitCopy {
    #[new]
    #[pyo3(signature = (folder, output=None, threads=None))]
    fn new(folder: PathBuf, output: Option<PathBuf>, threads: Option<usize>) -> Self {
        Self(CopyJob::new(CopySpec { folder, output, threads }))
    }

    fn start(&self) -> PyResult<()> {
        self.0.start().map_err(IntoPyErr::into_py_err)
    }

    fn progress<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (phase, fraction) = self.0.progress().map_or(("Waiting", 0.0), |progress| {
            let phase = match progress.step {
                CopyStep::Reading => "Reading the guide",
                CopyStep::Quantizing => "Making it smaller",
                CopyStep::Writing => "Writing the copy",
                CopyStep::Opening => "Opening both",
                CopyStep::Comparing => "Comparing them",
            };
            (phase, progress.fraction)
        });
        let dict = PyDict::new(py);
        dict.set_item("phase", phase)?;
        dict.set_item("fraction", fraction)?;
        dict.set_item("finished", self.0.is_finished())?;
        Ok(dict)
    }

    fn cancel(&self) {
        self.0.cancel();
    }

    fn join(&self, py: Python<'_>) -> PyResult<()> {
        py.detach(|| self.0.join()).map_err(IntoPyErr::into_py_err)
    }

    fn result<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        figures(py, &self.0.result().map_err(IntoPyErr::into_py_err)?)
    }
}

/// What was made, and what it is worth.
pub fn figures<'py>(py: Python<'py>, made: &EightBitCopy) -> PyResult<Bound<'py, PyDict>> {
    let figures = PyDict::new(py);
    figures.set_item("file", &made.file)?;
    figures.set_item("products", made.products)?;
    figures.set_item("exact_bytes", made.exact_bytes)?;
    figures.set_item("bytes", made.bytes)?;
    figures.set_item("images", made.agreement.images)?;
    figures.set_item("cosine_mean", made.agreement.cosine_mean)?;
    figures.set_item("cosine_min", made.agreement.cosine_min)?;
    figures.set_item("rank_mean", made.agreement.rank_mean)?;
    figures.set_item("rank_min", made.agreement.rank_min)?;
    figures.set_item("exact_images_per_second", made.agreement.exact_speed)?;
    figures.set_item("images_per_second", made.agreement.fast_speed)?;
    Ok(figures)
}
