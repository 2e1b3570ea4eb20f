// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a field follows from, but for the vertices: the parts in their frame, and how they move each other.

use glam::DVec3;

use super::boundary::Boundary;
use super::frame::Frame;
use super::parts::{NEG, POS, Parts};
use super::symmetry::{MirrorMap, Symmetry};

/// Parts, and what is known of how they hang together.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Layout {
    pub(crate) parts: Parts,
    pub(crate) frame: Frame,
    /// About which planes boxes share their parameters.
    pub(crate) symmetry: Symmetry,
    /// Whether mirror images are to move as such to the bit; else as the given parts say.
    pub(crate) exact: bool,
    /// Whether each box lies on a plane of symmetry, and so does not move across it, axis by axis (b).
    pub(crate) held: Vec<[bool; 3]>,
    pub(crate) boundary: Boundary,
    /// Boundary steps: the (leader, follower) pairs of one stage act at once, stages one after another.
    pub(crate) stages: Vec<Vec<[i32; 2]>>,
}

impl Layout {
    /// Number of parameter rows, P.
    pub(crate) fn parameter_rows(&self) -> usize {
        self.parts.box_row.iter().max().map_or(0, |&row| row as usize + 1)
    }

    /// Parameter row of a box.
    pub(crate) fn row(&self, part: usize) -> usize {
        self.parts.box_row[part] as usize
    }

    /// The mirror images of vertices (n, in the frame), where they are to move as such.
    pub(crate) fn mirrors(&self, vertices: &[DVec3]) -> Vec<MirrorMap> {
        let axes = if self.exact { self.symmetry.axes() } else { &[] };
        axes.iter().map(|&axis| MirrorMap::of(vertices, axis)).collect()
    }

    /// The direction in which each box moves along each axis when its parameter row is shifted by 1 (b).
    pub(crate) fn directions(&self) -> Vec<DVec3> {
        let (center, half, side) = (&self.parts.box_center, &self.parts.box_half_size, &self.parts.box_side);
        let mut directions = vec![DVec3::ONE; center.len()];
        for neg in (0..center.len()).filter(|&b| side[b] == NEG) {
            let pos = (0..center.len()).find(|&b| side[b] == POS && self.row(b) == self.row(neg));
            let Some(pos) = pos else { continue };
            for &axis in self.symmetry.axes() {
                // A twin lies apart by far more than rounding, and by more than it is out of place.
                if (center[neg][axis] - center[pos][axis]).abs() > 0.1 * half[pos][axis] {
                    directions[neg][axis] = -1.0;
                }
            }
        }
        directions
    }
}
