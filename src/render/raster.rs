// SPDX-License-Identifier: MIT OR Apache-2.0
//! Triangles to a visibility buffer: which triangle is nearest at each sample.
//!
//! Coordinates are snapped to 1/256 of a sample and edges evaluated in integers with the top-left rule, as
//! graphics hardware does: triangles that share an edge leave no crack and cover no sample twice.

use super::camera::{Camera, DISTANCE, TAN_HALF_FOV};
use super::frame::Frame;
use glam::Vec3;

/// Bits below one sample.
const SUB_BITS: i32 = 8;
const SUB: i32 = 1 << SUB_BITS;

/// A vertex on the screen: 1/256 samples right and down from the centre of the first sample.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Projected {
    x: i32,
    y: i32,
    /// One over the depth, which is linear on the screen.
    nearness: f32,
}

/// What a sample holds: the bits of the nearness above the inverted triangle index, so that the largest key is
/// the nearest triangle and, of equally near ones, the first. 0 is nothing.
type Key = u64;

/// A square grid of samples, reused from view to view.
#[derive(Debug, Default)]
pub(super) struct Raster {
    side: usize,
    projected: Vec<Projected>,
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
        let (mut low, mut high) = ([i32::MAX; 2], [i32::MIN; 2]);
        for (index, corners) in triangles.iter().enumerate() {
            let [a, b, c] = corners.map(|i| self.projected[i as usize]);
            // First and last sample whose centre the triangle's box holds.
            let x0 = (a.x.min(b.x).min(c.x) + (SUB - 1)) >> SUB_BITS;
            let x1 = a.x.max(b.x).max(c.x) >> SUB_BITS;
            let y0 = (a.y.min(b.y).min(c.y) + (SUB - 1)) >> SUB_BITS;
            let y1 = a.y.max(b.y).max(c.y) >> SUB_BITS;
            if x0 > x1 || y0 > y1 {
                continue;
            }
            low = [low[0].min(x0), low[1].min(y0)];
            high = [high[0].max(x1), high[1].max(y1)];
            fill(&mut self.keys, side, [x0, x1, y0, y1], [a, b, c], index as u32);
        }
        if low[0] <= high[0] {
            self.touched = [low[0] as usize, high[0] as usize + 1, low[1] as usize, high[1] as usize + 1];
        }
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
        let origin = half - SUB as f32 * 0.5 + 0.5;
        let across = camera.right * (focal * frame.inverse_radius);
        let down = camera.up * (-focal * frame.inverse_radius);
        let back = camera.back * frame.inverse_radius;
        self.projected.clear();
        self.projected.extend(positions.iter().map(|&position| {
            let p = position - frame.centre;
            let nearness = 1.0 / (DISTANCE - p.dot(back));
            // Positive for all that is in view, so that truncation rounds to nearest.
            let snap = |v: f32| (v + origin) as i32;
            Projected { x: snap(p.dot(across) * nearness), y: snap(p.dot(down) * nearness), nearness }
        }));
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

/// Enters one triangle into the samples of its box `[x0, x1, y0, y1]`, bounds included.
#[inline]
fn fill(keys: &mut [Key], side: usize, [x0, x1, y0, y1]: [i32; 4], corners: [Projected; 3], index: u32) {
    let [a, mut b, mut c] = corners;
    let area = i64::from(b.x - a.x) * i64::from(c.y - a.y) - i64::from(c.x - a.x) * i64::from(b.y - a.y);
    if area == 0 {
        return;
    }
    if area < 0 {
        std::mem::swap(&mut b, &mut c);
    }
    let edges = [Edge::new(b, c, x0, y0), Edge::new(c, a, x0, y0), Edge::new(a, b, x0, y0)];
    let (to_b, to_c) = (b.nearness - a.nearness, c.nearness - a.nearness);
    let per_area = 1.0 / area.abs() as f32;
    let slope = |at_b: i64, at_c: i64| (at_b as f32 * to_b + at_c as f32 * to_c) * per_area;
    let nearness = a.nearness + slope(edges[1].start, edges[2].start);
    let across = slope(edges[1].step_x, edges[2].step_x);
    let down = slope(edges[1].step_y, edges[2].step_y);

    let mut starts = [0, 1, 2].map(|i: usize| edges[i].start + edges[i].bias);
    let steps_x = [0, 1, 2].map(|i: usize| edges[i].step_x);
    for (row, y) in (y0..=y1).enumerate() {
        let mut inside = starts;
        let row_nearness = nearness + down * row as f32;
        let first = y as usize * side + x0 as usize;
        let mut entered = false;
        for (column, key) in keys[first..=first + (x1 - x0) as usize].iter_mut().enumerate() {
            // The sign bit of the three is that of the least.
            if inside[0] | inside[1] | inside[2] >= 0 {
                entered = true;
                let near = row_nearness + across * column as f32;
                let candidate = u64::from(near.to_bits()) << 32 | u64::from(!index);
                *key = (*key).max(candidate);
            } else if entered {
                break;
            }
            for (value, step) in inside.iter_mut().zip(steps_x) {
                *value += step;
            }
        }
        for (value, edge) in starts.iter_mut().zip(&edges) {
            *value += edge.step_y;
        }
    }
}
