// SPDX-License-Identifier: MIT OR Apache-2.0
//! Parts to field: scaling, tree translations and the boundary step as linear maps (paper §3.1).
//!
//! With `s = c − 1` the scale change of a box and `d` its shift, per axis:
//!
//! 1. a vertex of box `b` moves by `s_b · v + t_b`, with `v` taken from the frame's origin;
//! 2. the root has `t = 0`; a child has `t_c = t_p + s_p · p − s_c · q` with `p`, `q` the undeformed
//!    constraint points of its tree edge, so that the joint holds;
//! 3. a shift moves a box and all that hang on it, mirror images the mirrored way: `t_c = t_p + d_c`;
//! 4. where two boxes are adjacent, each follows the other near their boundary ([`super::boundary`]).
//!
//! Each step is a fixed linear map, so the field is found by applying the steps to one plane of coefficients
//! per axis and parameter row.

use glam::DVec3;
use rayon::prelude::*;

use super::boundary::{pull, pulls};
use super::layout::Layout;
use super::symmetry::MirrorMap;

/// What a parameter row does to its boxes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Motion {
    /// Scales them.
    Scale,
    /// Shifts them.
    Shift,
}

/// A layout with the vertices that it moves.
pub(crate) struct Propagation<'a> {
    pub(crate) layout: &'a Layout,
    /// Vertices in the frame (n).
    pub(crate) vertices: &'a [DVec3],
    /// Their mirror images, which are to move as such.
    pub(crate) mirrors: &'a [&'a MirrorMap],
}

impl Propagation<'_> {
    /// The basis of each of the `motions`, one after another: `3 × (motions · P) × n` row-major, in object units
    /// per scale change and per shift by the frame's unit.
    pub(crate) fn basis(&self, motions: &[Motion]) -> Vec<f32> {
        let Layout { parts, frame, boundary, stages, .. } = self.layout;
        let n = self.vertices.len();
        let count = self.layout.parameter_rows();
        let rows: Vec<(Motion, usize)> =
            motions.iter().flat_map(|&motion| (0..count).map(move |row| (motion, row))).collect();
        let translations = [self.scale_translations(), self.shift_translations()];
        let (rounds, extends) = (boundary.rounds(), boundary.extends());
        let pulls = pulls(*boundary, self.vertices, &parts.assignment, parts.box_center.len(), stages);
        let mut basis = vec![0.0_f32; 3 * rows.len() * n];
        basis.par_chunks_mut(n).enumerate().for_each(|(plane, values)| {
            let (axis, (motion, row)) = (plane / rows.len(), rows[plane % rows.len()]);
            let translations = &translations[usize::from(motion == Motion::Shift)];
            let owner = |v: usize| parts.assignment[v] as usize;
            // The box's scale change per scale change of this row.
            let scaled = |v: usize| motion == Motion::Scale && self.layout.row(owner(v)) == row;
            let slope = |v: usize| if scaled(v) { 1.0 } else { 0.0 };
            for (v, value) in values.iter_mut().enumerate() {
                let scaled = slope(v) * self.vertices[v][axis];
                *value = ((scaled + translations[owner(v)][row][axis]) * frame.unit) as f32;
            }
            let change = |from: usize, to: usize| {
                let slopes = if extends { slope(from) + slope(to) } else { 0.0 };
                // Most rows are those of other boxes.
                if slopes == 0.0 {
                    return 0.0;
                }
                let way = (self.vertices[to][axis] - self.vertices[from][axis]) * frame.unit;
                (0.5 * slopes * way) as f32
            };
            let mut moved = Vec::new();
            for _ in 0..rounds {
                for stage in &pulls {
                    pull(values, stage, change, &mut moved);
                }
            }
            for mirror in self.mirrors {
                symmetrise(values, mirror, axis, &mut moved);
            }
        });
        basis
    }

    /// Translation of each box per scale change of each parameter row, in the frame.
    fn scale_translations(&self) -> Vec<Vec<DVec3>> {
        let Layout { parts, frame, .. } = self.layout;
        self.translations(|all, edge, [parent, child]| {
            let mut moved = all[parent].clone();
            moved[self.layout.row(parent)] += frame.to_frame(parts.tree_parent_point[edge]);
            moved[self.layout.row(child)] -= frame.to_frame(parts.tree_child_point[edge]);
            moved
        })
    }

    /// Translation of each box per shift of each parameter row.
    fn shift_translations(&self) -> Vec<Vec<DVec3>> {
        let directions = self.layout.directions();
        self.translations(|all, _, [parent, child]| {
            let row = self.layout.row(child);
            let mut moved = all[parent].clone();
            // Mirror images of each other go their own ways.
            moved[row] = if row == self.layout.row(parent) { DVec3::ZERO } else { moved[row] };
            moved[row] += directions[child];
            moved
        })
    }

    /// Translations of all boxes per parameter row, from the root outwards, a tree edge at a time.
    fn translations(
        &self,
        follow: impl Fn(&[Vec<DVec3>], usize, [usize; 2]) -> Vec<DVec3>,
    ) -> Vec<Vec<DVec3>> {
        let parts = &self.layout.parts;
        let mut all = vec![vec![DVec3::ZERO; self.layout.parameter_rows()]; parts.box_center.len()];
        for (edge, &[parent, child]) in parts.tree_edges.iter().enumerate() {
            let [parent, child] = [parent as usize, child as usize];
            let mut moved = follow(&all, edge, [parent, child]);
            for axis in (0..3).filter(|&axis| self.layout.held[child][axis]) {
                for t in &mut moved {
                    t[axis] = 0.0;
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
