// SPDX-License-Identifier: MIT OR Apache-2.0
//! Part boxes that a person gives, paired where they mirror each other.

use glam::{DVec3, Vec3};

use super::boxes::PartBox;
use super::frame::{CELL, Frame};
use super::occupancy::{CellBox, Occupancy};
use super::parts::{MID, NEG, POS};
use super::symmetry::mirrored;

/// How far a given box may be, in units of the frame, from the mirror image of its twin.
const SAME_BOX: f64 = 2.0 * CELL;

/// All mid boxes, then all pos boxes, then their neg twins in the same order, and the symmetry axis: the one
/// asked for if every box is its own mirror image or has a twin, else none.
pub(crate) fn given_boxes(
    center: &[Vec3],
    half_size: &[Vec3],
    frame: Frame,
    occupancy: &Occupancy,
    symmetry: Option<usize>,
) -> (Vec<PartBox>, Option<usize>) {
    let boxes: Vec<(DVec3, DVec3)> = center
        .iter()
        .zip(half_size)
        .map(|(&center, half)| {
            let (center, half) = (frame.to_frame(center), half.as_dvec3() / frame.unit);
            (center - half, center + half)
        })
        .collect();
    if let Some((axis, twins)) = symmetry.and_then(|axis| Some((axis, twins(&boxes, axis)?))) {
        let is_pos = |b: usize| twins[b] != b && boxes[b].0[axis] + boxes[b].1[axis] > 0.0;
        let mids: Vec<usize> = (0..boxes.len()).filter(|&b| twins[b] == b).collect();
        let pos: Vec<usize> = (0..boxes.len()).filter(|&b| is_pos(b)).collect();
        let part = |side, b: usize, twin| {
            // Exact mirror images: the pos box's of its neg twin, the mean of a mid box and its own.
            let (low, high) = boxes[if side == NEG { twins[b] } else { b }];
            let image = |(low, high): (DVec3, DVec3)| (mirrored(low, axis), mirrored(high, axis));
            let (a, b) = image((low, high));
            let (low, high) = match side {
                NEG => (a.min(b), a.max(b)),
                MID => ((low + a.min(b)) * 0.5, (high + a.max(b)) * 0.5),
                _ => (low, high),
            };
            PartBox { side, domain: domain(occupancy, low, high), low, high, twin }
        };
        let mut parts: Vec<PartBox> = Vec::new();
        parts.extend(mids.iter().enumerate().map(|(i, &b)| part(MID, b, i)));
        let (first, count) = (mids.len(), pos.len());
        parts.extend(pos.iter().enumerate().map(|(i, &b)| part(POS, b, first + count + i)));
        parts.extend(pos.iter().enumerate().map(|(i, &b)| part(NEG, twins[b], first + i)));
        return (parts, Some(axis));
    }
    let single = |(twin, &(low, high)): (usize, &(DVec3, DVec3))| PartBox {
        side: MID,
        domain: domain(occupancy, low, high),
        low,
        high,
        twin,
    };
    (boxes.iter().enumerate().map(single).collect(), None)
}

/// The mirror twin of each box, the box itself where it is its own; none unless all have one.
fn twins(boxes: &[(DVec3, DVec3)], axis: usize) -> Option<Vec<usize>> {
    let twins: Vec<usize> = boxes
        .iter()
        .map(|&(low, high)| {
            let (a, b) = (mirrored(low, axis), mirrored(high, axis));
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
