// SPDX-License-Identifier: MIT OR Apache-2.0
//! Reading from a guide's folder: what is missing, too large or no file is told in a sentence.

use std::io::{ErrorKind, Read};
use std::path::Path;

use super::GuideError;

/// Largest file beside the networks; a tokenizer of 256,000 words has 34 MB.
const MAX_JSON_BYTES: u64 = 256 << 20;

/// Whether `path` is a file; an error where something else, or a link to nothing, is in its place.
pub fn regular_file(path: &Path) -> Result<bool, GuideError> {
    let shown = || path.display().to_string();
    match std::fs::metadata(path) {
        Ok(found) if found.is_file() => Ok(true),
        Ok(found) => {
            let what = if found.is_dir() { "a folder" } else { "a device or a pipe" };
            Err(GuideError::NotAFile { path: shown(), what })
        }
        Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
            if std::fs::symlink_metadata(path).is_ok() {
                return Err(GuideError::NotAFile { path: shown(), what: "a link to nothing" });
            }
            Ok(false)
        }
        Err(error) => Err(GuideError::Unreadable { path: shown(), reason: error.to_string() }),
    }
}

/// The bytes of a file that a guide's folder must have.
pub fn required(folder: &Path, name: &'static str) -> Result<Vec<u8>, GuideError> {
    optional(folder, name)?
        .ok_or_else(|| GuideError::MissingFile { folder: folder.display().to_string(), file: name.into() })
}

/// The bytes of a file that it may have; none where it is missing.
pub fn optional(folder: &Path, name: &str) -> Result<Option<Vec<u8>>, GuideError> {
    let path = folder.join(name);
    if regular_file(&path)? { read(&path, MAX_JSON_BYTES).map(Some) } else { Ok(None) }
}

/// The bytes of a file of `most` bytes at most.
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, GuideError> {
    let shown = || path.display().to_string();
    let unreadable = |e: std::io::Error| GuideError::Unreadable { path: shown(), reason: e.to_string() };
    let file = std::fs::File::open(path).map_err(unreadable)?;
    let length = file.metadata().map_err(unreadable)?.len();
    if length > most {
        return Err(GuideError::TooLarge { path: shown(), most: most >> 20 });
    }
    let mut bytes = Vec::with_capacity(length as usize);
    file.take(most).read_to_end(&mut bytes).map_err(unreadable)?;
    Ok(bytes)
}
