// SPDX-License-Identifier: MIT OR Apache-2.0
//! Which part box owns which vertex.

use glam::DVec3;
use rayon::prelude::*;

use crate::mesh::Mesh;

use super::boxes::PartBox;
use super::occupancy::{Occupancy, sample_triangle};
use super::symmetry::MirrorMap;

/// A loose part with at least this share of its surface in one box's space belongs to that box as a whole,
/// so that a leg that is let into a seat is not sliced.
const WHOLE: f64 = 0.8;

/// But not if another box would lose more than this share of the surface in its space: a fin that is of one
/// piece with its fuselage is no less a part.
const GUEST: f64 = 0.5;

/// Triangles that one thread takes at least.
const SHARE: usize = 50_000;

/// The owner of every vertex: the nearest box, the first of several (a vertex inside a box is at distance
/// 0); but loose parts (`islands` numbers them) that lie mostly in one box's space go to it whole, and mirror
/// images to mirror images.
pub(crate) fn assign(
    mesh: &Mesh,
    vertices: &[DVec3],
    islands: &[u32],
    occupancy: &Occupancy,
    boxes: &[PartBox],
    mirrors: &[&MirrorMap],
) -> Vec<i32> {
    let mut owners: Vec<i32> = vertices.par_iter().map(|&v| nearest_box(boxes, v)).collect();
    if boxes.len() > 1 {
        keep_islands_whole(mesh, vertices, islands, occupancy, boxes, &mut owners);
    }
    for mirror in mirrors {
        for vertex in 0..vertices.len() {
            let Some(image) = mirror.image[vertex] else { continue };
            // The positive side decides; points of the plane are their own images.
            if vertices[vertex][mirror.axis] > 0.0 && image as usize != vertex {
                owners[image as usize] = boxes[owners[vertex] as usize].images[mirror.axis] as i32;
            }
        }
    }
    owners
}

fn nearest_box(boxes: &[PartBox], vertex: DVec3) -> i32 {
    let mut best = (f64::INFINITY, 0);
    for (index, part) in boxes.iter().enumerate() {
        let distance = part.distance(vertex);
        if distance < best.0 {
            best = (distance, index as i32);
        }
    }
    best.1
}

fn keep_islands_whole(
    mesh: &Mesh,
    vertices: &[DVec3],
    islands: &[u32],
    occupancy: &Occupancy,
    boxes: &[PartBox],
    owners: &mut [i32],
) {
    let count = islands.iter().max().map_or(0, |&last| last as usize + 1);
    if count < 2 {
        return;
    }
    let none = || vec![0_u32; count * boxes.len()];
    let counted = mesh.triangles().par_iter().with_min_len(SHARE).fold(none, |mut samples, triangle| {
        let island = islands[triangle[0] as usize] as usize;
        sample_triangle(triangle.map(|i| vertices[i as usize]), |point| {
            let cell = occupancy.cell_of(point);
            if let Some(part) = boxes.iter().position(|part| part.domain.contains(cell)) {
                samples[island * boxes.len() + part] += 1;
            }
        });
        samples
    });
    let samples = counted.reduce(none, |a, b| a.iter().zip(b).map(|(a, b)| a + b).collect());
    let mut totals = vec![0_u32; boxes.len()];
    for (i, &count) in samples.iter().enumerate() {
        totals[i % boxes.len()] += count;
    }
    let share = |count: u32, all: u32| f64::from(count) / f64::from(all.max(1));
    let whole = |counts: &[u32]| {
        let all: u32 = counts.iter().sum();
        let part = counts.iter().position(|&count| share(count, all) >= WHOLE)?;
        let robs = (0..boxes.len()).any(|b| b != part && share(counts[b], totals[b]) > GUEST);
        (!robs).then_some(part as i32)
    };
    let whole: Vec<Option<i32>> = samples.chunks(boxes.len()).map(whole).collect();
    for (owner, &island) in owners.iter_mut().zip(islands) {
        if let Some(part) = whole[island as usize] {
            *owner = part;
        }
    }
}
