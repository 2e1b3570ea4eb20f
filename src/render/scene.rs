// SPDX-License-Identifier: MIT OR Apache-2.0
//! What both backends draw, checked once.

use super::{RenderError, View};
use crate::boxdef::DeformField;
use glam::Vec3;
use std::sync::Arc;

/// A field, its triangles and the views, known to fit together.
pub(super) struct Scene {
    pub field: Arc<DeformField>,
    pub triangles: Arc<[[u32; 3]]>,
    /// The vertices that a triangle uses, ascending: only they count for the frame.
    pub used: Vec<u32>,
    pub views: Vec<View>,
    pub size: u32,
}

impl Scene {
    pub fn new(
        field: Arc<DeformField>,
        triangles: Arc<[[u32; 3]]>,
        views: &[View],
        size: u32,
    ) -> Result<Self, RenderError> {
        if !(8..=2048).contains(&size) {
            return Err(RenderError::Size(size));
        }
        if views.is_empty() {
            return Err(RenderError::NoViews);
        }
        if triangles.is_empty() {
            return Err(RenderError::NoTriangles);
        }
        let vertices = field.vertex_count();
        let mut is_used = vec![false; vertices];
        for (triangle, corners) in triangles.iter().enumerate() {
            for &vertex in corners {
                *is_used.get_mut(vertex as usize).ok_or(RenderError::TriangleIndex {
                    triangle,
                    vertex,
                    vertices,
                })? = true;
            }
        }
        let used = (0u32..).zip(is_used).filter_map(|(vertex, used)| used.then_some(vertex)).collect();
        Ok(Self { field, triangles, used, views: views.to_vec(), size })
    }

    /// Bytes of one image.
    pub fn image_bytes(&self) -> usize {
        self.size as usize * self.size as usize * 4
    }

    /// Whether each candidate has a row of factors per parameter row.
    pub fn check(&self, candidates: &[Vec<Vec3>]) -> Result<(), RenderError> {
        let expected = self.field.parameter_rows();
        match candidates.iter().enumerate().find(|(_, scales)| scales.len() != expected) {
            Some((candidate, scales)) => {
                Err(RenderError::ScaleRows { candidate, expected, got: scales.len() })
            }
            None => Ok(()),
        }
    }
}
