// SPDX-License-Identifier: MIT OR Apache-2.0
//! The boundary step: how parts that touch follow each other where they meet (paper §3.1).
//!
//! A vertex of the follower moves towards the displacement of the nearest vertex of the leader, with a weight
//! that falls with their undeformed distance `d` (in units of the frame):
//!
//! - as in the paper, `½ · min(1, 1 / (50 (d + 0.001)))`, once. At the boundary itself a quarter of the
//!   difference is left, all of it across one edge of the mesh.
//! - smooth, `½ / (1 + (d / 0.08)²)`, three times over, which leaves a sixty-fourth; and towards what the
//!   displacement becomes on the way from the leader to the follower, by the mean of their scale changes.
//!   What is scaled alike then stays as it is, whatever the weights.
//!
//! On the authors' own shapes and parameters the smooth step stretches the worst edge a quarter as much, with
//! less change of curvature, less turning of normals and half the self-intersections.
//!
//! Weights and neighbours depend on the undeformed mesh alone, so both are fixed linear maps.

use std::str::FromStr;

use glam::DVec3;
use rayon::prelude::*;

use super::crowd::Crowd;
use super::error::BoxDefError;

/// How parts follow each other where they meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boundary {
    /// Spread over a neighbourhood of the boundary.
    #[default]
    Smooth,
    /// As in the paper.
    Paper,
}

impl Boundary {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Smooth => "smooth",
            Self::Paper => "paper",
        }
    }

    /// Rounds over all stages.
    pub(crate) fn rounds(self) -> usize {
        match self {
            Self::Smooth => 3,
            Self::Paper => 1,
        }
    }

    /// Whether the displacement that is followed changes on the way.
    pub(crate) fn extends(self) -> bool {
        self == Self::Smooth
    }

    /// How much a follower at undeformed distance `d`, in units of the frame, takes over.
    fn weight(self, d: f64) -> f64 {
        match self {
            Self::Smooth => 0.5 / (1.0 + (d / 0.08).powi(2)),
            Self::Paper => 0.5 * (1.0 / (50.0 * (d + 0.001))).min(1.0),
        }
    }
}

impl FromStr for Boundary {
    type Err = BoxDefError;

    fn from_str(name: &str) -> Result<Self, BoxDefError> {
        let known = [Self::Smooth, Self::Paper].into_iter().find(|boundary| boundary.name() == name);
        known.ok_or_else(|| BoxDefError::Boundary(name.into()))
    }
}

/// Follower, leader and weight: the follower's displacement moves towards the leader's.
pub(crate) type Pull = (u32, u32, f32);

/// The pulls of one round, stage by stage; `stages` are (leader, follower) pairs of boxes, `assignment` names
/// the box of each vertex.
pub(crate) fn pulls(
    boundary: Boundary,
    vertices: &[DVec3],
    assignment: &[i32],
    boxes: usize,
    stages: &[Vec<[i32; 2]>],
) -> Vec<Vec<Pull>> {
    let mut owned = vec![Vec::new(); boxes];
    for (vertex, &owner) in assignment.iter().enumerate() {
        owned[owner as usize].push(vertex as u32);
    }
    let crowds: Vec<Option<Crowd>> = owned.into_par_iter().map(|ids| Crowd::of(vertices, ids)).collect();
    let between = |leader: i32, follower: i32| -> Vec<Pull> {
        let (Some(leader), Some(follower)) = (&crowds[leader as usize], &crowds[follower as usize]) else {
            return Vec::new();
        };
        let pull = |(vertex, nearest, distance)| (vertex, nearest, boundary.weight(distance) as f32);
        follower.nearest_of(leader, vertices).into_iter().map(pull).collect()
    };
    let at_once = |stage: &Vec<[i32; 2]>| {
        let mut pulls: Vec<Pull> =
            stage.iter().flat_map(|&[leader, follower]| between(leader, follower)).collect();
        if stage.len() > 2 {
            temper(&mut pulls, vertices.len());
        }
        pulls
    };
    stages.iter().map(at_once).collect()
}

/// Keeps followers that several leaders pull at once from being pulled beyond them.
fn temper(pulls: &mut [Pull], vertices: usize) {
    let mut sums = vec![0.0_f32; vertices];
    for &(follower, _, weight) in pulls.iter() {
        sums[follower as usize] += weight;
    }
    for (follower, _, weight) in pulls {
        *weight /= sums[*follower as usize].max(1.0);
    }
}

/// Applies one stage to coefficients (n): all its pulls see the displacements from before it. `change` is the
/// displacement's change on the way from a leading to a following vertex; `moved` is scratch.
pub(crate) fn pull(
    values: &mut [f32],
    stage: &[Pull],
    change: impl Fn(usize, usize) -> f32,
    moved: &mut Vec<f32>,
) {
    moved.clear();
    moved.extend(stage.iter().map(|&(follower, leader, weight)| {
        let (follower, leader) = (follower as usize, leader as usize);
        weight * (values[leader] + change(leader, follower) - values[follower])
    }));
    for (&(follower, ..), change) in stage.iter().zip(moved.iter()) {
        values[follower as usize] += change;
    }
}
