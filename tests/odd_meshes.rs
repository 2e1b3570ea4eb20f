// SPDX-License-Identifier: MIT OR Apache-2.0
//! Meshes as people have them: every valid one gets a connected graph and a finite field.

mod common;

use boxmorph::boxdef::Symmetry;
use boxmorph::mesh::{Mesh, MeshError};
use common::check::check;
use common::{Maker, aeroplane, ball, chair, v};
use glam::Vec3;

#[test]
fn arrays_that_make_no_mesh_are_refused_with_a_sentence() {
    let triangle = vec![v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)];
    let with = |i: usize, p: Vec3| {
        let mut vertices = triangle.clone();
        vertices[i] = p;
        vertices
    };
    let cases = [
        (vec![], vec![], "no vertices"),
        (triangle.clone(), vec![], "no faces"),
        (with(1, v(f32::NAN, 0.0, 0.0)), vec![[0, 1, 2]], "vertex 1 has a coordinate that is not"),
        (with(2, v(0.0, f32::NEG_INFINITY, 0.0)), vec![[0, 1, 2]], "vertex 2 has"),
        (with(0, v(1e30, 0.0, 0.0)), vec![[0, 1, 2]], "scale the object down"),
        (triangle.clone(), vec![[0, 1, 2], [0, 1, 3]], "triangle 1 uses vertex 3, but there are only 3"),
        (vec![v(2.0, 2.0, 2.0); 3], vec![[0, 1, 2]], "one point"),
        (vec![v(2.0, 2.0, 2.0)], vec![[0, 0, 0]], "one point"),
        (with(2, v(2.0, 0.0, 0.0)), vec![[0, 1, 2]], "zero area"),
        (triangle.clone(), vec![[0, 1, 1]], "zero area"),
    ];
    for (vertices, triangles, sentence) in cases {
        let error: MeshError = Mesh::new(vertices, triangles).unwrap_err();
        assert!(error.to_string().contains(sentence), "{error:?} does not say {sentence:?}");
    }
}

#[test]
fn one_triangle_and_three_work() {
    let corners = vec![v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0), v(0.0, 0.0, 1.0)];
    let one = Mesh::new(corners[..3].to_vec(), vec![[0, 1, 2]]).unwrap();
    assert_eq!(check("one triangle", &one, 3, Symmetry::Auto).box_center().len(), 1);
    let three = Mesh::new(corners, vec![[0, 1, 2], [0, 1, 3], [0, 2, 3]]).unwrap();
    check("three triangles", &three, 3, Symmetry::Auto);
}

#[test]
fn a_sheet_thinner_than_any_cell_has_parts_too() {
    // A flat T in the plane y = 0: a bar on a stem.
    let mut m = Maker::default();
    m.patch(v(-1.0, 0.0, 1.0), v(2.0, 0.0, 0.0), v(0.0, 0.0, 0.3), (12, 3));
    m.patch(v(-0.1, 0.0, 0.0), v(0.2, 0.0, 0.0), v(0.0, 0.0, 1.0), (2, 8));
    let graph = check("flat T", &m.mesh(), 1, Symmetry::Auto);
    assert_eq!(graph.box_center().len(), 2, "{:?}", graph.box_half_size());
}

#[test]
fn an_open_shell_has_the_parts_of_a_closed_one() {
    let closed = chair(3).mesh();
    // Without the faces that look down.
    let open: Vec<[u32; 3]> = closed
        .triangles()
        .iter()
        .copied()
        .filter(|t| {
            let [a, b, c] = t.map(|i| closed.vertices()[i as usize]);
            (b - a).cross(c - a).normalize().z > -0.9
        })
        .collect();
    assert!(open.len() < closed.triangles().len());
    let open = Mesh::new(closed.vertices().to_vec(), open).unwrap();
    let (a, b) = (check("closed", &closed, 4, Symmetry::Auto), check("open", &open, 4, Symmetry::Auto));
    assert_eq!(a.box_side(), b.box_side());
    for (a, b) in a.box_center().iter().zip(b.box_center()) {
        assert!(a.distance(*b) < 0.05, "{a} and {b}");
    }
}

#[test]
fn flipped_normals_and_duplicate_faces_change_nothing() {
    let mesh = chair(2).mesh();
    let flipped = mesh
        .triangles()
        .iter()
        .enumerate()
        .map(|(i, &[a, b, c])| if i % 3 == 0 { [a, c, b] } else { [a, b, c] });
    let doubled: Vec<[u32; 3]> = flipped.chain(mesh.triangles()[..20].iter().copied()).collect();
    let other = Mesh::new(mesh.vertices().to_vec(), doubled).unwrap();
    let (a, b) = (check("plain", &mesh, 4, Symmetry::Auto), check("flipped", &other, 4, Symmetry::Auto));
    assert_eq!(a, b);
}

#[test]
fn stray_vertices_are_owned_but_do_not_matter() {
    let mesh = chair(2).mesh();
    let mut vertices = mesh.vertices().to_vec();
    vertices.push(v(1000.0, 0.0, 0.0));
    let strayed = Mesh::new(vertices, mesh.triangles().to_vec()).unwrap();
    let (a, b) = (check("plain", &mesh, 4, Symmetry::Auto), check("stray", &strayed, 4, Symmetry::Auto));
    assert_eq!(a.box_center(), b.box_center());
    assert_eq!(a.assignment(), &b.assignment()[..mesh.vertices().len()]);
}

#[test]
fn seams_do_not_part_a_shell() {
    // Every triangle with vertices of its own, as some files have them.
    let mesh = chair(2).mesh();
    let vertices = mesh.triangles().iter().flatten().map(|&i| mesh.vertices()[i as usize]).collect();
    let triangles = (0..mesh.triangles().len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let loose = Mesh::new(vertices, triangles).unwrap();
    let (a, b) = (check("joined", &mesh, 4, Symmetry::Auto), check("loose", &loose, 4, Symmetry::Auto));
    assert_eq!(a.box_side(), b.box_side());
    let scales: Vec<Vec3> = (0..a.parameter_rows()).map(|i| Vec3::splat(0.5 + i as f32 * 0.4)).collect();
    let (joined, apart) = (a.deform(&scales).unwrap(), b.deform(&scales).unwrap());
    for (corner, &i) in mesh.triangles().iter().flatten().enumerate() {
        assert!(apart[corner].distance(joined[i as usize]) < 0.02, "corner {corner} tears off");
    }
}

#[test]
fn parts_that_float_apart_are_joined() {
    for n in [2, 7] {
        let mut m = Maker::default();
        for i in 0..n {
            let at = i as f32 * 1.7;
            m.cuboid(v(at, 0.0, 0.0), v(at + 0.5, 0.8, 0.3 + at), 1);
        }
        let graph = check("floating blocks", &m.mesh(), 8, Symmetry::None);
        assert!(graph.box_center().len() > 1);
        assert!(graph.edges().len() + 1 >= graph.box_center().len());
    }
}

#[test]
fn two_halves_without_a_middle_stay_mirror_images() {
    let mut m = Maker::default();
    m.sphere(v(1.0, 0.0, 0.0), 0.5, 8);
    let mesh = m.mirrored(0).mesh();
    let graph = check("two balls", &mesh, 2, Symmetry::Auto);
    assert_eq!(graph.box_side(), [1, 2]);
    let out = graph.deform(&[v(1.5, 0.5, 2.0)]).unwrap();
    let half = out.len() / 2;
    for i in 0..half {
        assert_eq!(out[i + half], v(-out[i].x, out[i].y, out[i].z));
    }
}

#[test]
fn extreme_sizes_and_shapes_work() {
    for scale in
        [v(1e-6, 1e-6, 1e-6), v(1e6, 1e6, 1e6), v(1.0, 1.0, 1e-5), v(1e4, 1.0, 1.0), v(1.0, 1e-7, 1e3)]
    {
        for symmetry in Symmetry::ALL {
            let name = format!("chair times {scale} with {symmetry:?}");
            check(&name, &chair(2).moved(|p| p * scale).mesh(), 4, symmetry);
        }
    }
    check("ball about z", &ball(), 3, Symmetry::Z);
}

#[test]
fn shells_that_pass_through_each_other_have_the_parts_of_shells_that_touch() {
    let apart = chair(2).mesh();
    // Legs up through the seat, the back down through it.
    let mut half = Maker::default();
    for y in [-0.4, 0.32] {
        half.cuboid(v(0.32, y, 0.0), v(0.4, y + 0.08, 0.96), 2);
    }
    let mut m = half.mirrored(0);
    m.cuboid(v(-0.42, -0.42, 0.88), v(0.42, 0.42, 0.98), 4);
    m.cuboid(v(-0.42, 0.34, 0.9), v(0.42, 0.42, 1.9), 4);
    let (a, b) =
        (check("touching", &apart, 4, Symmetry::Auto), check("through", &m.mesh(), 4, Symmetry::Auto));
    assert_eq!(a.box_side(), b.box_side());
    for (a, b) in a.box_center().iter().zip(b.box_center()) {
        assert!(a.distance(*b) < 0.05, "{a} and {b}");
    }
}

/// A garden bench of 31 loose parts of eight vertices: slats on two frames, screwed to them.
fn slatted_bench() -> Mesh {
    let mut m = Maker::default();
    for i in 0..8 {
        let y = -0.24 + 0.066 * i as f32;
        m.cuboid(v(-0.75, y, 0.42), v(0.75, y + 0.05, 0.445), 1);
    }
    for i in 0..5 {
        let z = 0.52 + 0.075 * i as f32;
        m.cuboid(v(-0.75, 0.245, z), v(0.75, 0.27, z + 0.055), 1);
        for x in [-0.66, 0.66] {
            m.cuboid(v(x - 0.012, 0.235, z + 0.015), v(x + 0.012, 0.245, z + 0.04), 1);
        }
    }
    for x in [-0.66, 0.66] {
        m.cuboid(v(x - 0.03, 0.27, 0.0), v(x + 0.03, 0.33, 0.9), 1);
        m.cuboid(v(x - 0.03, -0.24, 0.0), v(x + 0.03, -0.18, 0.42), 1);
        m.cuboid(v(x - 0.025, -0.18, 0.36), v(x + 0.025, 0.27, 0.42), 1);
        m.cuboid(v(x - 0.02, -0.18, 0.12), v(x + 0.02, 0.27, 0.16), 1);
    }
    m.mesh()
}

/// Pairs of loose parts, of eight vertices each, that are at most `reach` apart.
fn touching(positions: &[Vec3], reach: f32) -> Vec<[usize; 2]> {
    let bounds: Vec<(Vec3, Vec3)> = positions
        .chunks(8)
        .map(|part| part.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |b, &p| (b.0.min(p), b.1.max(p))))
        .collect();
    let apart = |a: usize, b: usize| (bounds[a].0 - bounds[b].1).max(bounds[b].0 - bounds[a].1).max_element();
    let pairs = (0..bounds.len()).flat_map(|a| (0..a).map(move |b| [a, b]));
    pairs.filter(|&[a, b]| apart(a, b) <= reach).collect()
}

#[test]
fn dozens_of_loose_parts_are_a_few_boxes_and_none_falls_off() {
    let mesh = slatted_bench();
    let graph = check("slatted bench", &mesh, 4, Symmetry::Auto);
    let boxes = graph.box_center().len();
    assert!((3..=9).contains(&boxes), "{boxes} boxes: {:?}", graph.box_half_size());
    let scales: Vec<Vec3> = (0..graph.parameter_rows()).map(|i| v(1.0, 1.2, 0.7 + 0.2 * i as f32)).collect();
    let joined = touching(mesh.vertices(), 1e-4);
    let still = touching(&graph.deform(&scales).unwrap(), 0.03);
    assert!(joined.len() > 30);
    for pair in joined {
        assert!(still.contains(&pair), "{pair:?} are torn apart");
    }
}

#[test]
fn edges_of_three_and_four_faces_change_nothing() {
    let mesh = chair(2).mesh();
    // Walls inside the seat, hung on vertices of its outside.
    let inside: Vec<u32> = (0..mesh.vertices().len() as u32)
        .filter(|&i| {
            let p = mesh.vertices()[i as usize];
            p.x.abs() < 0.01 && (0.87..0.985).contains(&p.z)
        })
        .collect();
    let walls = inside.windows(3).map(|w| [w[0], w[1], w[2]]);
    let walled: Vec<[u32; 3]> = mesh.triangles().iter().copied().chain(walls).collect();
    assert!(walled.len() > mesh.triangles().len() + 5);
    let other = Mesh::new(mesh.vertices().to_vec(), walled).unwrap();
    let (a, b) = (check("plain", &mesh, 4, Symmetry::Auto), check("walled", &other, 4, Symmetry::Auto));
    assert_eq!(a, b);
}

#[test]
fn what_is_flat_as_paper_or_long_as_a_train_has_parts() {
    let card = check("card", &aeroplane().moved(|p| p * v(1.0, 1.0, 1e-4)).mesh(), 4, Symmetry::Auto);
    assert!(card.box_side().contains(&1), "a card aeroplane has wings: {:?}", card.box_half_size());
    let mut m = Maker::default();
    for i in 0..3 {
        let at = 10.0 * i as f32;
        m.cuboid(v(at, -0.5, 0.3), v(at + 7.0, 0.5, 1.4), 1);
    }
    m.cuboid(v(0.0, -0.1, 0.4), v(27.0, 0.1, 0.5), 1);
    let train = check("train", &m.mesh(), 4, Symmetry::Auto);
    assert!(train.box_center().len() >= 3, "a train has coaches: {:?}", train.box_half_size());
}
