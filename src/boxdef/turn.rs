// SPDX-License-Identifier: MIT OR Apache-2.0
//! Which way a shape faces: the turn about z that lays its own axes along x and y.
//!
//! Boxes are cut along axes. A chair that was modelled at an angle has neither parts nor symmetry along them,
//! so it is turned first. A shape that mirrors at some angle is taken to face that way: its plane of symmetry is
//! along a principal axis of its surface or, where those are undecided, along the smallest rectangle around it.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::{DMat2, DVec2, DVec3, Vec3};

use super::frame::Frame;
use super::islands::places;
use super::occupancy::Occupancy;
use super::symmetry::is_mirrored;
use crate::mesh::Mesh;

/// A smaller turn is not worth it, in radians.
const LEAST: f64 = 0.01;

/// A shape that mirrors as it is, is turned only if that makes the rectangle around it this much smaller.
const SMALLER: f64 = 0.75;

/// By how much principal moments must differ, as a share of their sum, to tell a direction.
const DECIDED: f64 = 0.01;

/// The angle about z, in radians from −π/4 to π/4, by which to turn a mesh (in object coordinates, z up) so
/// that its own axes lie along x and y; 0 where they do, and where it has none.
#[must_use]
pub fn own_turn(mesh: &Mesh) -> f64 {
    let points: Vec<DVec2> =
        mesh.triangles().iter().flatten().map(|&i| flat(mesh.vertices()[i as usize])).collect();
    let hull = convex_hull(points);
    let (rectangle, area) = smallest_rectangle(&hull);
    let worth = |turn: &f64| turn.abs() >= LEAST;
    let candidates: Vec<f64> =
        [principal_turn(mesh), Some(rectangle)].into_iter().flatten().filter(worth).collect();
    // What lies straight already, as most shapes do, is told at once.
    if candidates.is_empty() {
        return 0.0;
    }
    if mirrors(mesh, 0.0).contains(&true) {
        let smaller = worth(&rectangle) && area < SMALLER * area_at(&hull, 0.0);
        return if smaller && mirrors(mesh, rectangle) == [true; 2] { rectangle } else { 0.0 };
    }
    candidates.into_iter().find(|&turn| mirrors(mesh, turn).contains(&true)).unwrap_or(0.0)
}

/// A mesh's vertices turned about z through the origin.
#[must_use]
pub fn turned(vertices: &[Vec3], turn: f64) -> Vec<Vec3> {
    let rotation = DMat2::from_angle(turn);
    let turned = |v: &Vec3| (rotation * flat(*v)).extend(f64::from(v.z)).as_vec3();
    vertices.iter().map(turned).collect()
}

fn flat(v: Vec3) -> DVec2 {
    v.as_dvec3().truncate()
}

/// Whether the mesh mirrors about x and about y once it is turned.
fn mirrors(mesh: &Mesh, turn: f64) -> [bool; 2] {
    let Ok(mesh) = Mesh::new(turned(mesh.vertices(), turn), mesh.triangles().to_vec()) else {
        return [false; 2];
    };
    let frame = Frame::of_surface(&mesh);
    let vertices = frame.vertices(&mesh);
    let occupancy = Occupancy::of(&mesh, frame, &vertices, &places(&vertices));
    [0, 1].map(|axis| is_mirrored(&occupancy, axis))
}

/// The turn that lays the principal axes of the surface along x and y; none where there is no direction.
fn principal_turn(mesh: &Mesh) -> Option<f64> {
    let (mut area, mut sum, mut squares) = (0.0, DVec2::ZERO, [0.0; 3]);
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|i| mesh.vertices()[i as usize].as_dvec3());
        let weight = (b - a).cross(c - a).length();
        // Exact for what is linear and quadratic: the corners' midpoints, each a third.
        for p in [a.midpoint(b), b.midpoint(c), c.midpoint(a)].map(DVec3::truncate) {
            area += weight;
            sum += weight * p;
            squares[0] += weight * p.x * p.x;
            squares[1] += weight * p.x * p.y;
            squares[2] += weight * p.y * p.y;
        }
    }
    let mean = sum / area;
    let [xx, xy, yy] = [
        squares[0] / area - mean.x * mean.x,
        squares[1] / area - mean.x * mean.y,
        squares[2] / area - mean.y * mean.y,
    ];
    let apart = (2.0 * xy).hypot(xx - yy);
    (apart > DECIDED * (xx + yy)).then(|| quarter(-0.5 * (2.0 * xy).atan2(xx - yy)))
}

/// The same direction of axes, from −π/4 to π/4.
fn quarter(turn: f64) -> f64 {
    let turn = turn.rem_euclid(FRAC_PI_2);
    if turn > FRAC_PI_4 { turn - FRAC_PI_2 } else { turn }
}

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
fn convex_hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut hull: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = hull[..]
                && (b - a).perp_dot(point - b) <= 0.0
            {
                hull.pop();
            }
            hull.push(point);
        }
        hull.pop();
        hull
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    hull
}

/// The turn that makes the rectangle around a hull smallest, and its area: one side lies along an edge.
fn smallest_rectangle(hull: &[DVec2]) -> (f64, f64) {
    let mut best = (0.0, area_at(hull, 0.0));
    for (i, &corner) in hull.iter().enumerate() {
        let edge = hull[(i + 1) % hull.len()] - corner;
        let turn = quarter(-edge.to_angle());
        let area = area_at(hull, turn);
        if area < best.1 * (1.0 - 1e-9) {
            best = (turn, area);
        }
    }
    best
}

/// Area of the rectangle along x and y around a hull once it is turned.
fn area_at(hull: &[DVec2], turn: f64) -> f64 {
    let rotation = DMat2::from_angle(turn);
    let (low, high) = hull
        .iter()
        .map(|&p| rotation * p)
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    (high - low).element_product()
}
