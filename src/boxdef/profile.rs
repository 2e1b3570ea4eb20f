// SPDX-License-Identifier: MIT OR Apache-2.0
//! A piece of an object seen along an axis: where its outline steps, and how well two prisms hold it.

use super::occupancy::{CellBox, Occupancy};

/// A cut is worth it where the change of area beyond the surrounding slope is at least to this share.
const WORTH: f64 = 0.6;
/// The same where the last slab is the smaller one.
const WORTH_AT_END: f64 = 0.4;
/// Logarithm of a change of area up to which it counts as none.
const LEVEL: f64 = 0.15;
/// Slab boundaries that a short slope may take.
const SHOULDER: usize = 4;

/// The change of area (as a logarithm) at the boundary after slab `i`, if there is a step: either one that
/// goes clearly beyond the slope on both its sides, or the steepest place of a short slope between two flat
/// stretches, such as a bottle's shoulder, which counts as a whole.
pub(super) fn step(changes: &[f64], i: usize) -> Option<f64> {
    let here = changes[i].abs();
    // Changes the same way as here; against it, 0.
    let along = |k: usize| (changes[k] * changes[i].signum()).max(0.0);
    let before = if i > 0 { along(i - 1) } else { 0.0 };
    let after = if i + 1 < changes.len() { along(i + 1) } else { 0.0 };
    // Whatever is rounded tapers off at its ends.
    let tapers = (i == 0 && changes[i] > 0.0) || (i + 1 == changes.len() && changes[i] < 0.0);
    if before.max(after) - here <= if tapers { WORTH_AT_END.ln() } else { WORTH.ln() } {
        return Some(here);
    }
    let first = (0..i).rev().take_while(|&k| along(k) > LEVEL).last().unwrap_or(i);
    let last = (i + 1..changes.len()).take_while(|&k| along(k) > LEVEL).last().unwrap_or(i);
    let flat = |k: usize| changes[k].abs() <= LEVEL;
    let between_flats = first > 0 && flat(first - 1) && last + 1 < changes.len() && flat(last + 1);
    let steepest = (first..=last).all(|k| along(k) <= here);
    let whole: f64 = (first..=last).map(along).sum();
    (between_flats && steepest && last - first < SHOULDER && -whole <= WORTH.ln()).then_some(whole)
}

/// A piece seen along an axis, layer by layer.
pub(super) struct Profile {
    /// Number of filled cells of each layer.
    pub(super) layers: Vec<u32>,
    /// Whether the piece is cut on both sides of its middle at once.
    doubled: bool,
    /// Area seen of the layers below each layer; where doubled, of those nearer to the middle.
    inner: Vec<u64>,
    /// Area seen of each layer and those above; where doubled, of those farther from the middle.
    outer: Vec<u64>,
}

impl Profile {
    pub(super) fn of(occupancy: &Occupancy, cells: &CellBox, axis: usize, doubled: bool) -> Self {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let count = cells.extent(axis);
        let half = count / 2;
        // A doubled piece is symmetric, so its number of layers is even.
        let (reach, fold): (usize, &dyn Fn(usize) -> usize) = if doubled {
            (half, &|layer| if layer < half { half - 1 - layer } else { layer - half })
        } else {
            (count, &|layer| layer)
        };
        let mut layers = vec![0; count];
        // First and last filled layer of each column along the axis.
        let mut columns = vec![(usize::MAX, 0); cells.extent(u) * cells.extent(v)];
        occupancy.for_each_filled(cells, |cell| {
            let layer = cell[axis] - cells.low[axis];
            layers[layer] += 1;
            let column = &mut columns[(cell[u] - cells.low[u]) * cells.extent(v) + cell[v] - cells.low[v]];
            let folded = fold(layer).min(reach - 1);
            *column = (column.0.min(folded), column.1.max(folded));
        });
        let (mut inner, mut outer) = (vec![0; reach + 1], vec![0; reach + 1]);
        for &(first, last) in columns.iter().filter(|column| column.0 != usize::MAX) {
            inner[first + 1] += 1;
            outer[last] += 1;
        }
        for layer in 0..reach {
            inner[layer + 1] += inner[layer];
            outer[reach - 1 - layer] += outer[reach - layer];
        }
        Self { layers, doubled, inner, outer }
    }

    /// Volume of the prisms, each with the outline of its side of a cut, that hold the piece.
    fn prisms(&self, at: usize) -> u64 {
        let half = self.layers.len() / 2;
        let at = if self.doubled { at.abs_diff(half) } else { at };
        self.inner[at] * at as u64 + self.outer[at] * (self.outer.len() - 1 - at) as u64
    }

    /// Share of the volume of the one prism around the piece that two prisms save.
    pub(super) fn saving(&self, at: usize) -> f64 {
        let reach = self.outer.len() - 1;
        1.0 - self.prisms(at) as f64 / (self.outer[0] * reach as u64) as f64
    }

    /// The cut less than `within` layers from `at` with the least prisms; of equals the one nearest to `at`.
    pub(super) fn sharpen(&self, at: usize, within: usize) -> usize {
        let candidates = (at + 1).saturating_sub(within).max(1)..(at + within).min(self.layers.len());
        candidates.min_by_key(|&k| (self.prisms(k), k.abs_diff(at))).unwrap_or(at)
    }
}
