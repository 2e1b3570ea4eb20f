// SPDX-License-Identifier: MIT OR Apache-2.0
//! The CPU backend: 2 × 2 samples a pixel, candidates and views in parallel, no allocation after the first call.

use super::camera::Camera;
use super::frame::Frame;
use super::raster::{Raster, triangle};
use super::shading::Shader;
use super::{RenderError, Renderer, Scene};
use crate::boxdef::DeformField;
use crate::spare::Spare;
use glam::Vec3;
use rayon::prelude::*;

/// Renders on the CPU's cores, within the current `rayon` pool.
pub(super) struct CpuRenderer {
    scene: Scene,
    /// Red, green and blue of each triangle, 0 to 1; `None` draws grey.
    colors: Option<Vec<[f32; 3]>>,
    cameras: Vec<Camera>,
    positions: Spare<Vec<Vec3>>,
    rasters: Spare<Raster>,
}

impl CpuRenderer {
    pub fn new(scene: Scene) -> Self {
        let cameras = scene.views.iter().map(|&view| Camera::new(view)).collect();
        Self { scene, colors: None, cameras, positions: Spare::default(), rasters: Spare::default() }
    }

    /// Draws each triangle in its color, lighter or darker by the light on it.
    pub fn colored(scene: Scene, colors: &[[u8; 3]]) -> Result<Self, RenderError> {
        let (expected, got) = (scene.triangles.len(), colors.len());
        if got != expected {
            return Err(RenderError::ColorRows { expected, got });
        }
        let colors = colors.iter().map(|color| color.map(|channel| f32::from(channel) / 255.0)).collect();
        Ok(Self { colors: Some(colors), ..Self::new(scene) })
    }

    fn candidate(
        &self,
        index: usize,
        scales: &[Vec3],
        views: &[usize],
        out: &mut [u8],
    ) -> Result<(), RenderError> {
        self.positions.with(|positions| {
            let field: &DeformField = &self.scene.field;
            positions.resize(field.vertex_count(), Vec3::ZERO);
            field.deform_into(scales, positions);
            let frame =
                Frame::of(positions, &self.scene.used).ok_or(RenderError::NonFinite { candidate: index })?;
            out.par_chunks_exact_mut(self.scene.image_bytes()).zip(views).for_each(|(image, &view)| {
                let camera = &self.cameras[view];
                self.rasters.with(|raster| self.view(raster, camera, frame, positions, image));
            });
            Ok(())
        })
    }

    fn view(&self, raster: &mut Raster, camera: &Camera, frame: Frame, positions: &[Vec3], image: &mut [u8]) {
        let size = self.scene.size as usize;
        raster.draw(camera, frame, positions, &self.scene.triangles, 2 * size);
        let shader = Shader::new(camera, frame);
        let corners = |index: usize| self.scene.triangles[index].map(|vertex| positions[vertex as usize]);
        match &self.colors {
            None => resolve(raster, size, image, |index| [shader.grey(corners(index))]),
            Some(colors) => resolve(raster, size, image, |index| {
                let light = shader.light(corners(index));
                colors[index].map(|channel| light * channel)
            }),
        }
    }
}

/// Averages the samples of each pixel; `shade` gives a triangle's grey, or its red, green and blue.
fn resolve<const CHANNELS: usize>(
    raster: &Raster,
    size: usize,
    image: &mut [u8],
    shade: impl Fn(usize) -> [f32; CHANNELS],
) {
    image.fill(0);
    let [x0, x1, y0, y1] = raster.touched();
    let (x0, x1) = (x0 / 2, x1.div_ceil(2));
    let mut last = (usize::MAX, [0.0; CHANNELS]);
    for y in y0 / 2..y1.div_ceil(2) {
        let rows = [raster.row(2 * y), raster.row(2 * y + 1)];
        for x in x0..x1 {
            let samples = [rows[0][2 * x], rows[0][2 * x + 1], rows[1][2 * x], rows[1][2 * x + 1]];
            let (mut sum, mut covered) = ([0.0; CHANNELS], 0u8);
            for index in samples.into_iter().filter_map(triangle) {
                if index != last.0 {
                    last = (index, shade(index));
                }
                for (sum, value) in sum.iter_mut().zip(last.1) {
                    *sum += value;
                }
                covered += 1;
            }
            if covered > 0 {
                let byte = |value: f32| (value * 255.0 + 0.5) as u8;
                let shade = sum.map(|sum| byte(sum / f32::from(covered)));
                let [red, green, blue] = [0, 1, 2].map(|channel: usize| shade[channel.min(CHANNELS - 1)]);
                let alpha = byte(f32::from(covered) / 4.0);
                let at = 4 * (y * size + x);
                image[at..at + 4].copy_from_slice(&[red, green, blue, alpha]);
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

    fn draws_generations(&self) -> bool {
        false
    }

    fn backend_name(&self) -> String {
        "cpu".to_owned()
    }

    fn render(
        &self,
        candidates: &[Vec<Vec3>],
        views: &[usize],
        out: &mut Vec<u8>,
    ) -> Result<(), RenderError> {
        self.scene.check(candidates)?;
        let bytes = views.len() * self.scene.image_bytes();
        out.resize(candidates.len() * bytes, 0);
        if bytes == 0 {
            return Ok(());
        }
        // Of several errors the first candidate's is told.
        let error = out
            .par_chunks_exact_mut(bytes)
            .zip(candidates)
            .enumerate()
            .filter_map(|(index, (images, scales))| self.candidate(index, scales, views, images).err())
            .find_first(|_| true);
        error.map_or(Ok(()), Err)
    }
}
