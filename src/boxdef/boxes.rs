// SPDX-License-Identifier: MIT OR Apache-2.0
//! Pieces to part boxes: mid, pos and neg boxes, tight around the surface in their share of space.

use glam::DVec3;
use rayon::prelude::*;

use crate::mesh::Mesh;

use super::occupancy::{CellBox, Occupancy};
use super::parts::{MID, NEG, POS};
use super::split::Piece;
use super::symmetry::{Symmetry, Way};

/// A part box in the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PartBox {
    pub(crate) side: i8,
    pub(crate) domain: CellBox,
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
    /// Index of the mirror image about each axis; of the box itself where it is its own or there is none.
    pub(crate) images: [usize; 3],
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

/// The mirror image of box `index` about some axes.
pub(crate) fn image(boxes: &[PartBox], index: usize, way: &[usize]) -> usize {
    way.iter().fold(index, |index, &axis| boxes[index].images[axis])
}

/// Parameter row of each box: mid and pos boxes come first and have rows of their own, neg boxes that of the
/// pos box that they mirror.
pub(crate) fn box_rows(boxes: &[PartBox], symmetry: Symmetry) -> Vec<i32> {
    let images = |b| symmetry.ways().iter().map(move |way| image(boxes, b, way));
    (0..boxes.len()).map(|b| images(b).min().unwrap_or(b) as i32).collect()
}

/// All mid boxes, then all pos boxes, then the mirror images of the latter, way by way.
pub(crate) fn part_boxes(
    mesh: &Mesh,
    vertices: &[DVec3],
    occupancy: &Occupancy,
    pieces: &[Piece],
    symmetry: Symmetry,
) -> Vec<PartBox> {
    let boxes = pieces.iter().map(|piece| {
        let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (mut low, mut high) = ways_off(symmetry, piece.off_plane).fold(empty, |(low, high), way| {
            let domain = mirrored_cells(occupancy, &piece.domain, way);
            let (a, b) = mirrored_bounds(surface_bounds(mesh, vertices, occupancy, &domain), way);
            (low.min(a), high.max(b))
        });
        for &axis in symmetry.axes().iter().filter(|&&axis| !piece.off_plane[axis]) {
            high[axis] = high[axis].max(-low[axis]);
            low[axis] = -high[axis];
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
        (piece.off_plane, piece.domain, low, high)
    });
    with_images(&boxes.collect::<Vec<_>>(), occupancy, symmetry)
}

/// Adds the mirror images of boxes (off which planes each lies, domain, low and high corner) that come without
/// images first.
pub(crate) fn with_images(
    boxes: &[([bool; 3], CellBox, DVec3, DVec3)],
    occupancy: &Occupancy,
    symmetry: Symmetry,
) -> Vec<PartBox> {
    // Which of the boxes, mirrored in which way, stands at each index.
    let mut places: Vec<(usize, Way)> = Vec::new();
    for &way in symmetry.ways() {
        let is_moved = |&index: &usize| way.iter().all(|&axis| boxes[index].0[axis]);
        places.extend((0..boxes.len()).filter(is_moved).map(|index| (index, way)));
    }
    let image = |(index, way): (usize, Way), axis: usize| {
        if !symmetry.axes().contains(&axis) || !boxes[index].0[axis] {
            return (index, way);
        }
        let toggled = |other: &&Way| (0..3).all(|a| other.contains(&a) == (way.contains(&a) != (a == axis)));
        (index, *symmetry.ways().iter().find(toggled).unwrap_or(&way))
    };
    let at = |place: (usize, Way)| places.iter().position(|&other| other == place).unwrap_or_default();
    places
        .iter()
        .map(|&(index, way)| {
            let (off_plane, domain, low, high) = boxes[index];
            let side = match (off_plane.contains(&true), way.is_empty()) {
                (false, _) => MID,
                (true, true) => POS,
                (true, false) => NEG,
            };
            let (low, high) = mirrored_bounds((low, high), way);
            let images = std::array::from_fn(|axis| at(image((index, way), axis)));
            PartBox { side, domain: mirrored_cells(occupancy, &domain, way), low, high, images }
        })
        .collect()
}

/// The ways to mirror that lead to another place for what lies off some planes.
fn ways_off(symmetry: Symmetry, off_plane: [bool; 3]) -> impl Iterator<Item = Way> {
    symmetry.ways().iter().copied().filter(move |way| way.iter().all(|&axis| off_plane[axis]))
}

/// Keeps the boxes that own a vertex, or a mirror image of which does. Images are renumbered.
pub(crate) fn keep_owners(boxes: &[PartBox], owners: &[i32], symmetry: Symmetry) -> Vec<PartBox> {
    let mut owns = vec![false; boxes.len()];
    for &owner in owners {
        owns[owner as usize] = true;
    }
    let keeps = |b: &usize| symmetry.ways().iter().any(|way| owns[image(boxes, *b, way)]);
    let kept: Vec<usize> = (0..boxes.len()).filter(keeps).collect();
    let place = |b: usize| kept.binary_search(&b).unwrap_or(0);
    kept.iter().map(|&b| PartBox { images: boxes[b].images.map(place), ..boxes[b] }).collect()
}

/// A box from its low and high corner, mirrored; empty ones stay empty.
fn mirrored_bounds((low, high): (DVec3, DVec3), way: &[usize]) -> (DVec3, DVec3) {
    way.iter().fold((low, high), |(mut low, mut high), &axis| {
        (low[axis], high[axis]) = (-high[axis], -low[axis]);
        (low, high)
    })
}

fn mirrored_cells(occupancy: &Occupancy, cells: &CellBox, way: &[usize]) -> CellBox {
    way.iter().fold(*cells, |cells, &axis| {
        let size = occupancy.size()[axis];
        cells.with(axis, size - cells.high[axis], size - cells.low[axis])
    })
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
