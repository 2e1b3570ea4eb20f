// SPDX-License-Identifier: MIT OR Apache-2.0
//! What is scored of a mesh: the mesh itself or, where it is dense, a light proxy that looks the same.
//!
//! A guide's images have a few thousand pixels. Of two million triangles nearly all are smaller than that, and
//! drawing them takes all the time of a search. The proxy keeps some of the mesh's own vertices, so its field is
//! the mesh's at these: graph, field, gauge and outcome are of the whole mesh, and only images, normal error
//! and self-intersections are of the proxy.

use std::borrow::Cow;
use std::sync::Arc;

use glam::Vec3;
use meshopt::SimplifyOptions;

use crate::boxdef::DeformField;
use crate::mesh::Mesh;

/// A mesh with more triangles is simplified,
const DENSE: usize = 60_000;
/// to about this many: an image of 64 pixels has fewer samples.
const LIGHT: usize = 20_000;

/// How far the proxy's surface may be from the mesh's, as a share of its longest extent. In images of 224 pixels
/// the object's radius has 78 at most, so this is half a pixel at most.
const DEVIATION: f32 = 0.003;

/// What is scored of a mesh.
#[derive(Debug)]
pub struct Proxy<'a> {
    mesh: Cow<'a, Mesh>,
    /// The mesh's vertex that each of the proxy's is; none where the proxy is the mesh itself.
    kept: Option<Vec<u32>>,
}

impl<'a> Proxy<'a> {
    /// Simplifies a dense mesh as far as it stays within the deviation.
    pub fn of(mesh: &'a Mesh) -> Self {
        let dense = mesh.triangles().len() > DENSE;
        dense
            .then(|| Self::simplified(mesh))
            .flatten()
            .unwrap_or(Self { mesh: Cow::Borrowed(mesh), kept: None })
    }

    /// The mesh that is scored.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The field of the vertices that are scored, of that of all.
    pub fn field(&self, whole: Arc<DeformField>) -> Arc<DeformField> {
        match &self.kept {
            Some(kept) => Arc::new(whole.select(kept)),
            None => whole,
        }
    }

    /// None where what is left is no mesh.
    fn simplified(mesh: &Mesh) -> Option<Self> {
        let positions: Vec<[f32; 3]> = mesh.vertices().iter().map(Vec3::to_array).collect();
        let corners = mesh.triangles().as_flattened();
        // Permissive: seams between vertices in one place, of UVs or of flat faces, do not hold it up.
        let options = SimplifyOptions::Permissive;
        let left = meshopt::simplify_decoder(corners, &positions, 3 * LIGHT, DEVIATION, options, None);
        let mut kept = left.clone();
        kept.sort_unstable();
        kept.dedup();
        let mut place = vec![0; mesh.vertices().len()];
        for (new, &old) in (0_u32..).zip(&kept) {
            place[old as usize] = new;
        }
        let vertices = kept.iter().map(|&old| mesh.vertices()[old as usize]).collect();
        let triangles = left.as_chunks::<3>().0.iter().map(|t| t.map(|old| place[old as usize])).collect();
        let mesh = Cow::Owned(Mesh::new(vertices, triangles).ok()?);
        Some(Self { mesh, kept: Some(kept) })
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::TAU;

    use super::*;
    use crate::boxdef::{Boundary, BoxDefGraph, Symmetry};
    use crate::render::{Backend, render_positions, views_by_name};

    /// Grids of quads: `side` by `side` points each, at `place(grid, u, v)` with u and v from 0 to 1.
    fn grids(count: usize, side: usize, place: impl Fn(usize, f32, f32) -> Vec3) -> Mesh {
        let at = |i: usize| i as f32 / (side - 1) as f32;
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for grid in 0..count {
            let first = vertices.len();
            for i in 0..side * side {
                vertices.push(place(grid, at(i % side), at(i / side)));
            }
            for i in (0..side * (side - 1)).filter(|i| i % side < side - 1) {
                let [a, b, c, d] = [0, 1, side + 1, side].map(|step| (first + i + step) as u32);
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        Mesh::new(vertices, triangles).expect("grids are a mesh")
    }

    /// Boxes of six grids each, whose edges and corners are doubled as those of flat faces are.
    fn boxes(boxes: &[(Vec3, Vec3)], side: usize) -> Mesh {
        grids(6 * boxes.len(), side, |grid, u, v| {
            let (low, high) = boxes[grid / 6];
            let (axis, end) = (grid % 6 / 2, (grid % 2) as f32);
            let unit = [Vec3::new(end, u, v), Vec3::new(u, end, v), Vec3::new(u, v, end)][axis];
            low + unit * (high - low)
        })
    }

    /// A seat on four legs, with a back; 207,000 triangles.
    fn chair() -> Mesh {
        let leg = |x: f32, y: f32| (Vec3::new(x - 0.03, y - 0.03, 0.0), Vec3::new(x + 0.03, y + 0.03, 0.45));
        let seat = (Vec3::new(-0.24, -0.24, 0.44), Vec3::new(0.24, 0.24, 0.5));
        let back = (Vec3::new(-0.23, 0.19, 0.49), Vec3::new(0.23, 0.23, 1.0));
        let legs = [leg(-0.2, -0.2), leg(-0.2, 0.2), leg(0.2, -0.2), leg(0.2, 0.2)];
        boxes(&[&legs[..], &[seat, back]].concat(), 54)
    }

    /// A surface around z through (radius, height) pairs, of `side`² vertices.
    fn lathe(outline: &[(f32, f32)], center: Vec3, side: usize) -> impl Fn(f32, f32) -> Vec3 {
        let outline = outline.to_vec();
        move |u, v| {
            // Points are spread evenly over the pieces of the outline.
            let along = v * (outline.len() - 1) as f32;
            let piece = (along as usize).min(outline.len() - 2);
            let ((r0, z0), (r1, z1)) = (outline[piece], outline[piece + 1]);
            let (t, turn) = (along - piece as f32, u * TAU * (1.0 - 1.0 / side as f32));
            let radius = r0 + t * (r1 - r0);
            center + Vec3::new(radius * turn.cos(), radius * turn.sin(), z0 + t * (z1 - z0))
        }
    }

    /// A foot, a pole and a shade of one piece; 180,000 triangles.
    fn lamp() -> Mesh {
        let outline =
            [(0.01, 0.0), (0.3, 0.0), (0.3, 0.04), (0.03, 0.08), (0.02, 1.0), (0.28, 1.0), (0.16, 1.4)];
        let surface = lathe(&outline, Vec3::ZERO, 301);
        grids(1, 301, |_, u, v| surface(u, v))
    }

    /// Twelve rods of a few hundredths of the whole, and sheets without thickness; 195,000 triangles.
    fn rack() -> Mesh {
        let rod = |i: usize| Vec3::new(0.15 * (i % 4) as f32, 0.2 * (i / 4) as f32, 0.0);
        let side = 81;
        grids(15, side, |grid, u, v| match grid {
            0..12 => lathe(&[(0.012, 0.0), (0.008, 0.5), (0.012, 1.0)], rod(grid), side)(u, v),
            _ => Vec3::new(0.45 * u, 0.4 * v, 0.3 * (grid - 11) as f32),
        })
    }

    /// Pixels that a shape covers at least half, view by view.
    fn silhouettes(mesh: &Mesh, positions: &[Vec3], size: u32) -> Vec<bool> {
        let views = views_by_name("paper").expect("the paper's views");
        let rgba = render_positions(Backend::Cpu, positions, mesh.triangles(), &views, size);
        rgba.expect("the shape can be drawn").chunks_exact(4).map(|pixel| pixel[3] >= 128).collect()
    }

    /// Number of pixels of one silhouette that have none of another in them or next to them.
    fn astray(one: &[bool], other: &[bool], size: usize) -> usize {
        let near = |i: usize| {
            let (view, x, y) = (i / (size * size), i % size, i / size % size);
            let around = |x: usize| x.saturating_sub(1)..(x + 2).min(size);
            around(y).any(|y| around(x).any(|x| other[(view * size + y) * size + x]))
        };
        (0..one.len()).filter(|&i| one[i] && !near(i)).count()
    }

    #[test]
    fn a_dense_mesh_and_its_proxy_look_the_same_before_and_after() {
        for (name, mesh) in [("chair", chair()), ("lamp", lamp()), ("rack", rack())] {
            let graph = BoxDefGraph::build(&mesh, 4, Symmetry::Auto, Boundary::Smooth).expect("parts");
            let proxy = Proxy::of(&mesh);
            let left = proxy.mesh().triangles().len();
            assert!(left <= LIGHT && left > LIGHT / 3, "{name}: {left} triangles");
            let field = proxy.field(graph.shared_field());
            let stretched: Vec<Vec3> =
                (0..graph.parameter_rows()).map(|i| Vec3::new(1.5, 0.6, 0.7 + 0.4 * i as f32)).collect();
            for scales in [vec![Vec3::ONE; graph.parameter_rows()], stretched] {
                let (full, light) = (graph.field().deform(&scales), field.deform(&scales));
                for size in [64, 224] {
                    let full = silhouettes(&mesh, &full, size);
                    let light = silhouettes(proxy.mesh(), &light, size);
                    let covered = full.iter().filter(|&&covered| covered).count();
                    assert!(covered > full.len() / 50, "{name}: {covered} pixels");
                    let size = size as usize;
                    assert_eq!((astray(&full, &light, size), astray(&light, &full, size)), (0, 0), "{name}");
                }
            }
        }
    }

    #[test]
    fn a_mesh_that_is_not_dense_is_its_own_proxy() {
        let mesh = boxes(&[(Vec3::ZERO, Vec3::ONE)], 70);
        let proxy = Proxy::of(&mesh);
        assert!(mesh.triangles().len() > 50_000 && std::ptr::eq(proxy.mesh(), &raw const mesh));
        let field = Arc::new(DeformField::new(mesh.vertices().to_vec(), 0, Vec::new()));
        assert!(Arc::ptr_eq(&proxy.field(field.clone()), &field));
    }

    #[test]
    fn graph_and_proxy_of_a_dense_mesh_are_the_same_on_one_thread_and_two() {
        let mesh = lamp();
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| {
                let graph = BoxDefGraph::build(&mesh, 3, Symmetry::Auto, Boundary::Smooth)
                    .expect("the lamp has parts");
                let proxy = Proxy::of(&mesh);
                (proxy.mesh().clone(), proxy.field(graph.shared_field()), graph)
            })
        };
        assert!(on(1) == on(2));
    }
}
