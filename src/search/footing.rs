// SPDX-License-Identifier: MIT OR Apache-2.0
//! What stands on the floor together stays on the floor together.
//!
//! Nothing in the score says that a chair's front legs must end where its back legs do, yet nobody would keep
//! the chair. The height of a foot is linear in the scales, so "all feet at one height" is a set of linear
//! equations: candidates are moved to the nearest scales that fulfil them. They hold for the unchanged
//! object as well, and so along the whole spectrum.

use glam::Vec3;
use nalgebra::{DMatrix, DVector};

use super::SearchSpace;
use crate::boxdef::{BoxDefGraph, DeformField};

/// Parts whose lowest vertex is within this share of the object's height of the floor stand on it.
const ON_FLOOR: f32 = 0.01;

/// A foot that moves by less than this per unit of change cannot be moved.
const SINGULAR: f64 = 1e-9;

/// Rounds of correction: scale factors that reach their range in one leave the rest to the next.
const ROUNDS: usize = 4;

/// The equations that keep the feet of an object (z up) level.
#[derive(Debug, Clone)]
pub struct Footing {
    /// Parameter rows that stand on the floor and may change their height.
    rows: Vec<usize>,
    /// Height of each later foot over the first, per unit of change of each row of factors' z.
    slopes: DMatrix<f64>,
    /// Pseudo-inverse of `slopes` over `rows` alone: the least correction.
    correction: DMatrix<f64>,
}

impl Footing {
    /// The footing of an object under a `field` of its graph; none where fewer than two parameter rows stand on the floor, or where all
    /// that do are locked.
    #[must_use]
    pub fn of(graph: &BoxDefGraph, field: &DeformField, space: &SearchSpace) -> Option<Self> {
        let heights = || field.rest().iter().map(|v| v.z);
        let floor = heights().fold(f32::INFINITY, f32::min);
        let top = heights().fold(f32::NEG_INFINITY, f32::max);
        let mut feet: Vec<Option<usize>> = vec![None; graph.parameter_rows()];
        for (vertex, &part) in graph.assignment().iter().enumerate() {
            let foot = &mut feet[graph.parameter_row_of_box()[part as usize]];
            if foot.is_none_or(|lowest| field.rest()[vertex].z < field.rest()[lowest].z) {
                *foot = Some(vertex);
            }
        }
        let stands = |v: usize| field.rest()[v].z - floor <= ON_FLOOR * (top - floor);
        let standing: Vec<(usize, usize)> = feet
            .into_iter()
            .enumerate()
            .filter_map(|(row, foot)| foot.filter(|v| stands(*v)).map(|v| (row, v)))
            .collect();
        let (rows, feet): (Vec<usize>, Vec<usize>) = standing.into_iter().unzip();
        if rows.len() < 2 {
            return None;
        }
        let slope = |row: usize, vertex: usize| {
            let start = (2 * field.parameter_rows() + row) * field.vertex_count();
            f64::from(field.basis()[start + vertex])
        };
        let slopes = DMatrix::from_fn(rows.len() - 1, field.parameter_rows(), |foot, row| {
            slope(row, feet[foot + 1]) - slope(row, feet[0])
        });
        let rows: Vec<usize> = rows.into_iter().filter(|&row| !space.is_locked(row, 2)).collect();
        if rows.is_empty() {
            return None;
        }
        let correction = slopes.select_columns(&rows).pseudo_inverse(SINGULAR).ok()?;
        Some(Self { rows, slopes, correction })
    }

    /// Moves the z scale factors of the standing rows as little as can be, within `range`, to level the feet.
    pub fn level(&self, factors: &mut [Vec3], range: (f32, f32)) {
        for _ in 0..ROUNDS {
            let changes = DVector::from_iterator(factors.len(), factors.iter().map(|c| f64::from(c.z) - 1.0));
            let step = &self.correction * (&self.slopes * changes);
            for (&row, step) in self.rows.iter().zip(step.iter()) {
                factors[row].z = (factors[row].z - *step as f32).clamp(range.0, range.1);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxdef::{Boundary, Parts};
    use crate::mesh::Mesh;

    /// A seat on two legs, each a part of its own.
    fn bench() -> BoxDefGraph {
        let boxes = [
            (Vec3::new(0.0, 0.0, 1.1), Vec3::new(1.0, 0.5, 0.1)),
            (Vec3::new(-0.9, 0.0, 0.5), Vec3::new(0.1, 0.5, 0.5)),
            (Vec3::new(0.8, 0.0, 0.5), Vec3::new(0.1, 0.4, 0.5)),
        ];
        let mut vertices = Vec::new();
        let mut triangles = Vec::new();
        let mut assignment = Vec::new();
        for (part, (center, half)) in boxes.iter().enumerate() {
            let first = vertices.len() as u32;
            for corner in 0..8 {
                let sign = |bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
                vertices.push(*center + *half * Vec3::new(sign(0), sign(1), sign(2)));
                assignment.push(part as i32);
            }
            triangles.extend([[0, 1, 3], [4, 5, 7], [0, 4, 6]].map(|t| t.map(|i| first + i)));
        }
        let mesh = Mesh::new(vertices, triangles).expect("the bench is a mesh");
        let point = |x: f32| Vec3::new(x, 0.0, 1.0);
        let parts = Parts {
            box_center: boxes.iter().map(|b| b.0).collect(),
            box_half_size: boxes.iter().map(|b| b.1).collect(),
            box_side: vec![0; 3],
            box_row: vec![0, 1, 2],
            assignment,
            tree_edges: vec![[0, 1], [0, 2]],
            tree_parent_point: vec![point(-0.9), point(0.8)],
            tree_child_point: vec![point(-0.9), point(0.8)],
            edges: vec![[0, 1], [0, 2]],
        };
        BoxDefGraph::from_parts(&mesh, parts, Boundary::Smooth).expect("the parts fit")
    }

    fn feet(graph: &BoxDefGraph, scales: &[Vec3]) -> [f32; 2] {
        let positions = graph.deform(scales).expect("three rows");
        [1, 2].map(|part| {
            let owned = positions.iter().zip(graph.assignment()).filter(|(_, owner)| **owner == part);
            owned.map(|(p, _)| p.z).fold(f32::INFINITY, f32::min)
        })
    }

    #[test]
    fn feet_stay_level_whatever_the_scales() {
        let graph = bench();
        let footing =
            Footing::of(&graph, graph.field(), &SearchSpace::free(3)).expect("both legs stand on the floor");
        for (seat, left, right) in [(1.0, 0.5, 2.0), (0.4, 1.5, 1.0), (2.5, 3.0, 0.9)] {
            let mut scales = [Vec3::splat(seat), Vec3::splat(left), Vec3::splat(right)];
            let before = feet(&graph, &scales);
            assert!((before[0] - before[1]).abs() > 0.1, "the test needs feet that part");
            footing.level(&mut scales, (0.3, 3.1));
            let after = feet(&graph, &scales);
            // The boundary step moves the corners of a foot apart by a little.
            assert!((after[0] - after[1]).abs() < 1e-3, "{after:?}");
            assert!(scales.iter().all(|c| c.min_element() >= 0.3 && c.max_element() <= 3.1));
        }
    }

    #[test]
    fn a_locked_leg_is_followed_by_the_other() {
        let graph = bench();
        let locked = [[false; 3], [false, false, true], [false; 3]];
        let space = SearchSpace::new(3, Some(&locked), (0.3, 3.1)).expect("something is free");
        let footing = Footing::of(&graph, graph.field(), &space).expect("both legs stand on the floor");
        let mut scales = [Vec3::splat(1.2), Vec3::ONE, Vec3::splat(2.0)];
        footing.level(&mut scales, space.range());
        let after = feet(&graph, &scales);
        assert!((after[0] - after[1]).abs() < 1e-3, "{after:?}");
        assert_eq!(scales[1], Vec3::ONE);
    }

    #[test]
    fn level_feet_are_left_alone() {
        let graph = bench();
        let footing =
            Footing::of(&graph, graph.field(), &SearchSpace::free(3)).expect("both legs stand on the floor");
        let mut scales = [Vec3::ONE; 3];
        footing.level(&mut scales, (0.3, 3.1));
        assert_eq!(scales, [Vec3::ONE; 3]);
    }
}
