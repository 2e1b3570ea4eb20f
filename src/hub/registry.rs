// SPDX-License-Identifier: MIT OR Apache-2.0
//! The guides that are known to lie on the hub: data, `guides/registry.json`.

use std::sync::LazyLock;

use serde::Deserialize;

use super::HubError;

static REGISTRY: LazyLock<Registry> = LazyLock::new(|| {
    let text = include_str!("../../guides/registry.json");
    serde_json::from_str(text).expect("guides/registry.json is sound: tests/python/test_guides.py reads it")
});

#[derive(Debug, Deserialize)]
struct Registry {
    guides: Vec<Entry>,
}

/// A guide on the hub.
#[derive(Debug, Deserialize)]
pub struct Entry {
    /// Its name here, of which folders are named.
    pub id: String,
    /// Its name for people.
    pub title: String,
    /// Owner and name on the hub.
    pub repository: String,
    /// A commit, or the branch to take it from.
    pub revision: String,
    /// The licence of its weights.
    pub licence: String,
    /// Side of the images it reads, in pixels.
    pub image_size: u32,
    /// What it is good for, in a line.
    pub good_for: String,
    /// Files that every precision needs.
    pub files: Vec<RemoteFile>,
    /// The precisions there are, the most precise first.
    pub precisions: Vec<Precision>,
}

/// One precision of a guide.
#[derive(Debug, Deserialize)]
pub struct Precision {
    /// `fp32`, `fp16` or `int8`.
    pub name: String,
    /// Whether independent sources agree that the files have these names.
    pub verified: bool,
    /// What there is to know about it; empty: nothing.
    #[serde(default)]
    pub note: String,
    /// Its networks.
    pub files: Vec<RemoteFile>,
}

/// A file of a repository, by its path there.
#[derive(Debug, Deserialize)]
pub struct RemoteFile {
    /// Its path in the repository, and below the guide's folder.
    pub name: String,
    /// Its size, roughly.
    pub bytes: u64,
    /// Its SHA-256 where that is known, whatever a server says.
    pub sha256: Option<String>,
    /// Whether the guide is whole without it.
    #[serde(default)]
    pub optional: bool,
}

/// A guide in one precision: what is fetched.
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// The guide.
    pub entry: &'static Entry,
    /// The precision.
    pub precision: &'static Precision,
}

/// All guides, in the order in which they are offered.
#[must_use]
pub fn registry() -> &'static [Entry] {
    &REGISTRY.guides
}

impl Choice {
    /// The guide of this name in this precision.
    pub fn find(id: &str, precision: &str) -> Result<Self, HubError> {
        let entry = registry().iter().find(|entry| entry.id == id).ok_or_else(|| {
            let known = registry().iter().map(|entry| entry.id.as_str()).collect::<Vec<_>>().join(", ");
            HubError::UnknownGuide { id: id.into(), known }
        })?;
        let precision = entry.precisions.iter().find(|p| p.name == precision).ok_or_else(|| {
            let known = entry.precisions.iter().map(|p| p.name.as_str()).collect::<Vec<_>>().join(", ");
            HubError::UnknownPrecision { id: id.into(), precision: precision.into(), known }
        })?;
        Ok(Self { entry, precision })
    }

    /// Its files, the small ones first.
    pub fn files(&self) -> impl Iterator<Item = &'static RemoteFile> + use<> {
        self.entry.files.iter().chain(&self.precision.files)
    }

    /// The size of all files, roughly.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.files().map(|file| file.bytes).sum()
    }

    /// The name of its folder among the guides.
    #[must_use]
    pub fn folder_name(&self) -> String {
        format!("{}-{}", self.entry.id, self.precision.name)
    }
}
