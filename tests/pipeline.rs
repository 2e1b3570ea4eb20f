// SPDX-License-Identifier: MIT OR Apache-2.0
//! From candidates to evaluations: whatever the threads and the company, the same bytes.

mod common;
mod guides;

use boxmorph::boxdef::{Boundary, BoxDefGraph, Symmetry};
use boxmorph::guide::Guide;
use boxmorph::render::{BACKGROUNDS, Backend, composite, premultiply, render_positions, views_by_name};
use boxmorph::search::{Evaluation, ImagePlan, Objective, Preset, Target, Views, Wording};
use common::chair;
use glam::Vec3;

/// Candidates of a graph, each unlike the others.
fn candidates(rows: usize, count: usize) -> Vec<Vec<Vec3>> {
    let factor = |i: usize, j: usize| 0.6 + 0.25 * ((3 * i + 2 * j) % 7) as f32;
    (0..count).map(|i| (0..rows).map(|j| Vec3::new(1.0, factor(i, j), factor(j, i))).collect()).collect()
}

/// Evaluates groups of candidates of a chair, one call each, with one objective.
fn evaluate(guide: &Guide, sizes: &[usize], plan: ImagePlan) -> Vec<Evaluation> {
    let mesh = chair(3).mesh();
    let graph = BoxDefGraph::build(&mesh, 2, Symmetry::Auto, Boundary::Smooth).expect("a chair has parts");
    let target = Target::new(guide, &Wording::plain("a bar stool")).expect("the guide knows stools");
    let views = views_by_name("paper").expect("the paper's views");
    let (field, preset) = (graph.shared_field(), &Preset::STANDARD);
    let mut objective = Objective::new(&mesh, field, guide, &target, Backend::Cpu, &views, preset)
        .expect("the chair can be drawn");
    let mut rest = candidates(graph.parameter_rows(), sizes.iter().sum());
    let mut all = Vec::new();
    for &size in sizes {
        let later = rest.split_off(size);
        all.extend_from_slice(objective.evaluate(&rest, plan).expect("candidates can be evaluated"));
        rest = later;
    }
    assert_eq!(
        objective.images_encoded(),
        all.len() * Views::of(&views, Symmetry::None).pairs(plan, 0).len()
    );
    all
}

#[test]
fn threads_and_company_change_no_evaluation() {
    let Some(guide) = guides::mini() else { return };
    for plan in [ImagePlan::InTurn, ImagePlan::All] {
        let on = |threads: usize, sizes: &[usize]| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| evaluate(&guide, sizes, plan))
        };
        let together = on(1, &[9]);
        assert!(together.windows(2).all(|pair| pair[0] != pair[1]), "candidates differ");
        assert_eq!(together, on(2, &[9]));
        assert_eq!(together, on(3, &[1, 4, 0, 2, 2]));
    }
}

#[test]
fn a_view_before_a_background_embeds_as_the_image_of_both() {
    let Some(guide) = guides::mini() else { return };
    let (mesh, size) = (chair(3).mesh(), guide.image_size());
    let views = views_by_name("ring").expect("the ring of views");
    let mut rgba = render_positions(Backend::Cpu, mesh.vertices(), mesh.triangles(), &views, size)
        .expect("the chair can be drawn");
    let image = (size * size * 4) as usize;
    let mut images = Vec::new();
    for view in rgba.chunks_exact(image) {
        for background in BACKGROUNDS {
            let mut rgb = vec![0; image / 4 * 3];
            composite(view, background, &mut rgb);
            images.extend(rgb);
        }
    }
    let expected = guide.image_embeddings(&images).expect("images embed");
    premultiply(&mut rgba);
    let mut embeddings = vec![7.0; 3];
    guide.view_embeddings(&rgba, &BACKGROUNDS, 3, &mut embeddings).expect("views embed");
    assert_eq!(embeddings.len(), 3 * views.len() * guide.dimension());
    let images = embeddings.chunks_exact(guide.dimension()).zip(expected.chunks_exact(guide.dimension()));
    for (number, (one, other)) in images.enumerate() {
        // Before orange, green is not rounded a second time; before black and white nothing differs.
        let most = if number % 3 == 2 { 5e-3 } else { 1e-5 };
        let apart = one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(apart < most, "image {number}: {apart}");
    }
}
