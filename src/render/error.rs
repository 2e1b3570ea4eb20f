// SPDX-License-Identifier: MIT OR Apache-2.0
//! What can go wrong while rendering, each in a sentence that says what to do.

use thiserror::Error;

/// Why there is no image.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
pub enum RenderError {
    /// No such set of views.
    #[error("unknown views \"{0}\": choose \"paper\", \"ring\" or \"front right\"")]
    UnknownViews(String),
    /// No such backend.
    #[error("unknown renderer \"{0}\": choose \"auto\", \"cpu\" or \"gpu\"")]
    UnknownBackend(String),
    /// An empty list of views.
    #[error("there are no views to render: give at least one")]
    NoViews,
    /// An image too small to show anything, or too large for the buffers.
    #[error("an image size of {0} pixels is not possible: choose one from 8 to 2048")]
    Size(u32),
    /// Nothing to draw.
    #[error("the mesh has no faces to render: give an object with at least one face")]
    NoTriangles,
    /// A triangle refers to a vertex that does not exist.
    #[error(
        "triangle {triangle} refers to vertex {vertex}, but the mesh has {vertices} vertices: repair the mesh"
    )]
    TriangleIndex {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex it refers to.
        vertex: u32,
        /// Number of vertices there are.
        vertices: usize,
    },
    /// Another number of colors than of triangles.
    #[error("there are {got} colors for {expected} triangles: give one color each")]
    ColorRows {
        /// Triangles of the mesh.
        expected: usize,
        /// Colors given.
        got: usize,
    },
    /// Colors, for the backend that has none.
    #[error("the renderer \"gpu\" draws no colors: choose \"cpu\" or \"auto\"")]
    ColorsOnGpu,
    /// A candidate with another number of scale factors than the field has parameter rows.
    #[error(
        "candidate {candidate} has {got} rows of scale factors, but the field has {expected}: give one row each"
    )]
    ScaleRows {
        /// Index of the candidate.
        candidate: usize,
        /// Parameter rows of the field.
        expected: usize,
        /// Rows given.
        got: usize,
    },
    /// NaN or infinity in a vertex that a triangle uses.
    #[error(
        "candidate {candidate} has vertices at positions that are not finite: \
         look for NaN or infinite numbers in the mesh and the scale factors"
    )]
    NonFinite {
        /// Index of the candidate.
        candidate: usize,
    },
    /// No adapter for the `wgpu` backend.
    #[error("No GPU adapter was found (tried {tried}): choose the renderer \"cpu\" or install a driver.")]
    NoAdapter {
        /// The graphics interfaces that were asked.
        tried: String,
    },
    /// The mesh does not fit the adapter's buffers.
    #[error("the mesh is too large for the GPU ({0}): choose the renderer \"cpu\"")]
    TooLargeForGpu(String),
    /// The driver reported a failure: device lost, out of memory, validation.
    #[error("the GPU failed ({0}): choose the renderer \"cpu\"")]
    Gpu(String),
}

impl RenderError {
    /// The same where candidates are counted from `first`.
    #[must_use]
    pub(crate) fn counted_from(mut self, first: usize) -> Self {
        if let Self::NonFinite { candidate } | Self::ScaleRows { candidate, .. } = &mut self {
            *candidate += first;
        }
        self
    }

    /// True where the caller's input is wrong rather than the renderer.
    #[must_use]
    pub fn is_input(&self) -> bool {
        matches!(
            self,
            Self::UnknownViews(_)
                | Self::UnknownBackend(_)
                | Self::Size(_)
                | Self::NoTriangles
                | Self::TriangleIndex { .. }
                | Self::NonFinite { .. }
                | Self::ColorRows { .. }
                | Self::ColorsOnGpu
        )
    }
}
