// SPDX-License-Identifier: MIT OR Apache-2.0
//! How far apart two shapes of one object are, and what a candidate pays for coming near to others.

use glam::{Vec2, Vec3};

use super::{Gauge, KeepPlace, KeepSize};
use crate::mesh::Mesh;

/// Points that stand for the surface.
const POINTS: usize = 256;

/// Steps that fill a square evenly: the inverse of the plastic number, and of its square.
const EVENLY: Vec2 = Vec2::new(0.754_877_7, 0.569_840_3);

/// Points spread evenly over the surface of a mesh, by which its deformations are compared.
#[derive(Debug, Clone)]
pub struct Sketch<'a> {
    mesh: &'a Mesh,
    diagonal: f32,
    /// The triangle of each point, and its barycentric coordinates there.
    points: Vec<([u32; 3], Vec3)>,
}

impl<'a> Sketch<'a> {
    /// Spreads the points, the same for the same mesh.
    #[must_use]
    pub fn of(mesh: &'a Mesh) -> Self {
        let corner = |i: u32| mesh.vertices()[i as usize].as_dvec3();
        let mut area = 0.0;
        let mut until = Vec::with_capacity(mesh.triangles().len());
        for [a, b, c] in mesh.triangles() {
            area += (corner(*b) - corner(*a)).cross(corner(*c) - corner(*a)).length();
            until.push(area);
        }
        let point = |i: usize| {
            let at = area * (i as f64 + 0.5) / POINTS as f64;
            let triangle = until.partition_point(|&end| end < at).min(until.len() - 1);
            let mut place = (EVENLY * (i + 1) as f32).fract_gl();
            if place.x + place.y > 1.0 {
                place = 1.0 - place;
            }
            (mesh.triangles()[triangle], Vec3::new(1.0 - place.x - place.y, place.x, place.y))
        };
        let diagonal = Gauge::diagonal(mesh.vertices());
        Self { mesh, diagonal, points: (0..POINTS).map(point).collect() }
    }

    /// The points with the mesh's vertices at `positions` (n), in units of its bounding box's diagonal. The
    /// positions are put under the usual gauge first: size and place, which no score sees, make no difference.
    #[must_use]
    pub fn draw(&self, positions: &[Vec3]) -> Vec<Vec3> {
        let gauge = Gauge::new(self.mesh.vertices(), positions, KeepSize::Diagonal, KeepPlace::BottomCenter);
        let at = |i: u32| positions[i as usize];
        let place = |([a, b, c], w): &([u32; 3], Vec3)| w.x * at(*a) + w.y * at(*b) + w.z * at(*c);
        self.points.iter().map(|point| (gauge.scale * place(point) + gauge.shift) / self.diagonal).collect()
    }

    /// How far apart two drawings are: root mean square of the way from each point to its like, as a share of
    /// the bounding box's diagonal.
    #[must_use]
    pub fn distance(a: &[Vec3], b: &[Vec3]) -> f64 {
        let squares = a.iter().zip(b).map(|(a, b)| f64::from(a.distance_squared(*b)));
        (squares.sum::<f64>() / a.len() as f64).sqrt()
    }
}

/// What a search for another shape that is as good adds to the loss.
#[derive(Debug, Clone)]
pub struct Novelty<'a> {
    /// Draws the candidates.
    pub sketch: &'a Sketch<'a>,
    /// Drawings of the shapes to keep away from.
    pub others: Vec<Vec<Vec3>>,
    /// From this distance on a shape is far enough.
    pub far: f64,
    /// What it costs to be the same as another.
    pub weight: f64,
    /// The worth that is to be kept all the same,
    pub floor: f64,
    /// and what it costs to be worth less, a unit.
    pub steep: f64,
}

impl Novelty<'_> {
    /// How far a drawing is from the nearest of the others.
    #[must_use]
    pub fn distance(&self, drawing: &[Vec3]) -> f64 {
        self.others.iter().map(|other| Sketch::distance(drawing, other)).fold(f64::INFINITY, f64::min)
    }

    /// What is added to the loss of a candidate at this distance and of this worth.
    #[must_use]
    pub fn cost(&self, distance: f64, worth: f64) -> f64 {
        let near = self.weight * (1.0 - distance / self.far).max(0.0);
        near + self.steep * (self.floor - worth).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube of eight vertices with its corner at the origin.
    fn cube() -> Mesh {
        let vertices = (0..8u8).map(|i| Vec3::from([0, 1, 2].map(|bit| f32::from(i >> bit & 1)))).collect();
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
        Mesh::new(vertices, triangles).expect("a cube is a mesh")
    }

    fn drawn(change: impl Fn(Vec3) -> Vec3) -> Vec<Vec3> {
        let mesh = cube();
        let positions: Vec<Vec3> = mesh.vertices().iter().map(|v| change(*v)).collect();
        Sketch::of(&mesh).draw(&positions)
    }

    #[test]
    fn size_and_place_make_no_difference_and_proportions_do() {
        let cube = drawn(|v| v);
        let same = Sketch::distance(&cube, &drawn(|v| 3.0 * v + Vec3::new(5.0, -2.0, 7.0)));
        assert!(same < 1e-6, "{same}");
        let (taller, tall) =
            (drawn(|v| v * Vec3::new(1.0, 1.0, 3.0)), drawn(|v| v * Vec3::new(1.0, 1.0, 2.0)));
        assert!(Sketch::distance(&cube, &tall) > 0.1);
        assert!(Sketch::distance(&cube, &taller) > Sketch::distance(&cube, &tall));
    }

    #[test]
    fn points_lie_on_the_whole_surface_alike() {
        let points = drawn(|v| v);
        for axis in 0..3 {
            let along = || points.iter().map(|p| p[axis]);
            for end in [along().fold(f32::INFINITY, f32::min), along().fold(f32::NEG_INFINITY, f32::max)] {
                let on = along().filter(|x| (x - end).abs() < 1e-5).count();
                assert!((POINTS / 8..POINTS / 4).contains(&on), "{on} points on a side, axis {axis}");
            }
        }
    }

    #[test]
    fn the_same_shape_pays_and_one_that_is_far_enough_does_not() {
        let mesh = cube();
        let sketch = Sketch::of(&mesh);
        let others = vec![drawn(|v| v), drawn(|v| v * Vec3::new(1.0, 1.0, 3.0))];
        let novelty = Novelty { sketch: &sketch, others, far: 0.1, weight: 2.0, floor: 0.5, steep: 10.0 };
        let tall =
            sketch.draw(&mesh.vertices().iter().map(|v| *v * Vec3::new(1.0, 1.0, 2.9)).collect::<Vec<_>>());
        let nearest = novelty.distance(&tall);
        assert!(nearest > 0.0 && nearest < 0.02, "{nearest}");
        assert!((novelty.cost(0.0, 1.0) - 2.0).abs() < 1e-12);
        assert!((novelty.cost(0.05, 0.5) - 1.0).abs() < 1e-12);
        assert!(novelty.cost(0.2, 0.5).abs() < 1e-12);
        assert!((novelty.cost(0.2, 0.4) - 1.0).abs() < 1e-9, "what is worth too little pays too");
    }
}
