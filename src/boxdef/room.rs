// SPDX-License-Identifier: MIT OR Apache-2.0
//! How far parts may be shifted: they slide over the part they hang on, and do not leave it.
//!
//! Where two boxes meet face to face there is one axis on which they lie behind each other. Along it a shift
//! would tear them apart or push one into the other, and scaling does what there is to do. Along the other two a
//! part may go as far as the box that it hangs on reaches, but not over its edge: a leg to the rim of the seat.
//! What takes up much of that box's face, such as the outer half of a wing beside the inner one, goes on from it
//! rather than stands on it, and stays where it is. No box crosses a plane of symmetry.

use glam::DVec3;

use super::layout::Layout;
use super::parts::NEG;

/// A part that takes up more than this share of the face it meets is not shifted over it.
const STANDS: f64 = 0.3;

/// Least and greatest shift of each parameter row along each axis (P), in object units; both 0 where there is
/// no room, as for the part that all others hang on.
pub(crate) fn room(layout: &Layout) -> Vec<[(f32, f32); 3]> {
    let parts = &layout.parts;
    let mut room = vec![[(0.0, 0.0); 3]; layout.parameter_rows()];
    for &[parent, child] in &parts.tree_edges {
        let (parent, child) = (parent as usize, child as usize);
        if parts.box_side[child] == NEG || layout.row(parent) == layout.row(child) {
            continue;
        }
        let corners = |b: usize| {
            let (center, half) = (parts.box_center[b].as_dvec3(), parts.box_half_size[b].as_dvec3());
            (center - half, center + half)
        };
        let ((low, high), (child_low, child_high)) = (corners(parent), corners(child));
        let behind = (low - child_high).max(child_low - high).max_position();
        let face = |extent: DVec3| extent[(behind + 1) % 3] * extent[(behind + 2) % 3];
        if face(child_high - child_low) > STANDS * face(high - low) {
            continue;
        }
        let inwards = layout.frame.center - child_low;
        for axis in (0..3).filter(|&axis| axis != behind && !layout.held[child][axis]) {
            let mut least = (low - child_low)[axis].min(0.0);
            if layout.symmetry.axes().contains(&axis) {
                least = least.max(inwards[axis].min(0.0));
            }
            room[layout.row(child)][axis] = (least as f32, (high - child_high)[axis].max(0.0) as f32);
        }
    }
    room
}
