// SPDX-License-Identifier: MIT OR Apache-2.0
//! Scaling a shape to the unit sphere.

use glam::Vec3;

/// The sphere that becomes the unit sphere before a shape is seen.
///
/// The centre is that of the bounding box and the radius the largest distance to it, over the vertices that a
/// triangle uses. (The paper takes the mean of the vertices as the centre, which moves with the tessellation.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub centre: Vec3,
    /// One over the radius; 0 for a shape that is a single point.
    pub inverse_radius: f32,
}

impl Frame {
    /// The frame of the positions that `used` lists, or nothing if one of them is not finite.
    pub fn of(positions: &[Vec3], used: &[u32]) -> Option<Self> {
        let at = |i: &u32| positions[*i as usize];
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let mut finite = true;
        for p in used.iter().map(at) {
            low = low.min(p);
            high = high.max(p);
            finite &= p.is_finite();
        }
        if !finite || used.is_empty() {
            return None;
        }
        let centre = 0.5 * low + 0.5 * high;
        // Distances are squared in units of the box, so that no size overflows.
        let extent = (0.5 * high - 0.5 * low).max_element();
        if extent < f32::MIN_POSITIVE {
            return Some(Self { centre, inverse_radius: 0.0 });
        }
        let farthest =
            used.iter().map(at).map(|p| ((p - centre) / extent).length_squared()).fold(0.0, f32::max);
        Some(Self { centre, inverse_radius: 1.0 / extent / farthest.sqrt() })
    }
}
