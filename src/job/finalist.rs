// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a search found, judged by every image, and which of two is to be kept.

use super::outcome::Best;
use crate::search::{Evaluation, StopReason};

/// What one search found, judged by every image.
pub struct Finalist {
    pub best: Best,
    pub before: Evaluation,
    pub after: Evaluation,
    /// Whether it is another shape than what was given.
    pub improved: bool,
    /// Whether it hardly crosses itself.
    pub sound: bool,
    pub stop: StopReason,
}

impl Finalist {
    /// Another shape goes before what was given, a sound one before one that crosses itself, then that of
    /// greater worth.
    pub fn beats(&self, other: &Self) -> bool {
        let rank = |f: &Self| (f.improved, f.sound, f.after.worth());
        rank(self) > rank(other)
    }
}

/// Whether a shape is better than what was given: an outcome is never worse than that. Only where a comparative
/// asks for more than the pictures reward, the score may fall.
pub fn improves(after: &Evaluation, before: &Evaluation) -> bool {
    let asked = after.shortfall < before.shortfall && after.worth() >= before.worth();
    asked || after.score > before.score
}
