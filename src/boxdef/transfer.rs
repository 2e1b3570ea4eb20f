// SPDX-License-Identifier: MIT OR Apache-2.0
//! The field of a mesh, carried over to other points: a base mesh under its modifiers, a proxy, a refinement.

use std::num::NonZero;

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::field::DeformField;
use super::layout::Layout;
use super::nearest::Nearest;
use super::symmetry::MirrorMap;

/// Vertices that a point takes its field from. The farthest has weight 0, so that the field does not jump
/// where it changes.
const NEIGHBOURS: NonZero<usize> = NonZero::new(7).unwrap();

/// A mesh's field and what it takes to evaluate it elsewhere.
pub(crate) struct Transfer<'a> {
    pub(crate) layout: &'a Layout,
    pub(crate) field: &'a DeformField,
}

/// Where a point takes its field from.
struct Source {
    /// The point in the frame, on the positive sides of the planes that the mesh mirrors about.
    place: DVec3,
    /// Whether it lies on the negative side of each.
    reflected: [bool; 3],
    /// Vertices with their weights, which add up to 1.
    weights: Vec<(u32, f64)>,
}

impl Source {
    fn at_point(tree: &Nearest, point: DVec3, folds: &[usize]) -> Self {
        let (nearest, distance) = tree.one(point);
        if distance == 0.0 {
            return Self { place: point, reflected: [false; 3], weights: vec![(nearest, 1.0)] };
        }
        let (mut place, mut reflected) = (point, [false; 3]);
        for &axis in folds {
            reflected[axis] = point[axis] < 0.0;
            place[axis] = point[axis].abs();
        }
        let near = tree.some(place, NEIGHBOURS);
        let reach = near.last().map_or(0.0, |last| last.1);
        // Falls to 0 at the farthest, rises without limit towards 0 (Franke and Little's weights).
        let weight = |d: f64| ((reach - d) / (reach * d.max(1e-12))).powi(2);
        let sum: f64 = near.iter().map(|&(_, d)| weight(d)).sum();
        let weights = if sum > 0.0 {
            near.iter().map(|&(vertex, d)| (vertex, weight(d) / sum)).collect()
        } else {
            // All equally far.
            near.iter().map(|&(vertex, _)| (vertex, 1.0 / near.len() as f64)).collect()
        };
        Self { place, reflected, weights }
    }
}

impl Transfer<'_> {
    /// The field at `points` in object coordinates.
    ///
    /// A point in a vertex's place moves as the vertex does. Elsewhere it moves as the nearest vertices
    /// would if they lay there, scaled by their own boxes, weighed by nearness.
    pub(crate) fn at(&self, points: &[Vec3]) -> DeformField {
        let frame = self.layout.frame;
        let vertices: Vec<DVec3> = self.field.rest().iter().map(|&v| frame.to_frame(v)).collect();
        let tree = Nearest::new(&vertices, 0..vertices.len() as u32);
        // Only a mesh that is its own mirror image can be asked on one side for the other.
        let mut folds = self.layout.symmetry.axes().to_vec();
        folds.retain(|&axis| MirrorMap::of(&vertices, axis).is_complete());
        let sources: Vec<Source> =
            points.par_iter().map(|&point| Source::at_point(&tree, frame.to_frame(point), &folds)).collect();
        let (count, rows) = (points.len(), self.field.parameter_rows());
        let mut basis = vec![0.0_f32; 3 * rows * count];
        if count > 0 {
            basis.par_chunks_mut(count).enumerate().for_each(|(plane, values)| {
                let (axis, row) = (plane / rows, plane % rows);
                let known = &self.field.basis()[plane * vertices.len()..(plane + 1) * vertices.len()];
                for (value, source) in values.iter_mut().zip(&sources) {
                    *value = self.value(known, &vertices, source, axis, row, &folds);
                }
            });
        }
        let scale_rows = self.field.scale_rows();
        DeformField::with_shifts(points.to_vec(), scale_rows, rows - scale_rows, basis)
    }

    fn value(
        &self,
        known: &[f32],
        vertices: &[DVec3],
        source: &Source,
        axis: usize,
        row: usize,
        folds: &[usize],
    ) -> f32 {
        let across = folds.contains(&axis);
        if across && source.place[axis] == 0.0 {
            return 0.0;
        }
        let sum: f64 = source
            .weights
            .iter()
            .map(|&(vertex, weight)| {
                let vertex = vertex as usize;
                let owner = self.layout.parts.assignment[vertex] as usize;
                // A row of shifts is that of no box, so what is shifted goes along as it is.
                let beyond = if self.layout.row(owner) == row {
                    (source.place[axis] - vertices[vertex][axis]) * self.layout.frame.unit
                } else {
                    0.0
                };
                weight * (f64::from(known[vertex]) + beyond)
            })
            .sum();
        if across && source.reflected[axis] { -sum as f32 } else { sum as f32 }
    }
}
