// SPDX-License-Identifier: MIT OR Apache-2.0
//! The cache that other programs keep of the hub on this machine; a guide that lies there is used in place.

use std::path::{Path, PathBuf};

use super::registry::Choice;

/// The snapshot that holds all files of a guide, if there is one.
pub fn cached(choice: &Choice) -> Option<PathBuf> {
    let repository = format!("models--{}", choice.entry.repository.replace('/', "--"));
    snapshots(&root()?.join(repository), &choice.entry.revision)
        .into_iter()
        .find(|snapshot| holds(snapshot, choice))
}

/// Whether a folder holds all files that a guide needs.
pub fn holds(folder: &Path, choice: &Choice) -> bool {
    choice.files().all(|file| file.optional || folder.join(&file.name).is_file())
}

/// The snapshots of a repository in the cache: first that of `revision`, a commit or a branch.
fn snapshots(repository: &Path, revision: &str) -> Vec<PathBuf> {
    let all = repository.join("snapshots");
    let commit = std::fs::read_to_string(repository.join("refs").join(revision));
    let commit = commit.map_or_else(|_| revision.to_owned(), |text| text.trim().to_owned());
    let mut found: Vec<PathBuf> = std::fs::read_dir(&all)
        .map(|entries| entries.filter_map(|entry| Some(entry.ok()?.path())).collect())
        .unwrap_or_default();
    found.sort_by_key(|path| (path.file_name() != Some(commit.as_ref()), path.clone()));
    found
}

/// The cache's folder, where the hub's own programs look for it.
fn root() -> Option<PathBuf> {
    let named = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    if let Some(cache) = named("HF_HUB_CACHE").or_else(|| named("HUGGINGFACE_HUB_CACHE")) {
        return Some(cache);
    }
    let home = named("HF_HOME").or_else(|| {
        let cache = named("XDG_CACHE_HOME").or_else(|| Some(std::env::home_dir()?.join(".cache")));
        Some(cache?.join("huggingface"))
    });
    Some(home?.join("hub"))
}
