// SPDX-License-Identifier: MIT OR Apache-2.0
//! The `wgpu` backend against the CPU's, on whatever adapter there is.

mod shapes;

use boxmorph::render::{BACKGROUNDS, Backend, RenderError, Renderer, composite, open, views_by_name};
use glam::Vec3;
use shapes::{Shape, bumpy_ball, cuboid, joined, wavy_field};
use std::sync::Arc;

const ROWS: usize = 3;

/// All of them.
const VIEWS: [usize; 4] = [0, 1, 2, 3];

fn renderer((positions, triangles): Shape, backend: Backend, size: u32) -> Option<Box<dyn Renderer>> {
    let field = Arc::new(wavy_field(positions, ROWS));
    match open(backend, field, triangles.into(), &views_by_name("paper").unwrap(), size) {
        Ok(renderer) => Some(renderer),
        Err(error @ RenderError::NoAdapter { .. }) => {
            skip(&error);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

#[expect(clippy::print_stderr, reason = "a skipped test says why")]
fn skip(error: &RenderError) {
    assert!(error.to_string().starts_with("No GPU adapter was found (tried "));
    eprintln!("skipped: {error}");
}

fn candidates(count: usize) -> Vec<Vec<Vec3>> {
    let scale = |i: usize, j: usize, k: usize| 0.5 + 0.4 * ((5 * i + 3 * j + 2 * k) % 6) as f32;
    (0..count)
        .map(|i| (0..ROWS).map(|j| Vec3::new(scale(i, j, 0), scale(i, j, 1), scale(i, j, 2))).collect())
        .collect()
}

/// Many small triangles, some large ones, and faces that pass through each other.
fn scene() -> Shape {
    joined(&[
        bumpy_ball(60),
        cuboid(Vec3::new(0.5, 0.2, -0.9), Vec3::new(0.2, 0.9, 0.1)),
        cuboid(Vec3::new(-0.8, 0.3, 0.4), Vec3::new(0.8, 0.05, 0.3)),
    ])
}

#[test]
fn both_backends_draw_the_same_images() {
    for size in [33, 64, 224] {
        let Some(gpu) = renderer(scene(), Backend::Gpu, size) else { return };
        assert!(gpu.backend_name().starts_with("gpu: "), "{}", gpu.backend_name());
        let cpu = renderer(scene(), Backend::Cpu, size).unwrap();
        let candidates = candidates(3);
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        cpu.render(&candidates, &VIEWS, &mut ours).unwrap();
        gpu.render(&candidates, &VIEWS, &mut theirs).unwrap();
        assert_eq!(ours.len(), theirs.len());
        assert!(ours.chunks_exact(4).filter(|pixel| pixel[3] == 255).count() > 12 * size as usize);
        for background in BACKGROUNDS {
            let flat = |rgba: &[u8]| {
                let mut rgb = vec![0; rgba.len() / 4 * 3];
                composite(rgba, background, &mut rgb);
                rgb
            };
            let (ours, theirs) = (flat(&ours), flat(&theirs));
            let total: u64 = ours.iter().zip(&theirs).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
            let pixels = ours.len() / 3;
            let beyond = |limit: u8| {
                let pairs = ours.chunks_exact(3).zip(theirs.chunks_exact(3));
                pairs.filter(|(a, b)| (0..3).any(|i| a[i].abs_diff(b[i]) > limit)).count()
            };
            let (any, more) = (beyond(0), beyond(2));
            let mean = total as f64 / ours.len() as f64;
            assert!(mean <= 1.0, "mean difference {mean} at {size}");
            assert!(more * 100 <= pixels, "{more} of {pixels} pixels differ by more than 2, {any} at all");
        }
    }
}

#[test]
fn a_call_of_many_candidates_draws_each_as_a_call_of_its_own() {
    let ball = || bumpy_ball(12);
    let Some(gpu) = renderer(ball(), Backend::Gpu, 500) else { return };
    // 24 tiles of 1000 samples a side are more than one atlas holds.
    let candidates = candidates(6);
    let mut all = Vec::new();
    gpu.render(&candidates, &VIEWS, &mut all).unwrap();
    let mut one = Vec::new();
    for (candidate, images) in candidates.iter().zip(all.chunks_exact(all.len() / 6)) {
        gpu.render(std::slice::from_ref(candidate), &VIEWS, &mut one).unwrap();
        let different = one.iter().zip(images).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        // Where a tile lies in the atlas moves a vertex by less than a rounding.
        assert!(different * 1000 <= images.len(), "{different} of {} bytes", images.len());
    }
    gpu.render(&[], &VIEWS, &mut all).unwrap();
    assert!(all.is_empty());
}

#[test]
fn only_the_views_asked_for_are_drawn_in_the_order_given() {
    let Some(gpu) = renderer(scene(), Backend::Gpu, 64) else { return };
    let candidates = candidates(2);
    let (mut some, mut all) = (Vec::new(), Vec::new());
    gpu.render(&candidates, &[2, 0], &mut some).unwrap();
    gpu.render(&candidates, &VIEWS, &mut all).unwrap();
    let (some, all): (Vec<_>, Vec<_>) =
        (some.chunks_exact(64 * 64 * 4).collect(), all.chunks_exact(64 * 64 * 4).collect());
    for (drawn, asked) in some.iter().zip([2, 0, 6, 4]) {
        let different = drawn.iter().zip(all[asked]).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        assert!(different * 1000 <= drawn.len(), "{different} of {} bytes", drawn.len());
    }
    assert_eq!(some.len(), 4);
}

#[test]
fn the_same_call_gives_the_same_bytes() {
    let Some(gpu) = renderer(scene(), Backend::Gpu, 64) else { return };
    let candidates = candidates(4);
    let (mut first, mut second) = (Vec::new(), Vec::new());
    gpu.render(&candidates, &VIEWS, &mut first).unwrap();
    gpu.render(&candidates, &VIEWS, &mut second).unwrap();
    assert!(first == second);
}

#[test]
fn positions_that_are_not_finite_are_an_error_and_the_renderer_lives_on() {
    let Some(gpu) = renderer(scene(), Backend::Gpu, 64) else { return };
    let good = candidates(3);
    let (mut before, mut after) = (Vec::new(), Vec::new());
    gpu.render(&good, &VIEWS, &mut before).unwrap();
    for bad in [f32::NAN, f32::INFINITY] {
        let mut broken = good.clone();
        broken[1][0].x = bad;
        assert_eq!(gpu.render(&broken, &VIEWS, &mut after), Err(RenderError::NonFinite { candidate: 1 }));
    }
    gpu.render(&good, &VIEWS, &mut after).unwrap();
    assert!(before == after);
}

#[test]
fn auto_draws_on_the_cpu_where_the_adapter_is_software() {
    let Some(gpu) = renderer(scene(), Backend::Gpu, 64) else { return };
    let auto = renderer(scene(), Backend::Auto, 64).unwrap();
    let is_software = ["llvmpipe", "SwiftShader", "softpipe"].iter().any(|n| gpu.backend_name().contains(n));
    assert_eq!(auto.backend_name() == "cpu", is_software, "{}", gpu.backend_name());
}
