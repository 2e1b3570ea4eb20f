// SPDX-License-Identifier: MIT OR Apache-2.0
//! `Guide`.

use std::path::PathBuf;
use std::sync::Arc;

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::arrays;
use super::copy;
use super::errors::IntoPyErr;
use crate::guide::{self, Guide, GuideError, Provider};

/// Names the ONNX Runtime library to open where `ORT_DYLIB_PATH` names none.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned paths")]
pub fn set_default_library(path: PathBuf) {
    guide::set_default_library(&path);
}

/// The execution providers that ONNX Runtime's library offers, the processor last.
#[pyfunction]
pub fn execution_providers() -> PyResult<Vec<&'static str>> {
    let offered = Provider::offered().map_err(|e| IntoPyErr::into_py_err(&e))?;
    Ok(offered.into_iter().map(Provider::name).collect())
}

/// The file of ONNX Runtime's library that is in use.
#[pyfunction]
pub fn runtime_library() -> PyResult<PathBuf> {
    guide::runtime_library().map_err(|e| IntoPyErr::into_py_err(&e))
}

/// The version of ONNX Runtime's library that is in use.
#[pyfunction]
pub fn runtime_version() -> PyResult<String> {
    guide::runtime_version().map_err(|e| IntoPyErr::into_py_err(&e))
}

/// A text–image model.
#[pyclass(frozen, name = "Guide", module = "boxmorph")]
pub struct PyGuide(pub Arc<Guide>);

#[pymethods]
impl PyGuide {
    /// Opens the guide in a folder; None opens the embedded one.
    #[staticmethod]
    #[pyo3(signature = (path=None, threads=None, provider="auto", precision="auto"))]
    #[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned paths")]
    fn open(
        py: Python<'_>,
        path: Option<PathBuf>,
        threads: Option<usize>,
        provider: &str,
        precision: &str,
    ) -> PyResult<Self> {
        let guide = py.detach(|| -> Result<_, GuideError> {
            let provider = if provider == "auto" { None } else { Some(provider.parse()?) };
            let precision = (precision != "auto").then_some(precision);
            Guide::open(path.as_deref(), threads, provider, precision)
        });
        Ok(Self(Arc::new(guide.map_err(|e| IntoPyErr::into_py_err(&e))?)))
    }

    /// Writes a copy of a guide's image network in eight bits, and tells how far it agrees with the exact one.
    #[staticmethod]
    #[pyo3(signature = (folder, output=None, threads=None))]
    #[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned paths")]
    fn quantize(
        py: Python<'_>,
        folder: PathBuf,
        output: Option<PathBuf>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'_, PyDict>> {
        let made = py
            .detach(|| guide::eight_bit_copy(&folder, output.as_deref(), threads, &|_| true))
            .map_err(|e| IntoPyErr::into_py_err(&e))?;
        copy::figures(py, &made)
    }

    fn text_embedding<'py>(&self, py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyArray1<f32>>> {
        let embedding = py.detach(|| self.0.text_embedding(text));
        Ok(PyArray1::from_vec(py, embedding.map_err(|e| IntoPyErr::into_py_err(&e))?))
    }

    fn image_embeddings<'py>(
        &self,
        py: Python<'py>,
        images: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let images = arrays::images(images, self.0.image_size() as usize)?;
        let embeddings =
            py.detach(|| self.0.image_embeddings(&images)).map_err(|e| IntoPyErr::into_py_err(&e))?;
        let rows = embeddings.len() / self.0.dimension();
        PyArray1::from_vec(py, embeddings).reshape([rows, self.0.dimension()])
    }

    fn unknown_words(&self, text: &str) -> PyResult<Vec<String>> {
        self.0.unknown_words(text).map_err(|e| IntoPyErr::into_py_err(&e))
    }

    /// Refuses a prompt that is empty, endless, or of unknown words alone.
    fn check_prompt(&self, prompt: &str) -> PyResult<()> {
        self.0.check_prompt(prompt).map_err(|e| IntoPyErr::into_py_err(&e))
    }

    #[pyo3(signature = (word, count=3))]
    fn nearest_words(&self, word: &str, count: usize) -> Vec<String> {
        self.0.nearest_words(word, count)
    }

    /// The numbers of the tokens that its text network reads, padding included.
    fn token_ids(&self, text: &str) -> PyResult<Vec<i64>> {
        self.0.token_ids(text).map_err(|e| IntoPyErr::into_py_err(&e))
    }

    #[getter]
    fn image_size(&self) -> u32 {
        self.0.image_size()
    }

    /// The names it was taught; empty for a guide of general knowledge.
    #[getter]
    fn classes(&self) -> Vec<String> {
        self.0.classes().to_vec()
    }

    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    /// SHA-256 over its files.
    #[getter]
    fn sha256(&self) -> &str {
        self.0.hash()
    }

    /// What encodes the images: "cpu", or another of `execution_providers()`.
    #[getter]
    fn provider(&self) -> &'static str {
        self.0.provider().name()
    }

    /// The precision of its image network: by its file's name, unless its weights are of another.
    #[getter]
    fn precision(&self) -> &'static str {
        self.0.precision()
    }

    /// A sentence on why the provider that was asked for is not used; None where it is.
    #[getter]
    fn provider_note(&self) -> Option<&str> {
        self.0.provider_note()
    }

    fn __repr__(&self) -> String {
        format!("Guide({:?}, images of {} pixels)", self.0.name(), self.0.image_size())
    }
}
