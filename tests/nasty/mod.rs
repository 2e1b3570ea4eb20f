// SPDX-License-Identifier: MIT OR Apache-2.0
//! Meshes as nobody would want them, one for each seed: a few bases, then what befalls meshes, then a place.

mod afflictions;
mod bases;
mod places;

use boxmorph::mesh::Mesh;
use glam::Vec3;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::common::Maker;
use afflictions::AFFLICTIONS;
use bases::BASES;
use places::PLACES;

/// A mesh with the names of all that was combined in it.
pub struct Nasty {
    pub recipe: String,
    pub mesh: Mesh,
}

/// A step of a recipe: its name, and what it does to the mesh so far.
type Step = (&'static str, fn(&mut ChaCha8Rng, &mut Maker));

/// The mesh of a seed. What does not make a mesh, such as one whose last face was dropped, is drawn again.
pub fn nasty(seed: u64) -> Nasty {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    loop {
        let mut maker = Maker::default();
        let mut names = Vec::new();
        let mut take = |rng: &mut ChaCha8Rng, steps: &[Step], count: usize| {
            for _ in 0..count {
                let (name, step) = steps[rng.random_range(0..steps.len())];
                step(rng, &mut maker);
                names.push(name);
            }
        };
        let counts = [rng.random_range(1..4), rng.random_range(0..5), rng.random_range(0..3)];
        take(&mut rng, BASES, counts[0]);
        take(&mut rng, AFFLICTIONS, counts[1]);
        take(&mut rng, PLACES, counts[2]);
        if let Ok(mesh) = Mesh::new(maker.vertices, maker.triangles) {
            return Nasty { recipe: names.join(", "), mesh };
        }
    }
}

/// A point of the cube about the origin.
pub fn spread(rng: &mut ChaCha8Rng, size: f32) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| rng.random_range(-size..size)))
}
