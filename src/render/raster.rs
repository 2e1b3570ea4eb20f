// SPDX-License-Identifier: MIT OR Apache-2.0
//! Triangles to a visibility buffer: which triangle is nearest at each sample.
//!
//! Coordinates are snapped to 1/256 of a sample and edges evaluated in integers with the top-left rule, as
//! graphics hardware does: triangles that share an edge leave no crack and cover no sample twice.

use super::camera::{Camera, DISTANCE, TAN_HALF_FOV};
use super::frame::Frame;
use glam::Vec3;
use std::ops::Range;

/// Bits below one sample.
const SUB_BITS: i32 = 8;
const SUB: i32 = 1 << SUB_BITS;

/// Lifts a nearness above all that rounding can make of it.
const ABOVE_ROUNDING: f32 = 1.0 + 1e-4;

/// A vertex on the screen: 1/256 samples right and down from the centre of the first sample.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Projected {
    x: i32,
    y: i32,
    /// One over the depth, which is linear on the screen.
    nearness: f32,
}

impl Projected {
    /// First sample not left of and not above the vertex: column in the upper half, row in the lower.
    ///
    /// By the top-left rule a triangle covers none but the columns from the least to before the greatest of
    /// its corners' columns; rows likewise.
    fn cell(self) -> u32 {
        (((self.x + (SUB - 1)) >> SUB_BITS) << 16 | ((self.y + (SUB - 1)) >> SUB_BITS & 0xFFFF)) as u32
    }
}

/// What a sample holds: the bits of the nearness above the inverted triangle index, so that the largest key is
/// the nearest triangle and, of equally near ones, the first. 0 is nothing.
type Key = u64;

/// A square grid of samples, reused from view to view.
#[derive(Debug, Default)]
pub(super) struct Raster {
    side: usize,
    projected: Vec<Projected>,
    cells: Vec<u32>,
    /// Triangles that may cover a sample.
    candidates: Vec<u32>,
    keys: Vec<Key>,
    /// First and one-past-last column, then row, of what the last shape may have touched.
    touched: [usize; 4],
}

impl Raster {
    /// Draws a shape, which `frame` brings into the unit sphere and so wholly into the view.
    pub fn draw(
        &mut self,
        camera: &Camera,
        frame: Frame,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        side: usize,
    ) {
        self.clear(side);
        self.project(camera, frame, positions);
        self.find_candidates(triangles);
        let (mut low, mut high) = ([usize::MAX; 2], [0; 2]);
        for &index in &self.candidates {
            let corners = triangles[index as usize];
            let cells = corners.map(|i| self.cells[i as usize]);
            let [x, y] =
                [cells.map(|cell| (cell >> 16) as usize), cells.map(|cell| (cell & 0xFFFF) as usize)];
            let x = x[0].min(x[1]).min(x[2])..x[0].max(x[1]).max(x[2]);
            let y = y[0].min(y[1]).min(y[2])..y[0].max(y[1]).max(y[2]);
            low = [low[0].min(x.start), low[1].min(y.start)];
            high = [high[0].max(x.end), high[1].max(y.end)];
            fill(&mut self.keys, side, x, y, corners.map(|i| self.projected[i as usize]), index);
        }
        if low[0] < high[0] {
            self.touched = [low[0], high[0], low[1], high[1]];
        }
    }

    /// Most triangles of a fine mesh fall between the samples: a pass without branches sets them aside.
    fn find_candidates(&mut self, triangles: &[[u32; 3]]) {
        self.candidates.resize(triangles.len(), 0);
        let mut count = 0;
        for (index, corners) in (0u32..).zip(triangles) {
            let [a, b, c] = corners.map(|i| self.cells[i as usize]);
            let differ = (a ^ b) | (a ^ c);
            self.candidates[count] = index;
            count += usize::from(differ >> 16 != 0) & usize::from(differ & 0xFFFF != 0);
        }
        self.candidates.truncate(count);
    }

    /// Columns and rows outside which nothing was drawn: first and one-past-last of each.
    pub fn touched(&self) -> [usize; 4] {
        self.touched
    }

    /// The samples of row `y`, to be read with [`triangle`].
    pub fn row(&self, y: usize) -> &[Key] {
        &self.keys[y * self.side..(y + 1) * self.side]
    }

    fn clear(&mut self, side: usize) {
        if self.side == side {
            let [x0, x1, y0, y1] = self.touched;
            for y in y0..y1 {
                self.keys[y * side + x0..y * side + x1].fill(0);
            }
        } else {
            self.side = side;
            self.keys.clear();
            self.keys.resize(side * side, 0);
        }
        self.touched = [0; 4];
    }

    fn project(&mut self, camera: &Camera, frame: Frame, positions: &[Vec3]) {
        let half = (self.side as i32 * SUB) as f32 * 0.5;
        let focal = half / TAN_HALF_FOV;
        // Adding it leaves no bits below one: rounds to nearest, and cheaper than a conversion.
        let whole = 12_582_912.0_f32;
        let origin = whole + half - SUB as f32 * 0.5;
        let across = camera.right * (focal * frame.inverse_radius);
        let down = camera.up * (-focal * frame.inverse_radius);
        let back = camera.back * frame.inverse_radius;
        self.projected.clear();
        self.projected.extend(positions.iter().map(|&position| {
            let p = position - frame.centre;
            let nearness = 1.0 / (DISTANCE - p.dot(back));
            let snap = |v: f32| (v + origin).to_bits() as i32 - whole.to_bits() as i32;
            Projected { x: snap(p.dot(across) * nearness), y: snap(p.dot(down) * nearness), nearness }
        }));
        self.cells.clear();
        self.cells.extend(self.projected.iter().map(|vertex| vertex.cell()));
    }
}

/// The triangle that a sample shows.
#[inline]
pub(super) fn triangle(key: Key) -> Option<usize> {
    (key != 0).then_some(!(key as u32) as usize)
}

/// Twice the signed area of `a`, `b` and the origin of the coordinates shifted to `a`: an edge's value at `p`
/// starts from it and grows by `[step_x, step_y]` a sample.
struct Edge {
    start: i64,
    step_x: i64,
    step_y: i64,
    /// −1 where a sample right on the edge belongs to the neighbour.
    bias: i64,
}

impl Edge {
    /// From `a` to `b`, started at the sample (`x`, `y`); positive inside.
    #[inline]
    fn new(a: Projected, b: Projected, x: i32, y: i32) -> Self {
        let (dx, dy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
        let top_left = dy < 0 || (dy == 0 && dx > 0);
        Self {
            start: dx * i64::from((y << SUB_BITS) - a.y) - dy * i64::from((x << SUB_BITS) - a.x),
            step_x: -dy << SUB_BITS,
            step_y: dx << SUB_BITS,
            bias: if top_left { 0 } else { -1 },
        }
    }
}

/// Enters one triangle into the samples of columns `x` and rows `y`, which hold all that it covers.
#[inline]
fn fill(
    keys: &mut [Key],
    side: usize,
    x: Range<usize>,
    y: Range<usize>,
    [a, mut b, mut c]: [Projected; 3],
    index: u32,
) {
    let is_single = x.len() == 1 && y.len() == 1;
    if is_single {
        // Half of a fine mesh lies behind what is drawn already, and shows it before any edge is looked at.
        let most = a.nearness.max(b.nearness).max(c.nearness) * ABOVE_ROUNDING;
        if u64::from(most.to_bits()) < keys[y.start * side + x.start] >> 32 {
            return;
        }
    }
    let area = i64::from(b.x - a.x) * i64::from(c.y - a.y) - i64::from(c.x - a.x) * i64::from(b.y - a.y);
    if area == 0 {
        return;
    }
    if area < 0 {
        std::mem::swap(&mut b, &mut c);
    }
    let (x0, y0) = (x.start as i32, y.start as i32);
    let edges = [Edge::new(b, c, x0, y0), Edge::new(c, a, x0, y0), Edge::new(a, b, x0, y0)];
    let mut row_starts = [0, 1, 2].map(|i: usize| edges[i].start + edges[i].bias);
    // The sign bit of the three is that of the least.
    let is_inside = |values: [i64; 3]| values[0] | values[1] | values[2] >= 0;
    if is_single && !is_inside(row_starts) {
        return;
    }
    let (to_b, to_c) = (b.nearness - a.nearness, c.nearness - a.nearness);
    let per_area = 1.0 / area.abs() as f32;
    let slope = |at_b: i64, at_c: i64| (at_b as f32 * to_b + at_c as f32 * to_c) * per_area;
    let nearness = a.nearness + slope(edges[1].start, edges[2].start);
    let key = |nearness: f32| u64::from(nearness.to_bits()) << 32 | u64::from(!index);
    if is_single {
        let sample = &mut keys[y.start * side + x.start];
        *sample = (*sample).max(key(nearness));
        return;
    }
    let across = slope(edges[1].step_x, edges[2].step_x);
    let down = slope(edges[1].step_y, edges[2].step_y);
    for (row, y) in y.enumerate() {
        let mut values = row_starts;
        let row_nearness = nearness + down * row as f32;
        let mut entered = false;
        for (column, sample) in keys[y * side + x.start..y * side + x.end].iter_mut().enumerate() {
            if is_inside(values) {
                entered = true;
                *sample = (*sample).max(key(row_nearness + across * column as f32));
            } else if entered {
                break;
            }
            for (value, edge) in values.iter_mut().zip(&edges) {
                *value += edge.step_x;
            }
        }
        for (value, edge) in row_starts.iter_mut().zip(&edges) {
            *value += edge.step_y;
        }
    }
}
