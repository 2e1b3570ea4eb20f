// SPDX-License-Identifier: MIT OR Apache-2.0
//! A mesh as its parts are found in it: what any number of splits starts from.

use glam::DVec3;

use super::frame::Frame;
use super::islands::{islands, places};
use super::occupancy::Occupancy;
use super::symmetry::{MirrorMap, Symmetry, resolve};
use crate::mesh::Mesh;

/// A mesh in its frame, its filled cells, and its symmetry. Graphs of several split counts share it.
pub struct Ground<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(crate) frame: Frame,
    /// Vertices in the frame.
    pub(crate) vertices: Vec<DVec3>,
    /// Number of the loose part that each vertex belongs to.
    pub(crate) islands: Vec<u32>,
    /// The symmetry found or asked for; never `Auto`.
    pub(crate) symmetry: Symmetry,
    /// The vertices' mirror images about each of its axes.
    pub(crate) mirrors: Vec<MirrorMap>,
    pub(crate) occupancy: Occupancy,
}

impl<'a> Ground<'a> {
    /// Fills the cells of a mesh, and looks for its symmetry if that is `Auto`.
    #[must_use]
    pub fn of(mesh: &'a Mesh, symmetry: Symmetry) -> Self {
        let frame = Frame::of_surface(mesh);
        let vertices = frame.vertices(mesh);
        let places = places(&vertices);
        let occupancy = Occupancy::of(mesh, frame, &vertices, &places);
        let symmetry = resolve(symmetry, &occupancy);
        let mirrors = symmetry.axes().iter().map(|&axis| MirrorMap::of(&vertices, axis)).collect();
        let islands = islands(mesh, &places);
        Self { mesh, frame, vertices, islands, symmetry, mirrors, occupancy }
    }
}
