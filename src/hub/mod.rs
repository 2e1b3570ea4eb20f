// SPDX-License-Identifier: MIT OR Apache-2.0
//! Guides from the Hugging Face hub, or a mirror of it: which there are, and the way to the user's disk.
//!
//! Nothing but the files that the registry names is asked for or written. A guide appears in its folder only
//! when it is whole and each file has the hash that the hub announces. Knows nothing of how guides are opened.

mod cache;
mod client;
mod download;
mod endpoint;
mod error;
mod failure;
mod fetch;
mod hash;
mod progress;
mod proxy;
mod registry;
mod staging;
mod wanted;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

pub use download::DownloadSpec;
pub use error::HubError;
pub use progress::Progress;
pub use registry::{Choice, Entry, Precision, RemoteFile, registry};
pub use staging::{discard, remove};

use progress::Harness;
use staging::Staging;

/// The longest that a server may ask to be left alone before it is given up.
const LONGEST_WAIT: Duration = Duration::from_secs(90);

/// How much of a guide is on this machine.
#[derive(Debug, Clone, PartialEq)]
pub enum Presence {
    /// Nothing.
    Absent,
    /// Some bytes, of so many.
    Partial(u64, u64),
    /// All, in this folder, by a download.
    Present(PathBuf),
    /// All, in this folder of the cache that other programs keep of the hub.
    Cached(PathBuf),
}

/// How much of a guide is in the folder of guides `root`, or in the hub's cache.
#[must_use]
pub fn presence(root: &Path, choice: &Choice) -> Presence {
    let folder = root.join(choice.folder_name());
    if cache::holds(&folder, choice) {
        return Presence::Present(folder);
    }
    if let Some(folder) = cache::cached(choice) {
        return Presence::Cached(folder);
    }
    Staging::progress(root, choice).map_or(Presence::Absent, |(here, total)| Presence::Partial(here, total))
}

/// A running or finished download. Dropping it cancels the work; what has come is kept.
#[derive(Debug)]
pub struct Download {
    spec: DownloadSpec,
    harness: Arc<Harness>,
    thread: Mutex<Option<JoinHandle<()>>>,
    outcome: Arc<Mutex<Option<Result<PathBuf, HubError>>>>,
}

impl Download {
    /// A download that is not started.
    #[must_use]
    pub fn new(spec: DownloadSpec) -> Self {
        let harness = Arc::<Harness>::default();
        harness.update(|progress| progress.phase = "Waiting".into());
        Self { spec, harness, thread: Mutex::default(), outcome: Arc::default() }
    }

    /// Starts the work on a thread of its own.
    pub fn start(&self) -> Result<(), HubError> {
        let mut thread = lock(&self.thread);
        if thread.is_some() || lock(&self.outcome).is_some() {
            return Err(HubError::AlreadyStarted);
        }
        let (spec, harness, outcome) = (self.spec.clone(), self.harness.clone(), self.outcome.clone());
        let work = move || {
            let result = catch_unwind(AssertUnwindSafe(|| download::run(&spec, &harness)));
            let result = result.unwrap_or_else(|panic| {
                let reason = panic.downcast_ref::<&str>().map(ToString::to_string);
                let reason = reason.or_else(|| panic.downcast_ref::<String>().cloned());
                Err(HubError::Fault(reason.unwrap_or_else(|| "unknown".into())))
            });
            *lock(&outcome) = Some(result);
            harness.update(|progress| progress.finished = true);
        };
        let spawned = std::thread::Builder::new().name("boxmorph-download".into()).spawn(work);
        *thread = Some(spawned.map_err(|error| HubError::Thread(error.to_string()))?);
        Ok(())
    }

    /// Where the work stands.
    #[must_use]
    pub fn progress(&self) -> Progress {
        self.harness.progress()
    }

    /// Asks the work to stop; it does at once, and what has come is kept.
    pub fn cancel(&self) {
        self.harness.cancel();
    }

    /// Waits for the end of the work and says how it ended.
    pub fn join(&self) -> Result<(), HubError> {
        let handle = lock(&self.thread).take();
        if let Some(handle) = handle {
            let _ = handle.join();
        }
        match &*lock(&self.outcome) {
            Some(Err(error)) => Err(error.clone()),
            _ => Ok(()),
        }
    }

    /// The guide's folder, once it is there.
    pub fn result(&self) -> Result<PathBuf, HubError> {
        lock(&self.outcome).clone().unwrap_or(Err(HubError::NotFinished))
    }
}

impl Drop for Download {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// Locks, also where another thread panicked while holding the lock: all values here are replaced whole.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
