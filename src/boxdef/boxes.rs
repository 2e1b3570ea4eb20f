// SPDX-License-Identifier: MIT OR Apache-2.0
//! Pieces to part boxes: mid, pos and neg boxes, tight around the surface in their share of space.

use glam::DVec3;
use rayon::prelude::*;

use crate::mesh::Mesh;

use super::occupancy::{CellBox, Occupancy};
use super::parts::{NEG, POS};
use super::split::Piece;
use super::symmetry::mirrored;

/// A part box in the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PartBox {
    pub(crate) side: i8,
    pub(crate) domain: CellBox,
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
    /// Index of the mirror twin; of the box itself where there is none.
    pub(crate) twin: usize,
}

impl PartBox {
    pub(crate) fn center(&self) -> DVec3 {
        (self.low + self.high) * 0.5
    }

    pub(crate) fn half_size(&self) -> DVec3 {
        (self.high - self.low) * 0.5
    }

    /// Distance of a point to the box, 0 inside.
    pub(crate) fn distance(&self, point: DVec3) -> f64 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO).length()
    }

    /// Distance to another box, 0 if they touch or overlap.
    pub(crate) fn distance_to(&self, other: &Self) -> f64 {
        (self.low - other.high).max(other.low - self.high).max(DVec3::ZERO).length()
    }
}

/// All mid boxes, then all pos boxes, then their neg twins in the same order.
pub(crate) fn part_boxes(
    mesh: &Mesh,
    vertices: &[DVec3],
    occupancy: &Occupancy,
    pieces: &[Piece],
    symmetry: Option<usize>,
) -> Vec<PartBox> {
    let mut boxes: Vec<PartBox> = Vec::new();
    for (index, piece) in pieces.iter().enumerate() {
        let (mut low, mut high) = surface_bounds(mesh, vertices, occupancy, &piece.domain);
        if let Some(axis) = symmetry {
            let domain = mirrored_cells(occupancy, &piece.domain, axis);
            let (a, b) = surface_bounds(mesh, vertices, occupancy, &domain);
            let (a, b) = (mirrored(a, axis), mirrored(b, axis));
            (low, high) = (low.min(a.min(b)), high.max(a.max(b)));
        }
        let bound = |cells: [usize; 3]| {
            DVec3::from_array(std::array::from_fn(|axis| occupancy.boundary(axis, cells[axis])))
        };
        let (least, most) = (bound(piece.tight.low), bound(piece.tight.high));
        // What reaches into the domain by no more than rounding fills no cell; and a domain inside a solid
        // has cells but no surface.
        (low, high) = (low.max(least), high.min(most));
        if low.cmpgt(high).any() {
            (low, high) = (least, most);
        }
        boxes.push(PartBox { side: piece.side, domain: piece.domain, low, high, twin: index });
    }
    if let Some(axis) = symmetry {
        for index in 0..boxes.len() {
            if boxes[index].side == POS {
                let pos = boxes[index];
                let (a, b) = (mirrored(pos.low, axis), mirrored(pos.high, axis));
                let domain = mirrored_cells(occupancy, &pos.domain, axis);
                boxes[index].twin = boxes.len();
                boxes.push(PartBox { side: NEG, domain, low: a.min(b), high: a.max(b), twin: index });
            }
        }
    }
    boxes
}

/// Keeps the boxes that own a vertex, or whose twin does. Twins are renumbered.
pub(crate) fn keep_owners(boxes: &[PartBox], owners: &[i32]) -> Vec<PartBox> {
    let mut owns = vec![false; boxes.len()];
    for &owner in owners {
        owns[owner as usize] = true;
    }
    let kept: Vec<usize> = (0..boxes.len()).filter(|&b| owns[b] || owns[boxes[b].twin]).collect();
    let place = |b: usize| kept.binary_search(&b).unwrap_or(0);
    kept.iter().map(|&b| PartBox { twin: place(boxes[b].twin), ..boxes[b] }).collect()
}

fn mirrored_cells(occupancy: &Occupancy, cells: &CellBox, axis: usize) -> CellBox {
    let size = occupancy.size()[axis];
    cells.with(axis, size - cells.high[axis], size - cells.low[axis])
}

/// Bounds of the part of the surface that lies in a domain; empty (low above high) if none does.
fn surface_bounds(
    mesh: &Mesh,
    vertices: &[DVec3],
    occupancy: &Occupancy,
    domain: &CellBox,
) -> (DVec3, DVec3) {
    // A domain that reaches the grid's edge goes on without end.
    let low = DVec3::from_array(std::array::from_fn(|axis| match domain.low[axis] {
        0 => f64::NEG_INFINITY,
        index => occupancy.boundary(axis, index),
    }));
    let high = DVec3::from_array(std::array::from_fn(|axis| match domain.high[axis] {
        index if index == occupancy.size()[axis] => f64::INFINITY,
        index => occupancy.boundary(axis, index),
    }));
    let empty = || (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let of_triangle = |triangle: &[u32; 3]| {
        let corners = triangle.map(|i| vertices[i as usize]);
        let least = corners[0].min(corners[1]).min(corners[2]);
        let most = corners[0].max(corners[1]).max(corners[2]);
        if least.cmpge(high).any() || most.cmplt(low).any() {
            return empty();
        }
        if least.cmpge(low).all() && most.cmple(high).all() {
            return (least, most);
        }
        let (mut polygon, mut scratch) = (corners.to_vec(), Vec::new());
        for axis in 0..3 {
            clip(&mut polygon, &mut scratch, |p| p[axis] - low[axis]);
            clip(&mut polygon, &mut scratch, |p| high[axis] - p[axis]);
        }
        polygon.iter().fold(empty(), |(low, high), &point| (low.min(point), high.max(point)))
    };
    mesh.triangles().par_iter().map(of_triangle).reduce(empty, |a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// Keeps the part of a convex polygon where `inside` is not negative.
fn clip(polygon: &mut Vec<DVec3>, scratch: &mut Vec<DVec3>, inside: impl Fn(DVec3) -> f64) {
    scratch.clear();
    for (i, &point) in polygon.iter().enumerate() {
        let previous = polygon[(i + polygon.len() - 1) % polygon.len()];
        let (a, b) = (inside(previous), inside(point));
        if (a < 0.0) != (b < 0.0) {
            scratch.push(previous.lerp(point, a / (a - b)));
        }
        if b >= 0.0 {
            scratch.push(point);
        }
    }
    std::mem::swap(polygon, scratch);
}
