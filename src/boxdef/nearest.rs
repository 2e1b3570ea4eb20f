// SPDX-License-Identifier: MIT OR Apache-2.0
//! Nearest-point queries over a subset of points.

use std::collections::HashSet;
use std::num::NonZero;

use glam::{DVec3, I64Vec3};
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

/// Points in small cubes, to find those in all but the same place: faster than a tree, which is for any distance.
pub(crate) struct Close<'a> {
    points: &'a [DVec3],
    reach: f64,
    /// First of `ids` in each bucket, and their number at the end.
    starts: Vec<u32>,
    /// Indices of points, by the bucket of their cube.
    ids: Vec<u32>,
    /// Where so many points crowd into a cube that looking at each would take long.
    tree: Option<Nearest>,
}

/// Edge of a cube over the distance that is looked at: most queries touch one cube only.
const CUBE: f64 = 16.0;
/// Points looked at per query, on the average, up to which cubes are faster than a tree.
const CROWD: u64 = 64;

impl<'a> Close<'a> {
    /// Over all `points`; `reach` is how near they must be to be found.
    pub(crate) fn new(points: &'a [DVec3], reach: f64) -> Self {
        let buckets = points.len().next_power_of_two();
        let mut close = Self { points, reach, starts: vec![0; buckets + 1], ids: Vec::new(), tree: None };
        let of_point: Vec<u32> =
            points.par_iter().map(|&point| close.bucket(close.cube(point)) as u32).collect();
        for &bucket in &of_point {
            close.starts[bucket as usize + 1] += 1;
        }
        let looked_at: u64 = close.starts.iter().map(|&count| u64::from(count).pow(2)).sum();
        if looked_at > CROWD * points.len() as u64 {
            close.tree = Some(Nearest::new(points, 0..points.len() as u32));
            return close;
        }
        (0..buckets).for_each(|i| close.starts[i + 1] += close.starts[i]);
        let mut next = close.starts.clone();
        close.ids = vec![0; points.len()];
        for (id, &bucket) in (0_u32..).zip(&of_point) {
            let slot = &mut next[bucket as usize];
            close.ids[*slot as usize] = id;
            *slot += 1;
        }
        close
    }

    /// Index of the nearest point within reach; of points in the very same place the first.
    pub(crate) fn one(&self, query: DVec3) -> Option<u32> {
        if let Some(tree) = &self.tree {
            let (found, distance) = tree.one(query);
            return (distance <= self.reach).then_some(found);
        }
        let (low, high) = (self.cube(query - self.reach), self.cube(query + self.reach));
        let mut best = (self.reach * self.reach, u32::MAX);
        for x in low.x..=high.x {
            for y in low.y..=high.y {
                for z in low.z..=high.z {
                    let bucket = self.bucket(I64Vec3::new(x, y, z));
                    for &id in &self.ids[self.starts[bucket] as usize..self.starts[bucket + 1] as usize] {
                        let distance = self.points[id as usize].distance_squared(query);
                        if distance < best.0 || (distance <= best.0 && id < best.1) {
                            best = (distance, id);
                        }
                    }
                }
            }
        }
        (best.1 != u32::MAX).then_some(best.1)
    }

    fn cube(&self, point: DVec3) -> I64Vec3 {
        (point / (CUBE * self.reach)).floor().as_i64vec3()
    }

    /// The bucket of a cube, which it may share with others.
    fn bucket(&self, cube: I64Vec3) -> usize {
        // Odd numbers without pattern; the product's upper half is the most mixed.
        let mix = |hash: u64, x: i64| (hash ^ x as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(31);
        let hash = mix(mix(mix(0, cube.x), cube.y), cube.z);
        (hash >> 20) as usize & (self.starts.len() - 2)
    }
}

fn compare(a: [f64; 3], b: [f64; 3]) -> std::cmp::Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_close_is_found_however_crowded_it_is() {
        let spread = |step: f64| -> Vec<DVec3> {
            let at = |i: i32| DVec3::new(f64::from(i % 13), f64::from(i / 13 % 13), f64::from(i / 169 - 5));
            (0..2197).map(|i| at(i) * step).collect()
        };
        // Apart, and hundreds in a cube.
        for step in [0.01, 2.5e-6] {
            let points = spread(step);
            let close = Close::new(&points, 1e-6);
            assert_eq!(close.tree.is_some(), step < 1e-3);
            for (i, &point) in points.iter().enumerate() {
                assert_eq!(close.one(point + DVec3::splat(5e-7)), Some(i as u32));
                assert_eq!(close.one(point + DVec3::splat(7e-7)), None);
            }
        }
        assert_eq!(Close::new(&[DVec3::ONE; 3], 1e-6).one(DVec3::ONE), Some(0));
    }

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
