// SPDX-License-Identifier: MIT OR Apache-2.0
//! Parts to field: scaling, tree translations and the boundary step as linear maps (paper §3.1).
//!
//! With `s = c − 1` the scale change of a box, per axis:
//!
//! 1. a vertex of box `b` moves by `s_b · v + t_b`, with `v` taken from the frame's origin;
//! 2. the root has `t = 0`; a child has `t_c = t_p + s_p · p − s_c · q` with `p`, `q` the undeformed
//!    constraint points of its tree edge, so that the joint holds;
//! 3. where two boxes are adjacent, each follows the other near their boundary: a vertex of the follower
//!    moves towards the displacement of the nearest vertex of the leader, with weight
//!    `½ · min(1, 1 / (50 (d + 0.001)))`, `d` their undeformed distance.
//!
//! Weights and neighbours depend on the undeformed mesh alone, so each step is a fixed linear map, and the
//! field is found by applying the steps to one plane of coefficients per axis and parameter row.

use glam::DVec3;
use rayon::prelude::*;

use super::frame::Frame;
use super::nearest::Nearest;
use super::parts::{MID, Parts};
use super::symmetry::MirrorMap;

/// Follower, leader and weight: the follower's displacement moves towards the leader's.
type Pull = (u32, u32, f32);

/// The parts with everything that the field needs of them, in the frame.
pub(crate) struct Propagation<'a> {
    pub(crate) frame: Frame,
    pub(crate) parts: &'a Parts,
    pub(crate) rows: &'a [usize],
    /// Vertices in the frame (n).
    pub(crate) vertices: &'a [DVec3],
    /// Symmetry to keep exactly: mid boxes do not move along its axis, mirror images move as such.
    pub(crate) mirror: Option<&'a MirrorMap>,
    /// Boundary steps: the (leader, follower) pairs of one stage act at once, stages one after another.
    pub(crate) stages: Vec<Vec<[i32; 2]>>,
}

impl Propagation<'_> {
    /// The basis, `3 × P × n` row-major, in object units.
    pub(crate) fn basis(&self, parameter_rows: usize) -> Vec<f32> {
        let n = self.vertices.len();
        let translations = self.translations(parameter_rows);
        let pulls: Vec<Vec<Pull>> = self.pulls();
        let mut basis = vec![0.0_f32; 3 * parameter_rows * n];
        basis.par_chunks_mut(n).enumerate().for_each(|(plane, values)| {
            let (axis, row) = (plane / parameter_rows, plane % parameter_rows);
            for (v, value) in values.iter_mut().enumerate() {
                let owner = self.parts.assignment[v] as usize;
                let scaled = if self.rows[owner] == row { self.vertices[v][axis] } else { 0.0 };
                *value = ((scaled + translations[owner][row][axis]) * self.frame.unit) as f32;
            }
            let mut moved = Vec::new();
            for stage in &pulls {
                pull(values, stage, &mut moved);
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

    /// The boundary steps, stage by stage.
    fn pulls(&self) -> Vec<Vec<Pull>> {
        let mut owned = vec![Vec::new(); self.parts.box_center.len()];
        for (vertex, &owner) in self.parts.assignment.iter().enumerate() {
            owned[owner as usize].push(vertex as u32);
        }
        let trees: Vec<Option<Leader>> = owned.par_iter().map(|ids| Leader::of(self.vertices, ids)).collect();
        let between = |leader: i32, follower: i32| -> Vec<Pull> {
            let Some(tree) = &trees[leader as usize] else { return Vec::new() };
            owned[follower as usize]
                .par_iter()
                .map(|&vertex| {
                    let (nearest, distance) = tree.nearest(self.vertices[vertex as usize]);
                    (vertex, nearest, boundary_weight(distance) as f32)
                })
                .collect()
        };
        self.stages
            .iter()
            .map(|stage| stage.iter().flat_map(|&[leader, follower]| between(leader, follower)).collect())
            .collect()
    }
}

/// A box with more vertices than this is thinned for followers that are not near.
const MANY: usize = 4_000;
/// Edge of the cubes that keep one vertex each.
const THINNED: f64 = 0.01;
/// Nearer than this, all vertices count.
const NEAR: f64 = 0.05;

/// The vertices of a box, to be followed.
///
/// From afar one vertex of a neighbourhood is as good as another: their displacements are nearly the same,
/// and so are the weights. But to find the very nearest of a million that are all about equally far, as
/// those of a tube are from its axis, takes a long time.
struct Leader {
    all: Nearest,
    thinned: Option<Nearest>,
}

impl Leader {
    fn of(vertices: &[DVec3], ids: &[u32]) -> Option<Self> {
        let tree = |ids: &[u32]| Nearest::new(vertices, ids.iter().copied());
        let thinned = (ids.len() > MANY).then(|| tree(&Nearest::thin(vertices, ids, THINNED)));
        (!ids.is_empty()).then(|| Self { all: tree(ids), thinned })
    }

    fn nearest(&self, vertex: DVec3) -> (u32, f64) {
        match self.thinned.as_ref().map(|tree| tree.one(vertex)) {
            Some(found) if found.1 > NEAR => found,
            _ => self.all.one(vertex),
        }
    }
}

/// How much a follower at undeformed distance `d` (in units of the frame) takes over.
fn boundary_weight(d: f64) -> f64 {
    0.5 * (1.0 / (50.0 * (d + 0.001))).min(1.0)
}

/// One stage: all pulls see the displacements from before it.
fn pull(values: &mut [f32], stage: &[Pull], moved: &mut Vec<f32>) {
    moved.clear();
    moved.extend(
        stage.iter().map(|&(follower, leader, weight)| {
            weight * (values[leader as usize] - values[follower as usize])
        }),
    );
    for (&(follower, ..), change) in stage.iter().zip(moved.iter()) {
        values[follower as usize] += change;
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
