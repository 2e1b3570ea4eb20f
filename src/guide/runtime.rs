// SPDX-License-Identifier: MIT OR Apache-2.0
//! ONNX Runtime's library: found, opened once a process, and kept.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use ort::environment::Environment;

use super::GuideError;

static ENVIRONMENT: Mutex<Option<Environment>> = Mutex::new(None);
static DEFAULT_LIBRARY: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Names the library to open where `ORT_DYLIB_PATH` names none: the one inside the Python wheel.
pub fn set_default_library(path: &Path) {
    if let Ok(mut default) = DEFAULT_LIBRARY.lock() {
        *default = Some(path.to_owned());
    }
}

/// The process's environment, opened on first use. A failure is not kept: a better path may follow.
pub fn environment() -> Result<Environment, GuideError> {
    let path = library_path();
    let error = |reason: String| GuideError::Library { path: path.display().to_string(), reason };
    let mut opened = ENVIRONMENT.lock().map_err(|e| error(e.to_string()))?;
    if let Some(environment) = opened.as_ref() {
        return Ok(environment.clone());
    }
    let environment = ort::init_from(&path)
        .map_err(|e| error(e.to_string()))?
        .with_name("boxmorph")
        .with_telemetry(false)
        .build()
        .map_err(|e| error(e.to_string()))?;
    *opened = Some(environment.clone());
    Ok(environment)
}

fn library_path() -> PathBuf {
    if let Some(path) = std::env::var_os("ORT_DYLIB_PATH").filter(|path| !path.is_empty()) {
        return path.into();
    }
    if let Some(path) = DEFAULT_LIBRARY.lock().ok().and_then(|default| default.clone()) {
        return path;
    }
    let name = if cfg!(windows) {
        "onnxruntime.dll"
    } else if cfg!(target_os = "macos") {
        "libonnxruntime.dylib"
    } else {
        "libonnxruntime.so"
    };
    name.into()
}
