// SPDX-License-Identifier: MIT OR Apache-2.0
//! A search reuses its buffers: once they are there, nothing the size of one is allocated.
#![allow(unsafe_code, reason = "an allocator that counts has no other way")]

mod common;
mod guides;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use boxmorph::boxdef::{Boundary, BoxDefGraph, Symmetry};
use boxmorph::render::{Backend, open, views_by_name};
use boxmorph::search::{ImagePlan, Objective, Preset, Target, Wording};
use common::chair;
use glam::Vec3;

/// The system's allocator, which counts.
struct Counting;

static BLOCKS: AtomicUsize = AtomicUsize::new(0);
static LARGEST: AtomicUsize = AtomicUsize::new(0);

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        BLOCKS.fetch_add(1, Relaxed);
        LARGEST.fetch_max(layout.size(), Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        unsafe { System.dealloc(block, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Number of blocks that `work` allocates, and bytes of the largest.
fn allocated(work: impl FnOnce()) -> (usize, usize) {
    LARGEST.store(0, Relaxed);
    let before = BLOCKS.load(Relaxed);
    work();
    (BLOCKS.load(Relaxed) - before, LARGEST.load(Relaxed))
}

/// One test, since all threads of the process are counted.
#[test]
fn buffers_are_reused_from_generation_to_generation() {
    let Some(guide) = guides::mini() else { return };
    let mesh = chair(12).mesh();
    let graph = BoxDefGraph::build(&mesh, 2, Symmetry::Auto, Boundary::Smooth).expect("a chair has parts");
    let views = views_by_name("paper").expect("the paper's views");
    let rows = graph.parameter_rows();
    let generation = |k: usize| -> Vec<Vec<Vec3>> {
        (0..14).map(|i| vec![Vec3::splat(0.7 + 0.02 * (i + k) as f32); rows]).collect()
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");

    let renderer = open(Backend::Cpu, graph.shared_field(), mesh.triangles().into(), &views, 64);
    let renderer = renderer.expect("the chair can be drawn");
    let mut images = Vec::new();
    let (first, second) = (generation(0), generation(1));
    let (blocks, _) = pool.install(|| {
        for _ in 0..20 {
            renderer.render(&first, &[0, 1, 2, 3], &mut images).expect("it can be drawn");
        }
        allocated(|| renderer.render(&second, &[0, 1, 2, 3], &mut images).expect("it can be drawn"))
    });
    assert_eq!(blocks, 0, "drawing allocates nothing");

    let target = Target::new(&guide, &Wording::plain("a bar stool")).expect("the guide knows stools");
    let (field, preset) = (graph.shared_field(), &Preset::STANDARD);
    let mut objective = Objective::new(&mesh, field, &guide, &target, Backend::Cpu, &views, preset)
        .expect("the chair can be drawn");
    let (blocks, largest) = pool.install(|| {
        let mut evaluate = |generation: &[Vec<Vec3>]| {
            objective.evaluate(generation, ImagePlan::InTurn).expect("candidates can be evaluated");
        };
        for _ in 0..20 {
            evaluate(&first);
        }
        allocated(|| evaluate(&second))
    });
    // What is left: the lists of the plan, the mean embedding and what a call of ONNX Runtime is wrapped in.
    assert!(largest <= 4096, "a block of {largest} bytes");
    assert!(blocks <= 14 * 40, "{blocks} blocks for 14 candidates");
}
