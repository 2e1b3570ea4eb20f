// SPDX-License-Identifier: MIT OR Apache-2.0
//! Shifts of parts: what a user would notice.

mod common;

use boxmorph::boxdef::{Boundary, BoxDefGraph, Symmetry};
use common::{aeroplane, chair, lamp, table, v};
use glam::Vec3;

fn build(maker: common::Maker) -> (boxmorph::mesh::Mesh, BoxDefGraph) {
    let mesh = maker.mesh();
    let graph = BoxDefGraph::build(&mesh, 4, Symmetry::Auto, Boundary::Smooth).expect("a mesh has a graph");
    (mesh, graph)
}

/// No scaling, and a shift of one row.
fn only(graph: &BoxDefGraph, row: usize, shift: Vec3) -> (Vec<Vec3>, Vec<Vec3>) {
    let rows = graph.parameter_rows();
    let mut shifts = vec![Vec3::ZERO; rows];
    shifts[row] = shift;
    (vec![Vec3::ONE; rows], shifts)
}

#[test]
fn legs_slide_outwards_all_four_and_the_top_stays() {
    let (mesh, graph) = build(table(2));
    let leg = graph.parameter_row_of_box()[1];
    let (scales, shifts) = only(&graph, leg, v(0.1, 0.05, 0.0));
    let moved = graph.deform_shifted(&scales, &shifts).unwrap();
    for (i, (&to, &from)) in moved.iter().zip(mesh.vertices()).enumerate() {
        let outwards = v(0.1 * from.x.signum(), 0.05 * from.y.signum(), 0.0);
        if graph.parameter_row_of_box()[graph.assignment()[i] as usize] != leg {
            assert!(to.distance(from) < 0.06, "the top follows near the joints at most: {from} goes to {to}");
        } else if from.z < 0.3 {
            assert!(to.distance(from + outwards) < 0.01, "{from} goes to {to}");
        }
    }
}

#[test]
fn a_shift_of_nothing_changes_nothing_and_shifts_add_up() {
    let (mesh, graph) = build(aeroplane());
    let rows = graph.parameter_rows();
    let ones = vec![Vec3::ONE; rows];
    assert_eq!(graph.deform_shifted(&ones, &vec![Vec3::ZERO; rows]).unwrap(), mesh.vertices());
    let number = |k: usize| (k as f32 * 0.7).sin();
    let shifts: Vec<Vec3> =
        (0..rows).map(|r| v(number(3 * r), number(3 * r + 1), number(3 * r + 2)) * 0.2).collect();
    let scales: Vec<Vec3> = (0..rows).map(|r| Vec3::ONE + 0.5 * number(r + 7)).collect();
    let both = graph.deform_shifted(&scales, &shifts).unwrap();
    let scaled = graph.deform(&scales).unwrap();
    let shifted = graph.deform_shifted(&ones, &shifts).unwrap();
    for (i, rest) in mesh.vertices().iter().enumerate() {
        assert!(both[i].distance(scaled[i] + shifted[i] - rest) < 1e-5, "vertex {i}");
    }
}

#[test]
fn shifted_parts_stay_mirror_images_bit_for_bit() {
    for maker in [chair(2), aeroplane(), table(3)] {
        let (mesh, graph) = build(maker);
        let rows = graph.parameter_rows();
        let shifts: Vec<Vec3> = (0..rows).map(|r| v(0.1, -0.07, 0.05) * (r + 1) as f32).collect();
        let moved = graph.deform_shifted(&vec![Vec3::ONE; rows], &shifts).unwrap();
        for &axis in graph.symmetry().axes() {
            let mirrored = |mut p: Vec3| {
                p[axis] = -p[axis];
                p
            };
            let mut pairs = 0;
            for (i, &p) in mesh.vertices().iter().enumerate() {
                let Some(j) = mesh.vertices().iter().position(|&q| q == mirrored(p)) else { continue };
                assert_eq!(moved[j], mirrored(moved[i]), "vertices {i} and {j}");
                pairs += 1;
            }
            assert!(pairs > mesh.vertices().len() * 9 / 10);
        }
    }
}

#[test]
fn what_hangs_on_a_shifted_part_goes_along() {
    let mesh = lamp();
    let graph = BoxDefGraph::build(&mesh, 2, Symmetry::None, Boundary::Smooth).expect("a lamp has a graph");
    let [[_, stem], [parent, last]] = graph.tree_edges() else {
        panic!("three parts: {:?}", graph.tree_edges())
    };
    assert_eq!(stem, parent, "base and shade hang together by the stem");
    let (scales, shifts) = only(&graph, graph.parameter_row_of_box()[*stem as usize], v(0.1, 0.0, 0.0));
    let moved = graph.deform_shifted(&scales, &shifts).unwrap();
    let owned = || graph.assignment().iter().enumerate().filter(|(_, owner)| *owner == last);
    assert!(owned().count() > 0);
    for (i, _) in owned() {
        assert!((moved[i].x - mesh.vertices()[i].x - 0.1).abs() < 0.01, "vertex {i}");
    }
}

#[test]
fn parts_have_room_on_what_they_hang_on_and_nowhere_else() {
    let (mesh, graph) = build(table(2));
    let room = graph.shift_room();
    assert_eq!(room.len(), 2);
    let root = graph.parameter_row_of_box()[graph.tree_edges()[0][0] as usize];
    assert_eq!(room[root], [(0.0, 0.0); 3], "the top is what the legs hang on");
    let leg = room[1 - root];
    assert_eq!(leg[2], (0.0, 0.0), "up and down a leg would leave the top");
    let (low, high) = mesh.surface_bounds();
    let half = ((high - low) * 0.5).as_vec3();
    for axis in 0..2 {
        let (least, most) = leg[axis];
        assert!(least < 0.0 && most > 0.0 && most - least < half[axis], "{least} to {most}");
    }
    // At the ends of its room a leg neither crosses the middle nor overhangs the top.
    for shift in [v(leg[0].0, leg[1].0, 0.0), v(leg[0].1, leg[1].1, 0.0)] {
        let (scales, shifts) = only(&graph, 1 - root, shift);
        let moved = graph.deform_shifted(&scales, &shifts).unwrap();
        for ((to, from), &owner) in moved.iter().zip(mesh.vertices()).zip(graph.assignment()) {
            let is_leg = graph.parameter_row_of_box()[owner as usize] == 1 - root;
            let crosses = to.x * from.x < -1e-6 || to.y * from.y < -1e-6;
            let overhangs = to.x.abs() > half.x + 1e-4 || to.y.abs() > half.y + 1e-4;
            assert!(!is_leg || !(crosses || overhangs), "{from} goes to {to}");
        }
    }
}

#[test]
fn what_goes_on_from_a_part_is_not_shifted_over_it() {
    // A wing that is thinner from half its length on: the outer half is no part that stands on the inner one.
    let mut m = common::Maker::default();
    m.cuboid(v(0.1, -0.2, 0.0), v(0.6, 0.2, 0.06), 6).cuboid(v(0.6, -0.12, 0.01), v(1.1, 0.12, 0.05), 6);
    m.cuboid(v(-0.1, -1.2, -0.1), v(0.1, 0.8, 0.1), 6);
    let graph = build(m.mirrored(0)).1;
    let room = graph.shift_room();
    let row_at = |x: f32| {
        let b = (0..graph.box_center().len()).find(|&b| (graph.box_center()[b].x - x).abs() < 0.1);
        graph.parameter_row_of_box()[b.expect("there is such a part")]
    };
    let (inner, outer) = (room[row_at(0.35)], room[row_at(0.85)]);
    assert!(inner[1].1 - inner[1].0 > 1.0, "along the body there is room: {inner:?}");
    assert_eq!(outer, [(0.0, 0.0); 3]);
}

#[test]
fn the_field_with_shifts_can_be_had_at_other_points() {
    let (mesh, graph) = build(chair(2));
    let field = graph.field_with_shifts();
    assert_eq!(
        (field.scale_rows(), field.parameter_rows()),
        (graph.parameter_rows(), 2 * graph.parameter_rows())
    );
    assert_eq!(graph.field_at(&field, mesh.vertices()).unwrap(), field);
    assert_eq!(field.deform(&field.unchanged()), mesh.vertices());
}

#[test]
fn bad_shifts_are_refused_in_words() {
    let (_, graph) = build(chair(1));
    let ones = vec![Vec3::ONE; graph.parameter_rows()];
    let error = graph.deform_shifted(&ones, &[Vec3::ZERO]).unwrap_err().to_string();
    assert!(error.starts_with("shifts has 1 rows, but"), "{error}");
    let error = graph.deform_shifted(&ones, &vec![Vec3::NAN; ones.len()]).unwrap_err().to_string();
    assert!(error.starts_with("shifts has a number that is not finite in row 0"), "{error}");
}
