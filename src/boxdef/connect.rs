// SPDX-License-Identifier: MIT OR Apache-2.0
//! How part boxes hang together: adjacency, tree edges with their constraint points, graph edges.
//!
//! Boxes are adjacent where a mesh edge joins their vertices, or where their filled cells touch, which also
//! finds a separate leg under a seat of four vertices. What is still apart is joined by distance, so the
//! graph is always connected. Whatever is symmetric stays so: an edge comes with its mirror images.

use glam::DVec3;

use crate::mesh::Mesh;

use super::boxes::{PartBox, image};
use super::occupancy::Occupancy;
use super::parts::MID;
use super::symmetry::{Symmetry, mirrored};

/// How far apart, in cells, filled cells may lie and still touch.
const REACH: usize = 2;

/// Edges between boxes, in the frame.
pub(crate) struct Connections {
    /// (parent, child) in order of execution.
    pub(crate) tree_edges: Vec<[usize; 2]>,
    /// Constraint points on parent and child of each tree edge.
    pub(crate) points: Vec<[DVec3; 2]>,
    /// (leader, follower), by the lower box, then by the higher.
    pub(crate) edges: Vec<[usize; 2]>,
    /// The same in groups that act at once: an edge and its mirror images, then all with the roles swapped.
    pub(crate) stages: Vec<Vec<[usize; 2]>>,
}

/// Connects boxes; `owners` names the box of each vertex.
pub(crate) fn connect(
    mesh: &Mesh,
    occupancy: &Occupancy,
    boxes: &[PartBox],
    owners: &[i32],
    symmetry: Symmetry,
) -> Connections {
    let contacts = contacts(occupancy, boxes);
    let mut adjacency = Adjacency { boxes, symmetry, linked: vec![false; boxes.len() * boxes.len()] };
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|i| owners[i as usize] as usize);
        adjacency.link(a, b);
        adjacency.link(b, c);
        adjacency.link(c, a);
    }
    for &(pair, _) in &contacts {
        adjacency.link(pair[0], pair[1]);
    }
    adjacency.join_components();
    let (tree_edges, order) = adjacency.tree();
    let points = tree_edges.iter().map(|&edge| joint(boxes, &contacts, edge, symmetry)).collect();
    let (edges, stages) = adjacency.graph_edges(&order);
    Connections { tree_edges, points, edges, stages }
}

/// Where the filled cells of two boxes touch: the pair (lower first) and the mean place.
type Contact = ([usize; 2], DVec3);

fn contacts(occupancy: &Occupancy, boxes: &[PartBox]) -> Vec<Contact> {
    let count = boxes.len();
    let mut sums = vec![(DVec3::ZERO, 0_u32); count * count];
    for (index, part) in boxes.iter().enumerate() {
        for axis in 0..3 {
            for (layer, step) in [(part.domain.low[axis], -1), (part.domain.high[axis] - 1, 1)] {
                let face = part.domain.with(axis, layer, layer + 1);
                occupancy.for_each_filled(&face, |cell| {
                    touching(occupancy, boxes, index, cell, axis, step, |other, place| {
                        let sum = &mut sums[index.min(other) * count + index.max(other)];
                        *sum = (sum.0 + place, sum.1 + 1);
                    });
                });
            }
        }
    }
    let found = sums.iter().enumerate().filter(|(_, sum)| sum.1 > 0);
    found.map(|(i, sum)| ([i / count, i % count], sum.0 / f64::from(sum.1))).collect()
}

/// Calls `visit` with each other box that has a filled cell beyond `cell`, and the place between.
fn touching(
    occupancy: &Occupancy,
    boxes: &[PartBox],
    index: usize,
    cell: [usize; 3],
    axis: usize,
    step: i64,
    mut visit: impl FnMut(usize, DVec3),
) {
    let size = occupancy.size();
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    for away in 1..=REACH as i64 {
        let beyond = cell[axis] as i64 + step * away;
        if beyond < 0 || beyond >= size[axis] as i64 {
            return;
        }
        for a in cell[u].saturating_sub(1)..=(cell[u] + 1).min(size[u] - 1) {
            for b in cell[v].saturating_sub(1)..=(cell[v] + 1).min(size[v] - 1) {
                let mut other = cell;
                (other[axis], other[u], other[v]) = (beyond as usize, a, b);
                if !occupancy.is_filled(other) {
                    continue;
                }
                if let Some(found) = boxes.iter().position(|part| part.domain.contains(other))
                    && found != index
                {
                    visit(found, (occupancy.center(cell) + occupancy.center(other)) * 0.5);
                }
            }
        }
    }
}

struct Adjacency<'a> {
    boxes: &'a [PartBox],
    symmetry: Symmetry,
    linked: Vec<bool>,
}

impl Adjacency<'_> {
    /// A pair of boxes and its mirror images, the pair itself first.
    fn images(&self, pair: [usize; 2]) -> Vec<[usize; 2]> {
        images(self.boxes, self.symmetry, pair)
    }

    /// Links two boxes, and their mirror images.
    fn link(&mut self, a: usize, b: usize) {
        if a != b {
            let n = self.boxes.len();
            for [a, b] in self.images([a, b]) {
                self.linked[a * n + b] = true;
                self.linked[b * n + a] = true;
            }
        }
    }

    fn are_linked(&self, a: usize, b: usize) -> bool {
        self.linked[a * self.boxes.len() + b]
    }

    /// Links the nearest boxes of different components until there is one component.
    fn join_components(&mut self) {
        loop {
            let component = self.components();
            let n = self.boxes.len();
            let pairs = (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b)));
            let apart = pairs.filter(|&(a, b)| component[a] != component[b]);
            // Equally near: the pair with the nearer centres.
            let cost = |&(a, b): &(usize, usize)| {
                let (a, b) = (&self.boxes[a], &self.boxes[b]);
                (a.distance_to(b), a.center().distance(b.center()))
            };
            let nearest = apart.min_by(|x, y| {
                let (x, y) = (cost(x), cost(y));
                x.0.total_cmp(&y.0).then(x.1.total_cmp(&y.1))
            });
            let Some((a, b)) = nearest else { return };
            self.link(a, b);
        }
    }

    /// The lowest box that each box is connected to.
    fn components(&self) -> Vec<usize> {
        let n = self.boxes.len();
        let mut component: Vec<usize> = (0..n).collect();
        for start in 0..n {
            let mut open = if component[start] == start { vec![start] } else { vec![] };
            while let Some(a) = open.pop() {
                for (b, component) in component.iter_mut().enumerate().skip(start + 1) {
                    if self.are_linked(a, b) && *component == b {
                        *component = start;
                        open.push(b);
                    }
                }
            }
        }
        component
    }

    /// Tree edges, and the number of the front in which each box was expanded.
    ///
    /// Fronts spread from the largest mid box. All mid boxes go before any pos or neg box, and a box and
    /// its mirror images are found together, by parents that are mirror images.
    fn tree(&self) -> (Vec<[usize; 2]>, Vec<usize>) {
        let n = self.boxes.len();
        let size = |b: usize| (self.boxes[b].half_size() + 0.005).element_product();
        let is_mid = |b: usize| self.boxes[b].side == MID;
        // `rev` makes the lowest index win a tie.
        let root = (0..n).rev().max_by(|&a, &b| is_mid(a).cmp(&is_mid(b)).then(size(a).total_cmp(&size(b))));
        let root = root.unwrap_or(0);
        let mut edges = Vec::new();
        let mut order = vec![usize::MAX; n];
        let mut reached = vec![false; n];
        let mut waiting = vec![root];
        reached[root] = true;
        for [root, other] in self.images([root, root]).into_iter().map(|pair| [root, pair[0]]) {
            if !reached[other] {
                // No mid box at all: the sides are held together by the planes between them.
                edges.push([root, other]);
                reached[other] = true;
                waiting.push(other);
            }
        }
        let mut front_number = 0;
        while !waiting.is_empty() {
            let some_mid = waiting.iter().any(|&b| is_mid(b));
            let (front, later): (Vec<_>, Vec<_>) = waiting.into_iter().partition(|&b| is_mid(b) == some_mid);
            waiting = later;
            for &parent in &front {
                order[parent] = front_number;
            }
            for parent in front {
                for child in 0..n {
                    if !self.are_linked(parent, child) || reached[child] {
                        continue;
                    }
                    for [parent, child] in self.images([parent, child]) {
                        if !reached[child] {
                            reached[child] = true;
                            edges.push([parent, child]);
                            waiting.push(child);
                        }
                    }
                }
            }
            front_number += 1;
        }
        (edges, order)
    }

    /// Graph edges as (leader, follower), and the stages in which they act. The box that was expanded
    /// earlier leads; of equals the lower one, and elsewhere its mirror images.
    fn graph_edges(&self, order: &[usize]) -> (Vec<[usize; 2]>, Vec<Vec<[usize; 2]>>) {
        let n = self.boxes.len();
        let mut pairs = Vec::new();
        let mut stages: Vec<Vec<[usize; 2]>> = Vec::new();
        let mut done = vec![false; n * n];
        for a in 0..n {
            for b in a + 1..n {
                if !self.are_linked(a, b) || done[a * n + b] {
                    continue;
                }
                let mut group = self.images(if order[b] < order[a] { [b, a] } else { [a, b] });
                group.sort_unstable();
                group.dedup();
                for &[c, d] in &group {
                    let known = &mut done[c.min(d) * n + c.max(d)];
                    if !*known {
                        *known = true;
                        pairs.push([c, d]);
                    }
                }
                let swapped: Vec<_> = group.iter().map(|&[leader, follower]| [follower, leader]).collect();
                let both_ways = group.contains(&swapped[0]);
                stages.push(group);
                if !both_ways {
                    stages.push(swapped);
                }
            }
        }
        pairs.sort_by_key(|&[a, b]| (a.min(b), a.max(b)));
        (pairs, stages)
    }
}

/// A pair of boxes and its mirror images, way by way.
fn images(boxes: &[PartBox], symmetry: Symmetry, pair: [usize; 2]) -> Vec<[usize; 2]> {
    symmetry.ways().iter().map(|way| pair.map(|b| image(boxes, b, way))).collect()
}

/// Constraint points of a tree edge; those of mirror images are mirror images.
fn joint(boxes: &[PartBox], contacts: &[Contact], edge: [usize; 2], symmetry: Symmetry) -> [DVec3; 2] {
    let images = images(boxes, symmetry, edge);
    if images.iter().any(|&[_, child]| child == edge[0]) {
        // Mirror images of each other are scaled alike: held at the origin they need no translation.
        return [DVec3::ZERO; 2];
    }
    let least = *images.iter().min().unwrap_or(&edge);
    let mut points = half_joint(boxes, contacts, least);
    for (&way, &found) in symmetry.ways().iter().zip(&images) {
        if let (&[axis], true) = (way, found == edge) {
            for point in &mut points {
                point[axis] = 0.0;
            }
        }
    }
    let way = symmetry.ways().iter().zip(&images).find(|(_, found)| **found == least);
    way.map_or(points, |(way, _)| points.map(|point| mirrored(point, way)))
}

/// The middle of the contact on both boxes; of boxes apart, the centre of the child's face that is nearest
/// to the parent, and the nearest point of the parent.
fn half_joint(boxes: &[PartBox], contacts: &[Contact], [parent, child]: [usize; 2]) -> [DVec3; 2] {
    let pair = [parent.min(child), parent.max(child)];
    if let Some(&(_, place)) = contacts.iter().find(|contact| contact.0 == pair) {
        return [place; 2];
    }
    let (parent, child) = (&boxes[parent], &boxes[child]);
    let faces = (0..6).map(|face| {
        let sign = if face % 2 == 0 { 1.0 } else { -1.0 };
        child.center() + sign * DVec3::AXES[face / 2] * child.half_size()
    });
    let pairs = faces.map(|q| [q.clamp(parent.low, parent.high), q]);
    let nearest = pairs.min_by(|x, y| x[0].distance(x[1]).total_cmp(&y[0].distance(y[1])));
    nearest.unwrap_or([child.center(); 2])
}
