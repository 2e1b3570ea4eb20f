// SPDX-License-Identifier: MIT OR Apache-2.0
//! Meshes made for tests. Units are arbitrary, z is up.
#![allow(dead_code, reason = "each test binary uses some of these")]

pub mod check;

use boxmorph::mesh::Mesh;
use glam::Vec3;

/// Vertices and triangles that grow together.
#[derive(Default, Clone)]
pub struct Maker {
    pub vertices: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Maker {
    pub fn mesh(self) -> Mesh {
        Mesh::new(self.vertices, self.triangles).expect("a made mesh is valid")
    }

    /// A grid of (u + 1) × (v + 1) vertices, `u × v` quads, on the parallelogram at `origin`.
    pub fn patch(&mut self, origin: Vec3, a: Vec3, b: Vec3, (u, v): (u32, u32)) -> &mut Self {
        let first = self.vertices.len() as u32;
        for j in 0..=v {
            for i in 0..=u {
                self.vertices.push(origin + a * (i as f32 / u as f32) + b * (j as f32 / v as f32));
            }
        }
        for j in 0..v {
            for i in 0..u {
                let at = first + j * (u + 1) + i;
                self.triangles.push([at, at + 1, at + u + 2]);
                self.triangles.push([at, at + u + 2, at + u + 1]);
            }
        }
        self
    }

    /// A closed box of `n` × `n` quads a side, its six sides joined at the edges.
    pub fn cuboid(&mut self, low: Vec3, high: Vec3, n: u32) -> &mut Self {
        let mut side = Maker::default();
        let e = high - low;
        let (x, y, z) = (Vec3::X * e.x, Vec3::Y * e.y, Vec3::Z * e.z);
        for (origin, a, b) in
            [(low, y, x), (low, x, z), (low, z, y), (low + z, x, y), (low + y, z, x), (low + x, y, z)]
        {
            side.patch(origin, a, b, (n, n));
        }
        self.join(side)
    }

    /// Adds a piece whose vertices in one place are merged.
    ///
    /// Coordinates are rounded to a fine binary grid, so that mirror images are exact.
    pub fn join(&mut self, piece: Maker) -> &mut Self {
        let first = self.vertices.len();
        let mut index = Vec::new();
        for v in piece.vertices {
            let v = (v * 16384.0).round() / 16384.0;
            let tolerance = 1e-5 * (1.0 + v.length());
            let found = self.vertices[first..].iter().position(|w| w.distance(v) < tolerance);
            let at = found.map_or(self.vertices.len(), |i| first + i);
            if found.is_none() {
                self.vertices.push(v);
            }
            index.push(at as u32);
        }
        let merged = piece.triangles.iter().map(|t| t.map(|i| index[i as usize]));
        self.triangles.extend(merged.filter(|&[a, b, c]| a != b && b != c && c != a));
        self
    }

    /// A sphere of rings and segments.
    pub fn sphere(&mut self, center: Vec3, radius: f32, rings: u32) -> &mut Self {
        self.lathe(center, rings * 2, &half_circle(radius, rings))
    }

    /// A closed surface of revolution about z: (radius, height) pairs; ends on the axis have radius 0.
    pub fn lathe(&mut self, center: Vec3, segments: u32, profile: &[(f32, f32)]) -> &mut Self {
        let mut piece = Maker::default();
        let rings = profile.len() as u32;
        for &(radius, height) in profile {
            for s in 0..segments {
                let turn = s as f32 / segments as f32 * std::f32::consts::TAU;
                let (sin, cos) = turn.sin_cos();
                piece.vertices.push(center + Vec3::new(radius * cos, radius * sin, height));
            }
        }
        for r in 0..rings - 1 {
            for s in 0..segments {
                let at = |ring: u32, k: u32| ring * segments + k % segments;
                let (a, b, c, d) = (at(r, s), at(r, s + 1), at(r + 1, s + 1), at(r + 1, s));
                piece.triangles.push([a, b, c]);
                piece.triangles.push([a, c, d]);
            }
        }
        self.join(piece)
    }

    /// Everything on the far side of the plane across `axis` through the origin as well.
    pub fn mirrored(mut self, axis: usize) -> Self {
        let count = self.vertices.len() as u32;
        let images: Vec<Vec3> = self
            .vertices
            .iter()
            .map(|&v| {
                let mut v = v;
                v[axis] = -v[axis];
                v
            })
            .collect();
        self.vertices.extend(images);
        let flipped: Vec<[u32; 3]> =
            self.triangles.iter().map(|&[a, b, c]| [a + count, c + count, b + count]).collect();
        self.triangles.extend(flipped);
        self
    }

    pub fn moved(mut self, by: impl Fn(Vec3) -> Vec3) -> Self {
        self.vertices.iter_mut().for_each(|v| *v = by(*v));
        self
    }
}

fn half_circle(radius: f32, rings: u32) -> Vec<(f32, f32)> {
    (0..=rings)
        .map(|r| {
            let turn = r as f32 / rings as f32 * std::f32::consts::PI;
            (if r == 0 || r == rings { 0.0 } else { radius * turn.sin() }, -radius * turn.cos())
        })
        .collect()
}

pub fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A plain box, 2 × 1 × 0.5.
pub fn plain_box() -> Mesh {
    let mut m = Maker::default();
    m.cuboid(v(-1.0, -0.5, 0.0), v(1.0, 0.5, 0.5), 8);
    m.mesh()
}

/// A ball.
pub fn ball() -> Mesh {
    let mut m = Maker::default();
    m.sphere(Vec3::ZERO, 1.0, 24);
    m.mesh()
}

/// A cone, point up.
pub fn cone() -> Mesh {
    let mut m = Maker::default();
    let profile: Vec<(f32, f32)> = std::iter::once((0.0, 0.0))
        .chain((0..=20).map(|i| (0.5 - i as f32 * 0.025, i as f32 * 0.1)))
        .collect();
    m.lathe(Vec3::ZERO, 32, &profile);
    m.mesh()
}

/// A chair of islands as an artist leaves it: a seat, a back, four legs; `n` quads along each side.
pub fn chair(n: u32) -> Maker {
    let mut half = Maker::default();
    for y in [-0.4, 0.32] {
        half.cuboid(v(0.32, y, 0.0), v(0.4, y + 0.08, 0.9), n);
    }
    let mut m = half.mirrored(0);
    m.cuboid(v(-0.42, -0.42, 0.88), v(0.42, 0.42, 0.98), n * 2);
    m.cuboid(v(-0.42, 0.34, 0.98), v(0.42, 0.42, 1.9), n * 2);
    m
}

/// A table: a top and four legs, all islands.
pub fn table(n: u32) -> Maker {
    let mut quarter = Maker::default();
    quarter.cuboid(v(0.8, 0.4, 0.0), v(0.9, 0.5, 0.7), n);
    let mut m = quarter.mirrored(0).mirrored(1);
    m.cuboid(v(-1.0, -0.6, 0.7), v(1.0, 0.6, 0.78), n * 3);
    m
}

/// An aeroplane: a body along y, two wings, two tail wings, a fin.
pub fn aeroplane() -> Maker {
    let mut half = Maker::default();
    half.cuboid(v(0.1, -0.2, -0.02), v(1.2, 0.2, 0.02), 6);
    half.cuboid(v(0.1, 0.8, 0.05), v(0.4, 0.95, 0.08), 4);
    let mut m = half.mirrored(0);
    m.cuboid(v(-0.12, -1.0, -0.12), v(0.12, 1.0, 0.12), 12);
    m.cuboid(v(-0.015, 0.8, 0.12), v(0.015, 1.0, 0.45), 4);
    m
}

/// An L of two boxes, symmetric about no axis.
pub fn lopsided() -> Maker {
    let mut m = Maker::default();
    m.cuboid(v(0.0, 0.0, 0.0), v(2.0, 0.4, 0.3), 6);
    m.cuboid(v(0.0, 0.1, 0.3), v(0.3, 0.9, 1.8), 6);
    m
}

/// A desk lamp: a base with its stem, and a shade that is open above and below.
pub fn lamp() -> Mesh {
    let mut m = Maker::default();
    let foot = [(0.0, 0.0), (0.25, 0.0), (0.25, 0.04), (0.03, 0.06), (0.03, 0.4), (0.03, 0.9)];
    m.lathe(Vec3::ZERO, 32, &foot);
    m.lathe(Vec3::ZERO, 32, &[(0.3, 0.85), (0.25, 0.95), (0.2, 1.05), (0.15, 1.2)]);
    m.mesh()
}

/// A bottle with round shoulders.
pub fn bottle() -> Mesh {
    let mut m = Maker::default();
    let body = [(0.0, 0.0), (0.2, 0.0), (0.2, 0.1), (0.2, 0.3), (0.2, 0.5), (0.17, 0.56), (0.1, 0.62)];
    let neck = [(0.05, 0.66), (0.05, 0.75), (0.05, 0.85), (0.0, 0.85)];
    m.lathe(Vec3::ZERO, 32, &[&body[..], &neck[..]].concat());
    m.mesh()
}

/// A sofa on short feet.
pub fn sofa() -> Mesh {
    let mut half = Maker::default();
    half.cuboid(v(0.95, -0.4, 0.1), v(1.15, 0.4, 0.7), 3);
    for y in [-0.35, 0.25] {
        half.cuboid(v(0.8, y, 0.0), v(0.9, y + 0.1, 0.12), 1);
    }
    let mut m = half.mirrored(0);
    m.cuboid(v(-1.0, -0.4, 0.1), v(1.0, 0.4, 0.45), 4);
    m.cuboid(v(-1.0, 0.25, 0.45), v(1.0, 0.45, 0.95), 4);
    m.mesh()
}
