// SPDX-License-Identifier: MIT OR Apache-2.0
//! Candidates to images: one interface, a CPU rasteriser and `wgpu` (paper §4).
//!
//! A candidate is deformed, scaled to the unit sphere about the centre of its bounding box, and seen from each
//! view with flat grey shading and 2 × 2 samples a pixel. Images carry alpha; [`composite`] lays them over a
//! background.

mod camera;
mod composite;
mod cpu;
mod error;
mod frame;
mod gpu;
mod raster;
mod scene;
mod shading;

pub use camera::{View, views_by_name};
pub use composite::{BACKGROUNDS, composite, premultiply};
pub use error::RenderError;

use crate::boxdef::DeformField;
use glam::Vec3;
use scene::Scene;
use std::str::FromStr;
use std::sync::Arc;

/// What draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Backend {
    /// `wgpu` where the adapter is a real GPU, the CPU rasteriser elsewhere.
    #[default]
    Auto,
    /// The CPU rasteriser.
    Cpu,
    /// `wgpu` on whatever adapter there is, a software one included.
    Gpu,
}

impl FromStr for Backend {
    type Err = RenderError;

    fn from_str(name: &str) -> Result<Self, RenderError> {
        match name {
            "auto" => Ok(Self::Auto),
            "cpu" => Ok(Self::Cpu),
            "gpu" => Ok(Self::Gpu),
            _ => Err(RenderError::UnknownBackend(name.to_owned())),
        }
    }
}

/// The name of the best adapter, where it is a real GPU; asked once a process, since asking opens the drivers.
#[must_use]
pub fn real_gpu() -> Option<&'static str> {
    gpu::real_gpu()
}

/// Draws candidates of one field from fixed views; keeps its buffers between calls.
pub trait Renderer: Send + Sync {
    /// Number of views it was opened with.
    fn views(&self) -> usize;

    /// Pixels along each side of an image.
    fn size(&self) -> u32;

    /// Whether a whole generation is best drawn in one call, as on a GPU; elsewhere several threads may each draw
    /// some of it.
    fn draws_generations(&self) -> bool;

    /// What draws, for the report: `cpu`, or `gpu:` with the adapter's name and interface.
    fn backend_name(&self) -> String;

    /// Renders `candidates`, each the factors of its field ([`DeformField`]), from those of its views that `views`
    /// lists, into `out`. The others cost nothing.
    ///
    /// `out` becomes RGBA8 with straight alpha: candidates × views listed × size × size × 4, rows from the top. On
    /// an error its content is unspecified. Several threads may render at once.
    ///
    /// # Panics
    /// If it was not opened with one of the views.
    fn render(&self, candidates: &[Vec<Vec3>], views: &[usize], out: &mut Vec<u8>)
    -> Result<(), RenderError>;
}

/// A renderer for the candidates of `field`, whose vertices `triangles` connect.
///
/// `size`: pixels along each side of an image, 8 to 2048.
pub fn open(
    backend: Backend,
    field: Arc<DeformField>,
    triangles: Arc<[[u32; 3]]>,
    views: &[View],
    size: u32,
) -> Result<Box<dyn Renderer>, RenderError> {
    let scene = Scene::new(field, triangles, views, size)?;
    match backend {
        Backend::Auto if real_gpu().is_some() => Ok(match gpu::GpuRenderer::new(scene) {
            Ok(renderer) => Box::new(renderer),
            Err((_, scene)) => Box::new(cpu::CpuRenderer::new(scene)),
        }),
        Backend::Auto | Backend::Cpu => Ok(Box::new(cpu::CpuRenderer::new(scene))),
        Backend::Gpu => match gpu::GpuRenderer::new(scene) {
            Ok(renderer) => Ok(Box::new(renderer)),
            Err((error, _)) => Err(error),
        },
    }
}

/// Renders a shape as it is: RGBA8, views × size × size × 4.
///
/// `positions` are in object coordinates, z up. `Auto` is the CPU here: it has drawn one shape before a GPU is
/// open.
pub fn render_positions(
    backend: Backend,
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    views: &[View],
    size: u32,
) -> Result<Vec<u8>, RenderError> {
    let backend = if backend == Backend::Auto { Backend::Cpu } else { backend };
    let field = Arc::new(DeformField::new(positions.to_vec(), 0, Vec::new()));
    shape_as_it_is(&*open(backend, field, triangles.into(), views, size)?)
}

/// Renders a shape as [`render_positions`] does, but each triangle in its color, lighter or darker by the light on
/// it.
///
/// Colors are drawn on the CPU alone: there is no candidate to hurry for.
pub fn render_colored(
    backend: Backend,
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    colors: &[[u8; 3]],
    views: &[View],
    size: u32,
) -> Result<Vec<u8>, RenderError> {
    if backend == Backend::Gpu {
        return Err(RenderError::ColorsOnGpu);
    }
    let field = Arc::new(DeformField::new(positions.to_vec(), 0, Vec::new()));
    let scene = Scene::new(field, triangles.into(), views, size)?;
    shape_as_it_is(&cpu::CpuRenderer::colored(scene, colors)?)
}

/// All views of the only candidate of a field without parameters.
fn shape_as_it_is(renderer: &dyn Renderer) -> Result<Vec<u8>, RenderError> {
    let views: Vec<usize> = (0..renderer.views()).collect();
    let mut out = Vec::new();
    renderer.render(&[Vec::new()], &views, &mut out)?;
    Ok(out)
}
