// SPDX-License-Identifier: MIT OR Apache-2.0
//! Errors as Python exceptions.

use pyo3::PyErr;
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};

use crate::boxdef::BoxDefError;
use crate::guide;
use crate::hub::HubError;
use crate::job::JobError;
use crate::mesh::MeshError;
use crate::metrics::MetricsError;
use crate::render;
use crate::search::PromptError;

create_exception!(boxmorph, GuideError, PyException, "A guide that cannot be fetched, opened or used.");
create_exception!(boxmorph, RenderError, PyException, "Images that cannot be made.");
create_exception!(boxmorph, Cancelled, PyException, "The job, download or copy was cancelled.");

/// Conversion into the exception that Python sees.
pub trait IntoPyErr {
    /// The exception, with the error's sentence.
    fn into_py_err(self) -> PyErr;
}

impl IntoPyErr for MeshError {
    fn into_py_err(self) -> PyErr {
        PyValueError::new_err(self.to_string())
    }
}

impl IntoPyErr for BoxDefError {
    fn into_py_err(self) -> PyErr {
        PyValueError::new_err(self.to_string())
    }
}

impl IntoPyErr for MetricsError {
    fn into_py_err(self) -> PyErr {
        PyValueError::new_err(self.to_string())
    }
}

impl IntoPyErr for &guide::GuideError {
    fn into_py_err(self) -> PyErr {
        if self.is_input() {
            PyValueError::new_err(self.to_string())
        } else if matches!(self, guide::GuideError::Cancelled) {
            Cancelled::new_err(self.to_string())
        } else {
            GuideError::new_err(self.to_string())
        }
    }
}

impl IntoPyErr for PromptError {
    fn into_py_err(self) -> PyErr {
        match self {
            Self::Guide(error) => error.as_ref().into_py_err(),
            error => PyValueError::new_err(error.to_string()),
        }
    }
}

impl IntoPyErr for &render::RenderError {
    fn into_py_err(self) -> PyErr {
        if self.is_input() {
            PyValueError::new_err(self.to_string())
        } else {
            RenderError::new_err(self.to_string())
        }
    }
}

impl IntoPyErr for HubError {
    fn into_py_err(self) -> PyErr {
        match self {
            Self::Cancelled => Cancelled::new_err(self.to_string()),
            Self::UnknownGuide { .. } | Self::UnknownPrecision { .. } | Self::BadEndpoint { .. } => {
                PyValueError::new_err(self.to_string())
            }
            Self::AlreadyStarted | Self::NotFinished | Self::Thread(_) | Self::Fault(_) => {
                PyRuntimeError::new_err(self.to_string())
            }
            error => GuideError::new_err(error.to_string()),
        }
    }
}

impl IntoPyErr for JobError {
    fn into_py_err(self) -> PyErr {
        match self {
            Self::Cancelled => Cancelled::new_err(self.to_string()),
            Self::Guide(error) => error.as_ref().into_py_err(),
            Self::Render(error) => error.as_ref().into_py_err(),
            Self::BoxDef(_)
            | Self::BadPoints
            | Self::OtherMesh
            | Self::OtherOutcome { .. }
            | Self::BadSpectrum
            | Self::GraphAndParts
            | Self::LocksWithoutGraph
            | Self::Variations
            | Self::Prompt(_)
            | Self::Space(_) => PyValueError::new_err(self.to_string()),
            error => PyRuntimeError::new_err(error.to_string()),
        }
    }
}
