// SPDX-License-Identifier: MIT OR Apache-2.0
//! Which vertices hang together.

use glam::DVec3;
use rayon::prelude::*;

use crate::mesh::Mesh;

/// Sets of vertices that grow together.
pub(crate) struct Islands {
    parent: Vec<u32>,
}

impl Islands {
    /// Every vertex on its own.
    pub(crate) fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// The lowest vertex of a vertex' set.
    pub(crate) fn find(&mut self, mut vertex: u32) -> u32 {
        while self.parent[vertex as usize] != vertex {
            let above = self.parent[vertex as usize];
            self.parent[vertex as usize] = self.parent[above as usize];
            vertex = self.parent[vertex as usize];
        }
        vertex
    }

    /// Makes one set of two vertices' sets.
    pub(crate) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }
}

/// For each point the first one in the very same place.
pub(crate) fn places(points: &[DVec3]) -> Vec<u32> {
    // Adding 0 makes −0 and 0 one place.
    let place = |i: u32| points[i as usize].to_array().map(|x| (x + 0.0).to_bits());
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.par_sort_unstable_by_key(|&i| (place(i), i));
    let mut first = vec![0; points.len()];
    for same in order.chunk_by(|&a, &b| place(a) == place(b)) {
        for &i in same {
            first[i as usize] = same[0];
        }
    }
    first
}

/// Number of the loose part that each vertex belongs to. Vertices in the very same place are one, so that
/// seams split by UVs or normals do not part a shell; `places` names the first in each place.
pub(crate) fn islands(mesh: &Mesh, places: &[u32]) -> Vec<u32> {
    let n = mesh.vertices().len();
    let mut joined = Islands::new(n);
    for (vertex, &first) in places.iter().enumerate() {
        joined.join(vertex as u32, first);
    }
    for &[a, b, c] in mesh.triangles() {
        joined.join(a, b);
        joined.join(a, c);
    }
    let mut number = vec![u32::MAX; n];
    let mut count = 0;
    (0..n as u32)
        .map(|vertex| {
            let root = joined.find(vertex) as usize;
            if number[root] == u32::MAX {
                number[root] = count;
                count += 1;
            }
            number[root]
        })
        .collect()
}
