// SPDX-License-Identifier: MIT OR Apache-2.0
//! Nearest-point queries over a subset of points.

use std::collections::HashSet;
use std::num::NonZero;

use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;

/// A search tree over some of a slice of points.
pub(crate) struct Nearest {
    tree: ImmutableKdTree<f64, 3>,
    ids: Vec<u32>,
}

impl Nearest {
    /// Over the points that `ids` name; of points in the very same place only the first is kept.
    ///
    /// # Panics
    /// If `ids` is empty or a point is not finite: both are ruled out by what callers checked before.
    pub(crate) fn new(points: &[DVec3], ids: impl IntoIterator<Item = u32>) -> Self {
        let place = |i: u32| points[i as usize].to_array();
        let mut ids: Vec<u32> = ids.into_iter().collect();
        ids.par_sort_unstable_by(|&a, &b| compare(place(a), place(b)).then(a.cmp(&b)));
        ids.dedup_by(|a, b| compare(place(*a), place(*b)).is_eq());
        ids.sort_unstable();
        let places: Vec<[f64; 3]> = ids.iter().map(|&i| place(i)).collect();
        let tree = ImmutableKdTree::new_from_slice(&places).expect("a set of finite points makes a tree");
        Self { tree, ids }
    }

    /// The first of the points that `ids` name in each cube of a grid of this `edge`.
    pub(crate) fn thin(points: &[DVec3], ids: &[u32], edge: f64) -> Vec<u32> {
        let mut seen = HashSet::new();
        let cube = |i: u32| (points[i as usize] / edge).floor().as_i64vec3();
        ids.iter().copied().filter(|&i| seen.insert(cube(i))).collect()
    }

    /// Index of the nearest point, and its distance.
    pub(crate) fn one(&self, query: DVec3) -> (u32, f64) {
        let found = self.tree.query(&query.to_array()).nearest_one::<SquaredEuclidean<f64>>().execute();
        (self.ids[found.item as usize], found.distance.sqrt())
    }

    /// Indices and distances of the `count` nearest points (fewer if there are fewer), nearest first.
    pub(crate) fn some(&self, query: DVec3, count: NonZero<usize>) -> Vec<(u32, f64)> {
        let found = self.tree.query(&query.to_array()).nearest_n::<SquaredEuclidean<f64>>(count).execute();
        found.into_iter().map(|f| (self.ids[f.item as usize], f.distance.sqrt())).collect()
    }
}

fn compare(a: [f64; 3], b: [f64; 3]) -> std::cmp::Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_thousand_points_in_one_plane_or_one_place_are_no_trouble() {
        let grid: Vec<DVec3> =
            (0..10_000).map(|i| DVec3::new(f64::from(i % 100), f64::from(i / 100), 0.0)).collect();
        let tree = Nearest::new(&grid, 0..10_000);
        assert_eq!(tree.one(DVec3::new(41.2, 17.3, 5.0)).0, 1741);
        let heap = vec![DVec3::ONE; 10_000];
        assert_eq!(Nearest::new(&heap, 0..10_000).one(DVec3::ZERO), (0, 3.0_f64.sqrt()));
        let line: Vec<DVec3> = (0..10_000).map(|i| DVec3::new(0.0, 0.0, f64::from(i / 50))).collect();
        assert_eq!(Nearest::new(&line, 0..10_000).one(DVec3::new(0.0, 1.0, 100.2)).0, 5000);
    }
}
