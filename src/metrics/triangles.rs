// SPDX-License-Identifier: MIT OR Apache-2.0
//! Whether two triangles in space meet.

use glam::{DVec2, DVec3};

/// Whether two triangles have a point in common.
pub(super) fn triangles_meet(p: [DVec3; 3], q: [DVec3; 3]) -> bool {
    let above_q = q_sides(p, q);
    if one_sided(above_q) {
        return false;
    }
    let above_p = q_sides(q, p);
    if one_sided(above_p) {
        return false;
    }
    if above_q == [0; 3] || above_p == [0; 3] {
        return coplanar_meet(p, q);
    }
    let edges = |t: [DVec3; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    edges(p).into_iter().any(|edge| segment_meets_triangle(edge, q))
        || edges(q).into_iter().any(|edge| segment_meets_triangle(edge, p))
}

/// Whether a segment that is not in a triangle's plane passes through the triangle.
pub(super) fn segment_meets_triangle([a, b]: [DVec3; 2], t: [DVec3; 3]) -> bool {
    let (side_a, side_b) = (side(a, t), side(b, t));
    if side_a == side_b {
        return false;
    }
    // On the same side of the three planes through the segment and an edge each.
    let around = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| side(a, [b, t[i], t[j]]));
    around.iter().all(|&s| s >= 0) || around.iter().all(|&s| s <= 0)
}

/// On which side of a triangle's plane a point lies: −1, 0 (in the plane, up to rounding) or 1.
fn side(point: DVec3, [a, b, c]: [DVec3; 3]) -> i8 {
    let (u, v, w) = (b - a, c - a, point - a);
    let volume = u.cross(v).dot(w);
    let rounding = 1e-14 * u.length() * v.length() * w.length();
    i8::from(volume > rounding) - i8::from(volume < -rounding)
}

fn q_sides(p: [DVec3; 3], q: [DVec3; 3]) -> [i8; 3] {
    p.map(|corner| side(corner, q))
}

fn one_sided(sides: [i8; 3]) -> bool {
    sides == [1; 3] || sides == [-1; 3]
}

/// Whether two triangles in one plane overlap.
fn coplanar_meet(p: [DVec3; 3], q: [DVec3; 3]) -> bool {
    let cross = |t: [DVec3; 3]| (t[1] - t[0]).cross(t[2] - t[0]);
    let (np, nq) = (cross(p), cross(q));
    let normal = if np.length_squared() >= nq.length_squared() { np } else { nq };
    if normal == DVec3::ZERO {
        return false;
    }
    let drop = normal.abs().max_position();
    let flat = |t: [DVec3; 3]| t.map(|v| DVec2::new(v[(drop + 1) % 3], v[(drop + 2) % 3]));
    let (p, q) = (flat(p), flat(q));
    // Separating axes: the normals of the six edges; triangles that only touch do not overlap.
    let apart_along = |t: [DVec2; 3]| {
        (0..3).any(|i| {
            let axis = (t[(i + 1) % 3] - t[i]).perp();
            let range = |t: [DVec2; 3]| {
                let along = t.map(|v| axis.dot(v));
                (along[0].min(along[1]).min(along[2]), along[0].max(along[1]).max(along[2]))
            };
            let (a, b) = (range(p), range(q));
            a.1 <= b.0 || b.1 <= a.0
        })
    };
    !apart_along(p) && !apart_along(q)
}
