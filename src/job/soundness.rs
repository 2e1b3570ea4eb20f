// SPDX-License-Identifier: MIT OR Apache-2.0
//! Whether an outcome holds together: it may hardly cross itself more than the mesh did.

use std::cell::OnceCell;

use glam::Vec3;

use crate::mesh::Mesh;
use crate::metrics::self_intersection_ratio;

/// Triangles up to which it is asked; of more, where no light proxy could be made, it would take longer than the
/// search.
const MEASURED: usize = 200_000;

/// What outcomes of a mesh, or of the proxy that is scored, are held to.
pub struct Soundness<'a> {
    mesh: &'a Mesh,
    /// Share of the triangles that may cross others, over those of the mesh; `None` asks nothing.
    more: Option<f64>,
    before: OnceCell<f64>,
}

impl<'a> Soundness<'a> {
    pub fn new(mesh: &'a Mesh, more: Option<f64>) -> Self {
        let more = more.filter(|_| mesh.triangles().len() <= MEASURED);
        Self { mesh, more, before: OnceCell::new() }
    }

    /// Whether the mesh is sound with its vertices at `positions` (n).
    pub fn holds(&self, positions: &[Vec3]) -> bool {
        // Positions that cannot be measured are not sound.
        let ratio = |positions| self_intersection_ratio(self.mesh, positions).unwrap_or(f64::INFINITY);
        let before = || *self.before.get_or_init(|| ratio(self.mesh.vertices()));
        self.more.is_none_or(|more| ratio(positions) <= before() + more)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles, one above the other.
    fn sheets() -> Mesh {
        let at = |z: f32| [Vec3::new(0.0, 0.0, z), Vec3::new(1.0, 0.0, z), Vec3::new(0.0, 1.0, z)];
        Mesh::new([at(0.0), at(1.0)].concat(), vec![[0, 1, 2], [3, 4, 5]]).expect("two triangles are a mesh")
    }

    /// The upper one pushed through the lower one by a corner.
    fn crossed() -> Vec<Vec3> {
        let mut positions = sheets().vertices().to_vec();
        positions[3] = Vec3::new(0.2, 0.2, -1.0);
        positions
    }

    #[test]
    fn what_crosses_itself_is_not_sound() {
        let mesh = sheets();
        let soundness = Soundness::new(&mesh, Some(0.015));
        assert!(soundness.holds(mesh.vertices()));
        assert!(!soundness.holds(&crossed()));
        assert!(Soundness::new(&mesh, None).holds(&crossed()), "where nothing is asked");
    }

    #[test]
    fn what_crossed_itself_before_may_do_so_after() {
        let mesh = Mesh::new(crossed(), sheets().triangles().to_vec()).expect("two triangles are a mesh");
        assert!(Soundness::new(&mesh, Some(0.015)).holds(mesh.vertices()));
    }
}
