// SPDX-License-Identifier: MIT OR Apache-2.0
//! The reference protocol (paper §4): each split count is searched from scratch and to its end.

use std::sync::Arc;

use super::JobError;
use super::outcome::Stage;
use super::run::{AGAIN, Run};
use crate::search::Start;

impl Run<'_> {
    /// Searches every stage, and keeps the best by every image.
    pub fn each_in_full(&mut self, stages: &[Arc<Stage>]) -> Result<(), JobError> {
        let (preset, harness) = (&self.spec.preset, self.harness);
        let total = stages.len() * preset.max_generations;
        harness.update(|p| p.generations = total);
        for (index, stage) in stages.iter().enumerate() {
            let again = stages[..index].iter().filter(|earlier| Arc::ptr_eq(earlier, stage)).count();
            let seed = self.spec.seed.wrapping_add(again as u64 * AGAIN);
            let start = Start { factors: stage.whole.unchanged(), sigma: preset.sigma, seed };
            self.tell(stage);
            let mut entrant = self.enter(stage, preset, &start, None)?;
            let stop = loop {
                self.step(&mut entrant)?;
                let (candidates, evaluations) = entrant.search.generation();
                let best = candidates.iter().zip(evaluations).max_by(|a, b| a.1.score.total_cmp(&b.1.score));
                if let Some((factors, evaluation)) = best {
                    self.show(stage, evaluation.score, factors);
                }
                let done = index * preset.max_generations + entrant.search.generations();
                self.tell_share(done as f64 / total as f64);
                if let Some(stop) = entrant.search.stop_reason() {
                    break stop;
                }
            };
            let best = entrant.search.best().to_vec();
            self.conclude(&mut entrant, best, stop)?;
        }
        Ok(())
    }
}
