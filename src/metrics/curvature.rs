// SPDX-License-Identifier: MIT OR Apache-2.0
//! Change of Gaussian curvature as raw angle deficit.

use std::f64::consts::TAU;

use glam::Vec3;

use super::{MetricsError, check};
use crate::mesh::Mesh;

/// Mean over the vertices of the absolute change of K, K = 2π − Σ of the angles of the triangles at a vertex, in
/// radians, not divided by an area. `vertices` (n) are the new positions. Does not depend on the scale.
pub fn gaussian_curvature_change(mesh: &Mesh, vertices: &[Vec3]) -> Result<f64, MetricsError> {
    check(mesh, vertices)?;
    let (old, new) = (angle_deficits(mesh, mesh.vertices()), angle_deficits(mesh, vertices));
    let change: f64 = old.iter().zip(&new).map(|(old, new)| (new - old).abs()).sum();
    Ok(change / old.len() as f64)
}

fn angle_deficits(mesh: &Mesh, positions: &[Vec3]) -> Vec<f64> {
    let mut deficits = vec![TAU; positions.len()];
    for triangle in mesh.triangles() {
        for corner in 0..3 {
            let [at, next, last] = [0, 1, 2].map(|k| triangle[(corner + k) % 3] as usize);
            let here = positions[at].as_dvec3();
            let (a, b) = (positions[next].as_dvec3() - here, positions[last].as_dvec3() - here);
            // Well conditioned for every angle, and 0 where an edge has no length.
            deficits[at] -= a.cross(b).length().atan2(a.dot(b));
        }
    }
    deficits
}
