// SPDX-License-Identifier: MIT OR Apache-2.0
//! Pairs of overlapping boxes among many.

use glam::Vec3;

/// Boxes to a leaf of the tree.
const LEAF: usize = 8;

/// An axis-aligned box.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    pub(super) low: Vec3,
    pub(super) high: Vec3,
}

impl Bounds {
    pub(super) fn of(points: impl IntoIterator<Item = Vec3>) -> Self {
        let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = points.into_iter().fold(nothing, |(low, high), p| (low.min(p), high.max(p)));
        Self { low, high }
    }

    fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn overlaps(self, other: Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

/// Half a range of the sorted boxes each, down to leaves.
struct Node {
    bounds: Bounds,
    start: usize,
    end: usize,
    children: Option<[usize; 2]>,
}

struct Tree<'a> {
    boxes: &'a [Bounds],
    order: Vec<u32>,
    nodes: Vec<Node>,
}

/// All pairs (lower index first) of boxes that overlap or touch.
pub(super) fn overlapping_pairs(boxes: &[Bounds]) -> Vec<(u32, u32)> {
    let mut tree = Tree { boxes, order: (0..boxes.len() as u32).collect(), nodes: Vec::new() };
    let mut pairs = Vec::new();
    if !boxes.is_empty() {
        tree.build(0, boxes.len());
        tree.collect(0, 0, &mut pairs);
    }
    pairs
}

impl Tree<'_> {
    fn build(&mut self, start: usize, end: usize) -> usize {
        let inside = self.order[start..end].iter().map(|&i| self.boxes[i as usize]);
        let bounds = inside.reduce(Bounds::with).unwrap_or(Bounds { low: Vec3::ZERO, high: Vec3::ZERO });
        let index = self.nodes.len();
        self.nodes.push(Node { bounds, start, end, children: None });
        if end - start > LEAF {
            let axis = (bounds.high - bounds.low).max_position();
            let boxes = self.boxes;
            let place = |i: &u32| boxes[*i as usize].low[axis] + boxes[*i as usize].high[axis];
            let middle = (end - start) / 2;
            self.order[start..end]
                .select_nth_unstable_by(middle, |a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
            let low = self.build(start, start + middle);
            let high = self.build(start + middle, end);
            self.nodes[index].children = Some([low, high]);
        }
        index
    }

    fn collect(&self, a: usize, b: usize, pairs: &mut Vec<(u32, u32)>) {
        let (first, second) = (&self.nodes[a], &self.nodes[b]);
        if !first.bounds.overlaps(second.bounds) {
            return;
        }
        match (first.children, second.children) {
            (Some([low, high]), _) if a == b => {
                self.collect(low, low, pairs);
                self.collect(low, high, pairs);
                self.collect(high, high, pairs);
            }
            (Some(children), other)
                if other.is_none() || first.end - first.start >= second.end - second.start =>
            {
                for child in children {
                    self.collect(child, b, pairs);
                }
            }
            (_, Some(children)) => {
                for child in children {
                    self.collect(a, child, pairs);
                }
            }
            _ => self.collect_leaves(first, second, a == b, pairs),
        }
    }

    fn collect_leaves(&self, a: &Node, b: &Node, same: bool, pairs: &mut Vec<(u32, u32)>) {
        for (k, &i) in self.order[a.start..a.end].iter().enumerate() {
            let others = &self.order[b.start..b.end];
            for &j in if same { &others[k + 1..] } else { others } {
                if self.boxes[i as usize].overlaps(self.boxes[j as usize]) {
                    pairs.push((i.min(j), i.max(j)));
                }
            }
        }
    }
}
