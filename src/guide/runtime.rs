// SPDX-License-Identifier: MIT OR Apache-2.0
//! ONNX Runtime's library: found, opened once a process, and kept.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use ort::environment::Environment;

use super::GuideError;

static ENVIRONMENT: Mutex<Option<(Environment, PathBuf)>> = Mutex::new(None);
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
    let shown = path.display().to_string();
    let error = |reason: String| GuideError::Library { path: shown.clone(), reason };
    let mut opened = ENVIRONMENT.lock().map_err(|e| error(e.to_string()))?;
    if let Some((environment, _)) = opened.as_ref() {
        return Ok(environment.clone());
    }
    let environment = ort::init_from(&path)
        .map_err(|e| error(e.to_string()))?
        .with_name("boxmorph")
        .with_telemetry(false)
        .build()
        .map_err(|e| error(e.to_string()))?;
    *opened = Some((environment.clone(), path));
    Ok(environment)
}

/// The file of the library in use, opened if need be.
pub fn library() -> Result<PathBuf, GuideError> {
    environment()?;
    let opened = ENVIRONMENT.lock().ok().and_then(|opened| opened.as_ref().map(|(_, path)| path.clone()));
    Ok(opened.unwrap_or_else(library_path))
}

/// The version of the library in use, as far as its build or its file name tells; the library is opened if need
/// be.
pub fn version() -> Result<String, GuideError> {
    let file = library()?;
    let name = file.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
    Ok(version_of(ort::info(), &name))
}

/// Whether the library in use is not the one that came with Boxmorph.
pub fn is_own_library() -> Result<bool, GuideError> {
    let used = library()?;
    Ok(DEFAULT_LIBRARY.lock().ok().and_then(|default| default.clone()).is_some_and(|default| default != used))
}

/// The release branch that a build names, else the version in the file's name, else the commit.
fn version_of(build: &str, file: &str) -> String {
    let field = |name: &str| {
        let (_, value) = build.split_once(name)?;
        value.split(',').next().map(str::trim)
    };
    if let Some(release) = field("git-branch=").and_then(|branch| branch.strip_prefix("rel-")) {
        return release.to_owned();
    }
    let version = file.trim_start_matches(|c: char| !c.is_ascii_digit());
    let version: String = version.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    if version.contains('.') {
        return version.trim_end_matches('.').to_owned();
    }
    field("git-commit-id=").unwrap_or("unknown").to_owned()
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

#[cfg(test)]
mod tests {
    use super::version_of;

    #[test]
    fn the_version_is_the_release_else_the_files_else_the_commit() {
        let released = "ORT Build Info: git-branch=rel-1.24.1, git-commit-id=26250ae, build type=Release";
        assert_eq!(version_of(released, "libonnxruntime.so"), "1.24.1");
        let other = "ORT Build Info: git-branch=HEAD, git-commit-id=fab30a4, build type=Release";
        assert_eq!(version_of(other, "libonnxruntime.so.1.32.0"), "1.32.0");
        assert_eq!(version_of(other, "libonnxruntime.1.32.0.dylib"), "1.32.0");
        assert_eq!(version_of(other, "onnxruntime.dll"), "fab30a4");
        assert_eq!(version_of("", "onnxruntime.dll"), "unknown");
    }
}
