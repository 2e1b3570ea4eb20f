// SPDX-License-Identifier: MIT OR Apache-2.0
//! The Python module: the only place that knows Python. Arrays in, arrays out, errors as exceptions.

mod arrays;
mod copy;
mod errors;
mod graph;
mod guide;
mod guides;
mod job;
mod metrics;
mod render;
mod spectrum;
mod wording;

use pyo3::prelude::*;

/// The native module; `boxmorph/__init__.py` re-exports it.
#[pymodule]
mod _boxmorph {
    use super::{Bound, PyModule, PyModuleMethods, PyResult};

    #[pymodule_export]
    use super::copy::PyEightBitCopy;
    #[pymodule_export]
    use super::errors::{Cancelled, GuideError, RenderError};
    #[pymodule_export]
    use super::graph::{PyBoxDefGraph, PyMesh, own_turn};
    #[pymodule_export]
    use super::guide::{PyGuide, execution_providers, runtime_library, runtime_version, set_default_library};
    #[pymodule_export]
    use super::guides::guides;
    #[pymodule_export]
    use super::job::{PyJob, PyResult_};
    #[pymodule_export]
    use super::metrics::metrics;
    #[pymodule_export]
    use super::render::{graphics_adapter, render};
    #[pymodule_export]
    use super::spectrum::spectrum_scores;
    #[pymodule_export]
    use super::wording::PyWording;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
