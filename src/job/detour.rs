// SPDX-License-Identifier: MIT OR Apache-2.0
//! Another way to the prompt, where the search on a budget is led away from it.
//!
//! The loss flees the names that come near the prompt, and can end where one of them stays ahead. Another search then
//! begins with the score alone, and goes on from there with the whole loss.

use super::JobError;
use super::climb::NARROW;
use super::entrant::Entrant;
use super::run::{AGAIN, Run};
use crate::search::Start;

/// Share of the budget that is left for another way where a rival is still ahead of the best.
const DETOUR: f64 = 0.4;

/// Of that, the share in which nothing but the score counts, and that after which the way is compared with the best.
const UNRIVALLED: f64 = 0.4;
const TRIAL: f64 = 0.3;

impl<'a> Run<'a> {
    /// Goes on with the best and, where a rival is ahead of it then, tries another way: for the score alone at first.
    pub fn detour(&mut self, field: &mut Vec<Entrant<'a>>, end: usize, number: u64) -> Result<(), JobError> {
        let Some(leader) = field.first_mut() else { return Ok(()) };
        let images = (DETOUR * self.budget as f64) as usize;
        let stage = leader.stage.clone();
        self.tell(&stage);
        self.advance(leader, end.saturating_sub(self.spent.images + images))?;
        self.judge(leader)?;
        let outdone = leader.rivalry() > self.spec.preset.tie();
        if !outdone || self.is_late() {
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
}
