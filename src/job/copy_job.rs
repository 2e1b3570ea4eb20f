// SPDX-License-Identifier: MIT OR Apache-2.0
//! A copy of a guide in eight bits, made on the threads of jobs: it takes the better part of a minute for a large one.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;

use super::{JobError, background, lock};
use crate::guide::{CopyProgress, EightBitCopy, eight_bit_copy};

/// What is to be copied, and where to; see [`eight_bit_copy`].
#[derive(Debug, Clone)]
pub struct CopySpec {
    /// The guide's folder.
    pub folder: PathBuf,
    /// The copy's folder; `None` puts it beside the exact network.
    pub output: Option<PathBuf>,
    /// Threads that the two guides are compared with.
    pub threads: Option<usize>,
}

/// A running or finished copy. Dropping it cancels the work, which leaves nothing behind then.
#[derive(Debug)]
pub struct CopyJob {
    spec: CopySpec,
    shared: Arc<Shared>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

#[derive(Debug, Default)]
struct Shared {
    cancelled: AtomicBool,
    progress: Mutex<Option<CopyProgress>>,
    outcome: Mutex<Option<Result<EightBitCopy, JobError>>>,
}

impl CopyJob {
    /// A copy that is not started.
    #[must_use]
    pub fn new(spec: CopySpec) -> Self {
        Self { spec, shared: Arc::default(), thread: Mutex::default() }
    }

    /// Starts the work on a thread of its own.
    pub fn start(&self) -> Result<(), JobError> {
        let mut thread = lock(&self.thread);
        if thread.is_some() || self.is_finished() {
            return Err(JobError::AlreadyStarted);
        }
        let (spec, shared) = (self.spec.clone(), self.shared.clone());
        let work = move || {
            let watch = |progress| {
                *lock(&shared.progress) = Some(progress);
                !shared.cancelled.load(Ordering::Acquire)
            };
            let copy = || eight_bit_copy(&spec.folder, spec.output.as_deref(), spec.threads, &watch);
            let result = catch_unwind(AssertUnwindSafe(|| background::in_background(copy)));
            *lock(&shared.outcome) = Some(match result {
                Ok(done) => done.map_err(JobError::from),
                Err(panic) => Err(JobError::from_panic(panic.as_ref())),
            });
        };
        let spawned = std::thread::Builder::new().name("boxmorph-copy".into()).spawn(work);
        *thread = Some(spawned.map_err(|error| JobError::Thread(error.to_string()))?);
        Ok(())
    }

    /// How far it is, once it has begun.
    #[must_use]
    pub fn progress(&self) -> Option<CopyProgress> {
        *lock(&self.shared.progress)
    }

    /// Whether it has ended, in whatever way.
    #[must_use]
    pub fn is_finished(&self) -> bool {
        lock(&self.shared.outcome).is_some()
    }

    /// Asks the work to stop; it does after the step that it is in, some seconds at most.
    pub fn cancel(&self) {
        self.shared.cancelled.store(true, Ordering::Release);
    }

    /// Waits for the end of the work and says how it ended.
    pub fn join(&self) -> Result<(), JobError> {
        let handle = lock(&self.thread).take();
        if let Some(handle) = handle {
            handle.join().map_err(|panic| JobError::from_panic(panic.as_ref()))?;
        }
        match &*lock(&self.shared.outcome) {
            Some(Err(error)) => Err(error.clone()),
            _ => Ok(()),
        }
    }

    /// The copy, once it is there.
    pub fn result(&self) -> Result<EightBitCopy, JobError> {
        lock(&self.shared.outcome).clone().unwrap_or(Err(JobError::NotFinished))
    }
}

impl Drop for CopyJob {
    fn drop(&mut self) {
        self.cancel();
    }
}
