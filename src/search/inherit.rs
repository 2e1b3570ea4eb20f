// SPDX-License-Identifier: MIT OR Apache-2.0
//! A search of finer parts starts where one of coarser parts ended.

use glam::{DVec3, Vec3};

use crate::boxdef::BoxDefGraph;

/// Squared extents under this share of the largest say nothing about a scale.
const FLAT: f64 = 1e-6;

/// The scale factors, one row a parameter row of `graph`, that come nearest to a deformation found with
/// other boxes: in each part and axis the slope of the `deformed` positions over those at rest.
#[must_use]
pub fn inherit(graph: &BoxDefGraph, deformed: &[Vec3]) -> Vec<Vec3> {
    let rest = graph.field().rest();
    let boxes = graph.box_center().len();
    let mut count = vec![0.0; boxes];
    let mut centers = vec![(DVec3::ZERO, DVec3::ZERO); boxes];
    let owners = || graph.assignment().iter().map(|part| *part as usize);
    for (part, (a, b)) in owners().zip(rest.iter().zip(deformed)) {
        count[part] += 1.0;
        centers[part].0 += a.as_dvec3();
        centers[part].1 += b.as_dvec3();
    }
    for (center, count) in centers.iter_mut().zip(&count) {
        let count = f64::max(*count, 1.0);
        *center = (center.0 / count, center.1 / count);
    }
    // Mirrored boxes share a row: their sums are added.
    let mut sums = vec![(DVec3::ZERO, DVec3::ZERO); graph.parameter_rows()];
    for (part, (a, b)) in owners().zip(rest.iter().zip(deformed)) {
        let (a, b) = (a.as_dvec3() - centers[part].0, b.as_dvec3() - centers[part].1);
        let sum = &mut sums[graph.parameter_row_of_box()[part]];
        sum.0 += a * a;
        sum.1 += a * b;
    }
    let largest = sums.iter().map(|s| s.0.max_element()).fold(0.0, f64::max);
    let slope = |square: f64, product: f64| if square > FLAT * largest { product / square } else { 1.0 };
    sums.iter()
        .map(|(s, p)| DVec3::new(slope(s.x, p.x), slope(s.y, p.y), slope(s.z, p.z)).as_vec3())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxdef::{Boundary, Symmetry};
    use crate::mesh::Mesh;

    /// A slab on two blocks, as one mesh of islands.
    fn bench() -> Mesh {
        let boxes = [
            (Vec3::new(0.0, 0.0, 1.1), Vec3::new(1.0, 0.5, 0.1)),
            (Vec3::new(-0.9, 0.0, 0.5), Vec3::new(0.1, 0.5, 0.5)),
            (Vec3::new(0.9, 0.0, 0.5), Vec3::new(0.1, 0.5, 0.5)),
        ];
        let mut vertices = Vec::new();
        let mut triangles = Vec::new();
        for (center, half) in boxes {
            let first = vertices.len() as u32;
            for corner in 0..8 {
                let sign = |bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
                vertices.push(center + half * Vec3::new(sign(0), sign(1), sign(2)));
            }
            let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
            for [a, b, c, d] in faces {
                triangles.extend([[a, b, c], [a, c, d]].map(|t: [u32; 3]| t.map(|i| first + i)));
            }
        }
        Mesh::new(vertices, triangles).expect("the bench is a mesh")
    }

    #[test]
    fn a_whole_that_was_scaled_hands_on_its_scales() {
        let mesh = bench();
        let graph =
            BoxDefGraph::build(&mesh, 3, Symmetry::Auto, Boundary::Smooth).expect("the bench has parts");
        let scale = Vec3::new(1.5, 0.8, 2.0);
        let deformed: Vec<Vec3> = mesh.vertices().iter().map(|v| *v * scale + Vec3::X).collect();
        for row in inherit(&graph, &deformed) {
            assert!((row - scale).abs().max_element() < 1e-5, "{row}");
        }
    }

    #[test]
    fn what_one_graph_found_another_takes_over() {
        let mesh = bench();
        let coarse =
            BoxDefGraph::build(&mesh, 1, Symmetry::Auto, Boundary::Smooth).expect("the bench has parts");
        let fine =
            BoxDefGraph::build(&mesh, 4, Symmetry::Auto, Boundary::Smooth).expect("the bench has parts");
        let scales: Vec<Vec3> =
            (0..coarse.parameter_rows()).map(|i| Vec3::new(1.2, 0.9, 1.0 + 0.4 * i as f32)).collect();
        let wanted = coarse.deform(&scales).expect("a row each");
        let taken = fine.deform(&inherit(&fine, &wanted)).expect("a row each");
        let error = |found: &[Vec3]| {
            let shift = (wanted[0] - found[0]).length();
            found.iter().zip(&wanted).map(|(a, b)| a.distance(*b)).fold(shift, f32::max)
        };
        assert!(error(&taken) < 0.5 * error(mesh.vertices()), "{} {}", error(&taken), error(mesh.vertices()));
    }
}
