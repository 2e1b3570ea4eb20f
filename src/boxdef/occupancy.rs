// SPDX-License-Identifier: MIT OR Apache-2.0
//! Which cells of a grid an object fills: its surface, and whatever the outside cannot reach.
//!
//! Surface cells come from samples so dense that no gap lets a flood fill through, and what the fill from
//! outside does not reach is inside. Flat openings are closed for that; other open shells are hollow. Sheets
//! thinner than a cell, intersecting shells, loose parts and flipped normals need nothing more.

use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use crate::mesh::Mesh;

use super::frame::{CELL, Frame};
use super::openings::caps;

/// Distance of surface samples. No point of a triangle is farther than `SPACING / √2` < half a cell from
/// a sample, so a line between the centres of two neighbouring cells that crosses the surface has a sample
/// in one of the two: the fill, which goes from face to face, cannot pass.
const SPACING: f64 = 0.65 * CELL;

/// Pulls samples this much towards the centre, so that a face on a cell boundary falls into the cell on
/// its inner side, and mirrored faces into mirrored cells.
const INWARDS: f64 = 1.0 - 1e-6;

/// A box of cells: from `low` up to, but without, `high`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CellBox {
    pub(crate) low: [usize; 3],
    pub(crate) high: [usize; 3],
}

impl CellBox {
    pub(crate) fn extent(&self, axis: usize) -> usize {
        self.high[axis] - self.low[axis]
    }

    pub(crate) fn longest(&self) -> usize {
        (0..3).map(|axis| self.extent(axis)).max().unwrap_or(0)
    }

    pub(crate) fn volume(&self) -> usize {
        (0..3).map(|axis| self.extent(axis)).product()
    }

    pub(crate) fn contains(&self, cell: [usize; 3]) -> bool {
        (0..3).all(|axis| (self.low[axis]..self.high[axis]).contains(&cell[axis]))
    }

    /// What this box has in common with another; empty if nothing.
    pub(crate) fn within(&self, other: &Self) -> Self {
        let low = std::array::from_fn(|axis| self.low[axis].max(other.low[axis]));
        let high = std::array::from_fn(|axis| self.high[axis].min(other.high[axis]).max(low[axis]));
        Self { low, high }
    }

    /// The same box with other limits on one axis.
    pub(crate) fn with(mut self, axis: usize, low: usize, high: usize) -> Self {
        self.low[axis] = low;
        self.high[axis] = high;
        self
    }
}

/// Filled cells of a grid that is centred on the frame's origin, with an empty layer all around.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Occupancy {
    size: [usize; 3],
    filled: Vec<bool>,
}

impl Occupancy {
    /// Of a mesh in its frame; `vertices` are its vertices in the frame, `places` names the first in the place
    /// of each.
    pub(crate) fn of(mesh: &Mesh, frame: Frame, vertices: &[DVec3], places: &[u32]) -> Self {
        let (low, high) = mesh.surface_bounds();
        let half = (high - low) * (0.5 / frame.unit);
        let size = half.to_array().map(|h| 2 * (h / CELL).ceil().max(1.0) as usize + 2);
        let mut grid = Self { size, filled: Vec::new() };
        let mut filled = Vec::new();
        filled.resize_with(size.iter().product(), AtomicBool::default);
        // Cells are only ever filled, so the order of the triangles does not matter.
        let fill = |corners| {
            sample_triangle(corners, |point| {
                filled[grid.index(grid.cell_of(point))].store(true, Ordering::Relaxed);
            });
        };
        mesh.triangles().par_iter().for_each(|triangle| fill(triangle.map(|i| vertices[i as usize])));
        caps(mesh.triangles(), vertices, places).into_par_iter().for_each(fill);
        grid.filled = filled.into_iter().map(AtomicBool::into_inner).collect();
        grid.fill_inside();
        grid
    }

    pub(crate) fn size(&self) -> [usize; 3] {
        self.size
    }

    /// The whole grid.
    pub(crate) fn whole(&self) -> CellBox {
        CellBox { low: [0; 3], high: self.size }
    }

    pub(crate) fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.size[1] + y) * self.size[0] + x
    }

    pub(crate) fn is_filled(&self, cell: [usize; 3]) -> bool {
        self.filled[self.index(cell)]
    }

    pub(crate) fn clear(&mut self, cell: [usize; 3]) {
        let index = self.index(cell);
        self.filled[index] = false;
    }

    /// The cell that a point of the surface lies in.
    pub(crate) fn cell_of(&self, point: DVec3) -> [usize; 3] {
        let scaled = (point * (INWARDS / CELL)).floor().to_array();
        std::array::from_fn(|axis| {
            let cell = scaled[axis] as i64 + (self.size[axis] / 2) as i64;
            cell.clamp(1, self.size[axis] as i64 - 2) as usize
        })
    }

    /// Frame coordinate of the boundary before the cells with this index on the axis.
    pub(crate) fn boundary(&self, axis: usize, index: usize) -> f64 {
        (index as f64 - (self.size[axis] / 2) as f64) * CELL
    }

    /// Frame coordinates of a cell's centre.
    pub(crate) fn center(&self, cell: [usize; 3]) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|axis| self.boundary(axis, cell[axis]) + 0.5 * CELL))
    }

    /// Calls `visit` with every filled cell of a box.
    pub(crate) fn for_each_filled(&self, cells: &CellBox, mut visit: impl FnMut([usize; 3])) {
        for z in cells.low[2]..cells.high[2] {
            for y in cells.low[1]..cells.high[1] {
                let start = self.index([0, y, z]);
                let row = &self.filled[start + cells.low[0]..start + cells.high[0]];
                for (x, _) in row.iter().enumerate().filter(|&(_, &filled)| filled) {
                    visit([cells.low[0] + x, y, z]);
                }
            }
        }
    }

    /// The smallest box around the filled cells of a box; none if there are none.
    pub(crate) fn tighten(&self, cells: &CellBox) -> Option<CellBox> {
        let mut low = [usize::MAX; 3];
        let mut high = [0; 3];
        self.for_each_filled(cells, |cell| {
            for axis in 0..3 {
                low[axis] = low[axis].min(cell[axis]);
                high[axis] = high[axis].max(cell[axis] + 1);
            }
        });
        (low[0] != usize::MAX).then_some(CellBox { low, high })
    }

    /// The cell mirrored about the grid's centre.
    pub(crate) fn mirrored(&self, mut cell: [usize; 3], axes: &[usize]) -> [usize; 3] {
        for &axis in axes {
            cell[axis] = self.size[axis] - 1 - cell[axis];
        }
        cell
    }

    /// Share of the filled cells whose mirror image is filled or touches a filled cell.
    pub(crate) fn mirror_agreement(&self, axis: usize) -> f64 {
        let (mut all, mut matched) = (0_u64, 0_u64);
        self.for_each_filled(&self.whole(), |cell| {
            all += 1;
            let image = self.mirrored(cell, &[axis]);
            matched += u64::from(self.is_filled(image) || self.touches_filled(image));
        });
        matched as f64 / all as f64
    }

    /// Fills the mirror image of every filled cell.
    pub(crate) fn symmetrise(&mut self, axis: usize) {
        let mut images = Vec::new();
        self.for_each_filled(&self.whole(), |cell| {
            let image = self.index(self.mirrored(cell, &[axis]));
            if !self.filled[image] {
                images.push(image);
            }
        });
        for image in images {
            self.filled[image] = true;
        }
    }

    fn touches_filled(&self, cell: [usize; 3]) -> bool {
        let around = |axis: usize| cell[axis].saturating_sub(1)..(cell[axis] + 2).min(self.size[axis]);
        around(2).any(|z| around(1).any(|y| around(0).any(|x| self.is_filled([x, y, z]))))
    }

    /// Fills every cell that a walk over empty cells from the grid's corner does not reach.
    fn fill_inside(&mut self) {
        let mut outside = vec![false; self.filled.len()];
        let strides = [1, self.size[0], self.size[0] * self.size[1]];
        let mut open = vec![[0_usize; 3]];
        outside[0] = true;
        while let Some(cell) = open.pop() {
            let index = self.index(cell);
            for axis in 0..3 {
                let mut step = |next: usize, to: usize| {
                    if !outside[next] && !self.filled[next] {
                        outside[next] = true;
                        let mut neighbour = cell;
                        neighbour[axis] = to;
                        open.push(neighbour);
                    }
                };
                if cell[axis] > 0 {
                    step(index - strides[axis], cell[axis] - 1);
                }
                if cell[axis] + 1 < self.size[axis] {
                    step(index + strides[axis], cell[axis] + 1);
                }
            }
        }
        self.filled.iter_mut().zip(&outside).for_each(|(filled, outside)| *filled = !outside);
    }
}

/// Calls `visit` with points of a triangle: along its edges, and in rows parallel to the longest one,
/// `SPACING` apart at most. (Rows alone would leave gaps along edges that meet the longest at a small angle.)
pub(crate) fn sample_triangle([a, b, c]: [DVec3; 3], mut visit: impl FnMut(DVec3)) {
    let lengths = [(b - a).length(), (c - b).length(), (a - c).length()];
    let longest = (0..3).fold(0, |best, i| if lengths[i] > lengths[best] { i } else { best });
    let (start, end, apex) = [(a, b, c), (b, c, a), (c, a, b)][longest];
    let base = lengths[longest];
    let height = if base > 0.0 { (b - a).cross(c - a).length() / base } else { 0.0 };
    let mut line = |from: DVec3, to: DVec3, length: f64| {
        let steps = (length / SPACING).ceil().max(1.0) as usize;
        for step in 0..=steps {
            visit(from.lerp(to, step as f64 / steps as f64));
        }
    };
    line(start, apex, lengths[(longest + 2) % 3]);
    line(end, apex, lengths[(longest + 1) % 3]);
    let rows = (height / SPACING).ceil().max(1.0) as usize;
    for row in 0..rows {
        let t = row as f64 / rows as f64;
        line(start.lerp(apex, t), end.lerp(apex, t), base * (1.0 - t));
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::super::islands::places;
    use super::*;

    /// A closed cylinder about z, of radius 0.5 and height 1, turned by `turn` about x.
    fn cylinder(segments: u32, turn: f32) -> Mesh {
        let rotate = |v: Vec3| glam::Quat::from_rotation_x(turn) * v;
        let mut vertices = vec![Vec3::ZERO, Vec3::Z];
        for s in 0..segments {
            let (sin, cos) = (s as f32 / segments as f32 * std::f32::consts::TAU).sin_cos();
            vertices.extend([Vec3::new(0.5 * cos, 0.5 * sin, 0.0), Vec3::new(0.5 * cos, 0.5 * sin, 1.0)]);
        }
        let at = |s: u32, top: u32| 2 + 2 * (s % segments) + top;
        let around = (0..segments).flat_map(|s| {
            let (a, b, c, d) = (at(s, 0), at(s + 1, 0), at(s, 1), at(s + 1, 1));
            [[a, b, d], [a, d, c], [0, b, a], [1, c, d]]
        });
        Mesh::new(vertices.into_iter().map(rotate).collect(), around.collect()).unwrap()
    }

    fn filled(mesh: &Mesh) -> f64 {
        let frame = Frame::of_surface(mesh);
        let vertices = frame.vertices(mesh);
        let grid = Occupancy::of(mesh, frame, &vertices, &places(&vertices));
        let cells = grid.filled.iter().filter(|&&filled| filled).count();
        cells as f64 * (CELL * frame.unit).powi(3)
    }

    #[test]
    fn a_closed_cylinder_is_solid_however_it_lies() {
        for (segments, turn) in [(8, 0.0), (32, 0.0), (32, 0.3), (200, 0.7), (200, 1.2), (1000, 1.570_796_4)]
        {
            let volume = f64::from(segments) / 8.0 * (std::f64::consts::TAU / f64::from(segments)).sin();
            let found = filled(&cylinder(segments, turn));
            assert!(found > 0.95 * volume && found < 1.1 * volume, "{segments} segments at {turn}: {found}");
        }
    }
}
