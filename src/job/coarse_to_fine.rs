// SPDX-License-Identifier: MIT OR Apache-2.0
//! The search on a budget: many short searches of few parts, fewer of more parts that start where the best of those
//! ended, and the best of all on to the end, or by a detour where a rival leads it away.
//!
//! Where a search of few parts ends decides which optimum one of many parts finds, and costs little. Half of the
//! budget goes into finding a good start, half into going on from it.

use std::sync::Arc;

use super::JobError;
use super::climb::NARROW;
use super::entrant::Entrant;
use super::outcome::Stage;
use super::run::{AGAIN, Run};
use crate::search::{Budget, Start, StopReason, inherit};

/// Share of the budget that is spent before the best is gone on with.
const SCOUTING: f64 = 0.5;

/// Searches of the fewest parts where the budget is [`USUAL`]; more with the power [`GROWTH`] of a larger one.
const SCOUTS: f64 = 3.0;
const USUAL: f64 = 4400.0;
const GROWTH: f64 = 0.45;

/// Searches of more parts, as shares of those of the fewest.
const FOLLOWERS: [f64; 2] = [0.6, 0.3];

/// Searches whose outcome is looked at in the end.
const FINALISTS: usize = 3;

/// Generations after which the pace of a search is known, or a share of the seconds if that is over before.
const PACED: usize = 4;
const PACING: f64 = 0.1;

/// The least and the most that a budget in seconds comes to, in images.
const LEAST_IMAGES: usize = 100;
const MOST_IMAGES: usize = 1_000_000;

/// Of the seconds asked for, the share that the budget is made for.
const MEANT: f64 = 0.85;

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
