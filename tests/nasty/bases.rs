// SPDX-License-Identifier: MIT OR Apache-2.0
//! What nasty meshes are made of: sound shapes a few units large, and some that never were.

use std::f32::consts::TAU;

use glam::{Quat, Vec3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::{Step, spread};
use crate::common::{Maker, aeroplane, chair, lopsided, table, v};

pub const BASES: &[Step] = &[
    ("chair", |rng, m| place(rng, m, chair(1))),
    ("table", |rng, m| place(rng, m, table(1))),
    ("aeroplane", |rng, m| place(rng, m, aeroplane())),
    ("L", |rng, m| place(rng, m, lopsided())),
    ("box on legs", box_on_legs),
    ("lathe", lathe),
    ("bent sheet", bent_sheet),
    ("crossed sheets", crossed_sheets),
    ("tube", tube),
    ("soup", soup),
    ("islands", islands),
    ("chain", chain),
    ("plate with holes", plate_with_holes),
    ("shelf", shelf),
    ("box in a box", box_in_a_box),
    ("dense blob", dense_blob),
    ("one triangle", one_triangle),
];

/// Adds a piece somewhere, in some size.
fn place(rng: &mut ChaCha8Rng, m: &mut Maker, piece: Maker) {
    let (at, size) = (spread(rng, 1.0), rng.random_range(0.3..1.5));
    append(m, piece.moved(|p| p * size + at));
}

pub fn append(m: &mut Maker, piece: Maker) {
    let first = m.vertices.len() as u32;
    m.vertices.extend(piece.vertices);
    m.triangles.extend(piece.triangles.iter().map(|t| t.map(|i| i + first)));
}

/// A grid of (columns + 1) × (rows + 1) vertices bent by `at(u, v)`; its rims are not joined.
fn bent(m: &mut Maker, (columns, rows): (u32, u32), at: impl Fn(f32, f32) -> Vec3) {
    let mut sheet = Maker::default();
    sheet.patch(Vec3::ZERO, Vec3::X, Vec3::Y, (columns, rows));
    append(m, sheet.moved(|p| at(p.x, p.y)));
}

fn extent(rng: &mut ChaCha8Rng) -> Vec3 {
    spread(rng, 1.0).abs() + 0.01
}

/// Legs that end below the top, in it, or above it; some are missing.
fn box_on_legs(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let half = extent(rng);
    let at = spread(rng, 0.5);
    m.cuboid(at - half * v(1.0, 1.0, 0.1), at + half * v(1.0, 1.0, 0.1), rng.random_range(1..4));
    let (thick, gap) = (rng.random_range(0.005..0.1), rng.random_range(-0.1..0.1));
    for (x, y) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
        if rng.random_bool(0.9) {
            let top = at + half * v(0.9 * x, 0.9 * y, -0.1) - Vec3::Z * gap;
            m.cuboid(top - v(thick, thick, 1.0), top + v(thick, thick, 0.0), 1);
        }
    }
}

/// A surface of revolution, open or closed, and possibly passing through itself.
fn lathe(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let mut profile: Vec<(f32, f32)> = (0..rng.random_range(2..8))
        .map(|i| (rng.random_range(0.0..0.6), 0.3 * i as f32 + rng.random_range(-0.2..0.2)))
        .collect();
    if rng.random_bool(0.5) {
        profile[0].0 = 0.0;
    }
    m.lathe(spread(rng, 1.0), rng.random_range(3..24), &profile);
}

fn bent_sheet(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (a, b, wave) = (spread(rng, 1.5), spread(rng, 1.5), spread(rng, 0.3));
    let (at, turns) = (spread(rng, 1.0), rng.random_range(0.0..9.0));
    let counts = (rng.random_range(1..30), rng.random_range(1..6));
    bent(m, counts, |s, t| at + a * s + b * t + wave * (turns * s).sin());
}

/// Three sheets or more on one edge.
fn crossed_sheets(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (low, high) = (spread(rng, 1.0), spread(rng, 1.0));
    let first = m.vertices.len() as u32;
    m.vertices.extend([low, high]);
    for _ in 0..rng.random_range(3..6) {
        let side = m.vertices.len() as u32;
        m.vertices.push(low.lerp(high, 0.5) + spread(rng, 1.0));
        m.triangles.push([first, first + 1, side]);
    }
}

/// A pipe that winds, open at both ends, its seam not welded.
fn tube(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (at, reach, rise) = (spread(rng, 1.0), rng.random_range(0.1..1.0), rng.random_range(0.0..1.5));
    let (thick, turns) = (rng.random_range(0.002..0.15), rng.random_range(0.1..3.0));
    bent(m, (rng.random_range(3..10), rng.random_range(5..80)), |s, t| {
        let outwards = Quat::from_rotation_z(turns * TAU * t) * Vec3::X;
        let (sin, cos) = (TAU * s).sin_cos();
        at + outwards * (reach + thick * cos) + Vec3::Z * (rise * t + thick * sin)
    });
}

/// Triangles between random corners, some of them with a corner twice.
fn soup(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (first, at) = (m.vertices.len() as u32, spread(rng, 1.0));
    let count = rng.random_range(3..60);
    m.vertices.extend((0..count).map(|_| at + spread(rng, 0.7)));
    let triangles = rng.random_range(1..200);
    m.triangles.extend((0..triangles).map(|_| [0; 3].map(|_| first + rng.random_range(0..count))));
}

/// Dozens of loose boxes.
fn islands(rng: &mut ChaCha8Rng, m: &mut Maker) {
    for _ in 0..rng.random_range(12..90) {
        let (at, half) = (spread(rng, 1.5), extent(rng) * 0.2);
        m.cuboid(at - half, at + half, 1);
    }
}

/// Boxes in a row that touch, overlap or leave a gap.
fn chain(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (mut at, axis) = (spread(rng, 1.0), rng.random_range(0..3));
    for _ in 0..rng.random_range(2..15) {
        let half = extent(rng) * 0.3;
        at[axis] += half[axis];
        m.cuboid(at - half, at + half, rng.random_range(1..3));
        at[axis] += half[axis] + [0.0, -0.05, 0.03][rng.random_range(0..3)];
    }
}

/// A plate as an n-gon with holes is cut for drawing: long thin triangles from rim to rim.
fn plate_with_holes(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (at, holes) = (spread(rng, 1.0), rng.random_range(1..5));
    let thick = if rng.random_bool(0.5) { 0.0 } else { rng.random_range(0.001..0.1) };
    for hole in 0..holes {
        let rim = rng.random_range(3..40);
        let middle = at + Vec3::X * hole as f32;
        let radius = rng.random_range(0.05..0.45);
        for z in [0.0, thick] {
            bent(m, (4 * rim, 1), |s, t| {
                let (sin, cos) = (TAU * s).sin_cos();
                let square = 0.5 / sin.abs().max(cos.abs());
                middle + v(cos, sin, 0.0) * (radius + (square - radius) * t) + Vec3::Z * z
            });
        }
    }
}

/// Boards of no thickness, or nearly none.
fn shelf(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (at, size) = (spread(rng, 1.0), extent(rng) * 2.0);
    for z in 0..rng.random_range(3..9) {
        let low = at + Vec3::Z * 0.3 * z as f32;
        if rng.random_bool(0.5) {
            m.patch(low, Vec3::X * size.x, Vec3::Y * size.y, (1, 1));
        } else {
            m.cuboid(low, low + v(size.x, size.y, 1e-4), 1);
        }
    }
    for x in [0.0, size.x] {
        m.patch(at + Vec3::X * x, Vec3::Y * size.y, Vec3::Z * size.z, (1, 2));
    }
}

fn box_in_a_box(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let (at, half) = (spread(rng, 1.0), extent(rng));
    for share in [1.0, rng.random_range(0.05..0.999), rng.random_range(0.05..0.999)] {
        m.cuboid(at - half * share, at + half * share, 1);
    }
}

/// Some thousands to tens of thousands of triangles, pinched at its poles, its seam not welded.
fn dense_blob(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let n = if rng.random_bool(0.3) { rng.random_range(100..160) } else { rng.random_range(10..40) };
    let (at, half, dent) = (spread(rng, 1.0), extent(rng), rng.random_range(0.0..0.5));
    bent(m, (n, n), |s, t| {
        let ((sin, cos), (ring, height)) = ((TAU * s).sin_cos(), (0.5 * TAU * t).sin_cos());
        at + half * v(ring * cos, ring * sin, height) * (1.0 + dent * (17.0 * s).sin() * (11.0 * t).cos())
    });
}

fn one_triangle(rng: &mut ChaCha8Rng, m: &mut Maker) {
    let first = m.vertices.len() as u32;
    m.vertices.extend((0..3).map(|_| spread(rng, 1.0)));
    m.triangles.push([first, first + 1, first + 2]);
}
