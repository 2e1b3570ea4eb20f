// SPDX-License-Identifier: MIT OR Apache-2.0
//! Variations: further outcomes that are nearly as good as the best, and far from it and from each other.
//!
//! Each is searched for in the boxes of the winner, with a loss that falls with the distance from what was found
//! before, as long as the worth is kept. It is then chosen among all candidates of all searches in these boxes:
//! where the usual search came by another design, that is taken.

use glam::Vec3;

use super::JobError;
use super::entrant::Entrant;
use super::finalist::{Finalist, improves};
use super::outcome::Best;
use super::run::{AGAIN, Run, check};
use crate::search::{Evaluation, Novelty, Sketch, Start, StopReason};

/// Outcomes of one job at most.
pub const MOST_VARIATIONS: usize = 8;

/// A variation may lose this share of what the best gained, in score and in worth.
/// Of 36 outcomes asked for of nine objects, 17 were found with 0.05, 21 with 0.1, 30 with 0.15 and 34 with 0.25.
const TOLERANCE: f64 = 0.15;

/// First step sizes of searches near what was given and far from it, in units of the search variable.
const NEAR: f64 = 0.5;
const WIDE: f64 = 1.0;

/// Searches aim at losing no more than this share of the tolerance: they see a third of the images.
const AIM: f64 = 0.6;

/// Shapes that are farther from each other need not be.
const FAR: f64 = 0.1;

/// What it costs a candidate to be the same as another outcome, as a share of what the best gained,
const SAMENESS: f64 = 0.5;
/// and what it costs to be worth less than aimed at, a unit.
const STEEP: f64 = 5.0;

/// Candidates that are judged by every image for one variation, at most.
const JUDGED: usize = 40;

/// What variations are held to.
struct Bar {
    before: Evaluation,
    worth: f64,
    score: f64,
}

impl Bar {
    fn admits(&self, after: &Evaluation) -> bool {
        improves(after, &self.before) && after.worth() >= self.worth && after.score >= self.score
    }
}

impl<'a> Run<'a> {
    /// The variations of the winner, best first, each with its distance from it; as many as are asked for or as
    /// there are.
    pub fn vary(&mut self) -> Result<Vec<(f64, Finalist)>, JobError> {
        let Some(winner) = self.winner.as_ref().filter(|winner| winner.improved) else {
            return Ok(Vec::new());
        };
        let (before, after, stage) = (winner.before, winner.after, winner.best.stage.clone());
        let gain = (after.worth() - before.worth()).max(after.score - before.score);
        let slack = TOLERANCE * gain;
        let bar = Bar {
            before,
            worth: after.worth() - slack,
            score: after.score - TOLERANCE * (after.score - before.score).abs(),
        };
        let first = self.sketch.draw(&stage.scored.deform(&winner.best.factors));
        let mut novelty = Novelty {
            sketch: self.sketch,
            others: vec![first],
            far: FAR,
            weight: SAMENESS * gain,
            floor: after.worth() - AIM * slack,
            steep: STEEP,
        };
        self.pool.retain(&stage);
        self.harness.update(|p| p.phase = "Searching variations".into());
        let mut found = Vec::new();
        for variation in 1..self.spec.variations {
            let seed = !self.spec.seed.wrapping_add(variation as u64 * AGAIN);
            // Another design may be near what was given or far from it.
            let sigma = if variation % 2 == 1 { NEAR } else { WIDE };
            let start = Start { factors: stage.whole.unchanged(), sigma, seed };
            let mut entrant = self.enter(&stage, self.variation, &start, Some(novelty.clone()))?;
            while entrant.search.stop_reason().is_none() {
                self.step(&mut entrant)?;
                let part = entrant.search.generations() as f64 / self.variation.max_generations as f64;
                self.tell_share(variation as f64 + part);
            }
            // A candidate may be worth more than a third of its images say.
            let ranked = std::mem::take(&mut self.pool);
            let chosen = self.choose(&mut entrant, &ranked.ranked(&novelty, bar.worth - slack), &bar)?;
            self.pool = ranked;
            if let Some((drawing, finalist)) = chosen {
                found.push((Sketch::distance(&drawing, &novelty.others[0]), finalist));
                novelty.others.push(drawing);
            }
        }
        found.sort_by(|(_, a), (_, b)| b.after.score.total_cmp(&a.after.score));
        Ok(found)
    }

    /// The first of the ranked candidates that all images find good enough and that is sound.
    fn choose(
        &mut self,
        entrant: &mut Entrant<'a>,
        ranked: &[(&[Vec3], Vec<Vec3>)],
        bar: &Bar,
    ) -> Result<Option<(Vec<Vec3>, Finalist)>, JobError> {
        let stop = entrant.search.stop_reason().unwrap_or(StopReason::MaxGenerations);
        for (factors, drawing) in ranked.iter().take(JUDGED) {
            check(self.harness)?;
            let factors = factors.to_vec();
            let after = entrant.search.judge(std::slice::from_ref(&factors))?[0];
            self.count(entrant, 1);
            let stage = &entrant.stage;
            if bar.admits(&after) && self.soundness.holds(&stage.scored.deform(&factors)) {
                let best = Best { score: after.score, factors, stage: stage.clone() };
                let finalist =
                    Finalist { best, before: bar.before, after, improved: true, sound: true, stop };
                return Ok(Some((drawing.clone(), finalist)));
            }
        }
        Ok(None)
    }
}
