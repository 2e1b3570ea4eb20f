// SPDX-License-Identifier: MIT OR Apache-2.0
//! Metrics on surfaces whose values are known. Agreement with the authors' tools is tested from Python.

#![expect(clippy::float_cmp, reason = "counts divided by counts, and zeros, are exact")]

mod common;

use std::f64::consts::PI;

use boxmorph::mesh::Mesh;
use boxmorph::metrics::{gaussian_curvature_change, normal_error, self_intersection_ratio};
use common::{Maker, ball, v};
use glam::{Quat, Vec3};

/// A box with a smaller one beside it, `gap` apart; below 0 it sticks in it. No edge lies on another.
fn two_boxes(gap: f32) -> Mesh {
    let mut m = Maker::default();
    m.cuboid(v(0.0, 0.0, 0.0), v(1.0, 1.0, 1.0), 2);
    m.cuboid(v(1.0 + gap, 0.23, 0.31), v(2.0 + gap, 0.71, 0.84), 2);
    m.mesh()
}

#[test]
fn nothing_changed_is_zero() {
    let mesh = ball();
    assert_eq!(gaussian_curvature_change(&mesh, mesh.vertices()).unwrap(), 0.0);
    assert!(normal_error(&mesh, mesh.vertices()).unwrap().abs() < 1e-7);
    assert_eq!(self_intersection_ratio(&mesh, mesh.vertices()).unwrap(), 0.0);
}

#[test]
fn curvature_and_intersections_ignore_scale_and_turn() {
    let mesh = two_boxes(-0.3);
    let turn = Quat::from_rotation_x(0.7) * Quat::from_rotation_z(0.3);
    let moved: Vec<Vec3> = mesh.vertices().iter().map(|&p| turn * p * 30.0 + v(5.0, 6.0, 7.0)).collect();
    assert!(gaussian_curvature_change(&mesh, &moved).unwrap() < 1e-5);
    let ratio = self_intersection_ratio(&mesh, mesh.vertices()).unwrap();
    assert!(ratio > 0.0);
    assert_eq!(self_intersection_ratio(&mesh, &moved).unwrap(), ratio);
}

#[test]
fn a_pyramid_flattened_loses_its_curvature() {
    // Apex over a square: four right isosceles triangles would be flat.
    let mesh = Mesh::new(
        vec![v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0), v(-1.0, 0.0, 0.0), v(0.0, -1.0, 0.0), v(0.0, 0.0, 1.0)],
        vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    )
    .unwrap();
    let mut flat = mesh.vertices().to_vec();
    flat[4].z = 0.0;
    // Equilateral to right-angled: the apex goes from 2π − 4π/3 to 0; each corner from 2π − 2π/3 to 2π − π/2.
    let expected = (2.0 * PI / 3.0 + 4.0 * (PI / 6.0)) / 5.0;
    assert!((gaussian_curvature_change(&mesh, &flat).unwrap() - expected).abs() < 1e-6);
}

#[test]
fn normals_turned_by_an_angle_cost_its_cosine() {
    let mesh = ball();
    let turned: Vec<Vec3> = mesh.vertices().iter().map(|&p| Quat::from_rotation_y(PI as f32) * p).collect();
    // The normal of a ball is its position; turning by π about y flips x and z and keeps y.
    let cosines: f64 = mesh.vertices().iter().map(|p| f64::from(p.y * p.y - p.x * p.x - p.z * p.z)).sum();
    let expected = 1.0 - cosines / mesh.vertices().len() as f64;
    assert!((normal_error(&mesh, &turned).unwrap() - expected).abs() < 0.01);
    let lost = vec![Vec3::ZERO; mesh.vertices().len()];
    assert_eq!(normal_error(&mesh, &lost).unwrap(), 1.0, "a surface without area has lost every normal");
}

#[test]
fn boxes_pushed_into_each_other_intersect_and_apart_do_not() {
    let mesh = two_boxes(0.1);
    assert_eq!(self_intersection_ratio(&mesh, mesh.vertices()).unwrap(), 0.0);
    let pushed: Vec<Vec3> =
        mesh.vertices().iter().map(|&p| if p.x > 1.05 { p - v(0.4, 0.0, 0.0) } else { p }).collect();
    let ratio = self_intersection_ratio(&mesh, &pushed).unwrap();
    // The side that is pierced has 8 of 96 triangles, the sides that pierce it 4 half-sides of 4 each.
    assert!(ratio > 0.1 && ratio < 0.35, "{ratio}");
}

#[test]
fn crossing_touching_and_coplanar_triangles() {
    let pair = |b: [Vec3; 3]| {
        let a = [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)];
        let mesh = Mesh::new([a, b].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        self_intersection_ratio(&mesh, mesh.vertices()).unwrap()
    };
    assert_eq!(pair([v(0.2, 0.2, -1.0), v(0.2, 0.2, 1.0), v(3.0, 3.0, 0.0)]), 1.0, "pierced");
    assert_eq!(pair([v(0.2, 0.2, 0.1), v(0.2, 0.2, 1.0), v(3.0, 3.0, 0.1)]), 0.0, "above");
    assert_eq!(pair([v(0.6, 0.6, -1.0), v(0.6, 0.6, 1.0), v(3.0, 3.0, 0.0)]), 0.0, "beside");
    assert_eq!(pair([v(0.1, 0.1, 0.0), v(2.0, 0.1, 0.0), v(0.1, 2.0, 0.0)]), 1.0, "coplanar, overlapping");
    assert_eq!(pair([v(1.0, 1.0, 0.0), v(2.0, 1.0, 0.0), v(1.0, 2.0, 0.0)]), 0.0, "coplanar, apart");
}

#[test]
fn positions_of_another_mesh_are_refused() {
    let mesh = ball();
    let few = &mesh.vertices()[1..];
    for error in [
        gaussian_curvature_change(&mesh, few).unwrap_err(),
        normal_error(&mesh, few).unwrap_err(),
        self_intersection_ratio(&mesh, few).unwrap_err(),
    ] {
        assert!(error.to_string().contains("give one for each vertex"), "{error}");
    }
    let mut broken = mesh.vertices().to_vec();
    broken[3].y = f32::NAN;
    assert!(normal_error(&mesh, &broken).unwrap_err().to_string().contains("position 3"));
}
