// SPDX-License-Identifier: MIT OR Apache-2.0
//! `Wording`.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::errors::IntoPyErr;
use super::guide::PyGuide;
use crate::search::{self, PromptError, Wording};

/// What is asked for: a prompt, what it should not look like, what the object is now.
#[pyclass(frozen, name = "Wording", module = "boxmorph")]
pub struct PyWording(pub Wording);

#[pymethods]
impl PyWording {
    #[new]
    #[pyo3(signature = (prompt, negative=None, source=None, templates="auto"))]
    fn new(
        prompt: String,
        negative: Option<String>,
        source: Option<String>,
        templates: &str,
    ) -> PyResult<Self> {
        let templates = match templates {
            "auto" => None,
            "on" => Some(true),
            "off" => Some(false),
            _ => {
                return Err(PyValueError::new_err(format!(
                    "unknown templates \"{templates}\": choose \"auto\", \"on\" or \"off\""
                )));
            }
        };
        let given = |text: Option<String>| text.filter(|text| !text.trim().is_empty());
        Ok(Self(Wording { prompt, negative: given(negative), source: given(source), templates }))
    }

    #[getter]
    fn prompt(&self) -> &str {
        &self.0.prompt
    }

    /// The prompt's parts and their weights; one of weight 1 where none are given.
    #[getter]
    fn parts(&self) -> PyResult<Vec<(String, f64)>> {
        let parts = search::parts(&self.0.prompt).map_err(IntoPyErr::into_py_err)?;
        Ok(parts.into_iter().map(|part| (part.text, part.weight.unwrap_or(1.0))).collect())
    }

    /// Refuses texts that are misshapen, empty, endless or of unknown words alone; gives the words that the guide
    /// does not know.
    fn check(&self, py: Python<'_>, guide: &PyGuide) -> PyResult<Vec<String>> {
        let read = || -> Result<_, PromptError> {
            self.0.check(&guide.0)?;
            self.0.target(&guide.0)?;
            self.0.unknown_words(&guide.0)
        };
        py.detach(read).map_err(IntoPyErr::into_py_err)
    }

    fn __repr__(&self) -> String {
        format!("Wording({:?})", self.0.prompt)
    }
}

/// A prompt alone, or a wording.
#[derive(FromPyObject)]
pub enum Asked<'py> {
    /// A prompt.
    Text(String),
    /// All of it.
    Wording(PyRef<'py, PyWording>),
}

impl Asked<'_> {
    /// The wording.
    pub fn wording(&self) -> Wording {
        match self {
            Self::Text(prompt) => Wording::plain(prompt),
            Self::Wording(wording) => wording.0.clone(),
        }
    }
}
