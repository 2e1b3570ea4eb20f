// SPDX-License-Identifier: MIT OR Apache-2.0
//! What encodes images: the processor, or another execution provider of ONNX Runtime's library.

use std::str::FromStr;

use ort::ep::ExecutionProviderDispatch;
use ort::ep::{self, ArbitrarilyConfigurableExecutionProvider as _, ExecutionProvider};

use super::{GuideError, runtime};

/// An execution provider. The library inside the wheel has the processor, and Core ML on a Mac.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Provider {
    /// NVIDIA graphics cards.
    Cuda,
    /// Any graphics card under Windows.
    DirectMl,
    /// Apple's processors.
    CoreMl,
    /// AMD graphics cards.
    MiGraphX,
    /// Intel's processors and graphics.
    OpenVino,
    /// The processor, by ONNX Runtime itself.
    Cpu,
}

impl Provider {
    /// All that can be asked for, the fastest first.
    pub const ALL: [Self; 6] =
        [Self::Cuda, Self::DirectMl, Self::CoreMl, Self::MiGraphX, Self::OpenVino, Self::Cpu];

    /// Its name in the interface to Python and in records.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Cuda => "cuda",
            Self::DirectMl => "directml",
            Self::CoreMl => "coreml",
            Self::MiGraphX => "migraphx",
            Self::OpenVino => "openvino",
            Self::Cpu => "cpu",
        }
    }

    /// Those that the library in use was built with; they may still fail to start.
    pub fn offered() -> Result<Vec<Self>, GuideError> {
        let mut offered = Vec::new();
        for provider in Self::ALL {
            if provider.is_offered()? {
                offered.push(provider);
            }
        }
        Ok(offered)
    }

    /// Whether the library in use was built with it.
    pub fn is_offered(self) -> Result<bool, GuideError> {
        runtime::environment()?;
        let known = match self {
            Self::Cuda => ep::CUDA::is_available(),
            Self::DirectMl => ep::DirectML::is_available(),
            Self::CoreMl => ep::CoreML::is_available(),
            Self::MiGraphX => ep::MIGraphX::is_available(),
            Self::OpenVino => ep::OpenVINO::is_available(),
            Self::Cpu => Ok(true),
        };
        Ok(known.unwrap_or(false))
    }

    /// How ONNX Runtime is told to use it, the best way first; none for the processor, which it uses by itself.
    pub(super) fn ways(self, threads: usize) -> Vec<ExecutionProviderDispatch> {
        let ways = match self {
            Self::Cuda => vec![ep::CUDA::default().build()],
            Self::DirectMl => vec![ep::DirectML::default().build()],
            Self::CoreMl => vec![ep::CoreML::default().build()],
            Self::MiGraphX => vec![ep::MIGraphX::default().build()],
            // Its device "AUTO" is refused where there are no Intel graphics. 32-bit floats, where it would round
            // to 16 bits by itself.
            Self::OpenVino => vec![
                ep::OpenVINO::default().with_device_type("GPU").with_precision("FP32").build(),
                ep::OpenVINO::default()
                    .with_device_type("CPU")
                    .with_arbitrary_config("load_config", openvino(threads))
                    .build(),
            ],
            Self::Cpu => Vec::new(),
        };
        ways.into_iter().map(ExecutionProviderDispatch::error_on_failure).collect()
    }

    /// What its makers call it.
    fn title(self) -> &'static str {
        match self {
            Self::Cuda => "CUDA",
            Self::DirectMl => "DirectML",
            Self::CoreMl => "Core ML",
            Self::MiGraphX => "MIGraphX",
            Self::OpenVino => "OpenVINO",
            Self::Cpu => "the processor",
        }
    }

    /// The sentence where the library does not have it.
    pub(super) fn missing(self) -> String {
        format!(
            "ONNX Runtime's library in use has no {}, so the processor encodes the images; name a library that \
             has it, or choose another provider",
            self.title()
        )
    }

    /// The sentence where it does not start.
    pub(super) fn failed(self, error: &GuideError) -> String {
        let reason = match error {
            GuideError::BadModel { reason, .. } | GuideError::Run { reason, .. } => reason.clone(),
            other => other.to_string(),
        };
        let reason = reason.lines().next().unwrap_or_default();
        format!("{} cannot be used ({reason}), so the processor encodes the images", self.title())
    }
}

impl FromStr for Provider {
    type Err = GuideError;

    fn from_str(name: &str) -> Result<Self, GuideError> {
        Self::ALL.into_iter().find(|provider| provider.name() == name).ok_or_else(|| {
            let known = Self::ALL.map(|provider| format!("\"{}\"", provider.name())).join(", ");
            GuideError::UnknownProvider { name: name.into(), known: format!("\"auto\", {known}") }
        })
    }
}

/// The processor, so that results are the same everywhere; but a large guide goes to the graphics card, where a
/// library that the user named has one. `OpenVINO` is not taken by itself: on a processor it is no faster in 32
/// bits, and slower to open.
pub fn automatic(small: bool) -> Result<Provider, GuideError> {
    if small || !runtime::is_own_library()? {
        return Ok(Provider::Cpu);
    }
    let offered = Provider::offered()?;
    let taken = offered.into_iter().find(|provider| *provider != Provider::OpenVino);
    Ok(taken.unwrap_or(Provider::Cpu))
}

/// Settings of `OpenVINO` on the processor.
fn openvino(threads: usize) -> String {
    format!(r#"{{"CPU":{{"INFERENCE_PRECISION_HINT":"f32","INFERENCE_NUM_THREADS":"{threads}"}}}}"#)
}
