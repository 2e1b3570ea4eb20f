// SPDX-License-Identifier: MIT OR Apache-2.0
//! Where nasty meshes lie, and how large they are: up to the limits of what a mesh may be.

use glam::{Quat, Vec3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::{Step, spread};
use crate::common::Maker;

pub const PLACES: &[Step] = &[
    ("in another unit", another_unit),
    ("at the limits of size", limits),
    ("squashed", squashed),
    ("flat", flat),
    ("long", long),
    ("turned", turned),
    ("turned by 45 degrees", |_, m| {
        moved(m, |p| Quat::from_rotation_z(std::f32::consts::FRAC_PI_4) * p);
    }),
    ("far from its origin", far),
    ("with y for z", |_, m| moved(m, |p| Vec3::new(p.x, -p.z, p.y))),
];

fn moved(m: &mut Maker, by: impl Fn(Vec3) -> Vec3) {
    *m = std::mem::take(m).moved(by);
}

fn another_unit(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let unit = 10.0_f32.powf(rng.random_range(-6.0..6.0));
    moved(m, |p| p * unit);
}

/// The farthest coordinate that a mesh may have, or sizes that single precision can hardly tell from none.
fn limits(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let reach = m.vertices.iter().fold(f32::MIN_POSITIVE, |far, p| far.max(p.abs().max_element()));
    let size = [1e15, 1e-20, 1e-36, 1e-42][rng.random_range(0..4)];
    moved(m, |p| (p / reach) * size);
}

fn squashed(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let scale = Vec3::from_array(std::array::from_fn(|_| 10.0_f32.powf(rng.random_range(-7.0..0.0))));
    moved(m, |p| p * scale);
}

fn flat(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let axis = rng.random_range(0..3);
    m.vertices.iter_mut().for_each(|p| p[axis] = 0.0);
}

fn long(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let axis = rng.random_range(0..3);
    let scale = 10.0_f32.powf(rng.random_range(1.0..5.0));
    m.vertices.iter_mut().for_each(|p| p[axis] *= scale);
}

fn turned(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let turn = Quat::from_scaled_axis(spread(rng, 2.0));
    moved(m, |p| turn * p);
}

/// So far that coordinates are rounded to a coarse grid.
fn far(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let size = 10.0_f32.powf(rng.random_range(0.0..7.0));
    let offset = spread(rng, size);
    moved(m, |p| p + offset);
}
