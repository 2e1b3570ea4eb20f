// SPDX-License-Identifier: MIT OR Apache-2.0
//! Mirror symmetry: of the filled cells, and of the vertices.

use std::str::FromStr;

use glam::DVec3;
use rayon::prelude::*;

use super::error::BoxDefError;
use super::nearest::Close;
use super::occupancy::Occupancy;

/// The axes to mirror about.
pub(crate) type Way = &'static [usize];

/// How a graph treats left and right, front and back.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Symmetry {
    /// About x, y or both, whichever the shape mirrors about, else none. Never z: what is above and what is
    /// below mean different parts, even where they look alike.
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
    /// All four corners share their parameters, and so do the two sides of what lies on one of the planes.
    Xy,
}

impl Symmetry {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Auto, Self::None, Self::X, Self::Y, Self::Z, Self::Xy];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::None => "none",
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Xy => "xy",
        }
    }

    /// The axes that are named: 0 x, 1 y, 2 z.
    #[must_use]
    pub fn axes(self) -> &'static [usize] {
        match self {
            Self::Auto | Self::None => &[],
            Self::X => &[0],
            Self::Y => &[1],
            Self::Z => &[2],
            Self::Xy => &[0, 1],
        }
    }

    /// The symmetry about some axes; none where there is no such one.
    #[must_use]
    pub fn about(axes: &[usize]) -> Self {
        Self::ALL.into_iter().skip(1).find(|known| known.axes() == axes).unwrap_or(Self::None)
    }

    /// The ways to mirror; the first leaves everything as it is.
    pub(crate) fn ways(self) -> &'static [Way] {
        match self {
            Self::Auto | Self::None => &[&[]],
            Self::X => &[&[], &[0]],
            Self::Y => &[&[], &[1]],
            Self::Z => &[&[], &[2]],
            Self::Xy => &[&[], &[0], &[1], &[0, 1]],
        }
    }
}

impl FromStr for Symmetry {
    type Err = BoxDefError;

    fn from_str(name: &str) -> Result<Self, BoxDefError> {
        let known = Self::ALL.into_iter().find(|symmetry| symmetry.name() == name);
        known.ok_or_else(|| BoxDefError::Symmetry(name.into()))
    }
}

/// Share of the filled cells that need an image within a cell. Lower would take a chair with one arm
/// for a symmetric one.
const ENOUGH: f64 = 0.97;

/// The symmetry that a shape is to be treated with; never `Auto`.
pub(crate) fn resolve(symmetry: Symmetry, occupancy: &Occupancy) -> Symmetry {
    match symmetry {
        Symmetry::Auto => {
            let axes: Vec<usize> = (0..2).filter(|&axis| is_mirrored(occupancy, axis)).collect();
            Symmetry::about(&axes)
        }
        named => named,
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
        let candidate = |point: DVec3| close.one(mirrored(point, &[axis]));
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

/// A point's mirror image about the planes through the origin.
pub(crate) fn mirrored(mut point: DVec3, axes: &[usize]) -> DVec3 {
    for &axis in axes {
        point[axis] = -point[axis];
    }
    point
}
