// SPDX-License-Identifier: MIT OR Apache-2.0
//! The search on a budget: many short searches of few parts, fewer of more parts that start where the best of those
//! ended, and the best of all on to the end.
//!
//! Where a search of few parts ends decides which optimum one of many parts finds, and costs little. Half of the
//! budget goes into finding a good start, half into going on from it. Where another name is still ahead of the prompt
//! before the last quarter, that goes into another way, which begins with the score alone: no rival leads it away.

use std::sync::Arc;

use super::JobError;
use super::entrant::Entrant;
use super::outcome::Stage;
use super::run::{AGAIN, Run};
use crate::search::{Budget, Preset, Start, StopReason, inherit};

/// First step size of a search that starts where one of fewer parts ended, in units of the search variable.
const NARROW: f64 = 0.3;

/// Share of the budget that is spent before the best is gone on with.
const SCOUTING: f64 = 0.5;

/// Share of the budget that is left for another way where a rival is still ahead of the best.
const DETOUR: f64 = 0.25;

/// Of that, the share in which nothing but the score counts, and that after which the way is compared with the best.
const UNRIVALLED: f64 = 0.5;
const TRIAL: f64 = 0.25;

/// Searches of the fewest parts where the budget is [`USUAL`]; more with the power [`GROWTH`] of a larger one.
const SCOUTS: f64 = 3.0;
const USUAL: f64 = 4400.0;
const GROWTH: f64 = 0.45;

/// The largest budget with which a surrogate guesses candidates. It gains most with 500 images, a little with 1,600,
/// nothing with some thousand; and what it guesses crowds, where variations are chosen among all candidates.
const GUIDED: usize = 2500;

/// Searches of more parts, as shares of those of the fewest.
const FOLLOWERS: [f64; 2] = [0.6, 0.3];

/// Generations after which what a search has come to is judged by every image: this costs a tenth of the images.
const LOOK: usize = 10;

/// Searches whose outcome is looked at in the end.
const FINALISTS: usize = 3;

/// Generations after which the pace of a search is known, or a share of the seconds if that is over before.
const PACED: usize = 4;
const PACING: f64 = 0.1;

/// The least and the most that a budget in seconds comes to, in images.
const LEAST_IMAGES: usize = 100;
const MOST_IMAGES: usize = 1_000_000;

/// Of the seconds asked for, the share that the budget is made for, and that after which searches are broken off.
const MEANT: f64 = 0.85;
const LATE: f64 = 0.97;

impl<'a> Run<'a> {
    /// Searches the stages, from few parts to many, within the budget.
    pub fn coarse_to_fine(&mut self, stages: &[Arc<Stage>], budget: Budget) -> Result<(), JobError> {
        let images = match budget {
            Budget::Images(images) => images,
            Budget::Seconds(seconds) => self.images_in(seconds, &stages[0])?,
        };
        self.budget = images;
        let end = self.spent.images + images;
        let mut field: Vec<Entrant<'a>> = Vec::new();
        let mut number = 0;
        for (level, stage) in stages.iter().enumerate() {
            self.tell(stage);
            let count = searches(level, images);
            let share = (SCOUTING * images as f64) as usize / (stages.len() * count);
            let starts = self.starts(stage, &field[..field.len().min(count)], count);
            for (mut start, number) in starts.into_iter().zip(number..) {
                // With a slow guide and little time not every start is tried.
                if self.is_late() && !field.is_empty() {
                    break;
                }
                start.seed = self.spec.seed.wrapping_add(number * AGAIN);
                let entrant = self.climb(stage, &self.spec.preset, &start, share)?;
                field.push(entrant);
            }
            number += count as u64;
            field.sort_by(|a, b| a.loss().total_cmp(&b.loss()));
        }
        self.detour(&mut field, end, number)?;
        // One that ends before the budget does leaves the rest to the next.
        for entrant in field.iter_mut().take(FINALISTS) {
            let left = end.saturating_sub(self.spent.images);
            if left == 0 || self.is_late() {
                break;
            }
            self.tell(&entrant.stage.clone());
            self.advance(entrant, left)?;
            self.judge(entrant)?;
        }
        for (place, mut entrant) in field.into_iter().enumerate() {
            // Those behind are asked only where none before them is better than what was given.
            if (place >= FINALISTS || self.is_late())
                && self.winner.as_ref().is_some_and(|winner| winner.improved)
            {
                break;
            }
            let stop = entrant.search.stop_reason().unwrap_or(StopReason::MaxEvaluations);
            let best = entrant.factors().to_vec();
            self.conclude(&mut entrant, best, stop)?;
        }
        match stages.last() {
            Some(stage) if self.winner.as_ref().is_some_and(|winner| !winner.improved) && !self.is_late() => {
                self.again(stage)
            }
            _ => Ok(()),
        }
    }

    /// Goes on with the best and, where a rival is ahead of it then, tries another way: for the score alone at first.
    fn detour(&mut self, field: &mut Vec<Entrant<'a>>, end: usize, number: u64) -> Result<(), JobError> {
        let Some(leader) = field.first_mut() else { return Ok(()) };
        let images = (DETOUR * self.budget as f64) as usize;
        let stage = leader.stage.clone();
        self.tell(&stage);
        self.advance(leader, end.saturating_sub(self.spent.images + images))?;
        self.judge(leader)?;
        if !leader.is_outdone() || self.is_late() {
            return Ok(());
        }
        let seed = self.spec.seed.wrapping_add(number * AGAIN);
        let start = Start { factors: stage.whole.unchanged(), sigma: self.spec.preset.sigma, seed };
        let alone = self.climb(&stage, self.unrivalled, &start, (UNRIVALLED * images as f64) as usize)?;
        let start =
            Start { factors: alone.factors().to_vec(), sigma: NARROW, seed: seed.wrapping_add(AGAIN) };
        let other = self.climb(&stage, &self.spec.preset, &start, (TRIAL * images as f64) as usize)?;
        field.push(other);
        field.sort_by(|a, b| a.loss().total_cmp(&b.loss()));
        Ok(())
    }

    /// Searches a stage once more for the score alone, for half of the budget at most: where the prompt is far off,
    /// its rivals lead away from what little there is to gain.
    fn again(&mut self, stage: &Arc<Stage>) -> Result<(), JobError> {
        let (sigma, seed) = (self.spec.preset.sigma, self.spec.seed.wrapping_sub(AGAIN));
        let start = Start { factors: stage.whole.unchanged(), sigma, seed };
        let mut entrant = self.enter(stage, self.again, &start, None)?;
        let end = self.spent.images + self.budget / 2;
        while entrant.search.stop_reason().is_none() && self.spent.images < end && !self.is_late() {
            self.step(&mut entrant)?;
        }
        let stop = entrant.search.stop_reason().unwrap_or(StopReason::MaxEvaluations);
        let best = entrant.search.best().to_vec();
        self.conclude(&mut entrant, best, stop)
    }

    /// Where the searches of a stage start: at the best of fewer parts or, where there are none, at the unchanged
    /// object.
    fn starts(&self, stage: &Stage, best: &[Entrant<'_>], count: usize) -> Vec<Start> {
        let inherited = best.iter().map(|entrant| {
            let mut factors = stage.whole.unchanged();
            let scales = inherit(&stage.graph, &entrant.stage.whole.deform(entrant.factors()));
            factors[..scales.len()].copy_from_slice(&scales);
            Start { factors, sigma: NARROW, seed: 0 }
        });
        let sigma = self.spec.preset.sigma;
        let fresh = std::iter::repeat_with(|| Start { factors: stage.whole.unchanged(), sigma, seed: 0 });
        inherited.chain(fresh).take(count).collect()
    }

    /// Searches a stage for so many images.
    fn climb(
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
    fn advance(&mut self, entrant: &mut Entrant<'a>, images: usize) -> Result<(), JobError> {
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
    fn judge(&mut self, entrant: &mut Entrant<'a>) -> Result<(), JobError> {
        let judged = entrant.judge()?;
        self.count(entrant, judged);
        if entrant.has_improved() {
            self.show(&entrant.stage.clone(), entrant.score(), entrant.factors());
        }
        Ok(())
    }

    /// The images that can be encoded in so many seconds from the start of the job, by the pace of a short search.
    fn images_in(&mut self, seconds: f64, stage: &Arc<Stage>) -> Result<usize, JobError> {
        let preset = &self.spec.preset;
        let start = Start { factors: stage.whole.unchanged(), sigma: preset.sigma, seed: self.spec.seed };
        let mut entrant = self.enter(stage, preset, &start, None)?;
        let (images, since) = (self.spent.images, self.harness.seconds());
        for _ in 0..PACED {
            self.step(&mut entrant)?;
            if self.harness.seconds() - since > PACING * seconds {
                break;
            }
        }
        let pace = (self.spent.images - images) as f64 / (self.harness.seconds() - since).max(1e-3);
        let left = (MEANT * seconds - self.harness.seconds()).max(0.0);
        Ok(((pace * left) as usize).clamp(LEAST_IMAGES, MOST_IMAGES))
    }

    fn is_late(&self) -> bool {
        matches!(self.spec.preset.budget, Some(Budget::Seconds(seconds)) if self.harness.seconds() >= LATE * seconds)
    }
}

/// Searches of a stage, the first being that of the fewest parts.
fn searches(level: usize, images: usize) -> usize {
    let scouts = (SCOUTS * (images as f64 / USUAL).powf(GROWTH)).round().max(1.0);
    let share = level.checked_sub(1).map_or(1.0, |later| FOLLOWERS[later.min(FOLLOWERS.len() - 1)]);
    (share * scouts).ceil() as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_larger_budget_looks_at_more_starts_and_fewer_are_followed() {
        let counts = |images: usize| [0, 1, 2, 3].map(|level| searches(level, images));
        assert_eq!(counts(1400), [2, 2, 1, 1]);
        assert_eq!(counts(4400), [3, 2, 1, 1]);
        assert_eq!(counts(22_500), [6, 4, 2, 2]);
        assert_eq!(counts(10), [1, 1, 1, 1]);
    }
}
