// SPDX-License-Identifier: MIT OR Apache-2.0
//! Colors of triangles.

mod shapes;

use boxmorph::render::{Backend, RenderError, render_colored, render_positions, views_by_name};
use glam::Vec3;
use shapes::{bumpy_ball, cuboid, joined};

#[test]
fn colors_are_lit_as_the_grey_is_and_never_black() {
    let (positions, triangles) = bumpy_ball(40);
    let views = views_by_name("paper").unwrap();
    let plain = render_positions(Backend::Cpu, &positions, &triangles, &views, 64).unwrap();
    let white = vec![[255; 3]; triangles.len()];
    let image = render_colored(Backend::Auto, &positions, &triangles, &white, &views, 64).unwrap();
    for (pixel, plain) in image.chunks_exact(4).zip(plain.chunks_exact(4)) {
        assert_eq!(pixel[3], plain[3]);
        if pixel[3] > 0 {
            let lit = 0.35 * 255.0 + 0.65 / 0.6 * f32::from(plain[0]);
            assert!((f32::from(pixel[0]) - lit).abs() < 1.5, "{pixel:?} of {plain:?}");
            assert_eq!(pixel[1..3], [pixel[0]; 2]);
        }
    }
}

#[test]
fn each_triangle_has_its_own_color() {
    let left = cuboid(Vec3::ZERO, Vec3::ONE);
    let right = cuboid(Vec3::new(4.0, 0.0, 0.0), Vec3::ONE);
    let half = left.1.len();
    let (positions, triangles) = joined(&[left, right]);
    let mut colors = vec![[255, 0, 0]; triangles.len()];
    colors[half..].fill([0, 128, 255]);
    let views = views_by_name("paper").unwrap();
    let image = render_colored(Backend::Cpu, &positions, &triangles, &colors, &views, 96).unwrap();
    let (mut red, mut blue) = (0, 0);
    for pixel in image.chunks_exact(4).filter(|pixel| pixel[3] == 255) {
        if pixel[1..3] == [0, 0] {
            red += 1;
        } else if pixel[0] == 0 {
            let [green, light] = [pixel[1], pixel[2]].map(f32::from);
            assert!((green - light * 128.0 / 255.0).abs() <= 1.0, "{pixel:?}");
            blue += 1;
        }
    }
    assert!(red > 300 && blue > 300, "{red} red and {blue} blue pixels");
}

#[test]
fn colors_that_cannot_be_drawn_are_refused() {
    let (positions, triangles) = cuboid(Vec3::ZERO, Vec3::ONE);
    let views = views_by_name("paper").unwrap();
    let colors = vec![[255; 3]; triangles.len()];
    let refused = |backend, colors: &[[u8; 3]]| {
        render_colored(backend, &positions, &triangles, colors, &views, 64).unwrap_err()
    };
    assert_eq!(refused(Backend::Cpu, &colors[1..]), RenderError::ColorRows { expected: 12, got: 11 });
    let said = refused(Backend::Gpu, &colors).to_string();
    assert_eq!(said, "the renderer \"gpu\" draws no colors: choose \"cpu\" or \"auto\"");
}
