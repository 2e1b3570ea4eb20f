// SPDX-License-Identifier: MIT OR Apache-2.0
//! Cutting the filled cells into part boxes (paper §3.2).
//!
//! A box is scanned along each axis in slabs; where the projected area changes most between two adjacent
//! slabs is the place to cut: the score is the ratio of the two areas over the length of the axis, and
//! the lowest score of all boxes is cut first. A box on a plane of symmetry is cut across it twice at equal
//! distances, into a box on the plane and one off it, which stands for its mirror images.
//!
//! Where this differs from the authors' program:
//! - A number of splits is a budget. A cut must follow a step, not a slope: the areas must change clearly
//!   more than they do between the slabs next to them, or a short slope between two flat stretches; and
//!   it must be a great step or save volume. A plain box, a sphere or a cone stays whole.
//! - Walls that go all around are not cut open: a cup's, a tub's, a bookcase's.
//! - Empty layers part a box at once, however narrow they are: separate legs are separate parts.
//! - Both ends are scanned: a thin top at the far end is found as well as one at the near end.
//! - The cut is moved to the layer, within a slab, where two prisms hold the piece best.
//! - The score is also weighed by the share of the box's volume that the pieces' boxes take up.
//! - A piece whose longest side is short is not worth a box of its own. Where it stands apart from the rest of
//!   its side of a cut, it is left to the nearest box.
//! - All limits are whole cells, so that no rounding decides between two results.

use super::frame::CELL;
use super::hollow::opens_walls;
use super::occupancy::{CellBox, Occupancy};
use super::profile::{Profile, step};
use super::symmetry::Symmetry;

/// Cells to a slab: 0.1 of the frame's unit.
const SLAB: usize = 10;
/// Thickness of slabs and edge of the bins of their area, in cells: the authors' first, then finer ones for
/// what is thinner than that.
const SLABS: [(usize, usize); 2] = [(SLAB, 4), (SLAB / 2, 1)];
/// What reaches through a cut by no more cells than this belongs to the other side.
const SHAVING: usize = 3;
/// A double cut nearer to the plane than this many cells leaves nothing of use between.
const SLIVER: usize = 2;
/// Added to an axis' length in the score, so that short axes do not score without limit.
const SCORE_LENGTH: f64 = 0.03;
/// An axis shorter than this share of the longest is not scanned.
const LEAST_ASPECT: f64 = 0.2;
/// The longest side of a piece must have this many cells.
const LEAST_LENGTH: usize = 12;
/// A change of area to this share is worth a cut even if it saves little.
const CLEAR: f64 = 0.2;
/// Any other cut must save this share of the volume of a prism around the piece.
const LEAST_SAVING: f64 = 0.15;
/// How a piece is cut into slabs for a scan.
#[derive(Clone, Copy)]
struct Slabs {
    /// In cells.
    thickness: usize,
    /// Edge of the bins that the area is counted in.
    bin: usize,
    /// Whether the slabs are counted from the high end; what is left over at the other is not scanned.
    from_high: bool,
}

/// A box of cells with what is in it, on its way to a part box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    /// Whether it lies off the plane of symmetry of each axis, on the positive side, and has a mirror image.
    pub(crate) off_plane: [bool; 3],
    /// Its share of space: pieces and their mirror images fill the grid without overlap.
    pub(crate) domain: CellBox,
    /// The filled cells in it.
    pub(crate) tight: CellBox,
}

impl Piece {
    /// Whether it has mirror images.
    pub(crate) fn is_mirrored(&self) -> bool {
        self.off_plane.contains(&true)
    }
}

/// A place to cut a piece: before the cells with index `at`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cut {
    axis: usize,
    at: usize,
    score: f64,
}

/// Pieces without mirror images, then those that have some, after at most `splits` cuts.
///
/// Takes cells out of the grid: those that a cut leaves on the wrong side.
pub(crate) fn split(occupancy: &mut Occupancy, splits: u32, symmetry: Symmetry) -> Vec<Piece> {
    let whole = occupancy.whole();
    let tight = occupancy.tighten(&whole).unwrap_or(whole);
    let mut splitter = Splitter { occupancy, symmetry };
    let first = Piece { off_plane: [false; 3], domain: whole, tight };
    let mut pieces = vec![(first, splitter.best_cut(&first))];
    for _ in 0..splits {
        let Some((index, cut)) = lowest(&pieces) else { break };
        let (piece, _) = pieces.remove(index);
        splitter.shave(&piece, cut);
        for child in splitter.cut(&piece, cut) {
            let child = splitter.without_scraps(child);
            pieces.push((child, splitter.best_cut(&child)));
        }
    }
    let mut pieces: Vec<Piece> = pieces.into_iter().map(|(piece, _)| piece).collect();
    pieces.sort_by_key(Piece::is_mirrored);
    pieces
}

/// The piece with the lowest score; one without mirror images before one that has some, then the earlier.
fn lowest(pieces: &[(Piece, Option<Cut>)]) -> Option<(usize, Cut)> {
    let cuts = pieces
        .iter()
        .enumerate()
        .filter_map(|(i, (piece, cut))| cut.map(|cut| (i, piece.is_mirrored(), cut)));
    cuts.min_by(|a, b| a.2.score.total_cmp(&b.2.score).then(a.1.cmp(&b.1))).map(|(i, _, cut)| (i, cut))
}

struct Splitter<'a> {
    occupancy: &'a mut Occupancy,
    symmetry: Symmetry,
}

impl Splitter<'_> {
    /// The best cut of a piece that is worth it. Thinner slabs are tried where thicker ones find none.
    fn best_cut(&self, piece: &Piece) -> Option<Cut> {
        let occupancy = &*self.occupancy;
        let longest = piece.tight.longest() as f64;
        let profiles: [Profile; 3] = std::array::from_fn(|axis| {
            Profile::of(occupancy, &piece.tight, axis, self.is_doubled(piece, axis))
        });
        SLABS.into_iter().find_map(|(thickness, bin)| {
            let mut cuts = Vec::new();
            for (axis, profile) in profiles.iter().enumerate() {
                self.gap_cuts(piece, axis, &profile.layers, &mut cuts);
                if piece.tight.extent(axis) as f64 > LEAST_ASPECT * longest {
                    for from_high in [false, true] {
                        let slabs = Slabs { thickness, bin, from_high };
                        cuts.extend(self.slab_cuts(piece, axis, slabs, profile));
                    }
                }
            }
            self.best_of(piece, cuts)
        })
    }

    /// The cut with the lowest score once it is weighed by the volume that its pieces' boxes take up, of those
    /// that leave no scrap and open no walls. Of equals a double cut is best.
    fn best_of(&self, piece: &Piece, cuts: Vec<Cut>) -> Option<Cut> {
        let cuts = cuts.into_iter().filter_map(|cut| {
            let children = self.cut(piece, cut);
            let doubled = self.is_doubled(piece, cut.axis);
            let kept =
                children.len() > usize::from(!doubled) && children.iter().all(|child| !self.is_scrap(child));
            let weight = |child: &Piece| if doubled && child.off_plane[cut.axis] { 2.0 } else { 1.0 };
            let volume: f64 = children.iter().map(|c| weight(c) * c.tight.volume() as f64).sum();
            let share = volume / piece.tight.volume() as f64;
            kept.then_some((cut.score * share, !doubled, share, cut))
        });
        let mut cuts: Vec<_> = cuts.collect();
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.total_cmp(&b.2)));
        let opens = |cut: Cut| cut.score > 0.0 && opens_walls(self.occupancy, &piece.tight, cut.axis, cut.at);
        let best = cuts.into_iter().find(|&(.., cut)| !opens(cut));
        best.map(|(score, .., cut)| Cut { score, ..cut })
    }

    /// The pieces that a cut leaves; mirror images go without saying.
    fn cut(&self, piece: &Piece, cut: Cut) -> Vec<Piece> {
        let Cut { axis, at, .. } = cut;
        let part = |beyond, low, high| {
            let domain = piece.domain.with(axis, low, high);
            let tight = self.occupancy.tighten(&domain.within(&piece.tight))?;
            let mut off_plane = piece.off_plane;
            off_plane[axis] |= beyond;
            Some(Piece { off_plane, domain, tight })
        };
        let (low, high) = (piece.domain.low[axis], piece.domain.high[axis]);
        if !self.is_doubled(piece, axis) {
            return [part(false, at, high), part(false, low, at)].into_iter().flatten().collect();
        }
        let middle = self.occupancy.size()[axis] / 2;
        let away = at.abs_diff(middle);
        let inner = part(false, middle - away, middle + away);
        [inner, part(true, middle + away, high)].into_iter().flatten().collect()
    }

    /// Whether a piece is too small for a box of its own. Of mirror images apart each counts alone.
    fn is_scrap(&self, piece: &Piece) -> bool {
        let mut single = piece.tight;
        for &axis in self.symmetry.axes().iter().filter(|&&axis| !piece.off_plane[axis]) {
            let middle = self.occupancy.size()[axis] / 2;
            let half = self.occupancy.tighten(&single.with(axis, middle, single.high[axis]));
            single = half.filter(|half| half.low[axis] > middle).unwrap_or(single);
        }
        single.longest() < LEAST_LENGTH
    }

    /// The piece without what stands apart from it and is too small for a box of its own: the tips of wings
    /// beside a fin. Its surface goes to the box that is nearest.
    fn without_scraps(&self, piece: Piece) -> Piece {
        let mut cuts = Vec::new();
        for axis in 0..3 {
            let profile = Profile::of(self.occupancy, &piece.tight, axis, self.is_doubled(&piece, axis));
            self.gap_cuts(&piece, axis, &profile.layers, &mut cuts);
        }
        let rest = cuts.into_iter().find_map(|cut| match self.cut(&piece, cut)[..] {
            [a, b] if self.is_scrap(&a) != self.is_scrap(&b) => Some(if self.is_scrap(&a) { b } else { a }),
            _ => None,
        });
        rest.map_or(piece, |rest| self.without_scraps(rest))
    }

    /// Cuts in the middle of runs of empty layers.
    fn gap_cuts(&self, piece: &Piece, axis: usize, layers: &[u32], cuts: &mut Vec<Cut>) {
        let low = piece.tight.low[axis];
        let middle = self.occupancy.size()[axis] / 2;
        let mut start = 0;
        while start < layers.len() {
            if layers[start] > 0 {
                start += 1;
                continue;
            }
            let run = layers[start..].iter().take_while(|&&count| count == 0).count();
            let (from, to) = (low + start, low + start + run);
            let over_plane = self.is_doubled(piece, axis) && (from..=to).contains(&middle);
            let at = if over_plane { middle } else { usize::midpoint(from, to) };
            cuts.push(Cut { axis, at, score: 0.0 });
            start += run;
        }
    }

    /// Cuts between slabs of some thickness, where the area steps clearly.
    fn slab_cuts(
        &self,
        piece: &Piece,
        axis: usize,
        Slabs { thickness, bin, from_high }: Slabs,
        profile: &Profile,
    ) -> Vec<Cut> {
        let extent = piece.tight.extent(axis);
        let count = extent / thickness;
        let start = if from_high { extent - count * thickness } else { 0 };
        let low = piece.tight.low[axis] + start;
        let scanned = piece.tight.with(axis, low, low + count * thickness);
        let areas = self.slab_areas(&scanned, axis, thickness, bin);
        let changes: Vec<f64> = areas.windows(2).map(|pair| (pair[1] / pair[0]).ln()).collect();
        let length = extent as f64 * CELL;
        let cut = |i: usize| {
            let at = profile.sharpen(start + (i + 1) * thickness, SLAB);
            let saving = profile.saving(at);
            let ratio = (-step(&changes, i)?).exp();
            let worth = ratio <= CLEAR || saving >= LEAST_SAVING;
            let at = at + piece.tight.low[axis];
            let score = ratio / (length + SCORE_LENGTH);
            (worth && !self.leaves_sliver(piece, axis, at)).then_some(Cut { axis, at, score })
        };
        (0..changes.len()).filter_map(cut).collect()
    }

    /// Whether a double cut would leave next to nothing between its two planes.
    fn leaves_sliver(&self, piece: &Piece, axis: usize, at: usize) -> bool {
        let middle = self.occupancy.size()[axis] / 2;
        self.is_doubled(piece, axis) && at.abs_diff(middle) < SLIVER
    }

    /// Whether a piece is cut at both sides of the plane at once.
    fn is_doubled(&self, piece: &Piece, axis: usize) -> bool {
        self.symmetry.axes().contains(&axis) && !piece.off_plane[axis]
    }

    /// Takes out what a cut leaves of one part on the side of the other: columns that reach through the
    /// cut by a few cells only, such as the top of a fuselage at the foot of its fin. Where nothing would
    /// be left of a side, it stays.
    fn shave(&mut self, piece: &Piece, Cut { axis, at, .. }: Cut) {
        let middle = self.occupancy.size()[axis] / 2;
        let doubled = self.is_doubled(piece, axis);
        let at = if doubled { middle + at.abs_diff(middle) } else { at };
        for upwards in [false, true] {
            let mut shavings = Vec::new();
            let mut others = false;
            let layer = if upwards { at } else { at - 1 };
            self.occupancy.for_each_filled(&piece.tight.with(axis, layer, layer + 1), |cell| {
                let depth = self.depth(cell, axis, upwards);
                let mut beyond = cell;
                beyond[axis] = if upwards { at - 1 } else { at };
                if depth > SHAVING || !self.occupancy.is_filled(beyond) {
                    others = true;
                } else {
                    shavings.push((cell, depth));
                }
            });
            if !others {
                continue;
            }
            for (mut cell, depth) in shavings {
                for _ in 0..depth {
                    self.occupancy.clear(cell);
                    if doubled {
                        self.occupancy.clear(self.occupancy.mirrored(cell, &[axis]));
                    }
                    cell[axis] = if upwards { cell[axis] + 1 } else { cell[axis] - 1 };
                }
            }
        }
    }

    /// Number of filled cells in a row, `SHAVING` + 1 at most, from a cell on along an axis.
    fn depth(&self, mut cell: [usize; 3], axis: usize, upwards: bool) -> usize {
        // The grid's empty rim ends every row before the grid does.
        (0..=SHAVING)
            .take_while(|_| {
                let filled = self.occupancy.is_filled(cell);
                if filled {
                    cell[axis] = if upwards { cell[axis] + 1 } else { cell[axis] - 1 };
                }
                filled
            })
            .count()
    }

    /// Projected area of each slab along an axis, in bins.
    fn slab_areas(&self, cells: &CellBox, axis: usize, thickness: usize, bin: usize) -> Vec<f64> {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let bins = [cells.extent(u).div_ceil(bin), cells.extent(v).div_ceil(bin)];
        let slab_bins = bins[0] * bins[1];
        let mut seen = vec![false; cells.extent(axis) / thickness * slab_bins];
        self.occupancy.for_each_filled(cells, |cell| {
            let slab = (cell[axis] - cells.low[axis]) / thickness;
            let column = (cell[u] - cells.low[u]) / bin * bins[1] + (cell[v] - cells.low[v]) / bin;
            seen[slab * slab_bins + column] = true;
        });
        let count = |slab: &[bool]| slab.iter().filter(|&&s| s).count() as f64;
        // An empty slab counts as a thousandth of a bin: far below any other, and still a number.
        seen.chunks(slab_bins).map(|slab| count(slab).max(1e-3)).collect()
    }
}
