// SPDX-License-Identifier: MIT OR Apache-2.0
//! A thousand random meshes of every nasty kind: each has a connected graph and a finite field.

mod common;
mod nasty;

use std::panic::{AssertUnwindSafe, catch_unwind};

use boxmorph::boxdef::{Boundary, BoxDefGraph, Symmetry, own_turn};
use boxmorph::mesh::Mesh;
use common::check::check;
use glam::Vec3;
use nasty::{Nasty, nasty, spread};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::prelude::*;

/// Seeds between those whose graph is also built twice, from given boxes, and turned.
const SAMPLE: u64 = 10;

#[test]
fn a_thousand_nasty_meshes_all_work() {
    let failed: Vec<String> = (0..1000).into_par_iter().filter_map(failure).collect();
    assert!(failed.is_empty(), "{} of 1000 fail:\n{}", failed.len(), failed.join("\n"));
}

/// What goes wrong with a seed's mesh, with all that is needed to see it again.
fn failure(seed: u64) -> Option<String> {
    let Nasty { recipe, mesh } = nasty(seed);
    let mut rng = ChaCha8Rng::seed_from_u64(!seed);
    let modes = Symmetry::ALL;
    let (symmetry, splits) = (modes[rng.random_range(0..modes.len())], rng.random_range(1..9));
    let size = (mesh.vertices().len(), mesh.triangles().len());
    let name = format!("seed {seed} ({recipe}; {size:?}; {splits} splits, {symmetry:?})");
    let tried = catch_unwind(AssertUnwindSafe(|| {
        let graph = check(&name, &mesh, splits, symmetry);
        moves_finitely(&mut rng, &mesh, &graph);
        if seed.is_multiple_of(SAMPLE) {
            let again = BoxDefGraph::build(&mesh, splits, symmetry, Boundary::Smooth).unwrap();
            assert_eq!(bits(&graph), bits(&again), "built twice, it differs");
            assert_eq!(graph, again, "built twice, it differs");
            assert!(own_turn(&mesh).abs() <= 0.8, "it has no turn of its own");
            takes_given_boxes(&mut rng, &mesh, symmetry);
        }
    }));
    let why = tried.err()?;
    let words = why.downcast_ref::<String>().map(String::as_str).or(why.downcast_ref::<&str>().copied());
    Some(format!("{name}: {}", words.unwrap_or("a panic without words")))
}

fn bits(graph: &BoxDefGraph) -> Vec<u32> {
    graph.field().basis().iter().map(|b| b.to_bits()).collect()
}

/// Scales as a search tries them, and the field elsewhere: in, on and far outside the mesh.
fn moves_finitely(rng: &mut ChaCha8Rng, mesh: &Mesh, graph: &BoxDefGraph) {
    let scales: Vec<Vec3> =
        (0..graph.parameter_rows()).map(|_| spread(rng, 1.0) * 1.9 + Vec3::splat(2.0)).collect();
    assert!(graph.deform(&scales).unwrap().iter().all(|p| p.is_finite()), "a vertex goes nowhere");
    let (low, high) = mesh.surface_bounds();
    let reach = ((high - low).max_element() as f32).max(f32::MIN_POSITIVE);
    let vertices = mesh.vertices();
    let mut points: Vec<Vec3> = (0..20)
        .map(|i| {
            let from = vertices[rng.random_range(0..vertices.len())];
            from + spread(rng, 1.0) * reach * [0.0, 1e-3, 0.5, 3.0][i % 4]
        })
        .collect();
    points.extend([Vec3::ZERO, Vec3::splat(1e15), Vec3::splat(-1e15)]);
    let field = graph.field_at(graph.field(), &points).unwrap();
    assert!(field.basis().iter().all(|b| b.is_finite()), "the field elsewhere is not finite");
    assert_eq!(field.deform(&vec![Vec3::ONE; graph.parameter_rows()]), points);
    assert!(field.deform(&scales).iter().all(|p| p.is_finite()), "a point elsewhere goes nowhere");
}

/// Boxes anywhere about the mesh, some without volume.
fn takes_given_boxes(rng: &mut ChaCha8Rng, mesh: &Mesh, symmetry: Symmetry) {
    let (low, high) = mesh.surface_bounds();
    let (middle, half) = (((low + high) * 0.5).as_vec3(), ((high - low) * 0.5).as_vec3());
    let count = rng.random_range(1..9);
    let center: Vec<Vec3> = (0..count).map(|_| middle + spread(rng, 1.2) * half).collect();
    let half_size: Vec<Vec3> = (0..count).map(|_| (spread(rng, 1.0) * half).max(Vec3::ZERO)).collect();
    let graph = BoxDefGraph::from_boxes(mesh, &center, &half_size, symmetry, Boundary::Smooth).unwrap();
    let boxes = graph.box_center().len();
    assert!((1..=count).contains(&boxes), "{boxes} boxes of the {count} that were given");
    assert_eq!(graph.tree_edges().len(), boxes - 1);
    assert!(graph.field().basis().iter().all(|b| b.is_finite()), "the field of given boxes is not finite");
}
