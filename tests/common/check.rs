// SPDX-License-Identifier: MIT OR Apache-2.0
//! What must hold for every mesh.

use boxmorph::boxdef::{Boundary, BoxDefGraph, Symmetry};
use boxmorph::mesh::Mesh;
use glam::Vec3;

/// Boxes that mirror each other, at most.
const IMAGES: usize = 4;

/// Builds the graph of a mesh, and asserts what must hold for every mesh; `name` says which it is.
pub fn check(name: &str, mesh: &Mesh, splits: u32, symmetry: Symmetry) -> BoxDefGraph {
    let graph =
        BoxDefGraph::build(mesh, splits, symmetry, Boundary::Smooth).expect("every valid mesh has a graph");
    let boxes = graph.box_center().len();
    assert!(
        boxes >= 1 && boxes <= IMAGES * splits as usize + 1,
        "{name}: {boxes} boxes after {splits} splits"
    );
    assert_eq!(graph.assignment().len(), mesh.vertices().len());
    assert!(graph.assignment().iter().all(|&owner| (0..boxes as i32).contains(&owner)), "{name}");
    for part in graph.box_center().iter().chain(graph.box_half_size()) {
        assert!(part.is_finite(), "{name}");
    }
    let mut reached = vec![false; boxes];
    reached[graph.tree_edges().first().map_or(0, |edge| edge[0] as usize)] = true;
    for &[parent, child] in graph.tree_edges() {
        assert!(reached[parent as usize] && !reached[child as usize], "{name}: the tree is out of order");
        reached[child as usize] = true;
    }
    assert!(reached.iter().all(|&r| r), "{name}: the graph is not connected");
    assert!(graph.field().basis().iter().all(|b| b.is_finite()), "{name}: the field is not finite");
    let ones = vec![Vec3::ONE; graph.parameter_rows()];
    assert_eq!(graph.deform(&ones).unwrap(), mesh.vertices(), "{name}");
    let back = BoxDefGraph::from_parts(mesh, graph.parts().clone(), Boundary::Smooth);
    assert!(back.is_ok(), "{name}: its own parts are refused: {:?}", back.err());
    graph
}
