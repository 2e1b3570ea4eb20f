// SPDX-License-Identifier: MIT OR Apache-2.0
//! `BoxDefGraph`: part boxes, the edges between them, and the field that follows from both (paper §3.1).

use std::sync::Arc;

use glam::{DVec3, Vec3};

use super::assign::assign;
use super::boundary::Boundary;
use super::boxes::{PartBox, box_rows, keep_owners, part_boxes};
use super::connect::connect;
use super::error::BoxDefError;
use super::field::DeformField;
use super::frame::Frame;
use super::given::given_boxes;
use super::ground::Ground;
use super::layout::Layout;
use super::occupancy::Occupancy;
use super::parts::{NEG, POS, Parts, check_boxes};
use super::propagate::{Motion, Propagation};
use super::room::room;
use super::split::split;
use super::symmetry::{MirrorMap, Symmetry};
use super::transfer::Transfer;
use crate::mesh::Mesh;

/// Part boxes of a mesh, the tree and graph edges between them, and the deformation field.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxDefGraph {
    layout: Layout,
    rows: Vec<usize>,
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
        let symmetry = symmetry_of(&parts);
        let held = vec![[false; 3]; parts.box_center.len()];
        let layout = Layout { parts, frame, symmetry, exact: false, held, boundary, stages };
        Ok(Self::assemble(mesh, layout, &frame.vertices(mesh), &[]))
    }

    /// Finds the parts of a mesh with at most `splits` (1 to 8) cuts, fewer where no cut is worth it.
    pub fn build(
        mesh: &Mesh,
        splits: u32,
        symmetry: Symmetry,
        boundary: Boundary,
    ) -> Result<Self, BoxDefError> {
        Self::on(&Ground::of(mesh, symmetry), splits, boundary)
    }

    /// The same on a ground that graphs of other split counts share.
    pub fn on(ground: &Ground<'_>, splits: u32, boundary: Boundary) -> Result<Self, BoxDefError> {
        if !(1..=8).contains(&splits) {
            return Err(BoxDefError::Splits(splits));
        }
        let symmetry = ground.symmetry;
        let mut occupancy = ground.occupancy.clone();
        for &axis in symmetry.axes() {
            occupancy.symmetrise(axis);
        }
        let pieces = split(&mut occupancy, splits, symmetry);
        let boxes = part_boxes(ground.mesh, &ground.vertices, &occupancy, &pieces, symmetry);
        Ok(Self::of_boxes(ground, &occupancy, boxes, symmetry, boundary))
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
        let ground = Ground::of(mesh, symmetry);
        let (boxes, symmetry) =
            given_boxes(center, half_size, ground.frame, &ground.occupancy, ground.symmetry);
        Ok(Self::of_boxes(&ground, &ground.occupancy, boxes, symmetry, boundary))
    }

    /// Assigns vertices to boxes, joins the boxes, and computes the field.
    fn of_boxes(
        ground: &Ground<'_>,
        occupancy: &Occupancy,
        mut boxes: Vec<PartBox>,
        symmetry: Symmetry,
        boundary: Boundary,
    ) -> Self {
        let Ground { mesh, frame, vertices, islands, .. } = ground;
        let kept = |mirror: &&MirrorMap| symmetry.axes().contains(&mirror.axis);
        let mirrors: Vec<&MirrorMap> = ground.mirrors.iter().filter(kept).collect();
        let owners = loop {
            let owners = assign(mesh, vertices, islands, occupancy, &boxes, &mirrors);
            let kept = keep_owners(&boxes, &owners, symmetry);
            if kept.len() == boxes.len() {
                break owners;
            }
            boxes = kept;
        };
        let connections = connect(mesh, occupancy, &boxes, &owners, symmetry);
        let pair = |edge: [usize; 2]| edge.map(|b| b as i32);
        let parts = Parts {
            box_center: boxes.iter().map(|b| frame.to_object(b.center())).collect(),
            box_half_size: boxes.iter().map(|b| (b.half_size() * frame.unit).as_vec3()).collect(),
            box_side: boxes.iter().map(|b| b.side).collect(),
            box_row: box_rows(&boxes, symmetry),
            assignment: owners,
            tree_edges: connections.tree_edges.iter().copied().map(pair).collect(),
            tree_parent_point: connections.points.iter().map(|p| frame.to_object(p[0])).collect(),
            tree_child_point: connections.points.iter().map(|p| frame.to_object(p[1])).collect(),
            edges: connections.edges.iter().copied().map(pair).collect(),
        };
        let stages =
            connections.stages.into_iter().map(|stage| stage.into_iter().map(pair).collect()).collect();
        let is_held = |b: usize| [0, 1, 2].map(|a| symmetry.axes().contains(&a) && boxes[b].images[a] == b);
        let held: Vec<[bool; 3]> = (0..boxes.len()).map(is_held).collect();
        let layout = Layout { parts, frame: *frame, symmetry, exact: true, held, boundary, stages };
        Self::assemble(mesh, layout, vertices, &mirrors)
    }

    fn assemble(mesh: &Mesh, layout: Layout, vertices: &[DVec3], mirrors: &[&MirrorMap]) -> Self {
        let rows: Vec<usize> = layout.parts.box_row.iter().map(|&row| row as usize).collect();
        let basis = Propagation { layout: &layout, vertices, mirrors }.basis(&[Motion::Scale]);
        let field = Arc::new(DeformField::new(mesh.vertices().to_vec(), layout.parameter_rows(), basis));
        Self { layout, rows, field }
    }
}

/// About which planes the pos boxes have neg twins.
fn symmetry_of(parts: &Parts) -> Symmetry {
    let of_side = |side| (0..parts.box_side.len()).filter(move |&b| parts.box_side[b] == side);
    let mut apart = [false; 3];
    for (pos, neg) in of_side(POS).flat_map(|pos| of_side(NEG).map(move |neg| (pos, neg))) {
        let way = (parts.box_center[pos] - parts.box_center[neg]).abs();
        if parts.box_row[pos] == parts.box_row[neg] && way.max_element() > 0.0 {
            apart[way.max_position()] = true;
        }
    }
    let axes: Vec<usize> = (0..3).filter(|&axis| apart[axis]).collect();
    Symmetry::about(&axes)
}

impl BoxDefGraph {
    /// Centre of each box (b), in object coordinates.
    #[must_use]
    pub fn box_center(&self) -> &[Vec3] {
        &self.layout.parts.box_center
    }

    /// Half the extent of each box (b).
    #[must_use]
    pub fn box_half_size(&self) -> &[Vec3] {
        &self.layout.parts.box_half_size
    }

    /// Side of each box (b): 0 mid, 1 pos, 2 neg.
    #[must_use]
    pub fn box_side(&self) -> &[i8] {
        &self.layout.parts.box_side
    }

    /// Box that owns each vertex (n).
    #[must_use]
    pub fn assignment(&self) -> &[i32] {
        &self.layout.parts.assignment
    }

    /// (parent, child) pairs (b − 1), from the root outwards.
    #[must_use]
    pub fn tree_edges(&self) -> &[[i32; 2]] {
        &self.layout.parts.tree_edges
    }

    /// (leader, follower) pairs of adjacent boxes (e).
    #[must_use]
    pub fn edges(&self) -> &[[i32; 2]] {
        &self.layout.parts.edges
    }

    /// All of the above with the constraint points: what `from_parts` takes.
    #[must_use]
    pub fn parts(&self) -> &Parts {
        &self.layout.parts
    }

    /// Number of parameter rows, P: mid and pos boxes; a neg box shares that of the pos box it
    /// mirrors.
    #[must_use]
    pub fn parameter_rows(&self) -> usize {
        self.field.scale_rows()
    }

    /// Parameter row of each box (b).
    #[must_use]
    pub fn parameter_row_of_box(&self) -> &[usize] {
        &self.rows
    }

    /// The symmetry that was found or asked for; never `Auto`.
    #[must_use]
    pub fn symmetry(&self) -> Symmetry {
        self.layout.symmetry
    }

    /// How parts follow each other where they meet.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.layout.boundary
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

    /// The field with P rows for shifts after those for scale factors: the positions also follow shifts of the
    /// parts along the axes, which mirror images do the mirrored way.
    #[must_use]
    pub fn field_with_shifts(&self) -> DeformField {
        let vertices: Vec<DVec3> = self.field.rest().iter().map(|&v| self.layout.frame.to_frame(v)).collect();
        let mirrors = self.layout.mirrors(&vertices);
        let mirrors: Vec<&MirrorMap> = mirrors.iter().collect();
        let propagation = Propagation { layout: &self.layout, vertices: &vertices, mirrors: &mirrors };
        let basis = propagation.basis(&[Motion::Scale, Motion::Shift]);
        let rows = self.parameter_rows();
        DeformField::with_shifts(self.field.rest().to_vec(), rows, rows, basis)
    }

    /// The object's reach: the unit of the shifts among a field's factors, in object units.
    #[must_use]
    pub fn reach(&self) -> f32 {
        self.layout.frame.unit as f32
    }

    /// How far each parameter row can be shifted along each axis (P), in object units: least and greatest, such
    /// that its parts do not overhang those they hang on any more than they do. Both are 0 where there is no room.
    #[must_use]
    pub fn shift_room(&self) -> Vec<[(f32, f32); 3]> {
        room(&self.layout)
    }

    /// A field of this graph at other `points` in object coordinates: a base mesh under its modifiers, a proxy.
    /// `field` is [`Self::field`] or [`Self::field_with_shifts`].
    ///
    /// A point in a vertex's place moves exactly as the vertex does; if the mesh is its own mirror image,
    /// mirror images move as such.
    pub fn field_at(&self, field: &DeformField, points: &[Vec3]) -> Result<DeformField, BoxDefError> {
        if let Some(row) = points.iter().position(|point| !point.is_finite()) {
            return Err(BoxDefError::NotFinite { name: "points", row });
        }
        Ok(Transfer { layout: &self.layout, field }.at(points))
    }

    /// Positions (n) for P rows of scale factors, 1 = unchanged; neither re-centred nor re-scaled.
    pub fn deform(&self, scales: &[Vec3]) -> Result<Vec<Vec3>, BoxDefError> {
        self.check_rows("scales", scales)?;
        Ok(self.field.deform(scales))
    }

    /// Positions (n) for P rows of scale factors and P rows of shifts in object units, 0 = unchanged.
    pub fn deform_shifted(&self, scales: &[Vec3], shifts: &[Vec3]) -> Result<Vec<Vec3>, BoxDefError> {
        self.check_rows("scales", scales)?;
        self.check_rows("shifts", shifts)?;
        let shifts = shifts.iter().map(|&shift| 1.0 + shift / self.reach());
        let factors: Vec<Vec3> = scales.iter().copied().chain(shifts).collect();
        Ok(self.field_with_shifts().deform(&factors))
    }

    fn check_rows(&self, name: &'static str, rows: &[Vec3]) -> Result<(), BoxDefError> {
        let (found, expected) = (rows.len(), self.parameter_rows());
        if found != expected {
            let why = "one for each parameter row of the graph";
            return Err(BoxDefError::Length { name, found, expected, why });
        }
        match rows.iter().position(|row| !row.is_finite()) {
            Some(row) => Err(BoxDefError::NotFinite { name, row }),
            None => Ok(()),
        }
    }
}
