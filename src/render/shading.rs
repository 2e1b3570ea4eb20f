// SPDX-License-Identifier: MIT OR Apache-2.0
//! The grey of a face: the lowest two bands of spherical harmonics with all weights one (paper §4).

use super::camera::{Camera, DISTANCE};
use super::frame::Frame;
use glam::Vec3;

const ALBEDO: f32 = 0.6;
const BAND_0: f32 = 0.282_09;
const BAND_1: f32 = 0.488_60;

/// The light of a color where the grey would be black.
const SHADOW: f32 = 0.35;

/// Shades the faces of one candidate in one view.
///
/// Value: `0.6 · clamp01(0.28209 + 0.48860 (nx + ny + nz))` with the flat face normal in camera space. The
/// normal is turned towards the camera, so that flipped, mixed and open shells look like closed ones.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shader {
    light: Vec3,
    eye: Vec3,
    frame: Frame,
}

impl Shader {
    pub fn new(camera: &Camera, frame: Frame) -> Self {
        Self { light: camera.right + camera.up + camera.back, eye: DISTANCE * camera.back, frame }
    }

    /// Grey in 0–1 of the face with these corners, in object coordinates.
    #[inline]
    pub fn grey(&self, [a, b, c]: [Vec3; 3]) -> f32 {
        let unit = self.frame.inverse_radius;
        let normal = ((b - a) * unit).cross((c - a) * unit);
        let length = normal.length();
        if length == 0.0 {
            return ALBEDO * BAND_0;
        }
        let towards = self.eye - (a - self.frame.centre) * unit;
        let facing = if normal.dot(towards) < 0.0 { -length } else { length };
        ALBEDO * (BAND_0 + BAND_1 * (normal.dot(self.light) / facing)).clamp(0.0, 1.0)
    }

    /// What the color of this face is multiplied with: 1 where it is lit, and never so dark that the color could
    /// not be told.
    pub fn light(&self, corners: [Vec3; 3]) -> f32 {
        SHADOW + (1.0 - SHADOW) / ALBEDO * self.grey(corners)
    }
}
