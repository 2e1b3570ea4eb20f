// SPDX-License-Identifier: MIT OR Apache-2.0
//! A deformation job: mesh and prompt in, outcome out, on a thread of its own.

mod background;
mod climb;
mod coarse_to_fine;
mod copy_job;
mod detour;
mod entrant;
mod error;
mod finalist;
mod in_full;
mod outcome;
mod pool;
mod progress;
mod proxy;
mod run;
mod soundness;
mod spectrum_scores;
mod variations;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;

use glam::Vec3;

pub use copy_job::{CopyJob, CopySpec};
pub use error::JobError;
pub use outcome::Outcome;
pub use progress::Progress;
pub use spectrum_scores::spectrum_scores;
pub use variations::MOST_VARIATIONS;

use crate::boxdef::{Boundary, BoxDefGraph, Symmetry};
use crate::guide::Guide;
use crate::mesh::Mesh;
use crate::render::{Backend, RenderError};
use crate::search::{KeepPlace, KeepSize, Preset, SearchSpace, Wording};
use progress::Harness;

/// What a job is to do. The guide is shared: it is opened once a session.
#[derive(Debug, Clone)]
pub struct JobSpec {
    /// The object as it is seen (modifiers applied), in object coordinates, z up.
    pub mesh: Mesh,
    /// What it should become.
    pub wording: Wording,
    /// Who judges.
    pub guide: Arc<Guide>,
    /// The budget.
    pub preset: Preset,
    /// Same seed, same outcome.
    pub seed: u64,
    /// The parts, where they are known already; `None` finds them.
    pub graph: Option<Arc<BoxDefGraph>>,
    /// Whether each parameter row of the given graph keeps its scale on x, y and z; `None` locks nothing.
    pub locked: Option<Vec<[bool; 3]>>,
    /// Least and greatest scale factor.
    pub scale_range: (f32, f32),
    /// Whether parts may also be shifted over those they hang on.
    pub shift_parts: bool,
    /// Split count; `None` tries those of the preset and keeps the best.
    pub splits: Option<u32>,
    /// Symmetry of the part boxes; `None` takes the preset's.
    pub symmetry: Option<Symmetry>,
    /// How parts follow each other where they meet; `None` takes the preset's.
    pub boundary: Option<Boundary>,
    /// Who draws.
    pub backend: Backend,
    /// Size kept by the gauge; `None` keeps the diagonal, or the locked parts' size where parts are locked.
    pub keep_size: Option<KeepSize>,
    /// Place kept by the gauge.
    pub keep_place: KeepPlace,
    /// Outcomes wanted, 1 to [`MOST_VARIATIONS`]: the best, and others that are nearly as good and far from it
    /// and from each other.
    pub variations: usize,
    /// Further points to be moved by the same field, such as a base mesh under modifiers.
    pub points: Option<Vec<Vec3>>,
}

impl JobSpec {
    /// What is asked for, with templates where this guide and this preset have them: the paper's has none.
    fn resolved_wording(&self) -> Wording {
        self.wording.resolved(&self.guide, self.preset.name != Preset::PAPER.name)
    }

    /// The size that the gauge keeps.
    fn kept_size(&self) -> KeepSize {
        // Unchanged scales and no gauge: what is locked keeps its size to the bit.
        let locks = self.locked.iter().flatten().flatten().any(|&locked| locked);
        let usual = if locks { KeepSize::Off } else { KeepSize::default() };
        self.keep_size.unwrap_or(usual)
    }
}

/// A running or finished deformation. Dropping it cancels the work.
#[derive(Debug)]
pub struct Job {
    spec: Arc<JobSpec>,
    harness: Arc<Harness>,
    thread: Mutex<Option<JoinHandle<()>>>,
    outcome: Arc<Mutex<Option<Ended>>>,
}

/// How the work ended.
type Ended = Result<Arc<Outcome>, JobError>;

impl Job {
    /// Checks what is to be done; nothing runs yet.
    pub fn new(spec: JobSpec) -> Result<Self, JobError> {
        spec.wording.check(&spec.guide)?;
        if !(1..=MOST_VARIATIONS).contains(&spec.variations) {
            return Err(JobError::Variations);
        }
        if let Some(points) = &spec.points
            && points.iter().any(|p| !p.is_finite())
        {
            return Err(JobError::BadPoints);
        }
        match &spec.graph {
            Some(_) if spec.splits.is_some() || spec.boundary.is_some() => {
                return Err(JobError::GraphAndParts);
            }
            Some(graph) if graph.field().rest() != spec.mesh.vertices() => return Err(JobError::OtherMesh),
            None if spec.locked.is_some() => return Err(JobError::LocksWithoutGraph),
            _ => {}
        }
        let rows = spec.graph.as_ref().map_or(1, |graph| graph.parameter_rows());
        SearchSpace::new(rows, spec.locked.as_deref(), spec.scale_range)?;
        Ok(Self {
            spec: Arc::new(spec),
            harness: Arc::new(Harness::default()),
            thread: Mutex::new(None),
            outcome: Arc::new(Mutex::new(None)),
        })
    }

    /// Starts the work on a thread of its own.
    pub fn start(&self) -> Result<(), JobError> {
        let mut thread = lock(&self.thread);
        if thread.is_some() || lock(&self.outcome).is_some() {
            return Err(JobError::AlreadyStarted);
        }
        let (spec, harness, outcome) = (self.spec.clone(), self.harness.clone(), self.outcome.clone());
        harness.start();
        let work = move || {
            let run = || background::in_background(|| run::run(&spec, &harness));
            let result = catch_unwind(AssertUnwindSafe(run));
            let result = result.unwrap_or_else(|panic| Err(JobError::from_panic(panic.as_ref())));
            *lock(&outcome) = Some(result.map(Arc::new));
            harness.finish();
        };
        let spawned = std::thread::Builder::new().name("boxmorph-job".into()).spawn(work);
        *thread = Some(spawned.map_err(|e| JobError::Thread(e.to_string()))?);
        Ok(())
    }

    /// Where the work stands.
    #[must_use]
    pub fn progress(&self) -> Progress {
        self.harness.progress()
    }

    /// Score and positions of the best candidate so far, gauge applied: those of the extra points where
    /// they were given, else of the mesh.
    #[must_use]
    pub fn best(&self) -> Option<(f64, Vec<Vec3>)> {
        self.harness.best().map(|best| (best.score, best.positions(&self.spec)))
    }

    /// A picture of the best candidate so far from the front right, once there is one: RGBA8 with straight alpha,
    /// size × size × 4, rows from the top. `size` is 8 to 2048.
    pub fn best_view(&self, size: u32) -> Result<Option<Vec<u8>>, RenderError> {
        self.harness.best().map(|best| best.view(size)).transpose()
    }

    /// Asks the work to stop; it does within one generation.
    pub fn cancel(&self) {
        self.harness.cancel();
    }

    /// Waits for the end of the work and says how it ended.
    pub fn join(&self) -> Result<(), JobError> {
        let handle = lock(&self.thread).take();
        if let Some(handle) = handle {
            handle.join().map_err(|panic| JobError::from_panic(panic.as_ref()))?;
        }
        match &*lock(&self.outcome) {
            Some(Err(error)) => Err(error.clone()),
            _ => Ok(()),
        }
    }

    /// The outcome of a finished job.
    pub fn result(&self) -> Result<Arc<Outcome>, JobError> {
        match &*lock(&self.outcome) {
            Some(result) => result.clone(),
            None => Err(JobError::NotFinished),
        }
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// Locks, also where another thread panicked while holding the lock: all values here are replaced whole.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
