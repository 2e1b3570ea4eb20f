// SPDX-License-Identifier: MIT OR Apache-2.0
//! Part boxes that a person gives, paired where they mirror each other.

use glam::{DVec3, Vec3};

use super::boxes::{PartBox, with_images};
use super::frame::{CELL, Frame};
use super::occupancy::{CellBox, Occupancy};
use super::symmetry::{Symmetry, mirrored};

/// How far a given box may be, in units of the frame, from the mirror image of its twin.
const SAME_BOX: f64 = 2.0 * CELL;

/// All mid boxes, then all pos boxes, then the mirror images of the latter, and the symmetry: what is left of the
/// one asked for once every box is its own mirror image or that of another.
pub(crate) fn given_boxes(
    center: &[Vec3],
    half_size: &[Vec3],
    frame: Frame,
    occupancy: &Occupancy,
    symmetry: Symmetry,
) -> (Vec<PartBox>, Symmetry) {
    let boxes: Vec<(DVec3, DVec3)> = center
        .iter()
        .zip(half_size)
        .map(|(&center, half)| {
            let (center, half) = (frame.to_frame(center), half.as_dvec3() / frame.unit);
            (center - half, center + half)
        })
        .collect();
    let mut paired: Vec<(usize, Vec<usize>)> =
        symmetry.axes().iter().filter_map(|&axis| Some((axis, twins(&boxes, axis)?))).collect();
    if let [(_, x), (_, y)] = &paired[..]
        && (0..boxes.len()).any(|b| x[y[b]] != y[x[b]])
    {
        paired.truncate(1);
    }
    let axes: Vec<usize> = paired.iter().map(|&(axis, _)| axis).collect();
    let symmetry = Symmetry::about(&axes);
    // One box stands for its mirror images: the one on the positive sides.
    let stands = |b: &usize| {
        paired.iter().all(|(axis, twins)| twins[*b] == *b || boxes[*b].0[*axis] + boxes[*b].1[*axis] > 0.0)
    };
    let exact = |b: usize| {
        let (mut off_plane, (mut low, mut high)) = ([false; 3], boxes[b]);
        for (axis, twins) in &paired {
            off_plane[*axis] = twins[b] != b;
            if !off_plane[*axis] {
                let half = 0.5 * (high[*axis] - low[*axis]);
                (low[*axis], high[*axis]) = (-half, half);
            }
        }
        (off_plane, domain(occupancy, low, high), low, high)
    };
    let mut single: Vec<_> = (0..boxes.len()).filter(stands).map(exact).collect();
    single.sort_by_key(|part| part.0.contains(&true));
    (with_images(&single, occupancy, symmetry), symmetry)
}

/// The mirror twin of each box, the box itself where it is its own; none unless all have one.
fn twins(boxes: &[(DVec3, DVec3)], axis: usize) -> Option<Vec<usize>> {
    let twins: Vec<usize> = boxes
        .iter()
        .map(|&(low, high)| {
            let (a, b) = (mirrored(low, &[axis]), mirrored(high, &[axis]));
            let away = |&(l, h): &(DVec3, DVec3)| {
                (l - a.min(b)).abs().max_element().max((h - a.max(b)).abs().max_element())
            };
            let nearest = (0..boxes.len()).min_by(|&x, &y| away(&boxes[x]).total_cmp(&away(&boxes[y])));
            nearest.filter(|&b| away(&boxes[b]) <= SAME_BOX)
        })
        .collect::<Option<_>>()?;
    (0..boxes.len()).all(|b| twins[twins[b]] == b).then_some(twins)
}

/// The cells from that of a box's low corner to that of its high corner.
fn domain(occupancy: &Occupancy, low: DVec3, high: DVec3) -> CellBox {
    let (low, high) = (occupancy.cell_of(low), occupancy.cell_of(high));
    CellBox { low, high: std::array::from_fn(|axis| high[axis].max(low[axis]) + 1) }
}
