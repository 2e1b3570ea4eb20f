// SPDX-License-Identifier: MIT OR Apache-2.0
//! What has walls all around: a cup, a tub, the frame of a bed. A cut along a wall or through it would open it.

use super::occupancy::{CellBox, Occupancy};

/// A layer is hollow where this share of it is empty and enclosed.
const ENCLOSED: f64 = 0.2;
/// Walls stand around a piece where this share of its layers is hollow.
const WALLED: f64 = 0.5;

/// Whether a cut before the cells with index `at` on an axis would open walls that go around a piece: in most
/// layers across one of the other axes it touches what is empty and enclosed.
pub(super) fn opens_walls(occupancy: &Occupancy, cells: &CellBox, axis: usize, at: usize) -> bool {
    [(axis + 1) % 3, (axis + 2) % 3].into_iter().any(|across| {
        let along = 3 - axis - across;
        let least = (WALLED * cells.extent(across) as f64).ceil() as usize;
        let mut hollow = 0;
        (cells.low[across]..cells.high[across]).enumerate().any(|(seen, layer)| {
            if hollow + cells.extent(across) - seen < least {
                return false;
            }
            let layer = Layer { occupancy, cells, axis, along, across: layer };
            hollow += usize::from(layer.may_be_enclosed_at(at) && layer.is_enclosed_at(at));
            hollow >= least
        })
    })
}

/// A layer of a piece, seen along the third axis.
struct Layer<'a> {
    occupancy: &'a Occupancy,
    cells: &'a CellBox,
    axis: usize,
    along: usize,
    /// Index on the third axis.
    across: usize,
}

impl Layer<'_> {
    fn is_filled(&self, a: usize, b: usize) -> bool {
        let mut cell = [self.across; 3];
        (cell[self.axis], cell[self.along]) = (a, b);
        self.occupancy.is_filled(cell)
    }

    /// Whether one of the two rows at a cut has empty cells between filled ones: quick to see, and there is no
    /// enclosed cell without.
    fn may_be_enclosed_at(&self, at: usize) -> bool {
        let range = self.cells.low[self.along]..self.cells.high[self.along];
        [at - 1, at].into_iter().any(|a| {
            let first = range.clone().find(|&b| self.is_filled(a, b));
            let last = range.clone().rev().find(|&b| self.is_filled(a, b));
            first.zip(last).is_some_and(|(first, last)| (first..last).any(|b| !self.is_filled(a, b)))
        })
    }

    /// Whether the layer is hollow and its cells at a cut are of the hollow.
    fn is_enclosed_at(&self, at: usize) -> bool {
        let [low, high] = [self.cells.low, self.cells.high].map(|end| [end[self.axis], end[self.along]]);
        // One row and column of nothing all around.
        let size = [high[0] - low[0] + 2, high[1] - low[1] + 2];
        let mut open = vec![false; size[0] * size[1]];
        let mut front = vec![[0_usize; 2]];
        open[0] = true;
        let is_filled = |[a, b]: [usize; 2]| {
            let inside = (1..=size[0] - 2).contains(&a) && (1..=size[1] - 2).contains(&b);
            inside && self.is_filled(low[0] + a - 1, low[1] + b - 1)
        };
        while let Some([a, b]) = front.pop() {
            for next in [[a.wrapping_sub(1), b], [a + 1, b], [a, b.wrapping_sub(1)], [a, b + 1]] {
                if next[0] < size[0]
                    && next[1] < size[1]
                    && !open[next[0] * size[1] + next[1]]
                    && !is_filled(next)
                {
                    open[next[0] * size[1] + next[1]] = true;
                    front.push(next);
                }
            }
        }
        let row =
            |a: usize| (1..=size[1] - 2).filter(|&b| !open[a * size[1] + b] && !is_filled([a, b])).count();
        let enclosed: usize = (1..=size[0] - 2).map(row).sum();
        let a = at - low[0];
        enclosed as f64 >= ENCLOSED * ((size[0] - 2) * (size[1] - 2)) as f64 && row(a) + row(a + 1) > 0
    }
}
