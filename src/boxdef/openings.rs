// SPDX-License-Identifier: MIT OR Apache-2.0
//! Flat openings of a surface, such as the missing underside of a seat.
//!
//! For the question of what is inside they are closed, so that an open shell has the parts of a closed one.
//! The outline of a flat sheet is no opening, and openings that are not flat stay open.

use std::collections::HashMap;

use glam::DVec3;

use super::islands::{Islands, places};
use super::occupancy::CELL;

/// How far from its plane a flat outline may run.
const FLAT: f64 = 2.0 * CELL;

/// How far from the outline's plane a flat sheet may run.
const SHEET: f64 = 0.1 * CELL;

/// Triangles that close the flat openings of a surface; `vertices` are in the frame.
pub(crate) fn caps(triangles: &[[u32; 3]], vertices: &[DVec3]) -> Vec<[DVec3; 3]> {
    let place = places(vertices.len(), |i| vertices[i]);
    // Edges by the places of their ends, with the triangles' third corners.
    let mut edges: HashMap<(u32, u32), (u32, u32)> = HashMap::new();
    for triangle in triangles {
        let corners = triangle.map(|i| place[i as usize]);
        for i in 0..3 {
            let (a, b, third) = (corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
            if a != b {
                edges.entry((a.min(b), a.max(b))).or_insert((0, third)).0 += 1;
            }
        }
    }
    let mut rims: Vec<[u32; 3]> = edges
        .into_iter()
        .filter(|&(_, (uses, _))| uses == 1)
        .map(|((a, b), (_, third))| [a, b, third])
        .collect();
    // The map's order changes from run to run.
    rims.sort_unstable();
    let mut joined = Islands::new(vertices.len());
    rims.iter().for_each(|&[a, b, _]| joined.join(a, b));
    let mut outlines: HashMap<u32, Vec<[u32; 3]>> = HashMap::new();
    for &rim in &rims {
        outlines.entry(joined.find(rim[0])).or_default().push(rim);
    }
    let mut caps: Vec<(u32, Vec<[DVec3; 3]>)> =
        outlines.into_iter().filter_map(|(first, outline)| Some((first, cap(&outline, vertices)?))).collect();
    caps.sort_by_key(|&(first, _)| first);
    caps.into_iter().flat_map(|(_, cap)| cap).collect()
}

/// A fan over an outline, if it is a flat opening. Rims are (end, end, third corner of the triangle).
fn cap(outline: &[[u32; 3]], vertices: &[DVec3]) -> Option<Vec<[DVec3; 3]>> {
    let at = |i: u32| vertices[i as usize];
    let center: DVec3 =
        outline.iter().map(|&[a, b, _]| at(a) + at(b)).sum::<DVec3>() / (2.0 * outline.len() as f64);
    // Rims may run either way round: turn all normals to one side.
    let mut normal = DVec3::ZERO;
    for &[a, b, _] in outline {
        let part = (at(a) - center).cross(at(b) - center);
        normal += if part.dot(normal) < 0.0 { -part } else { part };
    }
    let normal = normal.try_normalize()?;
    let off_plane = |i: u32| (at(i) - center).dot(normal).abs();
    let flat = outline.iter().all(|&[a, b, _]| off_plane(a) <= FLAT && off_plane(b) <= FLAT);
    let sheet = outline.iter().all(|&[_, _, third]| off_plane(third) <= SHEET);
    (flat && !sheet).then(|| outline.iter().map(|&[a, b, _]| [center, at(a), at(b)]).collect())
}
