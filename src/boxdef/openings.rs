// SPDX-License-Identifier: MIT OR Apache-2.0
//! Flat openings of a surface, such as the missing underside of a seat.
//!
//! For the question of what is inside they are closed, so that an open shell has the parts of a closed one.
//! The outline of a flat sheet is no opening, and openings that are not flat stay open.

use std::collections::BTreeMap;

use glam::DVec3;

use super::frame::CELL;
use super::islands::Islands;

/// How far from its plane a flat outline may run.
const FLAT: f64 = 2.0 * CELL;

/// How far from the outline's plane a flat sheet may run.
const SHEET: f64 = 0.1 * CELL;

/// Triangles that close the flat openings of a surface; `vertices` are in the frame, `places` names the first
/// vertex in the place of each.
pub(crate) fn caps(triangles: &[[u32; 3]], vertices: &[DVec3], places: &[u32]) -> Vec<[DVec3; 3]> {
    let rims = rims(triangles, places);
    let mut joined = Islands::new(vertices.len());
    for &[a, b, _] in &rims {
        joined.join(a, b);
    }
    let mut outlines: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
    for &rim in &rims {
        outlines.entry(joined.find(rim[0])).or_default().push(rim);
    }
    outlines.values().filter_map(|outline| cap(outline, vertices)).flatten().collect()
}

/// Edges of one triangle only, as (end, end, the triangle's third corner).
fn rims(triangles: &[[u32; 3]], places: &[u32]) -> Vec<[u32; 3]> {
    let edges = || {
        triangles.iter().flat_map(|triangle| {
            let [a, b, c] = triangle.map(|i| places[i as usize]);
            [[a, b, c], [b, c, a], [c, a, b]].map(|[a, b, third]| [a.min(b), a.max(b), third])
        })
    };
    // Sorted by the lower end, by counting: much faster than comparing when there are millions.
    let mut start = vec![0; places.len() + 1];
    edges().for_each(|[low, ..]| start[low as usize + 1] += 1);
    (0..places.len()).for_each(|i| start[i + 1] += start[i]);
    let mut next = start.clone();
    let mut sorted = vec![[0; 3]; start[places.len()]];
    for edge in edges() {
        let slot = &mut next[edge[0] as usize];
        sorted[*slot] = edge;
        *slot += 1;
    }
    let mut rims = Vec::new();
    for range in start.windows(2) {
        let of_one = &mut sorted[range[0]..range[1]];
        of_one.sort_unstable();
        let same = of_one.chunk_by(|a, b| a[..2] == b[..2]);
        rims.extend(same.filter(|edge| edge.len() == 1 && edge[0][0] != edge[0][1]).map(|edge| edge[0]));
    }
    rims
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
