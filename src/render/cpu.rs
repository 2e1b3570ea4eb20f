// SPDX-License-Identifier: MIT OR Apache-2.0
//! The CPU backend: 2 × 2 samples a pixel, candidates and views in parallel, no allocation after the first call.

use super::camera::Camera;
use super::frame::Frame;
use super::raster::{Raster, triangle};
use super::shading::Shader;
use super::{RenderError, Renderer, Scene};
use crate::boxdef::DeformField;
use glam::Vec3;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Buffers that workers take and give back.
#[derive(Debug, Default)]
struct Pool<T>(Mutex<Vec<T>>);

impl<T: Default> Pool<T> {
    fn with<R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
        let mut item = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default();
        let result = work(&mut item);
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(item);
        result
    }
}

/// Renders on the CPU's cores, within the current `rayon` pool.
pub(super) struct CpuRenderer {
    scene: Scene,
    cameras: Vec<Camera>,
    positions: Pool<Vec<Vec3>>,
    rasters: Pool<Raster>,
}

impl CpuRenderer {
    pub fn new(scene: Scene) -> Self {
        let cameras = scene.views.iter().map(|&view| Camera::new(view)).collect();
        Self { scene, cameras, positions: Pool::default(), rasters: Pool::default() }
    }

    fn candidate(&self, index: usize, scales: &[Vec3], out: &mut [u8]) -> Result<(), RenderError> {
        self.positions.with(|positions| {
            let field: &DeformField = &self.scene.field;
            positions.resize(field.vertex_count(), Vec3::ZERO);
            field.deform_into(scales, positions);
            let frame =
                Frame::of(positions, &self.scene.used).ok_or(RenderError::NonFinite { candidate: index })?;
            let tile = out.len() / self.cameras.len();
            out.par_chunks_exact_mut(tile).zip(&self.cameras).for_each(|(image, camera)| {
                self.rasters.with(|raster| self.view(raster, camera, frame, positions, image));
            });
            Ok(())
        })
    }

    fn view(&self, raster: &mut Raster, camera: &Camera, frame: Frame, positions: &[Vec3], image: &mut [u8]) {
        let size = self.scene.size as usize;
        raster.draw(camera, frame, positions, &self.scene.triangles, 2 * size);
        let shader = Shader::new(camera, frame);
        let grey =
            |index: usize| shader.grey(self.scene.triangles[index].map(|vertex| positions[vertex as usize]));
        image.fill(0);
        let [x0, x1, y0, y1] = raster.touched();
        let (x0, x1) = (x0 / 2, x1.div_ceil(2));
        let mut last = (usize::MAX, 0.0);
        for y in y0 / 2..y1.div_ceil(2) {
            let rows = [raster.row(2 * y), raster.row(2 * y + 1)];
            for x in x0..x1 {
                let samples = [rows[0][2 * x], rows[0][2 * x + 1], rows[1][2 * x], rows[1][2 * x + 1]];
                let (mut sum, mut covered) = (0.0, 0u8);
                for index in samples.into_iter().filter_map(triangle) {
                    if index != last.0 {
                        last = (index, grey(index));
                    }
                    sum += last.1;
                    covered += 1;
                }
                if covered > 0 {
                    let byte = |value: f32| (value * 255.0 + 0.5) as u8;
                    let grey = byte(sum / f32::from(covered));
                    let alpha = byte(f32::from(covered) / 4.0);
                    let at = 4 * (y * size + x);
                    image[at..at + 4].copy_from_slice(&[grey, grey, grey, alpha]);
                }
            }
        }
    }
}

impl Renderer for CpuRenderer {
    fn views(&self) -> usize {
        self.cameras.len()
    }

    fn size(&self) -> u32 {
        self.scene.size
    }

    fn backend_name(&self) -> String {
        "cpu".to_owned()
    }

    fn render(&mut self, candidates: &[Vec<Vec3>], out: &mut Vec<u8>) -> Result<(), RenderError> {
        self.scene.check(candidates)?;
        let bytes = self.scene.candidate_bytes();
        out.resize(candidates.len() * bytes, 0);
        let this = &*self;
        // Collected in order, so that of several errors the first candidate's is told.
        let results: Vec<_> = out
            .par_chunks_exact_mut(bytes)
            .zip(candidates)
            .enumerate()
            .map(|(index, (images, scales))| this.candidate(index, scales, images))
            .collect();
        results.into_iter().collect()
    }
}
