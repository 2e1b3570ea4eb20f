// SPDX-License-Identifier: MIT OR Apache-2.0
//! The spectrum: the line through the object (α = 0) and the outcome (α = 1), and how far it goes.
//!
//! Positions are linear in α, and so is the effective scale factor of a part box: with the outcome's
//! scale factor c and the gauge's scale g it is 1 + α·(g·c − 1). Where it reaches 0 the box is flat, and
//! beyond that inside out; the slider ends before.

use glam::Vec3;

/// The effective scale factor that no part box goes below on the slider.
pub const LEAST_SCALE: f32 = 0.05;

/// The widest slider by default: from the opposite of the prompt to twice as far.
pub const DEFAULT_RANGE: [f32; 2] = [-1.0, 2.0];

/// The widest slider that Blender has.
pub const BLENDER_RANGE: [f32; 2] = [-10.0, 10.0];

/// The ends of the slider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderLimits {
    /// Least α, at most 0.
    pub min: f32,
    /// Greatest α, at least 1.
    pub max: f32,
}

/// The range of α in which every effective scale factor stays at or above [`LEAST_SCALE`].
///
/// `scales` are the outcome's scale factors (1 = unchanged), `gauge_scale` the scale of its gauge;
/// `widest` bounds the range, itself bounded by [`BLENDER_RANGE`]. Object and outcome are always on the
/// slider, even an outcome that has a part thinner than [`LEAST_SCALE`].
#[must_use]
pub fn slider_limits(scales: &[Vec3], gauge_scale: f32, widest: [f32; 2]) -> SliderLimits {
    let room = 1.0 - f64::from(LEAST_SCALE);
    let mut min = f64::from(widest[0].max(BLENDER_RANGE[0]));
    let mut max = f64::from(widest[1].min(BLENDER_RANGE[1]));
    for scale in scales.iter().flat_map(Vec3::to_array) {
        let change = f64::from(gauge_scale) * f64::from(scale) - 1.0;
        if change > 0.0 {
            min = min.max(-room / change);
        } else if change < 0.0 {
            max = max.min(-room / change);
        }
    }
    SliderLimits { min: rounded_towards_zero(min.min(0.0)), max: rounded_towards_zero(max.max(1.0)) }
}

/// The positions at `alpha`: rest + α·(outcome − rest), as a relative shape key mixes them.
///
/// # Panics
/// If `rest` and `outcome` differ in length.
#[must_use]
pub fn positions_at(rest: &[Vec3], outcome: &[Vec3], alpha: f32) -> Vec<Vec3> {
    assert_eq!(rest.len(), outcome.len(), "one outcome position per rest position");
    rest.iter().zip(outcome).map(|(&from, &to)| from + alpha * (to - from)).collect()
}

/// The nearest `f32` that is no farther from zero.
fn rounded_towards_zero(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest).abs() <= value.abs() {
        nearest
    } else if nearest > 0.0 {
        nearest.next_down()
    } else {
        nearest.next_up()
    }
}
