// SPDX-License-Identifier: MIT OR Apache-2.0
//! What the outside sees of a running download, and how it says stop.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// A snapshot of a download.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Progress {
    /// What is being done, in words.
    pub phase: String,
    /// The file that comes.
    pub file: String,
    /// Bytes that are here, those of earlier runs too.
    pub bytes: u64,
    /// Bytes of all files; 0 until the server has said.
    pub total: u64,
    /// Estimate of the seconds left, once there is one.
    pub seconds_left: Option<f64>,
    /// Why something is tried again; empty while all goes well.
    pub trouble: String,
    /// True when the download has ended, in whatever way.
    pub finished: bool,
}

/// The shared side of a download: written by its thread, read by anyone.
#[derive(Debug, Default)]
pub struct Harness {
    cancelled: AtomicBool,
    state: Mutex<State>,
}

#[derive(Debug, Default)]
struct State {
    progress: Progress,
    /// Bytes that came from the server in this run, and since when.
    came: u64,
    since: Option<Instant>,
}

impl Harness {
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Release);
    }

    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Acquire)
    }

    /// Changes the snapshot.
    pub fn update(&self, change: impl FnOnce(&mut Progress)) {
        change(&mut self.state().progress);
    }

    /// Counts bytes that came from the server.
    pub fn count(&self, bytes: u64) {
        let mut state = self.state();
        state.since.get_or_insert_with(Instant::now);
        state.came += bytes;
        state.progress.bytes += bytes;
        state.progress.trouble.clear();
    }

    pub fn progress(&self) -> Progress {
        let state = self.state();
        let mut progress = state.progress.clone();
        let seconds = state.since.map_or(0.0, |since| since.elapsed().as_secs_f64());
        // In the first second, the rate says nothing.
        if seconds > 1.0 && state.came > 0 && !progress.finished {
            let left = progress.total.saturating_sub(progress.bytes) as f64;
            progress.seconds_left = Some(left * seconds / state.came as f64);
        }
        progress
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
