// SPDX-License-Identifier: MIT OR Apache-2.0
//! The vertices of a box, for another box's to follow.
//!
//! From afar one vertex of a neighbourhood is as good as another: their displacements are nearly the same,
//! and so are the weights. But to find the very nearest of a million that are all about equally far, as
//! those of a tube are from its axis, takes a long time, and to find it for each of a million takes longer.

use glam::DVec3;
use rayon::prelude::*;

use super::nearest::Nearest;

/// A box with more vertices than this is thinned for followers that are not near, and its own vertices follow
/// in groups what is far.
const MANY: usize = 4_000;
/// Edge of the cubes that keep one vertex each.
const THINNED: f64 = 0.01;
/// Nearer than this, all vertices count.
const NEAR: f64 = 0.05;
/// Edge of the cubes whose vertices follow the same one if it is farther than `FAR`.
const GROUP: f64 = 0.01;
/// Over 20 groups away, the nearest vertex of one of a group is farther from the others by a thousandth of that at
/// most.
const FAR: f64 = 0.3;
/// The same for an eighth of a cube.
const LESS_FAR: f64 = 0.15;

/// The vertices of one box.
pub(super) struct Crowd {
    ids: Vec<u32>,
    all: Nearest,
    /// Where they are many.
    many: Option<Many>,
}

struct Many {
    /// One vertex of each neighbourhood.
    thinned: Nearest,
    /// Places in `ids`, cube by cube and eighth by eighth.
    order: Vec<u32>,
    /// Number of vertices in each eighth of each cube.
    groups: Vec<Vec<usize>>,
}

impl Crowd {
    /// Of the vertices that `ids` name; none of none.
    pub(super) fn of(vertices: &[DVec3], ids: Vec<u32>) -> Option<Self> {
        let all = (!ids.is_empty()).then(|| Nearest::new(vertices, ids.iter().copied()))?;
        let many = (ids.len() > MANY).then(|| Many::of(vertices, &ids));
        Some(Self { ids, all, many })
    }

    /// For each vertex the nearest one of a `leader`, and its distance.
    pub(super) fn nearest_of(&self, leader: &Self, vertices: &[DVec3]) -> Vec<(u32, u32, f64)> {
        let at = |id: u32| vertices[id as usize];
        let own = |id: u32| leader.nearest(at(id));
        let named = |(&id, (found, distance)): (&u32, (u32, f64))| (id, found, distance);
        let (Some(many), Some(leaders)) = (&self.many, &leader.many) else {
            return self.ids.par_iter().map(|id| named((id, own(*id)))).collect();
        };
        // What all of a group follow, if it is far.
        let shared = |group: &[u32], far: f64| {
            let (found, distance) = leaders.thinned.one(at(self.ids[group[0] as usize]));
            (distance > far).then_some(found)
        };
        let follow = |group: &[u32], found: Option<u32>, pairs: &mut Vec<(u32, f64)>| {
            let ids = group.iter().map(|&place| self.ids[place as usize]);
            match found {
                Some(found) => pairs.extend(ids.map(|id| (found, at(id).distance(at(found))))),
                None => pairs.extend(ids.map(own)),
            }
        };
        let of_cube = |(sizes, mut cube): (&[usize], &[u32])| {
            let mut pairs = Vec::with_capacity(cube.len());
            if let Some(found) = shared(cube, FAR) {
                follow(cube, Some(found), &mut pairs);
                return pairs;
            }
            for &size in sizes {
                let (group, rest) = cube.split_at(size);
                follow(group, shared(group, LESS_FAR), &mut pairs);
                cube = rest;
            }
            pairs
        };
        let pairs: Vec<(u32, f64)> = many.cubes().into_par_iter().flat_map_iter(of_cube).collect();
        let mut in_order = vec![(0, 0.0); pairs.len()];
        for (&place, pair) in many.order.iter().zip(pairs) {
            in_order[place as usize] = pair;
        }
        self.ids.iter().zip(in_order).map(named).collect()
    }

    fn nearest(&self, vertex: DVec3) -> (u32, f64) {
        match self.many.as_ref().map(|many| many.thinned.one(vertex)) {
            Some(found) if found.1 > NEAR => found,
            _ => self.all.one(vertex),
        }
    }
}

impl Many {
    fn of(vertices: &[DVec3], ids: &[u32]) -> Self {
        let thinned = Nearest::thin(vertices, ids, THINNED);
        let eighth = |id: u32| (vertices[id as usize] * (2.0 / GROUP)).floor().as_i64vec3().to_array();
        let mut placed: Vec<([i64; 3], [i64; 3], u32)> = (0..ids.len())
            .into_par_iter()
            .map(|place| {
                let eighth = eighth(ids[place]);
                (eighth.map(|x| x >> 1), eighth, place as u32)
            })
            .collect();
        placed.par_sort_unstable();
        let groups = placed
            .chunk_by(|a, b| a.0 == b.0)
            .map(|cube| cube.chunk_by(|a, b| a.1 == b.1).map(<[_]>::len).collect())
            .collect();
        let order = placed.into_iter().map(|(.., place)| place).collect();
        Self { thinned: Nearest::new(vertices, thinned), order, groups }
    }

    /// The sizes of the groups of each cube, and its share of `order`.
    fn cubes(&self) -> Vec<(&[usize], &[u32])> {
        let mut rest = &self.order[..];
        self.groups
            .iter()
            .map(|sizes| {
                let (cube, later) = rest.split_at(sizes.iter().sum());
                rest = later;
                (&sizes[..], cube)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hundred by a hundred vertices, a unit wide and rising by `rise` along x, shifted.
    fn sheet(rise: f64, shift: DVec3) -> Vec<DVec3> {
        let at =
            |i: i32| DVec3::new(f64::from(i % 100), f64::from(i / 100), rise * f64::from(i % 100)) / 99.0;
        (0..10_000).map(|i| at(i) + shift).collect()
    }

    #[test]
    fn many_follow_all_but_the_nearest() {
        let follower = sheet(1.0, DVec3::new(0.0, 0.31, 0.02));
        let vertices = [sheet(0.0, DVec3::ZERO), follower].concat();
        let ids = |from: u32| (from..from + 10_000).collect::<Vec<u32>>();
        let [leader, follower] = [0, 10_000].map(|from| Crowd::of(&vertices, ids(from)).expect("ids"));
        let found = follower.nearest_of(&leader, &vertices);
        assert!(found.iter().map(|pair| pair.0).eq(10_000..20_000));
        let mut nearby = 0;
        for (id, nearest, distance) in found {
            let place = vertices[id as usize];
            assert!((distance - place.distance(vertices[nearest as usize])).abs() < 1e-12);
            let least = leader.all.one(place).1;
            assert!(
                distance - least < if least < NEAR - 0.004 { 1e-12 } else { 0.004 },
                "{distance}, {least}"
            );
            nearby += usize::from(least < NEAR);
        }
        assert!(nearby > 100);
    }
}
