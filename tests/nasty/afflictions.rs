// SPDX-License-Identifier: MIT OR Apache-2.0
//! What befalls meshes on their way through files, modifiers and hands.

use glam::{Quat, Vec3};
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;

use super::bases::append;
use super::{Step, spread};
use crate::common::Maker;

pub const AFFLICTIONS: &[Step] = &[
    ("faces dropped", faces_dropped),
    ("faces flipped", faces_flipped),
    ("faces doubled", faces_doubled),
    ("every face apart", every_face_apart),
    ("faces shuffled", |rng, m| m.triangles.shuffle(rng)),
    ("unused vertices", unused_vertices),
    ("a stray vertex far away", stray_vertex),
    ("fins on edges", fins),
    ("faces without area", faces_without_area),
    ("needles", needles),
    ("islands of one point", point_islands),
    ("vertices collapsed", vertices_collapsed),
    ("a shell within rounding of another", shell_again),
    ("a turned copy through it", turned_copy),
    ("jitter", jitter),
    ("mirrored about x", |_, m| *m = std::mem::take(m).mirrored(0)),
    ("mirrored about y", |_, m| *m = std::mem::take(m).mirrored(1)),
    ("mirrored about z", |_, m| *m = std::mem::take(m).mirrored(2)),
    ("mirrored with an overlap", mirrored_with_an_overlap),
    ("folded flat at the plane", |_, m| m.vertices.iter_mut().for_each(|p| p.x = p.x.max(0.0))),
    ("snapped to a coarse grid", |_, m| m.vertices.iter_mut().for_each(|p| *p = (*p * 4.0).round() * 0.25)),
];

fn any_vertex(rng: &mut ChaCha8Rng, m: &Maker) -> u32 {
    rng.random_range(0..m.vertices.len() as u32)
}

fn faces_dropped(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let share = rng.random_range(0.0..0.9);
    m.triangles.retain(|_| !rng.random_bool(share));
}

fn faces_flipped(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let share = rng.random_range(0.0..1.0);
    for triangle in &mut m.triangles {
        if rng.random_bool(share) {
            triangle.swap(0, 1);
        }
    }
}

fn faces_doubled(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let share = rng.random_range(0.0..1.0);
    let doubled: Vec<_> = m.triangles.iter().copied().filter(|_| rng.random_bool(share)).collect();
    m.triangles.extend(doubled);
}

/// Each triangle has corners of its own, as in an STL file.
fn every_face_apart(_: &mut ChaCha8Rng, m: &mut Maker) {
    m.vertices = m.triangles.iter().flatten().map(|&i| m.vertices[i as usize]).collect();
    m.triangles = (0..m.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
}

fn unused_vertices(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let count = rng.random_range(1..50);
    m.vertices.extend((0..count).map(|_| spread(rng, 3.0)));
}

fn stray_vertex(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let far = 10.0_f32.powf(rng.random_range(1.0..14.0));
    m.vertices.push(spread(rng, far));
}

/// A third face on some edges.
fn fins(rng: &mut ChaCha8Rng, m: &mut Maker) {
    for _ in 0..rng.random_range(1..10) {
        if m.triangles.is_empty() {
            return;
        }
        let [a, b, _] = m.triangles[rng.random_range(0..m.triangles.len())];
        let tip = m.vertices.len() as u32;
        m.vertices.push(m.vertices[a as usize] + spread(rng, 0.5));
        m.triangles.push([a, b, tip]);
    }
}

/// Twice or three times the same corner, or corners on one line.
fn faces_without_area(rng: &mut ChaCha8Rng, m: &mut Maker) {
    for _ in 0..rng.random_range(1..20) {
        if m.vertices.is_empty() {
            return;
        }
        let (a, b) = (any_vertex(rng, m), any_vertex(rng, m));
        let middle = m.vertices[a as usize].midpoint(m.vertices[b as usize]);
        m.vertices.push(middle);
        m.triangles.extend([[a, a, b], [a, a, a], [a, m.vertices.len() as u32 - 1, b]]);
    }
}

/// Faces as long as the object and as thin as rounding.
fn needles(rng: &mut ChaCha8Rng, m: &mut Maker) {
    for _ in 0..rng.random_range(1..10) {
        if m.vertices.is_empty() {
            return;
        }
        let (a, b) = (any_vertex(rng, m), any_vertex(rng, m));
        m.vertices.push(m.vertices[a as usize] + spread(rng, 1e-6));
        m.triangles.push([a, b, m.vertices.len() as u32 - 1]);
    }
}

/// Triangles of three vertices in one place.
fn point_islands(rng: &mut ChaCha8Rng, m: &mut Maker) {
    for _ in 0..rng.random_range(1..10) {
        let first = m.vertices.len() as u32;
        m.vertices.extend([spread(rng, 2.0); 3]);
        m.triangles.push([first, first + 1, first + 2]);
    }
}

fn vertices_collapsed(rng: &mut ChaCha8Rng, m: &mut Maker) {
    for _ in 0..m.vertices.len() / 10 {
        let (a, b) = (any_vertex(rng, m), any_vertex(rng, m));
        m.vertices[a as usize] = m.vertices[b as usize];
    }
}

/// The same surface again, in the very same place or a hair beside it.
fn shell_again(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let size = [1e-30, 1e-7, 1e-5][rng.random_range(0..3)];
    let beside = spread(rng, size);
    append(m, m.clone().moved(|p| p + beside));
}

fn turned_copy(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let turn = Quat::from_scaled_axis(spread(rng, 2.0));
    append(m, m.clone().moved(|p| turn * p));
}

fn jitter(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let size = 10.0_f32.powf(rng.random_range(-7.0..-0.5));
    m.vertices.iter_mut().for_each(|p| *p += spread(rng, size));
}

/// Halves that reach over the plane, or do not meet.
fn mirrored_with_an_overlap(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let reach = m.vertices.iter().fold(0.0_f32, |far, p| far.max(p.abs().max_element()));
    let apart = rng.random_range(-1.0..1.2) * reach;
    *m = std::mem::take(m).moved(|p| p + Vec3::X * apart).mirrored(0);
}
