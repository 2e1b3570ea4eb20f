// SPDX-License-Identifier: MIT OR Apache-2.0
//! Choosing an adapter, opening it, and hearing of its failures.

use crate::render::RenderError;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The interfaces asked for adapters, in turn: OpenGL only where a GPU is insisted on and nothing else has one,
/// since it shares a process with Blender's own OpenGL.
const NATIVE: wgpu::Backends =
    wgpu::Backends::VULKAN.union(wgpu::Backends::METAL).union(wgpu::Backends::DX12);
const TRIED: &str = if cfg!(target_os = "macos") {
    "Metal"
} else if cfg!(windows) {
    "Vulkan, Direct3D 12 and OpenGL"
} else {
    "Vulkan and OpenGL"
};

/// Storage buffers that one of our shaders binds.
const STORAGE_BUFFERS: u32 = 5;

/// The first failure that the device reported; once there, the device is not used any more.
#[derive(Debug, Clone, Default)]
pub(super) struct Faults(Arc<Mutex<Option<String>>>);

impl Faults {
    fn report(&self, what: String) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(what);
    }

    /// An error if there was a failure.
    pub fn check(&self) -> Result<(), RenderError> {
        match &*self.0.lock().unwrap_or_else(PoisonError::into_inner) {
            Some(what) => Err(RenderError::Gpu(what.clone())),
            None => Ok(()),
        }
    }
}

/// An open device.
pub(super) struct Gpu {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub faults: Faults,
    pub name: String,
}

impl Gpu {
    /// Opens the best adapter: discrete, then integrated, then virtual, then software.
    pub fn open() -> Result<Self, RenderError> {
        let adapter = best_adapter(NATIVE)
            .or_else(|| best_adapter(wgpu::Backends::GL))
            .ok_or_else(|| RenderError::NoAdapter { tried: TRIED.to_owned() })?;
        let info = adapter.get_info();
        let descriptor = wgpu::DeviceDescriptor { required_limits: adapter.limits(), ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| RenderError::Gpu(error.to_string()))?;
        let faults = Faults::default();
        let heard = faults.clone();
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| heard.report(error.to_string())));
        let heard = faults.clone();
        device.set_device_lost_callback(move |_, message| {
            heard.report(format!("the device was lost: {message}"));
        });
        Ok(Self { device, queue, faults, name: format!("gpu: {} ({:?})", info.name, info.backend) })
    }
}

/// The name of the best adapter, where it is a real GPU; asked once a process, since asking opens the drivers.
pub(in crate::render) fn real_gpu() -> Option<&'static str> {
    static ANSWER: OnceLock<Option<String>> = OnceLock::new();
    let ask = || {
        let real = best_adapter(NATIVE).filter(|adapter| rank(adapter) < SOFTWARE);
        Ok(real.map(|adapter| adapter.get_info().name))
    };
    ANSWER.get_or_init(|| super::guarded(ask).unwrap_or(None)).as_deref()
}

const SOFTWARE: u8 = 4;

fn rank(adapter: &wgpu::Adapter) -> u8 {
    match adapter.get_info().device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => SOFTWARE,
    }
}

fn best_adapter(backends: wgpu::Backends) -> Option<wgpu::Adapter> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let instance = wgpu::Instance::new(descriptor);
    let needed = wgpu::DownlevelFlags::COMPUTE_SHADERS | wgpu::DownlevelFlags::VERTEX_STORAGE;
    pollster::block_on(instance.enumerate_adapters(backends))
        .into_iter()
        .filter(|adapter| adapter.get_downlevel_capabilities().flags.contains(needed))
        .filter(|adapter| adapter.limits().max_storage_buffers_per_shader_stage >= STORAGE_BUFFERS)
        .min_by_key(rank)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_driver_reports_becomes_an_error() {
        // Without an adapter there is no driver to report anything.
        let Ok(gpu) = Gpu::open() else { return };
        assert_eq!(gpu.faults.check(), Ok(()));
        let mut descriptor = wgpu::BufferDescriptor {
            label: None,
            size: gpu.device.limits().max_buffer_size.saturating_add(4),
            usage: wgpu::BufferUsages::STORAGE,
            mapped_at_creation: false,
        };
        let _ = gpu.device.create_buffer(&descriptor);
        let told = gpu.faults.check().unwrap_err().to_string();
        assert!(
            told.starts_with("the GPU failed (") && told.ends_with("choose the renderer \"cpu\""),
            "{told}"
        );
        descriptor.usage = wgpu::BufferUsages::empty();
        let _ = gpu.device.create_buffer(&descriptor);
        assert_eq!(gpu.faults.check().unwrap_err().to_string(), told, "the first failure is kept");
    }

    #[test]
    fn a_panic_inside_wgpu_becomes_an_error() {
        let told = super::super::guarded::<()>(|| panic!("no way out")).unwrap_err();
        assert_eq!(told, RenderError::Gpu("no way out".to_owned()));
    }
}
