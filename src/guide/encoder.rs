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
use super::prologue;
use super::text::Tokens;

/// A network, opened once or once a thread (a session runs one batch at a time).
pub struct Encoder {
    file: String,
    sessions: Vec<Mutex<Worker>>,
    inputs: Vec<String>,
    output: String,
    /// Whether it takes one image at a time.
    single: bool,
}

/// A session and what is fed to it besides the views, kept from run to run.
struct Worker {
    session: Session,
    opaque: Vec<u8>,
    mix: Vec<f32>,
    base: Vec<f32>,
}

impl Worker {
    fn new(session: Session) -> Self {
        Self { session, opaque: Vec::new(), mix: Vec::new(), base: Vec::new() }
    }
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
        let sessions = all.into_iter().map(|session| Mutex::new(Worker::new(session))).collect();
        Ok(Self {
            file: network.file.clone(),
            sessions,
            inputs: network.inputs.iter().map(|(name, _)| name.clone()).collect(),
            output: network.output.clone(),
            single: network.fixed_batch() == Some(1),
        })
    }

    /// How many runs there can be at a time.
    pub fn sessions(&self) -> usize {
        self.sessions.len()
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
        let mut worker = self.lock()?;
        let outputs = worker.session.run(feed).map_err(run)?;
        Ok(self.rows(&outputs, 1)?.to_vec())
    }

    /// The embeddings of RGB images, in batches of `batch` shared out over the sessions.
    pub fn encode_images(
        &self,
        images: &[u8],
        preprocess: &Preprocess,
        batch: usize,
    ) -> Result<Vec<f32>, GuideError> {
        let image_bytes = (preprocess.size as usize).pow(2) * 3;
        let encoded: Result<Vec<Vec<f32>>, GuideError> = images
            .par_chunks(image_bytes * batch)
            .map(|images| {
                let mut embeddings = Vec::new();
                let mut worker = self.lock()?;
                let mut opaque = std::mem::take(&mut worker.opaque);
                opaque.clear();
                opaque.extend(images.as_chunks::<3>().0.iter().flat_map(|&[r, g, b]| [r, g, b, 255]));
                // Nothing of the background is seen.
                let done = self.run(&mut worker, &opaque, &[[0; 3]], 1, preprocess, &mut embeddings);
                worker.opaque = opaque;
                done.map(|()| embeddings)
            })
            .collect();
        Ok(encoded?.concat())
    }

    /// The embeddings of premultiplied RGBA views, each before the next `per_view` of the `backgrounds`, which
    /// begin again when they are used up; in one run.
    pub fn encode_views(
        &self,
        views: &[u8],
        backgrounds: &[[u8; 3]],
        per_view: usize,
        preprocess: &Preprocess,
        embeddings: &mut Vec<f32>,
    ) -> Result<(), GuideError> {
        embeddings.clear();
        // Nothing is done in parallel while a session is held: the thread could take up a task that waits for it.
        let mut worker = self.lock()?;
        self.run(&mut worker, views, backgrounds, per_view, preprocess, embeddings)
    }

    /// Adds to `embeddings`.
    fn run(
        &self,
        worker: &mut Worker,
        views: &[u8],
        backgrounds: &[[u8; 3]],
        per_view: usize,
        preprocess: &Preprocess,
        embeddings: &mut Vec<f32>,
    ) -> Result<(), GuideError> {
        let pixels = (preprocess.size as usize).pow(2);
        let count = views.len() / (pixels * 4);
        assert_eq!(count * pixels * 4, views.len(), "whole images");
        if self.single && count * per_view > 1 {
            let mut backgrounds = backgrounds.iter().cycle();
            for view in views.chunks_exact(pixels * 4) {
                for background in backgrounds.by_ref().take(per_view) {
                    let background = std::slice::from_ref(background);
                    self.run(worker, view, background, 1, preprocess, embeddings)?;
                }
            }
            return Ok(());
        }
        let error = |e: ort::Error| self.run_error(&e);
        let Worker { session, mix, base, .. } = worker;
        preprocess.mix(backgrounds.iter().copied().cycle().take(count * per_view), mix, base);
        let views = TensorRef::from_array_view(([count, pixels, 4], views)).map_err(error)?;
        let rows = 3 * per_view;
        let mix = TensorRef::from_array_view(([count, rows, 4], mix.as_slice())).map_err(error)?;
        let base = TensorRef::from_array_view(([count, rows, 1], base.as_slice())).map_err(error)?;
        let feed = ort::inputs![prologue::VIEWS => views, prologue::MIX => mix, prologue::BASE => base];
        let outputs = session.run(feed).map_err(error)?;
        embeddings.extend_from_slice(self.rows(&outputs, count * per_view)?);
        Ok(())
    }

    /// The embeddings among `outputs`, if they are one a row.
    fn rows<'o>(&self, outputs: &'o SessionOutputs, count: usize) -> Result<&'o [f32], GuideError> {
        let (shape, data) =
            outputs[self.output.as_str()].try_extract_tensor::<f32>().map_err(|e| self.run_error(&e))?;
        if shape.len() != 2 || shape[0] != count as i64 {
            let reason = format!("its output has the shape {shape:?}, not one embedding a row");
            return Err(GuideError::BadModel { file: self.file.clone(), reason });
        }
        Ok(data)
    }

    fn lock(&self) -> Result<MutexGuard<'_, Worker>, GuideError> {
        // A free session first; else wait for one's own.
        let count = self.sessions.len();
        let index = rayon::current_thread_index().unwrap_or(0);
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
