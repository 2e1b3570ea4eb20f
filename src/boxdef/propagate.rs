// SPDX-License-Identifier: MIT OR Apache-2.0
//! Parts to field: scaling, tree translations and the boundary step as linear maps (paper §3.1).
//!
//! With `s = c − 1` the scale change of a box, per axis:
//!
//! 1. a vertex of box `b` moves by `s_b · v + t_b`, with `v` taken from the frame's origin;
//! 2. the root has `t = 0`; a child has `t_c = t_p + s_p · p − s_c · q` with `p`, `q` the undeformed
//!    constraint points of its tree edge, so that the joint holds;
//! 3. where two boxes are adjacent, each follows the other near their boundary ([`super::boundary`]).
//!
//! Each step is a fixed linear map, so the field is found by applying the steps to one plane of coefficients
//! per axis and parameter row.

use glam::DVec3;
use rayon::prelude::*;

use super::boundary::{Boundary, pull, pulls};
use super::frame::Frame;
use super::parts::{MID, Parts};
use super::symmetry::MirrorMap;

/// The parts with everything that the field needs of them, in the frame.
pub(crate) struct Propagation<'a> {
    pub(crate) frame: Frame,
    pub(crate) parts: &'a Parts,
    pub(crate) rows: &'a [usize],
    /// Vertices in the frame (n).
    pub(crate) vertices: &'a [DVec3],
    /// Symmetry to keep exactly: mid boxes do not move along its axis, mirror images move as such.
    pub(crate) mirror: Option<&'a MirrorMap>,
    pub(crate) boundary: Boundary,
    /// Boundary steps: the (leader, follower) pairs of one stage act at once, stages one after another.
    pub(crate) stages: Vec<Vec<[i32; 2]>>,
}

impl Propagation<'_> {
    /// The basis, `3 × P × n` row-major, in object units.
    pub(crate) fn basis(&self, parameter_rows: usize) -> Vec<f32> {
        let n = self.vertices.len();
        let translations = self.translations(parameter_rows);
        let (parts, rounds, extends) = (self.parts, self.boundary.rounds(), self.boundary.extends());
        let pulls =
            pulls(self.boundary, self.vertices, &parts.assignment, parts.box_center.len(), &self.stages);
        let mut basis = vec![0.0_f32; 3 * parameter_rows * n];
        basis.par_chunks_mut(n).enumerate().for_each(|(plane, values)| {
            let (axis, row) = (plane / parameter_rows, plane % parameter_rows);
            let owner = |v: usize| parts.assignment[v] as usize;
            // The box's scale change per scale change of this row.
            let slope = |v: usize| if self.rows[owner(v)] == row { 1.0 } else { 0.0 };
            for (v, value) in values.iter_mut().enumerate() {
                let scaled = slope(v) * self.vertices[v][axis];
                *value = ((scaled + translations[owner(v)][row][axis]) * self.frame.unit) as f32;
            }
            let change = |from: usize, to: usize| {
                let slopes = if extends { slope(from) + slope(to) } else { 0.0 };
                // Most rows are those of other boxes.
                if slopes == 0.0 {
                    return 0.0;
                }
                let way = (self.vertices[to][axis] - self.vertices[from][axis]) * self.frame.unit;
                (0.5 * slopes * way) as f32
            };
            let mut moved = Vec::new();
            for _ in 0..rounds {
                for stage in &pulls {
                    pull(values, stage, change, &mut moved);
                }
            }
            if let Some(mirror) = self.mirror {
                symmetrise(values, mirror, axis, &mut moved);
            }
        });
        basis
    }

    /// Translation of each box per scale change of each parameter row, in the frame.
    fn translations(&self, parameter_rows: usize) -> Vec<Vec<DVec3>> {
        let parts = self.parts;
        let mut all = vec![vec![DVec3::ZERO; parameter_rows]; parts.box_center.len()];
        for (edge, &[parent, child]) in parts.tree_edges.iter().enumerate() {
            let (parent, child) = (parent as usize, child as usize);
            let p = self.frame.to_frame(parts.tree_parent_point[edge]);
            let q = self.frame.to_frame(parts.tree_child_point[edge]);
            let mut moved = all[parent].clone();
            moved[self.rows[parent]] += p;
            moved[self.rows[child]] -= q;
            if let (Some(mirror), MID) = (self.mirror, parts.box_side[child]) {
                for t in &mut moved {
                    t[mirror.axis] = 0.0;
                }
            }
            all[child] = moved;
        }
        all
    }
}

/// Makes mirror images move as mirror images; what lies on the plane stays on it. `axis` is the plane's own
/// axis of coefficients.
fn symmetrise(values: &mut [f32], mirror: &MirrorMap, axis: usize, before: &mut Vec<f32>) {
    before.clear();
    before.extend_from_slice(values);
    let sign = if axis == mirror.axis { -1.0 } else { 1.0 };
    for (value, image) in values.iter_mut().zip(&mirror.image) {
        if let Some(image) = image {
            *value = 0.5 * (*value + sign * before[*image as usize]);
        }
    }
}
