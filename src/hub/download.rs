// SPDX-License-Identifier: MIT OR Apache-2.0
//! A whole guide, from the hub to its folder: first what the server announces, then file by file.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::Serialize;

use super::HubError;
use super::cache::{cached, holds};
use super::client::{Client, Meta};
use super::endpoint::Endpoint;
use super::fetch::{Announced, Fetch};
use super::hash::Hash;
use super::progress::{Harness, Progress};
use super::registry::{Choice, RemoteFile};
use super::staging::{RECORD, Staging};
use super::wanted::Wanted;

/// Room that is to stay free on the disk.
const RESERVE: u64 = 50_000_000;

/// What is to be downloaded, and where to.
#[derive(Debug, Clone)]
pub struct DownloadSpec {
    /// The guide.
    pub choice: Choice,
    /// The folder of guides; it is made if it does not exist.
    pub root: PathBuf,
    /// The hub's address; none: that of the environment, else the usual one.
    pub endpoint: Option<String>,
    /// How long a silent server is waited for.
    pub patience: Duration,
    /// The wait before something is tried again; it doubles with each try.
    pub pause: Duration,
}

/// Where a guide is from: kept with it.
#[derive(Serialize)]
struct Record<'a> {
    guide: &'a str,
    precision: &'a str,
    repository: &'a str,
    revision: &'a str,
    licence: &'a str,
    files: Vec<RecordedFile<'a>>,
}

#[derive(Serialize)]
struct RecordedFile<'a> {
    name: &'a str,
    bytes: u64,
    hash: &'a str,
}

/// Does the work, and returns the guide's folder: the one made, or where the guide was all along.
pub fn run(spec: &DownloadSpec, harness: &Harness) -> Result<PathBuf, HubError> {
    bring(spec, harness).map_err(|error| {
        let Progress { bytes, total, .. } = harness.progress();
        let missing = if total == 0 { spec.choice.bytes() } else { total.saturating_sub(bytes) };
        error.of_guide(&spec.root, missing)
    })
}

fn bring(spec: &DownloadSpec, harness: &Harness) -> Result<PathBuf, HubError> {
    let choice = &spec.choice;
    let target = spec.root.join(choice.folder_name());
    if target.exists() {
        let is_ours = target.join(RECORD).is_file() && holds(&target, choice);
        return if is_ours { Ok(target) } else { Err(HubError::Exists(target.display().to_string())) };
    }
    if let Some(folder) = cached(choice) {
        return Ok(folder);
    }
    let endpoint = Endpoint::new(spec.endpoint.as_deref())?;
    let staging = Staging::open(&spec.root, choice)?;
    let client = Client::new(spec.patience);
    let fetch = Fetch { client: &client, staging: &staging, harness, pause: spec.pause };
    let (revision, announced) = announcements(choice, &endpoint, &fetch)?;

    let total = announced.iter().map(|file| file.bytes).sum();
    staging.keep_total(total)?;
    let here = Staging::progress(&spec.root, choice).map_or(0, |(here, _)| here.min(total));
    harness.update(|progress| (progress.bytes, progress.total) = (here, total));
    check_room(&spec.root, total - here)?;
    for file in &announced {
        fetch.file(file)?;
    }

    let entry = choice.entry;
    let record = Record {
        guide: &entry.id,
        precision: &choice.precision.name,
        repository: &entry.repository,
        revision: &revision,
        licence: &entry.licence,
        files: announced
            .iter()
            .map(|file| RecordedFile { name: &file.wanted.file, bytes: file.bytes, hash: file.hash.digits() })
            .collect(),
    };
    staging.finish(&target, &record)?;
    Ok(target)
}

/// What the server says of all files, and the one commit that they are of.
fn announcements(
    choice: &Choice,
    endpoint: &Endpoint,
    fetch: &Fetch,
) -> Result<(String, Vec<Announced>), HubError> {
    fetch.harness.update(|progress| progress.phase = "Asking the server".into());
    let repository = &choice.entry.repository;
    let cancelled = || fetch.harness.is_cancelled();
    let mut revision = choice.entry.revision.clone();
    let mut announced = Vec::new();
    for file in choice.files() {
        let address = endpoint.file(repository, &revision, &file.name);
        let mut wanted = Wanted { address, repository: repository.clone(), file: file.name.clone() };
        let meta = match fetch.persist(|_| fetch.client.meta(&wanted, &cancelled))? {
            Some(meta) => meta,
            None if file.optional => continue,
            None => {
                let (host, repository) = (endpoint.host(), repository.clone());
                return Err(HubError::NotFound { host, file: file.name.clone(), repository });
            }
        };
        // A branch may move on meanwhile: from the first answer on, it is one commit.
        if let Some(commit) = meta.commit.as_ref().filter(|commit| is_commit(commit)) {
            revision.clone_from(commit);
            wanted.address = endpoint.file(repository, &revision, &file.name);
        }
        let (hash, bytes) = check(file, &meta, endpoint)?;
        announced.push(Announced { wanted, hash, bytes });
    }
    Ok((revision, announced))
}

fn is_commit(text: &str) -> bool {
    text.len() == 40 && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Hash and size of a file; the hash is the one that we know, where we know it.
fn check(file: &RemoteFile, meta: &Meta, endpoint: &Endpoint) -> Result<(Hash, u64), HubError> {
    let lacks = |what: &str| HubError::Protocol {
        host: endpoint.host(),
        reason: format!("it names no {what} of {}", file.name),
    };
    let hash = meta.hash.clone().ok_or_else(|| lacks("hash"))?;
    let bytes = meta.bytes.ok_or_else(|| lacks("size"))?;
    match (&file.sha256, &hash) {
        (Some(known), Hash::Sha256(announced)) if known != announced => {
            Err(HubError::OtherFile { file: file.name.clone(), host: endpoint.host() })
        }
        (Some(known), _) => Ok((Hash::Sha256(known.clone()), bytes)),
        (None, _) => Ok((hash, bytes)),
    }
}

fn check_room(root: &Path, needed: u64) -> Result<(), HubError> {
    fs::create_dir_all(root).map_err(|error| HubError::folder(root, &error))?;
    let needed = needed.saturating_add(RESERVE);
    match fs4::available_space(root) {
        Ok(free) if free < needed => {
            Err(HubError::NoSpace { folder: root.display().to_string(), needed, free })
        }
        // Where the system does not say, the disk will.
        _ => Ok(()),
    }
}
