// SPDX-License-Identifier: MIT OR Apache-2.0
//! `BoxDefGraph`: part boxes, the edges between them, and the field that follows from both (paper §3.1).

use std::sync::Arc;

use glam::{DVec3, Vec3};

use super::assign::assign;
use super::boundary::Boundary;
use super::boxes::{PartBox, keep_owners, part_boxes};
use super::connect::connect;
use super::error::BoxDefError;
use super::field::DeformField;
use super::frame::Frame;
use super::given::given_boxes;
use super::islands::{islands, places};
use super::occupancy::Occupancy;
use super::parts::{Parts, check_boxes};
use super::propagate::Propagation;
use super::split::split;
use super::symmetry::{self, MirrorMap, Symmetry};
use super::transfer::Transfer;
use crate::mesh::Mesh;

/// Part boxes of a mesh, the tree and graph edges between them, and the deformation field.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxDefGraph {
    parts: Parts,
    rows: Vec<usize>,
    parameter_rows: usize,
    symmetry_axis: Option<usize>,
    boundary: Boundary,
    frame: Frame,
    field: Arc<DeformField>,
}

impl BoxDefGraph {
    /// Takes parts that are already known, and deforms as the paper's authors do: scaling about the
    /// mean of the vertices, the boundary step edge by edge in the order given, first (leader, follower),
    /// then with the roles swapped. With `Boundary::Paper` it is exactly their deformation.
    pub fn from_parts(mesh: &Mesh, parts: Parts, boundary: Boundary) -> Result<Self, BoxDefError> {
        parts.check(mesh.vertices().len())?;
        let frame = Frame::of_vertices(mesh);
        let stages = parts.edges.iter().flat_map(|&[a, b]| [vec![[a, b]], vec![[b, a]]]).collect();
        let axis = twin_axis(&parts);
        let vertices = frame.vertices(mesh);
        Ok(Self::assemble(mesh, parts, frame, &vertices, axis, None, boundary, stages))
    }

    /// Finds the parts of a mesh with at most `splits` (1 to 8) cuts, fewer where no cut is worth it.
    pub fn build(
        mesh: &Mesh,
        splits: u32,
        symmetry: Symmetry,
        boundary: Boundary,
    ) -> Result<Self, BoxDefError> {
        if !(1..=8).contains(&splits) {
            return Err(BoxDefError::Splits(splits));
        }
        let mut ground = Ground::of(mesh);
        let axis = symmetry::resolve(symmetry, &ground.occupancy);
        if let Some(axis) = axis {
            ground.occupancy.symmetrise(axis);
        }
        let pieces = split(&mut ground.occupancy, splits, axis);
        let boxes = part_boxes(mesh, &ground.vertices, &ground.occupancy, &pieces, axis);
        Ok(Self::of_boxes(mesh, &ground, boxes, axis, boundary))
    }

    /// Takes boxes that a person gives, in object coordinates: `center` and `half_size` (b). Boxes may overlap and
    /// need not hold every vertex: each goes to the nearest. Those that own no vertex are left out.
    ///
    /// The symmetry is kept only if each box is its own mirror image or that of another.
    pub fn from_boxes(
        mesh: &Mesh,
        center: &[Vec3],
        half_size: &[Vec3],
        symmetry: Symmetry,
        boundary: Boundary,
    ) -> Result<Self, BoxDefError> {
        check_boxes(center, half_size)?;
        let ground = Ground::of(mesh);
        let axis = symmetry::resolve(symmetry, &ground.occupancy);
        let (boxes, axis) = given_boxes(center, half_size, ground.frame, &ground.occupancy, axis);
        Ok(Self::of_boxes(mesh, &ground, boxes, axis, boundary))
    }

    /// Assigns vertices to boxes, joins the boxes, and computes the field.
    fn of_boxes(
        mesh: &Mesh,
        ground: &Ground,
        mut boxes: Vec<PartBox>,
        axis: Option<usize>,
        boundary: Boundary,
    ) -> Self {
        let Ground { frame, vertices, places, occupancy } = ground;
        let mirror = axis.map(|axis| MirrorMap::of(vertices, axis));
        let islands = islands(mesh, places);
        let owners = loop {
            let owners = assign(mesh, vertices, &islands, occupancy, &boxes, mirror.as_ref());
            let kept = keep_owners(&boxes, &owners);
            if kept.len() == boxes.len() {
                break owners;
            }
            boxes = kept;
        };
        let connections = connect(mesh, occupancy, &boxes, &owners, axis);
        let pair = |edge: [usize; 2]| edge.map(|b| b as i32);
        let parts = Parts {
            box_center: boxes.iter().map(|b| frame.to_object(b.center())).collect(),
            box_half_size: boxes.iter().map(|b| (b.half_size() * frame.unit).as_vec3()).collect(),
            box_side: boxes.iter().map(|b| b.side).collect(),
            assignment: owners,
            tree_edges: connections.tree_edges.iter().copied().map(pair).collect(),
            tree_parent_point: connections.points.iter().map(|p| frame.to_object(p[0])).collect(),
            tree_child_point: connections.points.iter().map(|p| frame.to_object(p[1])).collect(),
            edges: connections.edges.iter().copied().map(pair).collect(),
        };
        let stages =
            connections.stages.into_iter().map(|stage| stage.into_iter().map(pair).collect()).collect();
        Self::assemble(mesh, parts, *frame, vertices, axis, mirror.as_ref(), boundary, stages)
    }

    #[expect(clippy::too_many_arguments, reason = "what both ways to a graph end in")]
    fn assemble(
        mesh: &Mesh,
        parts: Parts,
        frame: Frame,
        vertices: &[DVec3],
        symmetry_axis: Option<usize>,
        mirror: Option<&MirrorMap>,
        boundary: Boundary,
        stages: Vec<Vec<[i32; 2]>>,
    ) -> Self {
        let rows = parts.parameter_rows();
        let parameter_rows = rows.iter().max().map_or(0, |row| row + 1);
        let propagation =
            Propagation { frame, parts: &parts, rows: &rows, vertices, mirror, boundary, stages };
        let basis = propagation.basis(parameter_rows);
        let field = Arc::new(DeformField::new(mesh.vertices().to_vec(), parameter_rows, basis));
        Self { parts, rows, parameter_rows, symmetry_axis, boundary, frame, field }
    }
}

/// A mesh as its parts are found in it.
struct Ground {
    frame: Frame,
    /// Vertices in the frame.
    vertices: Vec<DVec3>,
    /// The first vertex in the place of each.
    places: Vec<u32>,
    occupancy: Occupancy,
}

impl Ground {
    fn of(mesh: &Mesh) -> Self {
        let frame = Frame::of_surface(mesh);
        let vertices = frame.vertices(mesh);
        let places = places(&vertices);
        let occupancy = Occupancy::of(mesh, frame, &vertices, &places);
        Self { frame, vertices, places, occupancy }
    }
}

/// The axis along which pos boxes lie apart from their neg twins.
fn twin_axis(parts: &Parts) -> Option<usize> {
    let sum = |side| -> Vec3 {
        let boxes = parts.box_side.iter().zip(&parts.box_center);
        boxes.filter(|&(&s, _)| s == side).map(|(_, &center)| center).sum()
    };
    let apart = (sum(super::parts::POS) - sum(super::parts::NEG)).abs();
    (apart.max_element() > 0.0).then(|| apart.max_position())
}

impl BoxDefGraph {
    /// Centre of each box (b), in object coordinates.
    #[must_use]
    pub fn box_center(&self) -> &[Vec3] {
        &self.parts.box_center
    }

    /// Half the extent of each box (b).
    #[must_use]
    pub fn box_half_size(&self) -> &[Vec3] {
        &self.parts.box_half_size
    }

    /// Side of each box (b): 0 mid, 1 pos, 2 neg.
    #[must_use]
    pub fn box_side(&self) -> &[i8] {
        &self.parts.box_side
    }

    /// Box that owns each vertex (n).
    #[must_use]
    pub fn assignment(&self) -> &[i32] {
        &self.parts.assignment
    }

    /// (parent, child) pairs (b − 1), from the root outwards.
    #[must_use]
    pub fn tree_edges(&self) -> &[[i32; 2]] {
        &self.parts.tree_edges
    }

    /// (leader, follower) pairs of adjacent boxes (e).
    #[must_use]
    pub fn edges(&self) -> &[[i32; 2]] {
        &self.parts.edges
    }

    /// All of the above with the constraint points: what `from_parts` takes.
    #[must_use]
    pub fn parts(&self) -> &Parts {
        &self.parts
    }

    /// Number of parameter rows, P: mid and pos boxes; a neg box shares its twin's.
    #[must_use]
    pub fn parameter_rows(&self) -> usize {
        self.parameter_rows
    }

    /// Parameter row of each box (b).
    #[must_use]
    pub fn parameter_row_of_box(&self) -> &[usize] {
        &self.rows
    }

    /// The symmetry that was found or asked for; never `Auto`.
    #[must_use]
    pub fn symmetry(&self) -> Symmetry {
        Symmetry::about(self.symmetry_axis)
    }

    /// The axis whose pos and neg sides mirror each other (0 x, 1 y, 2 z); none if there is no symmetry.
    #[must_use]
    pub fn symmetry_axis(&self) -> Option<usize> {
        self.symmetry_axis
    }

    /// How parts follow each other where they meet.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// The deformation field of the mesh's vertices.
    #[must_use]
    pub fn field(&self) -> &DeformField {
        &self.field
    }

    /// The same, to be held on to: a field may have hundreds of megabytes.
    #[must_use]
    pub fn shared_field(&self) -> Arc<DeformField> {
        self.field.clone()
    }

    /// The same field at other `points` in object coordinates: a base mesh under its modifiers, a proxy.
    ///
    /// A point in a vertex's place moves exactly as the vertex does; if the mesh is its own mirror image,
    /// mirror images move as such.
    pub fn field_at(&self, points: &[Vec3]) -> Result<DeformField, BoxDefError> {
        if let Some(row) = points.iter().position(|point| !point.is_finite()) {
            return Err(BoxDefError::NotFinite { name: "points", row });
        }
        let (parts, rows, field) = (&self.parts, &self.rows[..], &self.field);
        Ok(Transfer { frame: self.frame, parts, rows, field, symmetry: self.symmetry_axis }.at(points))
    }

    /// Positions (n) for P rows of scale factors, 1 = unchanged; neither re-centred nor re-scaled.
    pub fn deform(&self, scales: &[Vec3]) -> Result<Vec<Vec3>, BoxDefError> {
        if scales.len() != self.parameter_rows {
            return Err(BoxDefError::Length {
                name: "scales",
                found: scales.len(),
                expected: self.parameter_rows,
                why: "one for each parameter row of the graph",
            });
        }
        if let Some(row) = scales.iter().position(|scale| !scale.is_finite()) {
            return Err(BoxDefError::NotFinite { name: "scales", row });
        }
        Ok(self.field.deform(scales))
    }
}
