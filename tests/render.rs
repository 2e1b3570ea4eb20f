// SPDX-License-Identifier: MIT OR Apache-2.0
//! What the images of the CPU backend show.

mod shapes;

use approx::assert_abs_diff_eq;
use boxmorph::boxdef::DeformField;
use boxmorph::render::{
    BACKGROUNDS, Backend, RenderError, View, composite, open, render_positions, views_by_name,
};
use glam::{Quat, Vec3};
use shapes::{Shape, bumpy_ball, cuboid, grid, joined, sphere, wavy_field};
use std::sync::Arc;

/// The first image of the renderer's answer, as pixels.
struct Image {
    size: usize,
    pixels: Vec<[u8; 4]>,
}

impl Image {
    fn of((positions, triangles): &Shape, view: View, size: u32) -> Self {
        let bytes = render_positions(Backend::Cpu, positions, triangles, &[view], size).unwrap();
        let pixels = bytes.chunks_exact(4).map(|p| p.try_into().unwrap()).collect();
        Self { size: size as usize, pixels }
    }

    fn at(&self, x: usize, y: usize) -> [u8; 4] {
        self.pixels[y * self.size + x]
    }

    /// Covered pixels, partly covered ones in part.
    fn area(&self) -> f32 {
        self.pixels.iter().map(|p| f32::from(p[3]) / 255.0).sum()
    }

    /// Mean column and row of what is covered, in −1 to 1, right and up.
    fn middle(&self, wanted: impl Fn([u8; 4]) -> bool) -> [f32; 2] {
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for (i, &pixel) in self.pixels.iter().enumerate() {
            if pixel[3] > 0 && wanted(pixel) {
                sum[0] += (i % self.size) as f32 + 0.5;
                sum[1] += (i / self.size) as f32 + 0.5;
                count += 1.0;
            }
        }
        let half = self.size as f32 / 2.0;
        [sum[0] / count / half - 1.0, 1.0 - sum[1] / count / half]
    }
}

const FRONT: View = View { azimuth: 90.0, elevation: 0.0 };
const RIGHT: View = View { azimuth: 0.0, elevation: 0.0 };
const ABOVE: View = View { azimuth: 90.0, elevation: 90.0 };

/// Half a side of the image, at the distance where the shape's centre is, in radii of the shape.
const HALF_SIDE: f32 = 2.5 * 0.577_350_26;

fn grey(normal: Vec3) -> u8 {
    let value = 0.6 * (0.28209 + 0.48860 * (normal.x + normal.y + normal.z)).clamp(0.0, 1.0);
    (value * 255.0).round() as u8
}

#[test]
fn a_sphere_covers_the_disc_that_geometry_says() {
    let image = Image::of(&sphere(64), FRONT, 224);
    // The silhouette of a unit sphere at distance 2.5 is the cone of angle asin(1 / 2.5).
    let radius = 112.0 * (1.0_f32 / 2.5).asin().tan() / 0.577_350_26;
    let disc = std::f32::consts::PI * radius * radius;
    assert!((image.area() / disc - 1.0).abs() < 0.01, "{} pixels, not {disc}", image.area());
    let [x, y] = image.middle(|_| true);
    assert!(x.abs() < 0.005 && y.abs() < 0.005, "not in the middle: {x}, {y}");
}

#[test]
fn a_cube_seen_from_the_front_covers_its_near_face() {
    let image = Image::of(&cuboid(Vec3::ZERO, Vec3::ONE), FRONT, 224);
    let half = 1.0 / 3.0_f32.sqrt();
    let side = 224.0 * half / (2.5 - half) / 0.577_350_26;
    assert!((image.area() / (side * side) - 1.0).abs() < 0.01, "{} pixels", image.area());
    let [left, right] = [112.0 - side / 2.0, 112.0 + side / 2.0];
    assert_eq!(image.at(left as usize - 1, 112), [0; 4]);
    assert_eq!(image.at(left as usize + 2, 112)[3], 255);
    assert_eq!(image.at(right as usize - 2, 112)[3], 255);
    assert_eq!(image.at(right as usize + 2, 112), [0; 4]);
}

#[test]
fn alpha_is_the_share_of_samples_covered() {
    // Faces without area fix the frame; a small card in the middle ends right on the centres of samples, which
    // count at the left and the top.
    let sample = 2.0 * HALF_SIDE / 128.0;
    let (x0, x1, y0, y1) = (-4.0 * sample, 1.5 * sample, -6.0 * sample, 4.5 * sample);
    let mut positions =
        vec![Vec3::new(x0, 0.0, y0), Vec3::new(x1, 0.0, y0), Vec3::new(x1, 0.0, y1), Vec3::new(x0, 0.0, y1)];
    let mut triangles = vec![[0, 1, 2], [0, 2, 3]];
    for end in [Vec3::X, -Vec3::X, 0.3 * Vec3::Z, -0.3 * Vec3::Z] {
        let first = positions.len() as u32;
        positions.extend([end; 3]);
        triangles.push([first, first + 1, first + 2]);
    }
    let image = Image::of(&(positions, triangles), FRONT, 64);
    // Half a pixel across: two of four samples. The top edge cuts likewise, the corner keeps one.
    assert_eq!(image.at(31, 32)[3], 255);
    assert_eq!(image.at(32, 32)[3], 128);
    assert_eq!(image.at(33, 32)[3], 0);
    assert_eq!(image.at(31, 29)[3], 128);
    assert_eq!(image.at(32, 29)[3], 64);
    assert_eq!(image.at(30, 34)[3], 255);
    assert_eq!(image.at(30, 35)[3], 0);
    assert_eq!(image.at(29, 33)[3], 0);
    // The colour is that of the face, not darkened by the coverage.
    assert_eq!(image.at(32, 29)[..3], image.at(31, 32)[..3]);
}

#[test]
fn neighbours_leave_no_crack_and_no_shade_between_them() {
    let (positions, triangles) = grid(97);
    for tilt in [0.0, 0.3, 1.1] {
        let turn = Quat::from_rotation_y(tilt) * Quat::from_rotation_z(0.2);
        let turned = positions.iter().map(|&p| turn * p).collect();
        let image = Image::of(&(turned, triangles.clone()), ABOVE, 128);
        let greys: Vec<u8> =
            image.pixels.iter().filter(|pixel| pixel[3] == 255).map(|pixel| pixel[0]).collect();
        assert!(greys.len() > 1000);
        assert!(greys.iter().all(|&grey| grey.abs_diff(greys[0]) <= 1));
        for row in image.pixels.chunks_exact(128) {
            // The outline is convex, so that the full pixels of a row follow each other.
            let full: Vec<usize> = (0..128).filter(|&x| row[x][3] == 255).collect();
            assert!(full.windows(2).all(|pair| pair[1] == pair[0] + 1), "a crack in {full:?}");
        }
    }
}

#[test]
fn a_face_has_the_grey_of_its_normal_in_camera_space() {
    // Seen from the front: camera right is +x, up is +z, back is −y.
    for (normal, expected) in [
        (Vec3::new(0.0, -1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)),
        (Vec3::new(0.6, -0.8, 0.0), Vec3::new(0.6, 0.0, 0.8)),
        (Vec3::new(-0.6, -0.8, 0.0), Vec3::new(-0.6, 0.0, 0.8)),
        (Vec3::new(0.0, -0.6, 0.8), Vec3::new(0.0, 0.8, 0.6)),
        (Vec3::new(0.0, -0.28, -0.96), Vec3::new(0.0, -0.96, 0.28)),
    ] {
        let turn = Quat::from_rotation_arc(Vec3::Z, normal);
        let (positions, triangles) = grid(2);
        let image = Image::of(&(positions.iter().map(|&p| turn * p).collect(), triangles), FRONT, 65);
        let [r, g, b, a] = image.at(32, 32);
        assert_eq!([r, g, b, a], [grey(expected), grey(expected), grey(expected), 255], "{normal}");
    }
}

#[test]
fn flipping_the_winding_changes_no_pixel() {
    let (positions, triangles) = bumpy_ball(40);
    let flipped: Vec<_> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let mixed: Vec<_> =
        (0..).zip(&triangles).map(|(i, &[a, b, c])| if i % 3 == 0 { [a, c, b] } else { [a, b, c] }).collect();
    let views = views_by_name("paper").unwrap();
    let render =
        |triangles: &[[u32; 3]]| render_positions(Backend::Cpu, &positions, triangles, &views, 64).unwrap();
    assert!(render(&triangles) == render(&flipped));
    assert!(render(&triangles) == render(&mixed));
}

#[test]
fn where_a_shape_lies_and_how_large_it_is_does_not_show() {
    let (positions, triangles) = bumpy_ball(40);
    let views = views_by_name("paper").unwrap();
    let render = |change: &dyn Fn(Vec3) -> Vec3| {
        let moved: Vec<_> = positions.iter().map(|&p| change(p)).collect();
        render_positions(Backend::Cpu, &moved, &triangles, &views, 64).unwrap()
    };
    let rest = render(&|p| p);
    assert!(rest == render(&|p| 1024.0 * p), "powers of two are exact");
    assert!(rest == render(&|p| p * 2.0_f32.powi(-100)));
    for moved in [render(&|p| p + Vec3::new(3.0, -7.0, 5.0)), render(&|p| p * 0.001), render(&|p| p * 1e30)] {
        let different = rest.iter().zip(&moved).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        assert!(different * 200 < rest.len(), "{different} of {} bytes differ", rest.len());
    }
}

#[test]
fn vertices_that_no_face_uses_count_for_nothing() {
    let (mut positions, triangles) = bumpy_ball(20);
    let views = [FRONT];
    let without = render_positions(Backend::Cpu, &positions, &triangles, &views, 64).unwrap();
    positions.extend([Vec3::splat(1e9), Vec3::NAN]);
    let with = render_positions(Backend::Cpu, &positions, &triangles, &views, 64).unwrap();
    assert!(without == with);
}

#[test]
fn a_finer_tessellation_does_not_move_the_shape() {
    let coarse = joined(&[grid(3), cuboid(Vec3::Z, Vec3::splat(0.2))]);
    let fine = joined(&[grid(33), cuboid(Vec3::Z, Vec3::splat(0.2))]);
    let view = View { azimuth: 30.0, elevation: 30.0 };
    assert!(Image::of(&coarse, view, 64).pixels == Image::of(&fine, view, 64).pixels);
}

#[test]
fn things_appear_where_the_camera_geometry_says() {
    // A bar along x with a block at its +x end.
    let arrow = joined(&[
        cuboid(Vec3::ZERO, Vec3::new(1.0, 0.05, 0.05)),
        cuboid(Vec3::new(0.8, 0.0, 0.0), Vec3::splat(0.2)),
    ]);
    let side = |azimuth: f32| Image::of(&arrow, View { azimuth, elevation: 20.0 }, 64).middle(|_| true)[0];
    assert!(side(90.0) > 0.1, "+x is right, seen from the front");
    assert!(side(-90.0) < -0.1, "and left, seen from the back");
    assert!(side(45.0) > 0.05 && side(-45.0) < -0.05, "and so from between");

    // A block on top, and nearer things larger: a block at −y is near in front views.
    let tower = joined(&[
        cuboid(Vec3::ZERO, Vec3::new(0.05, 0.05, 1.0)),
        cuboid(Vec3::new(0.0, 0.0, 0.8), Vec3::splat(0.2)),
    ]);
    for view in [FRONT, RIGHT, View { azimuth: -135.0, elevation: 45.0 }] {
        assert!(Image::of(&tower, view, 64).middle(|_| true)[1] > 0.1, "+z is up in {view:?}");
    }
    let pair = joined(&[
        cuboid(Vec3::new(-0.5, -0.5, 0.0), Vec3::splat(0.2)),
        cuboid(Vec3::new(0.5, 0.5, 0.0), Vec3::splat(0.2)),
    ]);
    assert!(Image::of(&pair, FRONT, 64).middle(|_| true)[0] < -0.03, "the near block is at −x and larger");
    assert!(Image::of(&pair, View { azimuth: -90.0, elevation: 0.0 }, 64).middle(|_| true)[0] < -0.03);
}

#[test]
fn the_nearer_of_two_faces_is_seen() {
    // A card in front of a larger one, tilted so that their greys differ.
    let turned = |(positions, triangles): Shape, y: f32, scale: f32, tilt: f32| {
        let turn = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2) * Quat::from_rotation_y(tilt);
        (positions.iter().map(|&p| turn * p * scale + Vec3::new(0.0, y, 0.0)).collect(), triangles)
    };
    let near = turned(grid(5), -0.5, 0.3, 0.4);
    let far = turned(grid(5), 0.5, 0.8, 0.0);
    for order in [[near.clone(), far.clone()], [far, near]] {
        let image = Image::of(&joined(&order), FRONT, 64);
        assert_eq!(image.at(24, 22)[0], grey(Vec3::Z), "the far card");
        let turned = grey(Vec3::new(0.4_f32.sin(), 0.0, 0.4_f32.cos()));
        assert_eq!(image.at(32, 31)[0], turned, "the near card");
    }
}

#[test]
fn views_have_names_and_an_order() {
    let paper = views_by_name("paper").unwrap();
    assert_eq!(paper, [45.0, -45.0, -135.0, 135.0].map(|azimuth| View { azimuth, elevation: 45.0 }));
    assert_eq!(views_by_name("ring").unwrap().len(), 8);
    assert_eq!(
        views_by_name("beside").unwrap_err().to_string(),
        "unknown views \"beside\": choose \"paper\", \"ring\" or \"front right\""
    );
}

#[test]
fn candidates_are_deformed_and_laid_out_in_order() {
    let (positions, triangles) = cuboid(Vec3::ZERO, Vec3::ONE);
    // One parameter row that scales all about the origin.
    let basis = (0..3).flat_map(|axis| positions.iter().map(move |p| p[axis])).collect();
    let field = Arc::new(DeformField::new(positions.clone(), 1, basis));
    let views = [FRONT, RIGHT];
    let renderer = open(Backend::Cpu, field, triangles.clone().into(), &views, 32).unwrap();
    assert_eq!((renderer.views(), renderer.size(), renderer.backend_name().as_str()), (2, 32, "cpu"));
    let candidates = [Vec3::ONE, Vec3::new(0.5, 1.0, 1.0), Vec3::new(1.0, 1.0, 2.5)];
    let mut out = vec![7; 3];
    renderer.render(&candidates.map(|scales| vec![scales]), &[0, 1], &mut out).unwrap();
    assert_eq!(out.len(), 3 * 2 * 32 * 32 * 4);
    for (scales, images) in candidates.iter().zip(out.chunks_exact(2 * 32 * 32 * 4)) {
        let scaled: Vec<_> = positions.iter().map(|&p| p * *scales).collect();
        assert!(images == render_positions(Backend::Cpu, &scaled, &triangles, &views, 32).unwrap());
    }
    // Buffers are reused: fewer and smaller shapes leave nothing behind.
    renderer.render(&[vec![candidates[1]]], &[0, 1], &mut out).unwrap();
    let scaled: Vec<_> = positions.iter().map(|&p| p * candidates[1]).collect();
    assert!(out == render_positions(Backend::Cpu, &scaled, &triangles, &views, 32).unwrap());
}

#[test]
fn only_the_views_asked_for_are_drawn_in_the_order_given() {
    let (positions, triangles) = bumpy_ball(20);
    let field = Arc::new(wavy_field(positions, 1));
    let views = views_by_name("paper").unwrap();
    let renderer = open(Backend::Cpu, field, triangles.into(), &views, 32).unwrap();
    let candidates = [vec![Vec3::ONE], vec![Vec3::new(0.5, 1.0, 2.0)]];
    let draw = |views: &[usize]| {
        let mut out = Vec::new();
        renderer.render(&candidates, views, &mut out).unwrap();
        out
    };
    let (all, some) = (draw(&[0, 1, 2, 3]), draw(&[2, 0]));
    let image =
        |images: usize, index: usize| images + index * 32 * 32 * 4..images + (index + 1) * 32 * 32 * 4;
    for candidate in 0..2 {
        let (of_all, of_some) = (all.len() / 2 * candidate, some.len() / 2 * candidate);
        assert!(some[image(of_some, 0)] == all[image(of_all, 2)]);
        assert!(some[image(of_some, 1)] == all[image(of_all, 0)]);
    }
    assert!(draw(&[]).is_empty());
}

#[test]
fn one_thread_and_two_draw_the_same_bytes() {
    let (positions, triangles) = bumpy_ball(60);
    let field = Arc::new(wavy_field(positions, 3));
    let candidates: Vec<Vec<Vec3>> =
        (0..5).map(|i| (0..3).map(|j| Vec3::splat(0.6 + 0.3 * ((i * 2 + j) % 5) as f32)).collect()).collect();
    let draw = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let views = views_by_name("paper").unwrap();
        let renderer = open(Backend::Cpu, field.clone(), triangles.clone().into(), &views, 48).unwrap();
        let mut out = Vec::new();
        pool.install(|| renderer.render(&candidates, &[0, 1, 2, 3], &mut out)).unwrap();
        out
    };
    let one = draw(1);
    assert!(one == draw(2));
    assert!(one.chunks_exact(4).any(|pixel| pixel[3] == 255));
}

#[test]
fn compositing_mixes_by_alpha_and_rounds_to_nearest() {
    let rgba = [200, 100, 0, 255, 200, 100, 0, 0, 200, 100, 0, 128, 255, 255, 255, 64];
    let mut rgb = [0; 12];
    composite(&rgba, [255, 128, 10], &mut rgb);
    assert_eq!(rgb[..3], [200, 100, 0]);
    assert_eq!(rgb[3..6], [255, 128, 10]);
    for (channel, (c, b)) in [(200.0, 255.0), (100.0, 128.0), (0.0, 10.0_f32)].into_iter().enumerate() {
        let mixed = (c * 128.0 + b * 127.0) / 255.0_f32;
        assert_abs_diff_eq!(f32::from(rgb[6 + channel]), mixed.round(), epsilon = 0.0);
    }
    for background in BACKGROUNDS {
        composite(&[90, 90, 90, 0], background, &mut rgb[..3]);
        assert_eq!(rgb[..3], background);
    }
}

#[test]
fn shapes_without_area_give_empty_images() {
    let flat = vec![[0, 1, 2]];
    for positions in [
        vec![Vec3::splat(2.0); 3],
        vec![Vec3::ZERO, Vec3::X, 2.0 * Vec3::X],
        vec![Vec3::ZERO, Vec3::X * f32::MIN_POSITIVE * 1e-3, Vec3::ZERO],
    ] {
        let image = render_positions(Backend::Cpu, &positions, &flat, &[FRONT], 16).unwrap();
        assert!(image.iter().all(|&byte| byte == 0));
    }
}

#[test]
fn what_cannot_be_drawn_is_said_in_a_sentence() {
    let (positions, triangles) = cuboid(Vec3::ZERO, Vec3::ONE);
    let error = |positions: &[Vec3], triangles: &[[u32; 3]], views: &[View], size| {
        render_positions(Backend::Cpu, positions, triangles, views, size).unwrap_err().to_string()
    };
    for size in [0, 7, 2049] {
        let said = error(&positions, &triangles, &[FRONT], size);
        assert_eq!(
            said,
            format!("an image size of {size} pixels is not possible: choose one from 8 to 2048")
        );
    }
    assert!(error(&positions, &triangles, &[], 64).starts_with("there are no views"));
    assert!(error(&positions, &[], &[FRONT], 64).starts_with("the mesh has no faces"));
    assert!(error(&positions, &[[0, 1, 8]], &[FRONT], 64).starts_with("triangle 0 refers to vertex 8"));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let mut broken = positions.clone();
        broken[3].y = bad;
        assert!(
            error(&broken, &triangles, &[FRONT], 64).starts_with("candidate 0 has vertices at positions")
        );
    }
    assert!("blender".parse::<Backend>().unwrap_err().to_string().contains("choose \"auto\""));
    assert_eq!("gpu".parse(), Ok(Backend::Gpu));

    let field = Arc::new(wavy_field(positions, 2));
    let renderer = open(Backend::Cpu, field, triangles.into(), &[FRONT], 16).unwrap();
    let good = vec![Vec3::ONE; 2];
    let short = renderer.render(&[good.clone(), vec![Vec3::ONE]], &[0], &mut Vec::new());
    assert_eq!(short, Err(RenderError::ScaleRows { candidate: 1, expected: 2, got: 1 }));
    let broken = renderer.render(&[good.clone(), good, vec![Vec3::NAN; 2]], &[0], &mut Vec::new());
    assert_eq!(broken, Err(RenderError::NonFinite { candidate: 2 }));
}
