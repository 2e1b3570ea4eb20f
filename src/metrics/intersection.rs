// SPDX-License-Identifier: MIT OR Apache-2.0
//! Self-intersecting triangles.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::overlaps::{Bounds, overlapping_pairs};
use super::triangles::{segment_meets_triangle, triangles_meet};
use super::{MetricsError, check};
use crate::mesh::Mesh;

/// Share of the triangles that meet another one which is not their neighbour, with the vertices at
/// `vertices` (n).
///
/// As `MeshLab` counts: triangles that share an edge never meet; of two that share one corner, the segment
/// half-way between that corner and the opposite edge of one must pass through the other; two triangles on
/// the same three vertices meet.
pub fn self_intersection_ratio(mesh: &Mesh, vertices: &[Vec3]) -> Result<f64, MetricsError> {
    check(mesh, vertices)?;
    let corners: Vec<[DVec3; 3]> =
        mesh.triangles().iter().map(|t| t.map(|i| vertices[i as usize].as_dvec3())).collect();
    let bounds: Vec<Bounds> =
        mesh.triangles().iter().map(|t| Bounds::of(t.map(|i| vertices[i as usize]))).collect();
    let meeting: Vec<(u32, u32)> = overlapping_pairs(&bounds)
        .into_par_iter()
        .filter(|&(a, b)| {
            let (a, b) = (a as usize, b as usize);
            meet(mesh.triangles()[a], corners[a], mesh.triangles()[b], corners[b])
        })
        .collect();
    let mut selected = vec![false; corners.len()];
    for (a, b) in meeting {
        selected[a as usize] = true;
        selected[b as usize] = true;
    }
    Ok(selected.iter().filter(|&&s| s).count() as f64 / selected.len() as f64)
}

fn meet(a: [u32; 3], p: [DVec3; 3], b: [u32; 3], q: [DVec3; 3]) -> bool {
    // A triangle with a corner twice is a line.
    if [a, b].iter().any(|t| t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        return false;
    }
    let shared: Vec<(usize, usize)> =
        (0..3).filter_map(|i| b.iter().position(|&v| v == a[i]).map(|j| (i, j))).collect();
    match shared[..] {
        [] => triangles_meet(p, q),
        [(i, j)] => segment_meets_triangle(halfway(p, i), q) || segment_meets_triangle(halfway(q, j), p),
        [_, _] => false,
        _ => true,
    }
}

/// The segment half-way between a corner and the opposite edge.
fn halfway(p: [DVec3; 3], corner: usize) -> [DVec3; 2] {
    [1, 2].map(|k| p[(corner + k) % 3].midpoint(p[corner]))
}
