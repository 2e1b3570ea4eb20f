// SPDX-License-Identifier: MIT OR Apache-2.0
//! The four steps of a batch: deform, frame, draw, resolve.

/// Put the shared declarations before a shader.
macro_rules! shader {
    ($file:literal) => {
        concat!(include_str!("common.wgsl"), include_str!($file))
    };
}

/// Triangle numbers, one a sample.
pub(super) const NUMBERS: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;
/// Larger is nearer.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Compiled once a device.
pub(super) struct Pipelines {
    pub deform: wgpu::ComputePipeline,
    pub frame: wgpu::ComputePipeline,
    pub draw: wgpu::RenderPipeline,
    pub resolve: wgpu::ComputePipeline,
}

impl Pipelines {
    pub fn new(device: &wgpu::Device) -> Self {
        Self {
            deform: compute(device, "deform", shader!("deform.wgsl")),
            frame: compute(device, "frame", shader!("frame.wgsl")),
            draw: draw(device, shader!("draw.wgsl")),
            resolve: compute(device, "resolve", shader!("resolve.wgsl")),
        }
    }
}

fn module(device: &wgpu::Device, label: &str, source: &str) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    })
}

fn compute(device: &wgpu::Device, label: &str, source: &str) -> wgpu::ComputePipeline {
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(label),
        layout: None,
        module: &module(device, label, source),
        entry_point: None,
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}

fn draw(device: &wgpu::Device, source: &str) -> wgpu::RenderPipeline {
    let module = module(device, "draw", source);
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("draw"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: None,
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        // Both sides are drawn: meshes come flipped, mixed and open.
        primitive: wgpu::PrimitiveState { cull_mode: None, ..Default::default() },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: None,
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(NUMBERS.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
