// SPDX-License-Identifier: MIT OR Apache-2.0
//! One ONNX network: tokens or images in, embeddings out.

use std::sync::{Mutex, MutexGuard};

use ort::environment::Environment;
use ort::session::builder::GraphOptimizationLevel;
use ort::session::{Session, SessionOutputs};
use ort::value::{Tensor, TensorRef};
use rayon::prelude::*;

use super::GuideError;
use super::Provider;
use super::network::{Network, TextInput, text_input};
use super::preprocess::Preprocess;
use super::text::Tokens;

/// A network, opened once or once a thread (a session runs one batch at a time).
pub struct Encoder {
    file: String,
    sessions: Vec<Mutex<Worker>>,
    inputs: Vec<String>,
    output: String,
    fixed_batch: Option<usize>,
}

struct Worker {
    session: Session,
    pixels: Vec<f32>,
}

impl Encoder {
    pub fn open(
        environment: &Environment,
        network: &Network,
        provider: Provider,
        sessions: usize,
        intra_threads: usize,
    ) -> Result<Self, GuideError> {
        let bad = |reason: String| GuideError::BadModel { file: network.file.clone(), reason };
        let failed = |error: &ort::Error| bad(GuideError::reason(error));
        let open = || -> Result<Session, GuideError> {
            let mut builder = Session::builder(environment).map_err(|e| failed(&e))?;
            let ways = provider.ways(intra_threads);
            for (number, way) in ways.iter().enumerate() {
                match builder.with_execution_providers(std::slice::from_ref(way)) {
                    Ok(told) => {
                        builder = told;
                        break;
                    }
                    Err(error) if number + 1 == ways.len() => return Err(bad(error.to_string())),
                    Err(error) => builder = error.recover(),
                }
            }
            if provider == Provider::DirectMl {
                // It takes no other.
                builder = builder.with_memory_pattern(false).map_err(|e| bad(e.to_string()))?;
            }
            for (name, data) in &network.external {
                builder = builder
                    .with_external_initializer_file_in_memory(name, data.clone())
                    .map_err(|e| bad(e.to_string()))?;
            }
            builder
                .with_optimization_level(GraphOptimizationLevel::Level3)
                .map_err(|e| bad(e.to_string()))?
                .with_intra_threads(intra_threads)
                .map_err(|e| bad(e.to_string()))?
                .with_inter_threads(1)
                .map_err(|e| bad(e.to_string()))?
                .commit_from_memory(&network.model)
                .map_err(|e| failed(&e))
        };
        let first = open()?;
        let mut all = vec![first];
        for _ in 1..sessions {
            all.push(open()?);
        }
        let sessions =
            all.into_iter().map(|session| Mutex::new(Worker { session, pixels: Vec::new() })).collect();
        Ok(Self {
            file: network.file.clone(),
            sessions,
            inputs: network.inputs.iter().map(|(name, _)| name.clone()).collect(),
            output: network.output.clone(),
            fixed_batch: network.fixed_batch(),
        })
    }

    /// The embedding of one prompt.
    pub fn encode_tokens(&self, tokens: &Tokens) -> Result<Vec<f32>, GuideError> {
        let run = |e: ort::Error| self.run_error(&e);
        let shape = [1, tokens.ids.len()];
        let mut feed = Vec::new();
        for name in &self.inputs {
            let values = match text_input(name) {
                TextInput::Ids => tokens.ids.clone(),
                TextInput::Mask => tokens.mask.clone(),
                TextInput::Positions => (0..tokens.ids.len() as i64).collect(),
                TextInput::Types => vec![0; tokens.ids.len()],
            };
            let tensor = Tensor::from_array((shape, values)).map_err(run)?;
            feed.push((name.clone(), tensor.into_dyn()));
        }
        let mut worker = self.lock(0)?;
        let outputs = worker.session.run(feed).map_err(run)?;
        self.rows(&outputs, 1)
    }

    /// The embeddings of RGB images, in batches of `batch` shared out over the sessions.
    pub fn encode_images(
        &self,
        images: &[u8],
        preprocess: &Preprocess,
        batch: usize,
    ) -> Result<Vec<f32>, GuideError> {
        let image_bytes = (preprocess.size as usize).pow(2) * 3;
        let batch = self.fixed_batch.unwrap_or(batch);
        let batches: Vec<&[u8]> = images.chunks(image_bytes * batch).collect();
        let encoded: Result<Vec<Vec<f32>>, GuideError> = batches
            .par_iter()
            .map(|images| self.encode_batch(images, preprocess, images.len() / image_bytes))
            .collect();
        Ok(encoded?.concat())
    }

    fn encode_batch(
        &self,
        images: &[u8],
        preprocess: &Preprocess,
        count: usize,
    ) -> Result<Vec<f32>, GuideError> {
        let run = |e: ort::Error| self.run_error(&e);
        let side = preprocess.size as usize;
        let mut worker = self.lock(rayon::current_thread_index().unwrap_or(0))?;
        let Worker { session, pixels } = &mut *worker;
        preprocess.apply(images, pixels);
        let tensor = TensorRef::from_array_view(([count, 3, side, side], pixels.as_slice())).map_err(run)?;
        let outputs = session.run(ort::inputs![self.inputs[0].as_str() => tensor]).map_err(run)?;
        self.rows(&outputs, count)
    }

    /// The embeddings among `outputs`, if they are one a row.
    fn rows(&self, outputs: &SessionOutputs, count: usize) -> Result<Vec<f32>, GuideError> {
        let (shape, data) =
            outputs[self.output.as_str()].try_extract_tensor::<f32>().map_err(|e| self.run_error(&e))?;
        if shape.len() != 2 || shape[0] != count as i64 {
            let reason = format!("its output has the shape {shape:?}, not one embedding a row");
            return Err(GuideError::BadModel { file: self.file.clone(), reason });
        }
        Ok(data.to_vec())
    }

    fn lock(&self, index: usize) -> Result<MutexGuard<'_, Worker>, GuideError> {
        // A free session first; else wait for one's own.
        let count = self.sessions.len();
        (0..count).find_map(|k| self.sessions[(index + k) % count].try_lock().ok()).map_or_else(
            || {
                self.sessions[index % count].lock().map_err(|_| GuideError::Run {
                    file: self.file.clone(),
                    reason: "an earlier run broke off".into(),
                })
            },
            Ok,
        )
    }

    fn run_error(&self, error: &ort::Error) -> GuideError {
        GuideError::Run { file: self.file.clone(), reason: GuideError::reason(error) }
    }
}
