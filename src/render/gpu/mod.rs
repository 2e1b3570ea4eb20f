// SPDX-License-Identifier: MIT OR Apache-2.0
//! The `wgpu` backend: a generation in one submission.
//!
//! Candidates are deformed and framed in compute shaders, drawn as triangle numbers into an atlas of tiles at
//! twice the size, and shaded and averaged in a compute shader: the same samples as the CPU backend's, and no
//! multisampling, whose resolve not every driver gets right.

mod buffers;
mod device;
mod pipelines;
mod plan;

pub(super) use device::real_gpu;

use super::scene::Scene;
use super::{RenderError, Renderer};
use buffers::{Batch, FRAME_BYTES, SceneBuffers, Work, cameras, flatten};
use device::Gpu;
use glam::Vec3;
use pipelines::Pipelines;
use plan::{Demand, Plan};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, PoisonError, mpsc};
use wgpu::util::DeviceExt;

/// Renders on an adapter of `wgpu`.
pub(super) struct GpuRenderer {
    scene: Scene,
    demand: Demand,
    gpu: Gpu,
    pipelines: Pipelines,
    buffers: SceneBuffers,
    work: Mutex<Option<Work>>,
}

/// Runs `work`, a panic of `wgpu` becoming an error: some failures of a driver leave it no other way.
fn guarded<R>(work: impl FnOnce() -> Result<R, RenderError>) -> Result<R, RenderError> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        let what = payload.downcast_ref::<String>().map(String::as_str);
        let what = what.or_else(|| payload.downcast_ref::<&str>().copied());
        Err(RenderError::Gpu(what.unwrap_or("its driver gave up").to_owned()))
    })
}

impl GpuRenderer {
    /// Opens the best adapter and uploads the scene, which is given back where that fails.
    pub fn new(scene: Scene) -> Result<Self, (RenderError, Scene)> {
        match guarded(|| Self::prepare(&scene)) {
            Ok((demand, gpu, pipelines, buffers)) => {
                Ok(Self { scene, demand, gpu, pipelines, buffers, work: Mutex::default() })
            }
            Err(error) => Err((error, scene)),
        }
    }

    fn prepare(scene: &Scene) -> Result<(Demand, Gpu, Pipelines, SceneBuffers), RenderError> {
        let gpu = Gpu::open()?;
        let limits = gpu.device.limits();
        let demand = Demand {
            vertices: scene.field.vertex_count() as u64,
            views: scene.views.len() as u64,
            size: scene.size,
            buffer_limit: limits.max_storage_buffer_binding_size.min(limits.max_buffer_size),
            texture_limit: limits.max_texture_dimension_2d,
        };
        Plan::new(demand, 1)?;
        let largest = SceneBuffers::largest(scene);
        if largest > demand.buffer_limit {
            let sizes = format!("{} of {} MiB", largest >> 20, demand.buffer_limit >> 20);
            return Err(RenderError::TooLargeForGpu(sizes));
        }
        let pipelines = Pipelines::new(&gpu.device);
        gpu.faults.check()?;
        let buffers = SceneBuffers::new(&gpu.device, scene);
        gpu.faults.check()?;
        Ok((demand, gpu, pipelines, buffers))
    }

    /// Renders as many candidates as the working memory holds, into their images; `views` is their number.
    fn submit(
        &self,
        work: &Work,
        candidates: &[Vec<Vec3>],
        views: u32,
        out: &mut [u8],
    ) -> Result<(), RenderError> {
        let Gpu { device, queue, faults, .. } = &self.gpu;
        let count = candidates.len() as u32;
        let scales: Vec<f32> = candidates.iter().flat_map(|scales| flatten(scales)).collect();
        queue.write_buffer(&work.scales, 0, bytemuck::cast_slice(&scales));
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());

        let tiles = count * views;
        for first_tile in (0..tiles).step_by(work.plan.tiles() as usize) {
            let batch = self.batch(work, views, first_tile);
            if first_tile == 0 {
                self.deform_and_frame(&mut encoder, work, &batch, count);
            }
            let drawn = work.plan.tiles().min(tiles - first_tile);
            self.draw(&mut encoder, work, &batch, drawn);
            self.resolve(&mut encoder, work, &batch, drawn);
        }

        let (pixels, frames) = (out.len() as u64, u64::from(count) * FRAME_BYTES);
        encoder.copy_buffer_to_buffer(&work.pixels, 0, &work.readback, 0, pixels);
        encoder.copy_buffer_to_buffer(&work.frames, 0, &work.readback, pixels, frames);
        queue.submit([encoder.finish()]);
        faults.check()?;

        let slice = work.readback.slice(..pixels + frames);
        let (sender, receiver) = mpsc::channel();
        slice.map_async(wgpu::MapMode::Read, move |result| drop(sender.send(result)));
        device.poll(wgpu::PollType::wait_indefinitely()).map_err(failed)?;
        receiver.recv().map_err(failed)?.map_err(failed)?;
        faults.check()?;
        let broken = {
            let view = slice.get_mapped_range().map_err(failed)?;
            let (images, frames) = view.split_at(out.len());
            out.copy_from_slice(images);
            // The last number of a frame is negative where a position is not finite.
            frames.chunks_exact(FRAME_BYTES as usize).position(|frame| frame[15] & 0x80 != 0)
        };
        work.readback.unmap();
        broken.map_or(Ok(()), |candidate| Err(RenderError::NonFinite { candidate }))
    }

    fn batch(&self, work: &Work, views: u32, first_tile: u32) -> wgpu::Buffer {
        let batch = Batch {
            vertices: self.scene.field.vertex_count() as u32,
            parameter_rows: self.scene.field.parameter_rows() as u32,
            used: self.scene.used.len() as u32,
            size: self.scene.size,
            views,
            columns: work.plan.columns,
            rows: work.plan.rows,
            first_tile,
        };
        self.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("batch"),
            contents: bytemuck::bytes_of(&batch),
            usage: wgpu::BufferUsages::UNIFORM,
        })
    }

    fn deform_and_frame(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        work: &Work,
        batch: &wgpu::Buffer,
        candidates: u32,
    ) {
        let Self { pipelines, buffers, .. } = self;
        let deform = self.bind(
            &pipelines.deform.get_bind_group_layout(0),
            &[batch, &buffers.rest, &buffers.basis, &work.scales, &work.positions],
        );
        let frame = self.bind(
            &pipelines.frame.get_bind_group_layout(0),
            &[batch, &work.positions, &buffers.used, &work.frames],
        );
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipelines.deform);
        pass.set_bind_group(0, &deform, &[]);
        pass.dispatch_workgroups((self.scene.field.vertex_count() as u32).div_ceil(256), candidates, 1);
        pass.set_pipeline(&pipelines.frame);
        pass.set_bind_group(0, &frame, &[]);
        pass.dispatch_workgroups(candidates, 1, 1);
    }

    fn draw(&self, encoder: &mut wgpu::CommandEncoder, work: &Work, batch: &wgpu::Buffer, tiles: u32) {
        let Self { pipelines, buffers, .. } = self;
        let group = self.bind(
            &pipelines.draw.get_bind_group_layout(0),
            &[batch, &work.positions, &buffers.triangles, &work.frames, &work.cameras],
        );
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &work.numbers,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &work.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&pipelines.draw);
        pass.set_bind_group(0, &group, &[]);
        pass.draw(0..3 * self.scene.triangles.len() as u32, 0..tiles);
    }

    fn resolve(&self, encoder: &mut wgpu::CommandEncoder, work: &Work, batch: &wgpu::Buffer, tiles: u32) {
        let Self { pipelines, buffers, .. } = self;
        let layout = pipelines.resolve.get_bind_group_layout(0);
        let mut entries = entries(&[batch, &work.positions, &buffers.triangles, &work.frames, &work.cameras]);
        entries.push(wgpu::BindGroupEntry {
            binding: 5,
            resource: wgpu::BindingResource::TextureView(&work.numbers),
        });
        entries.push(wgpu::BindGroupEntry { binding: 6, resource: work.pixels.as_entire_binding() });
        let group = self.group(&layout, &entries);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipelines.resolve);
        pass.set_bind_group(0, &group, &[]);
        let groups = self.scene.size.div_ceil(8);
        pass.dispatch_workgroups(groups, groups, tiles);
    }

    fn bind(&self, layout: &wgpu::BindGroupLayout, buffers: &[&wgpu::Buffer]) -> wgpu::BindGroup {
        self.group(layout, &entries(buffers))
    }

    fn group(&self, layout: &wgpu::BindGroupLayout, entries: &[wgpu::BindGroupEntry]) -> wgpu::BindGroup {
        let descriptor = wgpu::BindGroupDescriptor { label: None, layout, entries };
        self.gpu.device.create_bind_group(&descriptor)
    }
}

/// Whole buffers at bindings 0, 1, …
fn entries<'a>(buffers: &[&'a wgpu::Buffer]) -> Vec<wgpu::BindGroupEntry<'a>> {
    (0..)
        .zip(buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
        .collect()
}

fn failed(error: impl std::fmt::Display) -> RenderError {
    RenderError::Gpu(error.to_string())
}

impl Renderer for GpuRenderer {
    fn views(&self) -> usize {
        self.scene.views.len()
    }

    fn size(&self) -> u32 {
        self.scene.size
    }

    fn draws_generations(&self) -> bool {
        true
    }

    fn backend_name(&self) -> String {
        self.gpu.name.clone()
    }

    fn render(
        &self,
        candidates: &[Vec<Vec3>],
        views: &[usize],
        out: &mut Vec<u8>,
    ) -> Result<(), RenderError> {
        self.scene.check(candidates)?;
        self.gpu.faults.check()?;
        let bytes = views.len() * self.scene.image_bytes();
        out.resize(candidates.len() * bytes, 0);
        if out.is_empty() {
            return Ok(());
        }
        // One call at a time: the working memory is the device's.
        let mut shared = self.work.lock().unwrap_or_else(PoisonError::into_inner);
        let plan = Plan::new(self.demand, candidates.len())?;
        let kept = shared.take().filter(|work| work.plan.candidates >= plan.candidates);
        let work = match kept {
            Some(work) => work,
            None => guarded(|| {
                let work = Work::new(&self.gpu.device, &self.scene, plan);
                self.gpu.faults.check().map(|()| work)
            })?,
        };
        let axes = cameras(&self.scene, views);
        self.gpu.queue.write_buffer(&work.cameras, 0, bytemuck::cast_slice(&axes));
        let step = work.plan.candidates;
        for (index, (group, images)) in candidates.chunks(step).zip(out.chunks_mut(step * bytes)).enumerate()
        {
            guarded(|| self.submit(&work, group, views.len() as u32, images))
                .map_err(|error| error.counted_from(index * step))?;
        }
        *shared = Some(work);
        Ok(())
    }
}
