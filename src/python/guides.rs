// SPDX-License-Identifier: MIT OR Apache-2.0
//! `guides`: which guides can be downloaded, and their download.

use pyo3::prelude::*;

/// Guides that lie on the Hugging Face hub, and their download.
#[pymodule]
pub mod guides {
    use std::path::PathBuf;
    use std::time::Duration;

    use pyo3::exceptions::PyValueError;
    use pyo3::prelude::*;
    use pyo3::types::{PyDict, PyList};

    use crate::hub::{self, Choice, DownloadSpec, Presence};
    use crate::python::errors::IntoPyErr;

    /// All guides that can be downloaded, as dicts.
    #[pyfunction]
    fn registry(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
        let list = PyList::empty(py);
        for entry in hub::registry() {
            let dict = PyDict::new(py);
            dict.set_item("id", &entry.id)?;
            dict.set_item("title", &entry.title)?;
            dict.set_item("repository", &entry.repository)?;
            dict.set_item("revision", &entry.revision)?;
            dict.set_item("licence", &entry.licence)?;
            dict.set_item("image_size", entry.image_size)?;
            dict.set_item("good_for", &entry.good_for)?;
            let precisions = PyDict::new(py);
            for precision in &entry.precisions {
                let choice = Choice { entry, precision };
                let details = PyDict::new(py);
                details.set_item("bytes", choice.bytes())?;
                details.set_item("verified", precision.verified)?;
                details.set_item("note", &precision.note)?;
                details.set_item("folder_name", choice.folder_name())?;
                details.set_item("files", choice.files().map(|file| &file.name).collect::<Vec<_>>())?;
                precisions.set_item(&precision.name, details)?;
            }
            dict.set_item("precisions", precisions)?;
            list.append(dict)?;
        }
        Ok(list)
    }

    /// How much of a guide is on this machine, as a dict.
    #[pyfunction]
    #[pyo3(signature = (id, precision, folder))]
    #[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned paths")]
    fn presence<'py>(
        py: Python<'py>,
        id: &str,
        precision: &str,
        folder: PathBuf,
    ) -> PyResult<Bound<'py, PyDict>> {
        let choice = Choice::find(id, precision).map_err(IntoPyErr::into_py_err)?;
        let (state, path, bytes, total) = match hub::presence(&folder, &choice) {
            Presence::Absent => ("absent", None, 0, choice.bytes()),
            Presence::Partial(bytes, total) => ("partial", None, bytes, total),
            Presence::Present(path) => ("present", Some(path), choice.bytes(), choice.bytes()),
            Presence::Cached(path) => ("cached", Some(path), choice.bytes(), choice.bytes()),
        };
        let dict = PyDict::new(py);
        dict.set_item("state", state)?;
        dict.set_item("path", path)?;
        dict.set_item("bytes", bytes)?;
        dict.set_item("total", total)?;
        Ok(dict)
    }

    /// Deletes a guide that was downloaded into `folder`, or what an unfinished download left there.
    #[pyfunction]
    #[pyo3(signature = (id, precision, folder))]
    #[expect(clippy::needless_pass_by_value, reason = "pyo3 extracts owned paths")]
    fn remove(id: &str, precision: &str, folder: PathBuf) -> PyResult<()> {
        let choice = Choice::find(id, precision).map_err(IntoPyErr::into_py_err)?;
        hub::discard(&folder, &choice)
            .and_then(|()| hub::remove(&folder, &choice))
            .map_err(IntoPyErr::into_py_err)
    }

    /// A download on a thread of its own; not started when made.
    #[pyclass(frozen, module = "boxmorph.guides")]
    struct Download(hub::Download);

    #[pymethods]
    impl Download {
        #[new]
        #[pyo3(signature = (id, precision, folder, *, endpoint=None, timeout=30.0, pause=1.0))]
        fn new(
            id: &str,
            precision: &str,
            folder: PathBuf,
            endpoint: Option<String>,
            timeout: f64,
            pause: f64,
        ) -> PyResult<Self> {
            let choice = Choice::find(id, precision).map_err(IntoPyErr::into_py_err)?;
            let spec = DownloadSpec {
                choice,
                root: folder,
                endpoint,
                patience: seconds(timeout, "timeout")?,
                pause: seconds(pause, "pause")?,
            };
            Ok(Self(hub::Download::new(spec)))
        }

        fn start(&self) -> PyResult<()> {
            self.0.start().map_err(IntoPyErr::into_py_err)
        }

        fn progress<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
            let progress = self.0.progress();
            let dict = PyDict::new(py);
            dict.set_item("phase", progress.phase)?;
            dict.set_item("file", progress.file)?;
            dict.set_item("bytes", progress.bytes)?;
            dict.set_item("total", progress.total)?;
            dict.set_item("seconds_left", progress.seconds_left)?;
            dict.set_item("trouble", progress.trouble)?;
            dict.set_item("finished", progress.finished)?;
            Ok(dict)
        }

        fn cancel(&self) {
            self.0.cancel();
        }

        fn join(&self, py: Python<'_>) -> PyResult<()> {
            py.detach(|| self.0.join()).map_err(IntoPyErr::into_py_err)
        }

        fn result(&self) -> PyResult<PathBuf> {
            self.0.result().map_err(IntoPyErr::into_py_err)
        }
    }

    fn seconds(value: f64, name: &str) -> PyResult<Duration> {
        Duration::try_from_secs_f64(value)
            .ok()
            .filter(|duration| *duration <= Duration::from_hours(1))
            .ok_or_else(|| PyValueError::new_err(format!("{name} must be 0 to 3600 seconds")))
    }
}
