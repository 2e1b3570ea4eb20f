// SPDX-License-Identifier: MIT OR Apache-2.0
//! A search in the running, and the best that it has come to by every image.

use std::sync::Arc;

use glam::Vec3;

use super::JobError;
use super::finalist::{Finalist, improves};
use super::outcome::{Best, Stage};
use super::soundness::Soundness;
use crate::search::{Evaluation, Search, StopReason};

/// Halvings of the way back to the mesh where an outcome crosses itself.
const HALVINGS: usize = 6;

/// Share of what was gained that has to be left where an outcome goes back.
const WORTH_IT: f64 = 0.5;

/// A search of a stage's boxes.
pub struct Entrant<'a> {
    pub stage: Arc<Stage>,
    pub search: Search<'a>,
    /// The unchanged object.
    pub before: Evaluation,
    /// The best by every image, at first the unchanged object.
    best: (Evaluation, Vec<Vec3>),
    /// That of the highest score by every image.
    highest: (f64, Vec<Vec3>),
    counted: usize,
}

impl<'a> Entrant<'a> {
    pub fn new(stage: Arc<Stage>, mut search: Search<'a>) -> Result<Self, JobError> {
        let unchanged = stage.whole.unchanged();
        let before = search.judge(std::slice::from_ref(&unchanged))?[0];
        let highest = (before.score, unchanged.clone());
        Ok(Self { stage, search, before, best: (before, unchanged), highest, counted: 0 })
    }

    /// Images encoded since this was last asked.
    pub fn images_not_counted(&mut self) -> usize {
        let encoded = self.search.images_encoded();
        encoded - std::mem::replace(&mut self.counted, encoded)
    }

    /// Loss of the best, by every image.
    pub fn loss(&self) -> f64 {
        self.best.0.loss
    }

    /// Score of the best, by every image.
    pub fn score(&self) -> f64 {
        self.best.0.score
    }

    /// What the strongest rival takes from the best, as weighted.
    pub fn rivalry(&self) -> f64 {
        self.best.0.rivalry
    }

    /// Whether the best is another shape than what was given.
    pub fn has_improved(&self) -> bool {
        improves(&self.best.0, &self.before)
    }

    /// Factors of the best.
    pub fn factors(&self) -> &[Vec3] {
        &self.best.1
    }

    /// Judges what the search has come to by every image; returns the number of candidates judged.
    pub fn judge(&mut self) -> Result<usize, JobError> {
        let candidates = [self.search.leader().to_vec(), self.search.middle()];
        let judged = self.search.judge(&candidates)?.to_vec();
        for (evaluation, factors) in judged.into_iter().zip(candidates) {
            if evaluation.score > self.highest.0 {
                self.highest = (evaluation.score, factors.clone());
            }
            if evaluation.loss < self.best.0.loss {
                self.best = (evaluation, factors);
            }
        }
        Ok(2)
    }

    /// What the search found, and the number of candidates judged for it: of the `chosen` factors and those of the
    /// highest score, the first that are an improvement. What crosses itself goes back towards the unchanged object
    /// until it does not, unless that costs more than half of what was gained.
    pub fn finish(
        &mut self,
        chosen: Vec<Vec3>,
        soundness: &Soundness<'_>,
        stop: StopReason,
    ) -> Result<(Finalist, usize), JobError> {
        let finalist = |factors: Vec<Vec3>, after: Evaluation, improved: bool, sound: bool| {
            let best = Best { score: after.score, factors, stage: self.stage.clone() };
            Finalist { best, before: self.before, after, improved, sound, stop }
        };
        // Where what the loss likes best is no more like the prompt, the candidate that is most like it.
        let highest = self.search.highest().to_vec();
        let mut judged = 0;
        for wanted in [chosen, self.highest.1.clone(), highest] {
            let far = self.search.judge(std::slice::from_ref(&wanted))?[0];
            judged += 1;
            if !improves(&far, &self.before) {
                continue;
            }
            let back = sound(&self.stage, &wanted, soundness);
            if back == wanted {
                return Ok((finalist(wanted, far, true, true), judged));
            }
            let near = self.search.judge(std::slice::from_ref(&back))?[0];
            judged += 1;
            let gain = |after: &Evaluation| after.worth() - self.before.worth();
            if improves(&near, &self.before) && gain(&near) >= WORTH_IT * gain(&far) {
                return Ok((finalist(back, near, true, true), judged));
            }
            return Ok((finalist(wanted, far, true, false), judged));
        }
        Ok((finalist(self.stage.whole.unchanged(), self.before, false, true), judged))
    }
}

/// The farthest factors on the way from the unchanged object that do not cross themselves.
fn sound(stage: &Stage, factors: &[Vec3], soundness: &Soundness<'_>) -> Vec<Vec3> {
    if soundness.holds(&stage.scored.deform(factors)) {
        return factors.to_vec();
    }
    let at = |alpha: f32| factors.iter().map(|&f| Vec3::ONE.lerp(f, alpha)).collect::<Vec<_>>();
    let (mut sound, mut crossed) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (sound + crossed);
        if soundness.holds(&stage.scored.deform(&at(middle))) {
            sound = middle;
        } else {
            crossed = middle;
        }
    }
    at(sound)
}
