// SPDX-License-Identifier: MIT OR Apache-2.0
//! One search within a job: so many images of a stage, its best judged by every image now and then, and shown.

use std::sync::Arc;

use super::JobError;
use super::entrant::Entrant;
use super::outcome::Stage;
use super::run::Run;
use crate::search::{Budget, Preset, Start};

/// First step size of a search that starts where another ended, in units of the search variable.
pub const NARROW: f64 = 0.3;

/// The largest budget with which a surrogate guesses candidates. It gains most with 500 images, a little with 1,600,
/// nothing with some thousand; and what it guesses crowds, where variations are chosen among all candidates.
const GUIDED: usize = 2500;

/// Generations after which what a search has come to is judged by every image: this costs a tenth of the images.
const LOOK: usize = 10;

/// Share of the seconds asked for, after which searches are broken off.
const LATE: f64 = 0.97;

impl<'a> Run<'a> {
    /// Searches a stage for so many images.
    pub fn climb(
        &mut self,
        stage: &Arc<Stage>,
        preset: &'a Preset,
        start: &Start,
        images: usize,
    ) -> Result<Entrant<'a>, JobError> {
        let mut entrant = self.enter(stage, preset, start, None)?;
        if self.budget <= GUIDED {
            entrant.search = entrant.search.guided();
        }
        self.advance(&mut entrant, images)?;
        self.judge(&mut entrant)?;
        Ok(entrant)
    }

    /// Goes on with a search until it has encoded so many more images, or ends.
    pub fn advance(&mut self, entrant: &mut Entrant<'a>, images: usize) -> Result<(), JobError> {
        let end = self.spent.images + images;
        while entrant.search.stop_reason().is_none() && self.spent.images < end && !self.is_late() {
            self.step(entrant)?;
            if entrant.search.generations().is_multiple_of(LOOK) {
                self.judge(entrant)?;
            }
            let fraction = self.spent.images as f64 / self.budget.max(1) as f64;
            self.tell_share(fraction.min(1.0));
        }
        Ok(())
    }

    /// Judges what a search has come to by every image, and shows it.
    pub fn judge(&mut self, entrant: &mut Entrant<'a>) -> Result<(), JobError> {
        let judged = entrant.judge()?;
        self.count(entrant, judged);
        if entrant.has_improved() {
            self.show(&entrant.stage.clone(), entrant.score(), entrant.factors());
        }
        Ok(())
    }

    /// Whether the seconds asked for are all but over.
    pub fn is_late(&self) -> bool {
        matches!(self.spec.preset.budget, Some(Budget::Seconds(seconds)) if self.harness.seconds() >= LATE * seconds)
    }
}
