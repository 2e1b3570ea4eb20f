// SPDX-License-Identifier: MIT OR Apache-2.0
//! Mirror symmetry: of the filled cells, and of the vertices.

use glam::DVec3;
use rayon::prelude::*;

use super::nearest::Close;
use super::occupancy::Occupancy;

/// How a graph treats left and right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Symmetry {
    /// X if the shape mirrors about x, else y if it does about y, else none. Never z: what is above and
    /// what is below mean different parts, even where they look alike.
    #[default]
    Auto,
    /// No symmetry: every box has its own parameters.
    None,
    /// The two sides of x share their parameters.
    X,
    /// The two sides of y share their parameters.
    Y,
    /// The two sides of z share their parameters.
    Z,
}

impl Symmetry {
    /// The axis, if one is named.
    #[must_use]
    pub fn axis(self) -> Option<usize> {
        match self {
            Self::Auto | Self::None => None,
            Self::X => Some(0),
            Self::Y => Some(1),
            Self::Z => Some(2),
        }
    }

    /// The symmetry about an axis, or none.
    #[must_use]
    pub fn about(axis: Option<usize>) -> Self {
        axis.and_then(|axis| [Self::X, Self::Y, Self::Z].get(axis).copied()).unwrap_or(Self::None)
    }
}

/// Share of the filled cells that need an image within a cell. Lower would take a chair with one arm
/// for a symmetric one.
const ENOUGH: f64 = 0.97;

/// The axis about which a shape is to be treated as symmetric.
pub(crate) fn resolve(symmetry: Symmetry, occupancy: &Occupancy) -> Option<usize> {
    match symmetry {
        Symmetry::Auto => (0..2).find(|&axis| is_mirrored(occupancy, axis)),
        named => named.axis(),
    }
}

/// Whether a shape mirrors about an axis.
pub(crate) fn is_mirrored(occupancy: &Occupancy, axis: usize) -> bool {
    occupancy.mirror_agreement(axis) >= ENOUGH
}

/// For each vertex the vertex in its mirror image's place, and itself on the plane; none where there is no
/// such vertex. Taken twice it leads back to the same place.
pub(crate) struct MirrorMap {
    pub(crate) axis: usize,
    pub(crate) image: Vec<Option<u32>>,
}

/// How far from the exact place an image may lie, in units of the frame.
const SAME_PLACE: f64 = 1e-5;

impl MirrorMap {
    /// About the plane through the frame's origin.
    pub(crate) fn of(vertices: &[DVec3], axis: usize) -> Self {
        let close = Close::new(vertices, SAME_PLACE);
        let candidate = |point: DVec3| close.one(mirrored(point, axis));
        let first: Vec<Option<u32>> = vertices.par_iter().map(|&v| candidate(v)).collect();
        let image = first
            .iter()
            .enumerate()
            .map(|(vertex, &found)| {
                let back = first[found? as usize]?;
                (vertices[back as usize] == vertices[vertex]).then_some(found?)
            })
            .collect();
        Self { axis, image }
    }

    /// Whether every vertex has an image.
    pub(crate) fn is_complete(&self) -> bool {
        self.image.iter().all(Option::is_some)
    }
}

/// A point's mirror image about the plane through the origin.
pub(crate) fn mirrored(mut point: DVec3, axis: usize) -> DVec3 {
    point[axis] = -point[axis];
    point
}
