// SPDX-License-Identifier: MIT OR Apache-2.0
//! Guides: text–image models that say how much an image looks like a prompt.
//!
//! A guide is a folder in the layout of CLIP and `SigLIP` exports: `vision_model.onnx` and `text_model.onnx`, or
//! `model.onnx` with both, in one or more precisions, here or under `onnx/`; `tokenizer.json`,
//! `preprocessor_config.json`, `config.json`.
//! The embedded guide is compiled into the library.

mod agreement;
mod disk;
mod eight_bit_copy;
mod encoder;
mod error;
mod files;
mod layout;
mod network;
mod onnx;
mod opening;
mod preprocess;
mod prologue;
mod prompts;
mod provider;
mod quantize;
mod runtime;
mod suggest;
mod text;

use std::sync::OnceLock;

pub use agreement::Agreement;
pub use eight_bit_copy::{CopyProgress, CopyStep, EightBitCopy, eight_bit_copy};
pub use error::GuideError;
pub use provider::Provider;
pub use runtime::{library as runtime_library, set_default_library, version as runtime_version};

use encoder::Encoder;
use preprocess::Preprocess;
use text::Text;

/// RGB images encoded in one run of the network. Fixed, so that no result depends on the number of threads.
const IMAGE_BATCH: usize = 12;

/// Images that keep the processor, and a graphics card, busy in one run of the network. Of fewer the embedded guide
/// takes a quarter longer for each, its weights coming anew from memory after images were drawn; more gain little.
const ENOUGH: usize = 8;
const ENOUGH_ON_CARD: usize = 144;

/// An opened text–image model. Embeddings are unit vectors of [`Guide::dimension`] numbers.
pub struct Guide {
    name: String,
    hash: String,
    classes: Vec<String>,
    class_embeddings: OnceLock<Vec<f32>>,
    preprocess: Preprocess,
    text: Text,
    vision: Encoder,
    text_encoder: Encoder,
    dimension: usize,
    provider: Provider,
    provider_note: Option<String>,
    precision: &'static str,
}

impl std::fmt::Debug for Guide {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Guide").field("name", &self.name).field("hash", &self.hash).finish_non_exhaustive()
    }
}

impl Guide {
    /// The folder's name, or `mini` for the embedded guide.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// SHA-256 over all the guide's files, in hexadecimal.
    #[must_use]
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// The names the guide was taught, where it says so; empty for a guide of general knowledge.
    #[must_use]
    pub fn classes(&self) -> &[String] {
        &self.classes
    }

    /// What encodes the images.
    #[must_use]
    pub fn provider(&self) -> Provider {
        self.provider
    }

    /// A sentence on why the provider that was asked for is not used; none where it is.
    #[must_use]
    pub fn provider_note(&self) -> Option<&str> {
        self.provider_note.as_deref()
    }

    /// The precision of its image network, such as "fp32" or "int8": by its file's name, unless its weights are
    /// of another.
    #[must_use]
    pub fn precision(&self) -> &'static str {
        self.precision
    }

    /// Side of the square images it reads, in pixels.
    #[must_use]
    pub fn image_size(&self) -> u32 {
        self.preprocess.size
    }

    /// Length of an embedding.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The unit embedding of `text`.
    pub fn text_embedding(&self, text: &str) -> Result<Vec<f32>, GuideError> {
        prompts::check_text(text)?;
        let tokens = self.text.encode(text)?;
        let mut embedding = self.text_encoder.encode_tokens(&tokens)?;
        normalise(&mut embedding)?;
        Ok(embedding)
    }

    /// The numbers of the tokens that its text network reads for `text`, padding included.
    pub fn token_ids(&self, text: &str) -> Result<Vec<i64>, GuideError> {
        Ok(self.text.encode(text)?.ids)
    }

    /// Unit embeddings, `names × dimension`, of [`Guide::classes`].
    pub fn class_embeddings(&self) -> Result<&[f32], GuideError> {
        if let Some(known) = self.class_embeddings.get() {
            return Ok(known);
        }
        let each: Result<Vec<_>, _> = self.classes.iter().map(|name| self.text_embedding(name)).collect();
        let all = each?.concat();
        Ok(self.class_embeddings.get_or_init(|| all))
    }

    /// Unit embeddings, `count × dimension`, of `count` RGB images (`count × size × size × 3` bytes).
    pub fn image_embeddings(&self, images: &[u8]) -> Result<Vec<f32>, GuideError> {
        let image_bytes = (self.preprocess.size as usize).pow(2) * 3;
        if !images.len().is_multiple_of(image_bytes) {
            return Err(GuideError::ImageBytes { size: self.preprocess.size, bytes: images.len() });
        }
        let mut all = self.vision.encode_images(images, &self.preprocess, IMAGE_BATCH)?;
        normalise_each(&mut all, self.dimension)?;
        Ok(all)
    }

    /// Bytes of RGB images that keep all its sessions busy for one run each.
    fn bytes_at_once(&self) -> usize {
        (self.preprocess.size as usize).pow(2) * 3 * IMAGE_BATCH * self.vision.sessions()
    }

    /// Unit embeddings of rendered views before backgrounds, in one run of the network: `embeddings` becomes
    /// `views × per_view × dimension` numbers.
    ///
    /// `views` are RGBA8 with premultiplied alpha, count × size × size × 4. Each is seen before the next `per_view`
    /// of the `backgrounds`, which begin again when they are used up.
    ///
    /// # Panics
    /// If `views` are no whole number of images.
    pub fn view_embeddings(
        &self,
        views: &[u8],
        backgrounds: &[[u8; 3]],
        per_view: usize,
        embeddings: &mut Vec<f32>,
    ) -> Result<(), GuideError> {
        self.vision.encode_views(views, backgrounds, per_view, &self.preprocess, embeddings)?;
        normalise_each(embeddings, self.dimension)
    }

    /// Images that one run of the network should have at least.
    #[must_use]
    pub fn images_a_run(&self) -> usize {
        if self.provider == Provider::Cpu { ENOUGH } else { ENOUGH_ON_CARD }
    }

    /// The words of `text` that the guide has never seen; none for a guide that spells words out.
    pub fn unknown_words(&self, text: &str) -> Result<Vec<String>, GuideError> {
        self.text.unknown_words(text)
    }
}

fn normalise_each(embeddings: &mut [f32], dimension: usize) -> Result<(), GuideError> {
    embeddings.chunks_exact_mut(dimension.max(1)).try_for_each(normalise)
}

fn normalise(embedding: &mut [f32]) -> Result<(), GuideError> {
    let norm = embedding.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    if !norm.is_finite() || norm == 0.0 {
        return Err(GuideError::BadEmbedding);
    }
    for x in embedding {
        *x = (f64::from(*x) / norm) as f32;
    }
    Ok(())
}
