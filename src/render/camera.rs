// SPDX-License-Identifier: MIT OR Apache-2.0
//! Where the cameras of the reference protocol stand (paper §4).
//!
//! The paper's coordinates are y-up; ours are Blender's, z-up. `(x, y, z)` here is `(x, z, −y)` there. The
//! conversion happens once, in [`Camera::new`]: everything after it is in object coordinates.

use super::RenderError;
use glam::Vec3;

/// Distance of the camera from the centre of the shape, which is scaled to the unit sphere.
pub(super) const DISTANCE: f32 = 2.5;
/// Tangent of half the field of view of 60°.
pub(super) const TAN_HALF_FOV: f32 = 0.577_350_26;

/// A direction from which the shape is seen, up being +z.
///
/// The camera stands at distance 2.5 from the centre of the unit-sphere-normalised shape, looks at that
/// centre and has a field of view of 60°.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Degrees around the up axis from +x towards −y: 0 looks from +x (right), 90 from −y (the front).
    pub azimuth: f32,
    /// Degrees above the horizon.
    pub elevation: f32,
}

/// The views called `name`.
///
/// `"paper"`: elevation 45°, azimuths 45°, −45°, −135°, 135°, seen from the front right, the back right, the
/// back left and the front left. `"ring"`: elevation 30°, eight azimuths from 0° in steps of 45°. `"front right"`:
/// elevation 36°, azimuth 45°, from where outcomes are evaluated: no view that a search has looked from.
pub fn views_by_name(name: &str) -> Result<Vec<View>, RenderError> {
    match name {
        "paper" => Ok([45.0, -45.0, -135.0, 135.0].map(|azimuth| View { azimuth, elevation: 45.0 }).to_vec()),
        "ring" => Ok((0..8u8).map(|i| View { azimuth: 45.0 * f32::from(i), elevation: 30.0 }).collect()),
        "front right" => Ok(vec![View { azimuth: 45.0, elevation: 36.0 }]),
        _ => Err(RenderError::UnknownViews(name.to_owned())),
    }
}

/// The axes of a camera in object coordinates: orthonormal, right-handed, looking along −`back`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Camera {
    pub right: Vec3,
    pub up: Vec3,
    pub back: Vec3,
}

impl Camera {
    pub fn new(view: View) -> Self {
        let (sin_a, cos_a) = view.azimuth.to_radians().sin_cos();
        let (sin_e, cos_e) = view.elevation.to_radians().sin_cos();
        let object = |x: f32, y: f32, z: f32| Vec3::new(x, -z, y);
        // Written out rather than as cross products, so that looking straight down is well defined.
        Self {
            right: object(sin_a, 0.0, -cos_a),
            up: object(-sin_e * cos_a, cos_e, -sin_e * sin_a),
            back: object(cos_e * cos_a, sin_e, cos_e * sin_a),
        }
    }
}
