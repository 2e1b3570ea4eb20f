// SPDX-License-Identifier: MIT OR Apache-2.0
//! Shapes made for the rendering tests: positions and triangles, z up.
#![allow(dead_code, reason = "each test binary uses some of them")]

use boxmorph::boxdef::DeformField;
use glam::Vec3;
use std::f32::consts::{PI, TAU};

pub type Shape = (Vec<Vec3>, Vec<[u32; 3]>);

/// A box from `centre − half` to `centre + half`, wound outwards.
pub fn cuboid(centre: Vec3, half: Vec3) -> Shape {
    let corner = |i: u32| {
        let sign = |bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        centre + half * Vec3::new(sign(0), sign(1), sign(2))
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    ((0..8).map(corner).collect(), faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

/// The square −1 to 1 in x and y at z = 0, of `n` vertices a side.
pub fn grid(n: u32) -> Shape {
    let at = |i: u32| 2.0 * i as f32 / (n - 1) as f32 - 1.0;
    let positions = (0..n * n).map(|i| Vec3::new(at(i % n), at(i / n), 0.0)).collect();
    (positions, cells(n, n))
}

/// A sphere of radius 1, of `n` rings.
pub fn sphere(n: u32) -> Shape {
    ball(n, |_| 1.0)
}

/// A ball with bumps, to which no axis is special.
pub fn bumpy_ball(n: u32) -> Shape {
    ball(n, |d| 1.0 + 0.3 * (5.0 * d.x + 1.0).sin() * (4.0 * d.y).cos() + 0.2 * (6.0 * d.z + d.x).sin())
}

fn ball(n: u32, radius: impl Fn(Vec3) -> f32) -> Shape {
    let around = 2 * n;
    let point = |i: u32| {
        let (polar, turn) = ((i / around) as f32 / (n - 1) as f32 * PI, (i % around) as f32);
        let (sin, cos) = (turn / (around - 1) as f32 * TAU).sin_cos();
        let direction = Vec3::new(polar.sin() * cos, polar.sin() * sin, polar.cos());
        direction * radius(direction)
    };
    ((0..n * around).map(point).collect(), cells(around, n))
}

/// The triangles of a grid of vertices.
fn cells(columns: u32, rows: u32) -> Vec<[u32; 3]> {
    (0..rows - 1)
        .flat_map(|y| (0..columns - 1).map(move |x| y * columns + x))
        .flat_map(|a| [[a, a + columns, a + 1], [a + 1, a + columns, a + columns + 1]])
        .collect()
}

/// Several shapes as one.
pub fn joined(shapes: &[Shape]) -> Shape {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (more, faces) in shapes {
        let first = positions.len() as u32;
        positions.extend(more);
        triangles.extend(faces.iter().map(|face| face.map(|i| i + first)));
    }
    (positions, triangles)
}

/// A field whose parameter rows each scale a wavy share of the shape.
pub fn wavy_field(positions: Vec<Vec3>, parameter_rows: usize) -> DeformField {
    let basis = (0..3)
        .flat_map(|axis| (0..parameter_rows).map(move |row| (axis, row)))
        .flat_map(|(axis, row)| {
            positions.iter().map(move |p| p[axis] * 0.5 * (1.0 + (3.0 * p.x + row as f32).sin()))
        })
        .collect();
    DeformField::new(positions, parameter_rows, basis)
}
