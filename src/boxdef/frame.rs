// SPDX-License-Identifier: MIT OR Apache-2.0
//! The normalised frame in which parts are found and distances are weighed.

use glam::{DVec3, Vec3};

use crate::mesh::Mesh;

/// Edge length of an occupancy cell in units of the frame: the authors' grid.
pub(crate) const CELL: f64 = 0.01;

/// Maps object coordinates to a frame whose origin is a centre and whose unit is the farthest vertex from
/// it, so that nothing that follows depends on the object's place or unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub(crate) center: DVec3,
    pub(crate) unit: f64,
}

impl Frame {
    /// Centre of the surface's bounding box, and the farthest vertex of the surface: does not change with
    /// the tessellation, and ignores stray vertices.
    pub(crate) fn of_surface(mesh: &Mesh) -> Self {
        let (low, high) = mesh.surface_bounds();
        let used = mesh.triangles().iter().flatten().map(|&i| mesh.vertices()[i as usize]);
        Self::about((low + high) * 0.5, used)
    }

    /// Mean of all vertices, and the farthest vertex: the authors' choice.
    pub(crate) fn of_vertices(mesh: &Mesh) -> Self {
        let sum: DVec3 = mesh.vertices().iter().map(|v| v.as_dvec3()).sum();
        Self::about(sum / mesh.vertices().len() as f64, mesh.vertices().iter().copied())
    }

    fn about(center: DVec3, points: impl Iterator<Item = Vec3>) -> Self {
        let farthest = points.map(|p| p.as_dvec3().distance_squared(center)).fold(0.0, f64::max);
        Self { center, unit: farthest.sqrt() }
    }

    /// Object coordinates to the frame.
    pub(crate) fn to_frame(self, point: Vec3) -> DVec3 {
        (point.as_dvec3() - self.center) / self.unit
    }

    /// The frame to object coordinates.
    pub(crate) fn to_object(self, point: DVec3) -> Vec3 {
        (point * self.unit + self.center).as_vec3()
    }

    /// All of a mesh's vertices in the frame.
    pub(crate) fn vertices(self, mesh: &Mesh) -> Vec<DVec3> {
        mesh.vertices().iter().map(|&v| self.to_frame(v)).collect()
    }
}
