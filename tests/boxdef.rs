// SPDX-License-Identifier: MIT OR Apache-2.0
//! Parts, graph and field of made objects: what a user would notice.

mod common;

use boxmorph::boxdef::{Boundary, BoxDefError, BoxDefGraph, Parts, Symmetry, own_turn, turned};
use boxmorph::mesh::Mesh;
use common::{Maker, aeroplane, ball, bottle, chair, cone, lamp, lopsided, plain_box, sofa, table, v};
use glam::Vec3;

fn build(mesh: &Mesh, splits: u32) -> BoxDefGraph {
    BoxDefGraph::build(mesh, splits, Symmetry::Auto, Boundary::Smooth).expect("every valid mesh has a graph")
}

fn sides(graph: &BoxDefGraph) -> [usize; 3] {
    [0, 1, 2].map(|side| graph.box_side().iter().filter(|&&s| s == side).count())
}

/// Scale factors that differ from row to row and from axis to axis.
fn some_scales(rows: usize, seed: u32) -> Vec<Vec3> {
    let number = |k: usize| {
        let mixed = (k as u32 + 1).wrapping_mul(2_654_435_761).wrapping_add(seed.wrapping_mul(40_503)) >> 8;
        0.3 + 2.5 * (mixed % 1000) as f32 / 1000.0
    };
    (0..rows).map(|r| Vec3::new(number(3 * r), number(3 * r + 1), number(3 * r + 2))).collect()
}

#[test]
fn a_table_of_islands_has_a_top_and_four_legs() {
    let mesh = table(2).mesh();
    let graph = build(&mesh, 3);
    assert_eq!(sides(&graph), [1, 1, 3], "a top, and a leg with three mirror images");
    assert_eq!((graph.symmetry(), graph.parameter_rows()), (Symmetry::Xy, 2), "four legs scale alike");
    for leg in 1..5 {
        let half = graph.box_half_size()[leg];
        assert!(half.x < 0.06 && half.y < 0.06 && (half.z - 0.35).abs() < 0.02, "leg {leg}: {half}");
    }
    // Nothing is left that is worth a cut, whatever the budget.
    assert_eq!(build(&mesh, 8).box_center(), graph.box_center());
}

#[test]
fn a_chair_has_a_seat_a_back_and_four_legs_however_coarse() {
    for n in [1, 3] {
        let mesh = chair(n).mesh();
        let graph = build(&mesh, 4);
        assert_eq!(sides(&graph), [2, 2, 2], "{n} quads a side: seat, back, two pairs of legs");
        // No island is sliced: all vertices of one cuboid have one owner.
        let legs = &graph.assignment()[..mesh.vertices().len() - (build_counts(n * 2) * 2)];
        for leg in legs.chunks(build_counts(n)) {
            assert!(leg.iter().all(|&owner| owner == leg[0]), "a leg of {n} quads a side is sliced");
        }
    }
}

/// Vertices of a cuboid of n quads a side.
fn build_counts(n: u32) -> usize {
    ((n + 1).pow(3) - (n - 1).pow(3)) as usize
}

#[test]
fn an_aeroplane_has_wings_apart_from_its_body() {
    let graph = build(&aeroplane().mesh(), 4);
    assert!(sides(&graph)[1] >= 2, "wings and tail wings: {:?}", graph.box_center());
    let fin = graph.box_half_size().iter().position(|half| half.x < 0.02).expect("the fin is a part");
    assert!(graph.assignment().contains(&(fin as i32)), "the fin has vertices");
    let body = graph.box_half_size()[graph.tree_edges()[0][0] as usize];
    assert!(body.y > 0.9 && body.x < 0.15, "the body is the root: {body}");
}

#[test]
fn round_and_upholstered_things_have_the_parts_that_one_would_name() {
    let lamp = build(&lamp(), 2);
    assert_eq!(sides(&lamp), [3, 0, 0], "base, stem and shade: {:?}", lamp.box_half_size());
    let bottle = build(&bottle(), 1);
    assert_eq!(sides(&bottle), [2, 0, 0], "body and neck: {:?}", bottle.box_half_size());
    let sofa = build(&sofa(), 5);
    assert_eq!(sides(&sofa), [2, 2, 2], "seat, back, arms, feet: {:?}", sofa.box_half_size());
    assert!(sofa.box_half_size().iter().any(|half| half.z < 0.07), "the feet are parts of their own");
}

#[test]
fn what_has_no_parts_stays_whole() {
    for (name, mesh) in [("box", plain_box()), ("ball", ball()), ("cone", cone())] {
        let graph = build(&mesh, 8);
        assert_eq!(graph.box_center().len(), 1, "{name}: {:?}", graph.box_half_size());
        assert_eq!(graph.parameter_rows(), 1);
        assert!(graph.tree_edges().is_empty() && graph.edges().is_empty());
        let (scale, start) = (v(2.0, 1.0, 0.5), mesh.surface_bounds());
        let (center, out) = ((start.0 + start.1) * 0.5, graph.deform(&[scale]).unwrap());
        for (moved, &rest) in out.iter().zip(mesh.vertices()) {
            let expected = center + (rest.as_dvec3() - center) * scale.as_dvec3();
            assert!(moved.as_dvec3().distance(expected) < 1e-5, "{name} is scaled about its middle");
        }
    }
}

#[test]
fn walls_all_around_stay_whole() {
    let mut cup = Maker::default();
    let outside = [(0.0, 0.0), (0.35, 0.0), (0.4, 1.0)];
    cup.lathe(Vec3::ZERO, 48, &[&outside[..], &[(0.36, 1.0), (0.31, 0.05), (0.0, 0.05)]].concat());
    let cup = build(&cup.mesh(), 8);
    // The bottom may be a part, a slice of the wall may not.
    assert!(
        cup.box_half_size().iter().all(|half| half.x > 0.35 && half.y > 0.35),
        "{:?}",
        cup.box_half_size()
    );
    let mut bookcase = Maker::default();
    for side in [-0.4, 0.36] {
        bookcase.cuboid(v(side, -0.15, 0.0), v(side + 0.04, 0.15, 1.2), 2);
    }
    for shelf in [0.0, 0.4, 0.8, 1.16] {
        bookcase.cuboid(v(-0.36, -0.15, shelf), v(0.36, 0.15, shelf + 0.04), 2);
    }
    let bookcase = build(&bookcase.mesh(), 8);
    assert_eq!(bookcase.box_center().len(), 1, "a bookcase: {:?}", bookcase.box_half_size());
}

#[test]
fn a_box_does_not_reach_through_the_air_for_scraps() {
    let mut plane = aeroplane();
    // Wide wings and a high fin, so that the first cut is above the body, through the tips of the wings.
    plane.cuboid(v(-1.2, -0.6, -0.02), v(1.2, 0.6, 0.02), 6);
    plane.cuboid(v(-0.015, 0.7, 0.12), v(0.015, 1.0, 0.9), 4);
    for side in [-1.0, 1.0] {
        plane.cuboid(v(side * 0.97 - 0.03, -0.05, 0.0), v(side * 0.97 + 0.03, 0.05, 0.17), 1);
    }
    for splits in 1..=8 {
        let graph = build(&plane.clone().mesh(), splits);
        for (center, half) in graph.box_center().iter().zip(graph.box_half_size()) {
            let holds_wings = center.z - half.z < 0.05;
            assert!(
                holds_wings || half.x < 0.5,
                "{splits} splits: a box from wing tip to wing tip: {center} {half}"
            );
        }
    }
}

#[test]
fn symmetry_is_found_on_x_and_y_and_only_there() {
    let x_and_y = table(1).mesh();
    assert_eq!(build(&x_and_y, 2).symmetry(), Symmetry::Xy);
    let turned = chair(1).moved(|p| v(p.y, p.x, p.z)).mesh();
    assert_eq!(build(&turned, 2).symmetry(), Symmetry::Y);
    let on_z = chair(1).moved(|p| v(p.y, p.z, p.x)).mesh();
    assert_eq!(build(&on_z, 2).symmetry(), Symmetry::None, "what is above is never taken for what is below");
    let asked = BoxDefGraph::build(&on_z, 4, Symmetry::Z, Boundary::Smooth).unwrap();
    assert_eq!((asked.symmetry(), sides(&asked)), (Symmetry::Z, [2, 2, 2]));
    let none = build(&lopsided().mesh(), 3);
    assert_eq!((none.symmetry(), sides(&none)[1]), (Symmetry::None, 0));
    let off = BoxDefGraph::build(&x_and_y, 3, Symmetry::None, Boundary::Smooth).unwrap();
    assert_eq!(sides(&off)[1..], [0, 0], "every leg has parameters of its own when symmetry is off");
}

#[test]
fn scales_of_one_give_the_input_back_bit_for_bit() {
    let mesh = chair(2).moved(|p| p * 0.37 + v(3.1, -7.7, 0.2)).mesh();
    let graph = build(&mesh, 4);
    let out = graph.deform(&vec![Vec3::ONE; graph.parameter_rows()]).unwrap();
    assert_eq!(out, mesh.vertices());
}

#[test]
fn a_deformation_is_linear_and_crosses_no_axis() {
    let mesh = aeroplane().mesh();
    let graph = build(&mesh, 4);
    let (a, b) = (some_scales(graph.parameter_rows(), 1), some_scales(graph.parameter_rows(), 2));
    let (out_a, out_b) = (graph.deform(&a).unwrap(), graph.deform(&b).unwrap());
    let middle: Vec<Vec3> = a.iter().zip(&b).map(|(a, b)| (*a + *b) * 0.5).collect();
    for ((a, b), m) in out_a.iter().zip(&out_b).zip(graph.deform(&middle).unwrap()) {
        assert!(((*a + *b) * 0.5).distance(m) < 2e-6 * 4.0);
    }
    let only_x: Vec<Vec3> = a.iter().map(|s| v(s.x, 1.0, 1.0)).collect();
    for (moved, rest) in graph.deform(&only_x).unwrap().iter().zip(mesh.vertices()) {
        assert_eq!((moved.y, moved.z), (rest.y, rest.z));
    }
}

/// Four posts, apart from each other.
fn posts() -> Maker {
    let mut m = Maker::default();
    m.cuboid(v(0.3, 0.2, 0.0), v(0.4, 0.3, 1.0), 2);
    m.mirrored(0).mirrored(1)
}

/// A hub with an arm to each side, of one length along x and of another along y.
fn cross() -> Maker {
    let mut m = Maker::default();
    m.cuboid(v(0.2, -0.06, 0.44), v(1.0, 0.06, 0.56), 3).cuboid(v(-0.06, 0.2, 0.44), v(0.06, 0.7, 0.56), 3);
    let mut m = m.mirrored(0).mirrored(1);
    m.cuboid(v(-0.2, -0.2, 0.0), v(0.2, 0.2, 1.0), 4);
    m
}

#[test]
fn a_symmetric_mesh_stays_symmetric_bit_for_bit_and_closed_at_the_planes() {
    let cases = [
        (chair(2), Symmetry::X),
        (aeroplane(), Symmetry::X),
        (table(3), Symmetry::Xy),
        (posts(), Symmetry::Xy),
        (cross(), Symmetry::Xy),
    ];
    for (maker, symmetry) in cases {
        let mesh = maker.mesh();
        let graph = build(&mesh, 5);
        assert_eq!(graph.symmetry(), symmetry);
        let out = graph.deform(&some_scales(graph.parameter_rows(), 3)).unwrap();
        for &axis in symmetry.axes() {
            let mirrored = |mut p: Vec3| {
                p[axis] = -p[axis];
                p
            };
            let mut pairs = 0;
            for (i, &p) in mesh.vertices().iter().enumerate() {
                let image = mesh.vertices().iter().position(|&q| q == mirrored(p));
                let Some(j) = image else { continue };
                assert_eq!(out[j], mirrored(out[i]), "vertices {i} and {j}");
                if p[axis] == 0.0 {
                    assert!(out[i][axis].abs() <= 0.0, "vertex {i} leaves the plane");
                }
                pairs += 1;
            }
            assert!(pairs > mesh.vertices().len() * 9 / 10, "the mesh is its own mirror image");
        }
    }
}

#[test]
fn what_mirrors_about_two_planes_shares_its_parameters_four_times() {
    let posts = build(&posts().mesh(), 4);
    assert_eq!((sides(&posts), posts.parameter_rows()), ([0, 1, 3], 1), "a post and three images");
    let cross = build(&cross().mesh(), 4);
    assert_eq!((sides(&cross), cross.parameter_rows()), ([1, 2, 2], 3), "a hub, two arms twice");
    // One axis is enough where one is asked for.
    let table = BoxDefGraph::build(&table(2).mesh(), 3, Symmetry::X, Boundary::Smooth).unwrap();
    assert_eq!((sides(&table), table.parameter_rows()), ([1, 2, 2], 3));
}

/// A hammer of one piece: a head across the end of a handle.
fn hammer() -> Mesh {
    let mut m = Maker::default();
    let handle = [(0.0, 0.0), (0.06, 0.0), (0.06, 0.2), (0.06, 0.4), (0.06, 0.6), (0.06, 0.72), (0.06, 0.8)];
    let head = [(0.1, 0.8), (0.2, 0.8), (0.3, 0.8), (0.3, 0.85), (0.3, 0.95), (0.3, 1.0), (0.0, 1.0)];
    m.lathe(Vec3::ZERO, 32, &[&handle[..], &head[..]].concat());
    m.mesh()
}

#[test]
fn the_smooth_boundary_spreads_what_the_papers_leaves_to_one_edge() {
    let mesh = hammer();
    let worst = |boundary| {
        let graph = BoxDefGraph::build(&mesh, 1, Symmetry::Auto, boundary).unwrap();
        assert_eq!(graph.parameter_rows(), 2);
        let owner = |i: u32| graph.assignment()[i as usize];
        let mut scales = vec![Vec3::ONE; 2];
        // The handle grows as thick as the head.
        scales[graph.parameter_row_of_box()[owner(0) as usize]] = v(4.0, 4.0, 1.0);
        let out = graph.deform(&scales).unwrap();
        let edges = mesh.triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let crossing = edges.filter(|&[a, b]| owner(a) != owner(b));
        let length = |at: &[Vec3], [a, b]: [u32; 2]| at[a as usize].distance(at[b as usize]);
        crossing.map(|edge| length(&out, edge) / length(mesh.vertices(), edge)).fold(0.0, f32::max)
    };
    let (smooth, paper) = (worst(Boundary::Smooth), worst(Boundary::Paper));
    assert!(smooth < 0.7 * paper, "an edge stretches {smooth}-fold, {paper}-fold with the paper's step");
}

#[test]
fn what_is_scaled_alike_is_only_scaled() {
    let mesh = chair(2).mesh();
    let graph = build(&mesh, 4);
    let (low, high) = mesh.surface_bounds();
    let center = ((low + high) * 0.5).as_vec3();
    let scale = v(1.5, 0.8, 1.2);
    for (moved, &rest) in
        graph.deform(&vec![scale; graph.parameter_rows()]).unwrap().iter().zip(mesh.vertices())
    {
        assert!(moved.distance(center + (rest - center) * scale) < 1e-5, "{rest} goes to {moved}");
    }
}

#[test]
fn parts_stay_attached_when_one_is_scaled() {
    let mesh = table(2).mesh();
    let graph = build(&mesh, 3);
    let mut scales = vec![Vec3::ONE; graph.parameter_rows()];
    scales[1].z = 2.0;
    scales[0].x = 1.5;
    let out = graph.deform(&scales).unwrap();
    let top_bottom = bounds(&graph, &out, 0).0.z;
    for leg in 1..5 {
        let (low, high) = bounds(&graph, &out, leg);
        assert!(
            (high.z - top_bottom).abs() < 0.03,
            "leg {leg} ends at {}, the top begins at {top_bottom}",
            high.z
        );
        assert!(
            (low.x.abs().max(high.x.abs()) - 1.325).abs() < 0.06,
            "leg {leg} keeps its place under the top"
        );
    }
}

fn bounds(graph: &BoxDefGraph, positions: &[Vec3], part: i32) -> (Vec3, Vec3) {
    let owned = positions.iter().zip(graph.assignment()).filter(|&(_, &owner)| owner == part);
    owned.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), (&p, _)| (low.min(p), high.max(p)))
}

#[test]
fn place_and_unit_change_nothing() {
    let reference = build(&chair(2).mesh(), 4);
    for (scale, shift) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 100.0), (0.0254, -3.0)] {
        let graph = build(&chair(2).moved(|p| p * scale + Vec3::splat(shift)).mesh(), 4);
        assert_eq!(graph.box_side(), reference.box_side(), "scale {scale}, shift {shift}");
        assert_eq!(graph.assignment(), reference.assignment());
        assert_eq!(graph.tree_edges(), reference.tree_edges());
        let pairs = graph.field().basis().iter().zip(reference.field().basis());
        let mut errors: Vec<f32> = pairs.map(|(a, b)| (a / scale - b).abs()).collect();
        errors.sort_by(f32::total_cmp);
        // Rounding may turn a tie between two equally near vertices: few, and by little.
        let (most, worst) = (errors[errors.len() * 98 / 100], errors[errors.len() - 1]);
        assert!(most < 1e-4 && worst < 0.02, "scale {scale}, shift {shift}: {most}, {worst}");
    }
}

#[test]
fn one_thread_and_two_give_the_same_bytes() {
    let mesh = aeroplane().mesh();
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| build(&mesh, 5))
    };
    let (one, two) = (on(1), on(2));
    assert_eq!(one, two);
    let bits = |g: &BoxDefGraph| g.field().basis().iter().map(|b| b.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&one), bits(&two));
}

#[test]
fn the_field_at_the_vertices_is_the_field() {
    let mesh = chair(3).mesh();
    let graph = build(&mesh, 4);
    assert_eq!(graph.field_at(graph.field(), mesh.vertices()).unwrap(), *graph.field());
}

#[test]
fn the_field_at_other_points_is_symmetric_and_moves_with_the_parts() {
    let mesh = table(4).mesh();
    let graph = build(&mesh, 3);
    let points: Vec<Vec3> = (0..200)
        .map(|i| {
            let t = i as f32 / 199.0;
            v((t * 13.0).sin(), (t * 29.0).cos() * 0.6, t * 0.78)
        })
        .flat_map(|p| [p, v(-p.x, p.y, p.z), v(0.0, p.y, p.z)])
        .collect();
    let field = graph.field_at(graph.field(), &points).unwrap();
    let out = field.deform(&some_scales(graph.parameter_rows(), 5));
    for triple in out.chunks(3) {
        assert_eq!(triple[1], v(-triple[0].x, triple[0].y, triple[0].z));
        assert!(triple[2].x.abs() <= 0.0, "{} leaves the plane", triple[2]);
    }
    // A refined mesh moves as the coarse one does: a scaling of everything is the same everywhere.
    let all = vec![v(1.5, 0.8, 1.2); graph.parameter_rows()];
    let (low, high) = mesh.surface_bounds();
    let center = ((low + high) * 0.5).as_vec3();
    for (moved, &rest) in graph.field_at(graph.field(), &points).unwrap().deform(&all).iter().zip(&points) {
        assert!(moved.distance(center + (rest - center) * all[0]) < 1e-5, "{rest} goes to {moved}");
    }
}

#[test]
fn given_boxes_are_paired_where_they_mirror_each_other() {
    let mesh = chair(2).mesh();
    let found = build(&mesh, 4);
    let give = |center: &[Vec3], half: &[Vec3]| {
        BoxDefGraph::from_boxes(&mesh, center, half, Symmetry::Auto, Boundary::Smooth).unwrap()
    };
    // In any order, and a little off.
    let turned = |rows: &[Vec3], off: f32| rows.iter().rev().map(|&v| v + off).collect::<Vec<_>>();
    let given = give(&turned(found.box_center(), 0.002), &turned(found.box_half_size(), 0.001));
    assert_eq!((given.symmetry(), sides(&given)), (found.symmetry(), sides(&found)));
    assert_eq!(given.parameter_rows(), found.parameter_rows());
    let scales = some_scales(given.parameter_rows(), 8);
    let moved = given.deform(&scales).unwrap();
    for (i, p) in mesh.vertices().iter().enumerate() {
        let image = mesh.vertices().iter().position(|q| *q == v(-p.x, p.y, p.z)).unwrap();
        assert_eq!(moved[image], v(-moved[i].x, moved[i].y, moved[i].z));
    }
    // Without the last leg the rest is not symmetric, and the leg's vertices go to what is nearest.
    let kept = found.box_center().len() - 1;
    let lopsided = give(&found.box_center()[..kept], &found.box_half_size()[..kept]);
    assert_eq!((lopsided.symmetry(), sides(&lopsided)), (Symmetry::None, [kept, 0, 0]));
}

#[test]
fn given_boxes_are_paired_about_both_axes() {
    let mesh = table(2).mesh();
    let found = build(&mesh, 3);
    let give = |center: &[Vec3], half: &[Vec3]| {
        BoxDefGraph::from_boxes(&mesh, center, half, Symmetry::Auto, Boundary::Smooth).unwrap()
    };
    let given = give(found.box_center(), found.box_half_size());
    assert_eq!((given.symmetry(), given.parameter_rows()), (Symmetry::Xy, 2));
    assert_eq!(given.assignment(), found.assignment());
    // Two boxes in one: the legs of one side. What is left of the symmetry is that about the other axis.
    let mut center = found.box_center().to_vec();
    let mut half = found.box_half_size().to_vec();
    let left: Vec<usize> = (1..5).filter(|&leg| center[leg].x < 0.0).collect();
    center[left[0]].y = 0.0;
    half[left[0]].y += found.box_center()[left[0]].y.abs();
    center.remove(left[1]);
    half.remove(left[1]);
    let given = give(&center, &half);
    assert_eq!((given.symmetry(), sides(&given)), (Symmetry::Y, [2, 1, 1]));
}

#[test]
fn given_boxes_are_checked_with_a_sentence_each() {
    let mesh = plain_box();
    let refused = |center: &[Vec3], half: &[Vec3]| {
        BoxDefGraph::from_boxes(&mesh, center, half, Symmetry::Auto, Boundary::Smooth)
            .unwrap_err()
            .to_string()
    };
    assert!(refused(&[], &[]).contains("no boxes"));
    assert!(refused(&[Vec3::ZERO], &[]).contains("box_half_size has 0 rows, but 1"));
    assert!(refused(&[Vec3::NAN], &[Vec3::ONE]).contains("box_center has a number that is not finite"));
    assert!(refused(&[Vec3::ZERO], &[-Vec3::ONE]).contains("below zero in row 0"));
    // A box that is nowhere near still owns what is nearest to it: everything.
    let far =
        BoxDefGraph::from_boxes(&mesh, &[v(50.0, 0.0, 0.0)], &[Vec3::ONE], Symmetry::None, Boundary::Smooth);
    assert_eq!(far.unwrap().parameter_rows(), 1);
}

#[test]
fn a_shape_that_lies_askew_is_turned_to_its_own_axes() {
    for (name, maker) in [("chair", chair(2)), ("table", table(2)), ("aeroplane", aeroplane())] {
        let mesh = maker.mesh();
        assert!(own_turn(&mesh).abs() <= 0.0, "{name} lies straight");
        for askew in [45.0_f64, 30.0, -20.0, 5.0] {
            let other =
                Mesh::new(turned(mesh.vertices(), askew.to_radians()), mesh.triangles().to_vec()).unwrap();
            let back = own_turn(&other).to_degrees();
            // By a quarter more or less the axes are the same ones.
            let off = (askew + back).rem_euclid(90.0);
            assert!(off.min(90.0 - off) < 0.1, "{name} at {askew} is turned by {back}");
        }
    }
}

#[test]
fn what_has_no_direction_of_its_own_is_not_turned() {
    assert!(own_turn(&ball()).abs() <= 0.0);
    assert!(own_turn(&bottle()).abs() <= 0.0);
    let skewed = lopsided().moved(|p| p + v(0.3 * p.y, 0.1 * p.z, 0.0)).mesh();
    assert!(own_turn(&skewed).abs() <= 0.0);
}

fn two_boxes() -> (Mesh, Parts) {
    let mut m = Maker::default();
    m.cuboid(v(-1.0, -1.0, 0.0), v(1.0, 1.0, 1.0), 2).cuboid(v(-0.5, -0.5, 1.0), v(0.5, 0.5, 2.0), 2);
    let each = build_counts(2);
    let parts = Parts {
        box_center: vec![v(0.0, 0.0, 0.5), v(0.0, 0.0, 1.5)],
        box_half_size: vec![v(1.0, 1.0, 0.5), v(0.5, 0.5, 0.5)],
        box_side: vec![0, 0],
        box_row: vec![0, 1],
        assignment: [vec![0; each], vec![1; each]].concat(),
        tree_edges: vec![[0, 1]],
        tree_parent_point: vec![v(0.0, 0.0, 1.0)],
        tree_child_point: vec![v(0.0, 0.0, 1.0)],
        edges: vec![[0, 1]],
    };
    (m.mesh(), parts)
}

/// What the sentence must say, and what is spoilt.
type Case = (&'static str, fn(&mut Parts));

#[test]
fn given_parts_are_checked_with_a_sentence_each() {
    let (mesh, good) = two_boxes();
    assert_eq!(BoxDefGraph::from_parts(&mesh, good.clone(), Boundary::Paper).unwrap().parts(), &good);
    let cases: [Case; 17] = [
        ("no boxes", |p| *p = Parts::default()),
        ("box_half_size has 1 rows", |p| p.box_half_size.truncate(1)),
        ("box_side has 1 rows", |p| p.box_side.truncate(1)),
        ("assignment has 1 rows", |p| p.assignment.truncate(1)),
        ("tree_edges has 0 rows, but 1", |p| p.tree_edges.clear()),
        ("tree_parent_point has 0 rows", |p| p.tree_parent_point.clear()),
        ("box_center has a number that is not finite in row 1", |p| p.box_center[1].x = f32::NAN),
        ("below zero in row 0", |p| p.box_half_size[0].y = -1.0),
        ("box_side is 3 in row 1", |p| p.box_side[1] = 3),
        ("1 pos and 0 neg", |p| p.box_side[1] = 1),
        ("box_row has 1 rows", |p| p.box_row.truncate(1)),
        ("box_row is 2 in row 1, where 1 belongs", |p| p.box_row[1] = 2),
        ("box_row is 1 in row 1, where the row of a pos box belongs", |p| p.box_side[1] = 2),
        ("assignment names box 2 in row 3", |p| p.assignment[3] = 2),
        ("edges names box -1", |p| p.edges[0][1] = -1),
        ("(1 to 1) is out of place", |p| p.tree_edges[0] = [1, 1]),
        ("joins box 0 to itself", |p| p.edges[0] = [0, 0]),
    ];
    for (sentence, spoil) in cases {
        let mut parts = good.clone();
        spoil(&mut parts);
        let error = BoxDefGraph::from_parts(&mesh, parts, Boundary::Paper).unwrap_err().to_string();
        assert!(error.contains(sentence), "{error:?} does not say {sentence:?}");
    }
}

#[test]
fn a_graph_can_be_taken_apart_and_put_together_again() {
    for mesh in [chair(2).mesh(), table(2).mesh(), cross().mesh()] {
        let built = build(&mesh, 4);
        let again = BoxDefGraph::from_parts(&mesh, built.parts().clone(), Boundary::Paper).unwrap();
        assert_eq!(again.parts(), built.parts());
        assert_eq!(again.parameter_row_of_box(), built.parameter_row_of_box());
        assert_eq!(again.symmetry(), built.symmetry());
    }
}

#[test]
fn bad_requests_are_refused_in_words() {
    let mesh = plain_box();
    for splits in [0, 9] {
        assert_eq!(
            BoxDefGraph::build(&mesh, splits, Symmetry::Auto, Boundary::Smooth).unwrap_err(),
            BoxDefError::Splits(splits)
        );
    }
    let graph = build(&mesh, 1);
    let error = graph.deform(&[Vec3::ONE; 2]).unwrap_err().to_string();
    assert!(error.contains("scales has 2 rows, but 1 are needed"), "{error}");
    assert!(graph.deform(&[Vec3::NAN]).is_err());
    assert!(graph.field_at(graph.field(), &[Vec3::INFINITY]).is_err());
}
