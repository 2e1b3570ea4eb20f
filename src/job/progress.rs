// SPDX-License-Identifier: MIT OR Apache-2.0
//! What the outside sees of a running job, and how it says stop.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::lock;
use super::outcome::Best;

/// A snapshot of a job.
#[derive(Debug, Clone, PartialEq)]
pub struct Progress {
    /// What is being done, in words.
    pub phase: String,
    /// Generations done, over all split counts.
    pub generation: usize,
    /// Generations that there can be at most.
    pub generations: usize,
    /// Candidates evaluated.
    pub evaluations: usize,
    /// Score of the unchanged object, once known.
    pub score_before: Option<f64>,
    /// Best score so far, once there is one.
    pub best_score: Option<f64>,
    /// Share of the work done, 0 to 1.
    pub fraction: f64,
    /// Seconds since the start.
    pub seconds: f64,
    /// Estimate of the seconds left, once there is one.
    pub seconds_left: Option<f64>,
    /// True when the job has ended, in whatever way.
    pub finished: bool,
}

/// The shared side of a job: written by its thread, read by anyone.
#[derive(Debug)]
pub struct Harness {
    cancelled: AtomicBool,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    started: Option<Instant>,
    ended: Option<Instant>,
    progress: Progress,
    best: Option<Best>,
}

impl Default for Harness {
    fn default() -> Self {
        let progress = Progress {
            phase: "Waiting".into(),
            generation: 0,
            generations: 0,
            evaluations: 0,
            score_before: None,
            best_score: None,
            fraction: 0.0,
            seconds: 0.0,
            seconds_left: None,
            finished: false,
        };
        let state = State { started: None, ended: None, progress, best: None };
        Self { cancelled: AtomicBool::new(false), state: Mutex::new(state) }
    }
}

impl Harness {
    pub fn start(&self) {
        lock(&self.state).started = Some(Instant::now());
    }

    pub fn finish(&self) {
        let mut state = lock(&self.state);
        state.ended = Some(Instant::now());
        state.progress.finished = true;
    }

    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Release);
    }

    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Acquire)
    }

    /// Changes the snapshot.
    pub fn update(&self, change: impl FnOnce(&mut Progress)) {
        change(&mut lock(&self.state).progress);
    }

    pub fn set_best(&self, best: Best) {
        let mut state = lock(&self.state);
        state.progress.best_score = Some(best.score);
        state.best = Some(best);
    }

    pub fn best(&self) -> Option<Best> {
        lock(&self.state).best.clone()
    }

    pub fn seconds(&self) -> f64 {
        let state = lock(&self.state);
        state.started.map_or(0.0, |t| (state.ended.unwrap_or_else(Instant::now) - t).as_secs_f64())
    }

    pub fn progress(&self) -> Progress {
        let seconds = self.seconds();
        let mut progress = lock(&self.state).progress.clone();
        progress.seconds = seconds;
        if progress.finished {
            progress.fraction = 1.0;
        }
        // Before a twentieth is done, an estimate says nothing.
        let known = progress.fraction > 0.05;
        progress.seconds_left = known.then(|| seconds * (1.0 - progress.fraction) / progress.fraction);
        progress
    }
}
