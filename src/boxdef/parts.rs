// SPDX-License-Identifier: MIT OR Apache-2.0
//! Part boxes and how they hang together, as plain arrays: what `BoxDefGraph::from_parts` takes.

use glam::Vec3;

use super::error::BoxDefError;

/// Side of a box that lies on the symmetry plane, or belongs to a shape without one.
pub(crate) const MID: i8 = 0;
/// Side of a box beyond the symmetry plane.
pub(crate) const POS: i8 = 1;
/// Side of the mirror twin of a pos box.
pub(crate) const NEG: i8 = 2;

/// Part boxes, the owner of every vertex, and the edges between boxes; b boxes, n vertices.
///
/// Coordinates are object coordinates. Boxes may stand in any order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Parts {
    /// Centre of each box (b).
    pub box_center: Vec<Vec3>,
    /// Half the extent of each box (b), not below zero.
    pub box_half_size: Vec<Vec3>,
    /// Side of each box (b): 0 mid, 1 pos, 2 neg.
    pub box_side: Vec<i8>,
    /// Parameter row of each box (b): mid boxes have the first rows, in order, pos boxes the next ones, and a
    /// neg box that of the pos box whose mirror image it is.
    pub box_row: Vec<i32>,
    /// Box that owns each vertex (n).
    pub assignment: Vec<i32>,
    /// (parent, child) pairs (b − 1) in order of execution: the first parent is the root, and every later
    /// parent is the root or an earlier child.
    pub tree_edges: Vec<[i32; 2]>,
    /// Undeformed constraint point on the parent of each tree edge (b − 1).
    pub tree_parent_point: Vec<Vec3>,
    /// Undeformed constraint point on the child of each tree edge (b − 1).
    pub tree_child_point: Vec<Vec3>,
    /// (leader, follower) pairs of adjacent boxes (e) in order of execution of the boundary step.
    pub edges: Vec<[i32; 2]>,
}

impl Parts {
    /// Checks everything that the deformation relies on.
    pub(crate) fn check(&self, vertex_count: usize) -> Result<(), BoxDefError> {
        check_boxes(&self.box_center, &self.box_half_size)?;
        let boxes = self.box_center.len();
        let per_tree_edge = "one less than there are boxes";
        for (name, found, expected, why) in [
            ("box_side", self.box_side.len(), boxes, PER_BOX),
            ("box_row", self.box_row.len(), boxes, PER_BOX),
            ("assignment", self.assignment.len(), vertex_count, "one for each vertex of the mesh"),
            ("tree_edges", self.tree_edges.len(), boxes - 1, per_tree_edge),
            ("tree_parent_point", self.tree_parent_point.len(), boxes - 1, per_tree_edge),
            ("tree_child_point", self.tree_child_point.len(), boxes - 1, per_tree_edge),
        ] {
            if found != expected {
                return Err(BoxDefError::Length { name, found, expected, why });
            }
        }
        check_finite("tree_parent_point", &self.tree_parent_point)?;
        check_finite("tree_child_point", &self.tree_child_point)?;
        self.check_sides()?;
        check_indices("assignment", boxes, self.assignment.iter().map(|&i| [i, i]))?;
        check_indices("tree_edges", boxes, self.tree_edges.iter().copied())?;
        check_indices("edges", boxes, self.edges.iter().copied())?;
        self.check_tree()?;
        if let Some(row) = self.edges.iter().position(|[a, b]| a == b) {
            return Err(BoxDefError::LoopEdge { row, index: self.edges[row][0] });
        }
        Ok(())
    }

    fn check_sides(&self) -> Result<(), BoxDefError> {
        if let Some(row) = self.box_side.iter().position(|side| ![MID, POS, NEG].contains(side)) {
            return Err(BoxDefError::Side { row, side: self.box_side[row] });
        }
        let own = own_rows(&self.box_side);
        let mids = self.box_side.iter().filter(|&&side| side == MID).count() as i32;
        let rows = own.iter().flatten().count() as i32;
        for (row, (&found, own)) in self.box_row.iter().zip(own).enumerate() {
            let expected = match own {
                Some(own) if own != found => own.to_string(),
                None if !(mids..rows).contains(&found) => "the row of a pos box".into(),
                _ => continue,
            };
            return Err(BoxDefError::BoxRow { row, found, expected });
        }
        let is_neg = |row| (0..self.box_row.len()).any(|b| self.box_row[b] == row && self.box_side[b] == NEG);
        if (mids..rows).all(is_neg) {
            return Ok(());
        }
        let count = |side| self.box_side.iter().filter(|&&s| s == side).count();
        Err(BoxDefError::Twins { pos: count(POS), neg: count(NEG) })
    }

    fn check_tree(&self) -> Result<(), BoxDefError> {
        let mut reached = vec![false; self.box_center.len()];
        for (row, &[parent, child]) in self.tree_edges.iter().enumerate() {
            if row == 0 {
                reached[parent as usize] = true;
            }
            let why = if !reached[parent as usize] {
                "its parent is not reached by the rows before it; order the edges from the root outwards"
            } else if reached[child as usize] {
                "its child is already reached; give every box but the root one parent"
            } else {
                reached[child as usize] = true;
                continue;
            };
            return Err(BoxDefError::TreeOrder { row, parent, child, why });
        }
        Ok(())
    }

    /// The rows of boxes with one symmetry: the j-th neg box has that of the j-th pos box.
    pub fn rows_of_twins(box_side: &[i8]) -> Result<Vec<i32>, BoxDefError> {
        let count = |side| box_side.iter().filter(|&&s| s == side).count();
        let (pos, neg) = (count(POS), count(NEG));
        if pos != neg {
            return Err(BoxDefError::Twins { pos, neg });
        }
        let mut twins = count(MID) as i32..;
        let row = |own: Option<i32>| own.or_else(|| twins.next()).unwrap_or_default();
        Ok(own_rows(box_side).into_iter().map(row).collect())
    }
}

/// The parameter row that each mid and pos box has by its place; none for neg boxes.
fn own_rows(box_side: &[i8]) -> Vec<Option<i32>> {
    let mids = box_side.iter().filter(|&&side| side == MID).count() as i32;
    let (mut mid, mut pos) = (0.., mids..);
    let own = |&side: &i8| match side {
        MID => mid.next(),
        POS => pos.next(),
        _ => None,
    };
    box_side.iter().map(own).collect()
}

/// Why arrays must be as long as `box_center`.
const PER_BOX: &str = "one for each row of box_center";

/// Whether there are boxes, a half size for each, and all of them are finite and not inside out.
pub(crate) fn check_boxes(center: &[Vec3], half_size: &[Vec3]) -> Result<(), BoxDefError> {
    if center.is_empty() {
        return Err(BoxDefError::NoBoxes);
    }
    let (found, expected) = (half_size.len(), center.len());
    if found != expected {
        return Err(BoxDefError::Length { name: "box_half_size", found, expected, why: PER_BOX });
    }
    check_finite("box_center", center)?;
    check_finite("box_half_size", half_size)?;
    match half_size.iter().position(|v| v.min_element() < 0.0) {
        Some(row) => Err(BoxDefError::NegativeSize { row }),
        None => Ok(()),
    }
}

fn check_finite(name: &'static str, rows: &[Vec3]) -> Result<(), BoxDefError> {
    match rows.iter().position(|v| !v.is_finite()) {
        Some(row) => Err(BoxDefError::NotFinite { name, row }),
        None => Ok(()),
    }
}

fn check_indices(
    name: &'static str,
    boxes: usize,
    rows: impl Iterator<Item = [i32; 2]>,
) -> Result<(), BoxDefError> {
    for (row, pair) in rows.enumerate() {
        if let Some(&index) = pair.iter().find(|&&i| !(0..boxes as i32).contains(&i)) {
            return Err(BoxDefError::BoxIndex { name, row, index, boxes });
        }
    }
    Ok(())
}
