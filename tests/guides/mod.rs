// SPDX-License-Identifier: MIT OR Apache-2.0
//! The embedded guide, where ONNX Runtime's library has been fetched.
#![allow(dead_code, reason = "each test binary uses some of it")]

use std::path::Path;

use boxmorph::guide::{Guide, set_default_library};

/// The embedded guide; none, with a line that says why, where there is no library to run it.
#[expect(clippy::print_stderr, reason = "a skipped test says why")]
pub fn mini() -> Option<Guide> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("python/boxmorph/onnxruntime");
    let files = std::fs::read_dir(&folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let is_library = |path: &std::path::PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        name.starts_with("libonnxruntime.") || name == "onnxruntime.dll"
    };
    if let Some(library) = files.into_iter().find(is_library) {
        set_default_library(&library);
    } else if std::env::var_os("ORT_DYLIB_PATH").is_none() {
        eprintln!(
            "skipped: there is no ONNX Runtime in {}; run scripts/fetch_onnxruntime.py",
            folder.display()
        );
        return None;
    }
    Some(Guide::open(None, None, None, None).expect("the embedded guide opens"))
}
