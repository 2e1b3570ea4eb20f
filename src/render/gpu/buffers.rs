// SPDX-License-Identifier: MIT OR Apache-2.0
//! What lies on the device: the scene, uploaded once, and a submission's working memory, kept between calls.

use super::pipelines::{DEPTH, NUMBERS};
use super::plan::Plan;
use crate::render::camera::Camera;
use crate::render::scene::Scene;
use glam::Vec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages};

/// Uniforms of one batch, as `Batch` in `common.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Batch {
    pub vertices: u32,
    pub parameter_rows: u32,
    pub used: u32,
    pub size: u32,
    pub views: u32,
    pub columns: u32,
    pub rows: u32,
    pub first_tile: u32,
}

/// Bytes of a frame: centre and one over the radius.
pub(super) const FRAME_BYTES: u64 = 16;

/// Bytes of a camera: three axes, each padded to four numbers.
const CAMERA_FLOATS: usize = 12;

/// The parts of a scene that no candidate changes.
pub(super) struct SceneBuffers {
    pub rest: Buffer,
    pub basis: Buffer,
    pub triangles: Buffer,
    pub used: Buffer,
}

impl SceneBuffers {
    pub fn new(device: &wgpu::Device, scene: &Scene) -> Self {
        let upload = |label, contents: &[u8]| {
            // A binding cannot be empty, as the basis of a field without parameters is.
            let contents = if contents.is_empty() { &[0; 4] } else { contents };
            let usage = BufferUsages::STORAGE;
            device.create_buffer_init(&BufferInitDescriptor { label: Some(label), contents, usage })
        };
        Self {
            rest: upload("rest", bytemuck::cast_slice(&flatten(scene.field.rest()))),
            basis: upload("basis", bytemuck::cast_slice(scene.field.basis())),
            triangles: upload("triangles", bytemuck::cast_slice(&scene.triangles)),
            used: upload("used", bytemuck::cast_slice(&scene.used)),
        }
    }

    /// The largest of them, bytes.
    pub fn largest(scene: &Scene) -> u64 {
        let longest = (3 * scene.field.vertex_count())
            .max(scene.field.basis().len())
            .max(3 * scene.triangles.len())
            .max(CAMERA_FLOATS * scene.views.len());
        4 * longest as u64
    }
}

/// Cameras of the views that `chosen` lists, as `Camera` in `common.wgsl`.
pub(super) fn cameras(scene: &Scene, chosen: &[usize]) -> Vec<f32> {
    let axes = chosen.iter().map(|&view| Camera::new(scene.views[view]));
    let axes = axes.flat_map(|Camera { right, up, back }| [right, up, back]);
    axes.flat_map(|axis| [axis.x, axis.y, axis.z, 0.0]).collect()
}

/// Vectors as numbers, three each.
pub(super) fn flatten(vectors: &[Vec3]) -> Vec<f32> {
    vectors.iter().flat_map(Vec3::to_array).collect()
}

/// The working memory of one submission under a plan.
pub(super) struct Work {
    pub plan: Plan,
    /// Of the views that are drawn.
    pub cameras: Buffer,
    pub scales: Buffer,
    pub positions: Buffer,
    pub frames: Buffer,
    pub pixels: Buffer,
    /// The pixels, then the frames.
    pub readback: Buffer,
    pub numbers: wgpu::TextureView,
    pub depth: wgpu::TextureView,
}

impl Work {
    pub fn new(device: &wgpu::Device, scene: &Scene, plan: Plan) -> Self {
        let candidates = plan.candidates as u64;
        let buffer = |label, size: u64, usage| {
            let size = size.max(4);
            let descriptor =
                wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
            device.create_buffer(&descriptor)
        };
        let texture = |label, format, extra| {
            let side = 2 * scene.size;
            let descriptor = wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d {
                    width: plan.columns * side,
                    height: plan.rows * side,
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | extra,
                view_formats: &[],
            };
            device.create_texture(&descriptor).create_view(&wgpu::TextureViewDescriptor::default())
        };
        let (storage, source) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC);
        let pixels = candidates * (scene.views.len() * scene.image_bytes()) as u64;
        let frames = candidates * FRAME_BYTES;
        let scales = candidates * scene.field.parameter_rows() as u64 * 12;
        Self {
            plan,
            cameras: buffer(
                "cameras",
                (scene.views.len() * CAMERA_FLOATS * 4) as u64,
                storage | BufferUsages::COPY_DST,
            ),
            scales: buffer("scales", scales, storage | BufferUsages::COPY_DST),
            positions: buffer("positions", candidates * scene.field.vertex_count() as u64 * 12, storage),
            frames: buffer("frames", frames, storage | source),
            pixels: buffer("pixels", pixels, storage | source),
            readback: buffer("readback", pixels + frames, BufferUsages::MAP_READ | BufferUsages::COPY_DST),
            numbers: texture("numbers", NUMBERS, wgpu::TextureUsages::TEXTURE_BINDING),
            depth: texture("depth", DEPTH, wgpu::TextureUsages::empty()),
        }
    }
}
