// SPDX-License-Identifier: MIT OR Apache-2.0
//! The hidden folder in which a guide grows until it is whole, beside where it is to be.
//!
//! A file there that bears its own name is whole; one that ends in `.part` has its hash in its name, so that a
//! later run goes on only with the same file. A lock beside the folder keeps other processes out.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::HubError;
use super::hash::Hash;
use super::registry::Choice;

/// What is kept with a guide: where it is from.
pub const RECORD: &str = "boxmorph.json";

/// What is kept with a guide that is not whole: how many bytes it will have.
const TOTAL: &str = "total.json";

#[derive(Serialize, Deserialize)]
struct Total {
    bytes: u64,
}

/// The folder of a guide that is not whole yet.
#[derive(Debug)]
pub struct Staging {
    folder: PathBuf,
    lock_path: PathBuf,
    lock: Option<File>,
}

impl Staging {
    /// Makes the folder, or takes up the one that is there.
    pub fn open(root: &Path, choice: &Choice) -> Result<Self, HubError> {
        let folder = Self::path(root, choice);
        fs::create_dir_all(&folder).map_err(|error| HubError::folder(&folder, &error))?;
        let lock_path = folder.with_added_extension("lock");
        let lock = File::create(&lock_path).map_err(|error| HubError::folder(&lock_path, &error))?;
        match lock.try_lock() {
            Ok(()) => Ok(Self { folder, lock_path, lock: Some(lock) }),
            Err(TryLockError::WouldBlock) => Err(HubError::Busy(root.display().to_string())),
            // Some network drives know no locks: better a download without than none.
            Err(TryLockError::Error(_)) => Ok(Self { folder, lock_path, lock: None }),
        }
    }

    /// Where the folder is, whether it exists or not.
    pub fn path(root: &Path, choice: &Choice) -> PathBuf {
        root.join(format!(".download-{}", choice.folder_name()))
    }

    /// The bytes that an unfinished download has and will have; none where there is none.
    pub fn progress(root: &Path, choice: &Choice) -> Option<(u64, u64)> {
        let folder = Self::path(root, choice);
        let here = bytes_below(&folder).ok().filter(|&bytes| bytes > 0)?;
        let total =
            fs::read(folder.join(TOTAL)).ok().and_then(|text| serde_json::from_slice::<Total>(&text).ok());
        Some((here, total.map_or_else(|| choice.bytes(), |total| total.bytes).max(here)))
    }

    /// Where a file is once it is whole.
    pub fn whole(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Where a file of this hash is while it comes. Parts of others by this name are deleted.
    pub fn part(&self, name: &str, hash: &Hash) -> Result<PathBuf, HubError> {
        let whole = self.whole(name);
        let folder = whole.parent().unwrap_or(&self.folder);
        let failed = |error: io::Error| HubError::folder(folder, &error);
        fs::create_dir_all(folder).map_err(failed)?;
        let file = whole.file_name().unwrap_or_default().to_string_lossy();
        let part = folder.join(format!("{file}.{}.part", &hash.digits()[..16]));
        for entry in fs::read_dir(folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            let other = path.file_name().unwrap_or_default().to_string_lossy();
            if path != part && other.starts_with(&format!("{file}.")) && other.ends_with(".part") {
                remove_file(&path)?;
            }
        }
        Ok(part)
    }

    /// Keeps how many bytes there will be.
    pub fn keep_total(&self, bytes: u64) -> Result<(), HubError> {
        self.write(TOTAL, &Total { bytes })
    }

    /// Makes the guide appear in its place, whole, with a record of where it is from.
    pub fn finish(mut self, target: &Path, record: &impl Serialize) -> Result<(), HubError> {
        self.write(RECORD, record)?;
        remove_file(&self.folder.join(TOTAL))?;
        fs::rename(&self.folder, target).map_err(|error| HubError::folder(target, &error))?;
        self.release();
        Ok(())
    }

    fn write(&self, name: &str, value: &impl Serialize) -> Result<(), HubError> {
        let path = self.folder.join(name);
        let text = serde_json::to_vec_pretty(value).map_err(|error| HubError::Fault(error.to_string()))?;
        fs::write(&path, text).map_err(|error| HubError::folder(&path, &error))
    }

    fn release(&mut self) {
        if self.lock.take().is_some() {
            // Another process may hold its own by now; then it stays.
            let _ = fs::remove_file(&self.lock_path);
        }
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        self.release();
        // Nothing came: nothing stays.
        if bytes_below(&self.folder).is_ok_and(|bytes| bytes == 0) {
            let _ = fs::remove_dir_all(&self.folder);
        }
    }
}

/// Deletes what an unfinished download has left.
pub fn discard(root: &Path, choice: &Choice) -> Result<(), HubError> {
    let folder = Staging::path(root, choice);
    if !folder.exists() {
        return Ok(());
    }
    let staging = Staging::open(root, choice)?;
    let removed = fs::remove_dir_all(&folder).map_err(|error| HubError::folder(&folder, &error));
    drop(staging);
    removed
}

/// Deletes a guide that was downloaded; what else lies in its folder stays there, and so the folder.
pub fn remove(root: &Path, choice: &Choice) -> Result<(), HubError> {
    let folder = root.join(choice.folder_name());
    for name in choice.files().map(|file| file.name.as_str()).chain([RECORD]) {
        remove_file(&folder.join(name))?;
    }
    for path in [folder.join("onnx"), folder] {
        let _ = fs::remove_dir(path);
    }
    Ok(())
}

/// Deletes a file that may be missing.
pub fn remove_file(path: &Path) -> Result<(), HubError> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(HubError::folder(path, &error)),
        _ => Ok(()),
    }
}

/// The bytes of a guide's files in a folder, which may be missing: whole ones and parts.
fn bytes_below(folder: &Path) -> io::Result<u64> {
    let mut total = 0;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            total += bytes_below(&entry.path())?;
        } else if entry.file_name() != TOTAL {
            total += entry.metadata()?.len();
        }
    }
    Ok(total)
}
