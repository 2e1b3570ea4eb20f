// SPDX-License-Identifier: MIT OR Apache-2.0
//! Turn of the vertex normals.

use glam::Vec3;

use super::{MetricsError, check};
use crate::mesh::Mesh;

/// Mean over the vertices of 1 − cos between old and new vertex normal. `vertices` (n) are the new positions.
///
/// A vertex that has lost its normal (all its triangles without area) counts as 1; one that had none to
/// begin with is left out.
pub fn normal_error(mesh: &Mesh, vertices: &[Vec3]) -> Result<f64, MetricsError> {
    check(mesh, vertices)?;
    let (old, new) = (mesh.vertex_normals(mesh.vertices()), mesh.vertex_normals(vertices));
    let (mut sum, mut count) = (0.0, 0_u32);
    for (old, new) in old.iter().zip(&new).filter(|(old, _)| old.is_finite()) {
        let cosine = if new.is_finite() { f64::from(old.dot(*new)) } else { 0.0 };
        sum += 1.0 - cosine;
        count += 1;
    }
    Ok(sum / f64::from(count.max(1)))
}
