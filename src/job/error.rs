// SPDX-License-Identifier: MIT OR Apache-2.0
//! How a job can fail.

use std::any::Any;
use std::sync::Arc;

use thiserror::Error;

use super::MOST_VARIATIONS;
use crate::boxdef::BoxDefError;
use crate::guide::GuideError;
use crate::render::RenderError;
use crate::search::{ObjectiveError, PromptError, SearchError, SpaceError};

/// Why a job gives no outcome. Cheap to clone: it is reported each time the result is asked for.
#[derive(Debug, Clone, Error)]
pub enum JobError {
    /// The user cancelled.
    #[error("the deformation was cancelled; the object is unchanged")]
    Cancelled,
    /// `start` was called twice.
    #[error("this job was started before; make a new one to run it again")]
    AlreadyStarted,
    /// `result` was called too early.
    #[error("the job has not finished; call start() and join() first")]
    NotFinished,
    /// No thread could be had.
    #[error("no thread could be started for the job ({0}); close other programs and try again")]
    Thread(String),
    /// The extra points are not numbers.
    #[error("the points hold NaN or infinite coordinates; repair the base mesh")]
    BadPoints,
    /// An outcome of another mesh.
    #[error(
        "the outcome has {found} vertices and the mesh {expected}; give positions of the mesh's vertices"
    )]
    OtherOutcome {
        /// Vertices of the mesh.
        expected: usize,
        /// Positions given.
        found: usize,
    },
    /// A spectrum that is not of numbers.
    #[error("the outcome or the values along its spectrum are NaN or infinite; give finite numbers")]
    BadSpectrum,
    /// The graph belongs to another mesh.
    #[error("the graph was built from a mesh of other vertices; build it from this one")]
    OtherMesh,
    /// A graph was given, and how to make one.
    #[error("a graph has its parts and boundary already; give either the graph, or splits and boundary")]
    GraphAndParts,
    /// Locks without the graph whose rows they name.
    #[error("locked names the parameter rows of a graph; give that graph too")]
    LocksWithoutGraph,
    /// More variations than there can be, or none.
    #[error("variations must be a whole number from 1 to {MOST_VARIATIONS}")]
    Variations,
    /// What is asked for cannot be.
    #[error(transparent)]
    Prompt(Arc<PromptError>),
    /// There is nothing to search.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// A defect of ours.
    #[error("Boxmorph failed in a way that was not foreseen ({0}); please report it with the object")]
    Panic(String),
    /// The guide failed.
    #[error(transparent)]
    Guide(Arc<GuideError>),
    /// The renderer failed.
    #[error(transparent)]
    Render(Arc<RenderError>),
    /// The part graph failed.
    #[error(transparent)]
    BoxDef(Arc<BoxDefError>),
    /// The search failed.
    #[error(transparent)]
    Search(Arc<SearchError>),
}

impl JobError {
    pub(super) fn from_panic(panic: &(dyn Any + Send)) -> Self {
        let text = panic.downcast_ref::<&str>().map(ToString::to_string);
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Self::Panic(text.unwrap_or_else(|| "no message".into()))
    }
}

impl From<GuideError> for JobError {
    fn from(error: GuideError) -> Self {
        Self::Guide(Arc::new(error))
    }
}

impl From<PromptError> for JobError {
    fn from(error: PromptError) -> Self {
        match error {
            PromptError::Guide(error) => Self::Guide(error),
            error => Self::Prompt(Arc::new(error)),
        }
    }
}

impl From<RenderError> for JobError {
    fn from(error: RenderError) -> Self {
        Self::Render(Arc::new(error))
    }
}

impl From<BoxDefError> for JobError {
    fn from(error: BoxDefError) -> Self {
        Self::BoxDef(Arc::new(error))
    }
}

impl From<SearchError> for JobError {
    fn from(error: SearchError) -> Self {
        Self::Search(Arc::new(error))
    }
}

impl From<ObjectiveError> for JobError {
    fn from(error: ObjectiveError) -> Self {
        match error {
            ObjectiveError::Guide(error) => error.into(),
            ObjectiveError::Render(error) => error.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_a_sentence() {
        let part = 3;
        let panic = std::panic::catch_unwind(|| panic!("part {part} is missing")).expect_err("it panics");
        let error = JobError::from_panic(panic.as_ref()).to_string();
        assert!(error.contains("(part 3 is missing); please report it"), "{error}");
    }
}
