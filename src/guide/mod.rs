// SPDX-License-Identifier: MIT OR Apache-2.0
//! Guides: text–image models that say how much an image looks like a prompt.
//!
//! A guide is a folder in the layout of CLIP and `SigLIP` exports: `vision_model.onnx` and `text_model.onnx`, or
//! `model.onnx` with both, in one or more precisions, here or under `onnx/`; `tokenizer.json`,
//! `preprocessor_config.json`, `config.json`.
//! The embedded guide is compiled into the library.

mod agreement;
mod encoder;
mod error;
mod files;
mod layout;
mod network;
mod onnx;
mod preprocess;
mod prologue;
mod provider;
mod quantize;
mod runtime;
mod smaller;
mod suggest;
mod text;

use std::path::Path;
use std::sync::OnceLock;

pub use agreement::Agreement;
pub use error::GuideError;
pub use provider::Provider;
pub use runtime::{library as runtime_library, set_default_library, version as runtime_version};
pub use smaller::{Copied, Smaller, Step, smaller};

use encoder::Encoder;
use files::GuideFiles;
use network::Network;
use preprocess::Preprocess;
use suggest::Vocabulary;
use text::Text;

/// RGB images encoded in one run of the network. Fixed, so that no result depends on the number of threads.
const IMAGE_BATCH: usize = 12;

/// Images that keep the processor, and a graphics card, busy in one run of the network. Of fewer the embedded guide
/// takes a quarter longer for each, its weights coming anew from memory after images were drawn; more gain little.
const ENOUGH: usize = 8;
const ENOUGH_ON_CARD: usize = 144;

/// Longest prompt taken, in characters: guides read some tens of words at most.
const MAX_PROMPT: usize = 1000;

/// Unknown words named in one refusal.
const NAMED: usize = 6;

/// Names given as examples where nothing the guide knows is spelled like the prompt.
const EXAMPLES: usize = 8;

/// Networks up to this size are opened once a thread; larger ones share one session.
const SMALL_MODEL_BYTES: usize = 64 << 20;

/// Most rows of a text network's table that no token of its tokenizer uses.
const SPARE_ROWS: usize = 1024;

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
    /// Opens the guide in `folder`, or the embedded one. `threads` defaults to the machine's; `provider`, which
    /// encodes the images, to the processor, or for a large guide to a graphics card where a library of the
    /// user's own has one; `precision`, such as "fp16" or "int8", to the most exact that the folder has.
    ///
    /// A provider that cannot be used is no error: the processor takes its place, and
    /// [`Guide::provider_note`] says why.
    pub fn open(
        folder: Option<&Path>,
        threads: Option<usize>,
        provider: Option<Provider>,
        precision: Option<&str>,
    ) -> Result<Self, GuideError> {
        let files = match folder {
            Some(folder) => GuideFiles::read(folder, precision)?,
            None => GuideFiles::embedded()?,
        };
        let threads = threads.unwrap_or_else(available_threads).max(1);
        let small = files.vision.bytes() <= SMALL_MODEL_BYTES;
        let wanted = match provider {
            Some(provider) => provider,
            None => provider::automatic(small)?,
        };
        let mut note = None;
        if !wanted.is_offered()? {
            note = Some(wanted.missing());
        } else if wanted != Provider::Cpu {
            match Self::of_files(files.clone(), threads, small, wanted) {
                Ok(guide) => return Ok(guide),
                Err(error) => note = Some(wanted.failed(&error)),
            }
        }
        let guide = Self::of_files(files, threads, small, Provider::Cpu)?;
        Ok(Self { provider_note: note, ..guide })
    }

    fn of_files(
        files: GuideFiles,
        threads: usize,
        small: bool,
        provider: Provider,
    ) -> Result<Self, GuideError> {
        let environment = runtime::environment()?;
        let (sessions, intra) = if small && provider == Provider::Cpu { (threads, 1) } else { (1, threads) };
        let preprocess = Preprocess::from_json(&files.preprocessor)?;
        check_images(&files.vision, preprocess.size)?;
        let text = Text::new(&files)?;
        check_vocabulary(&files.text, text.vocabulary_size())?;
        let classes = files.classes();
        let (network, hash) =
            rayon::join(|| prologue::extend(&files.vision, preprocess.size), || files.hash());
        // What has been read of the image network is large, and needed no more.
        let GuideFiles { name, text: text_network, precision, .. } = files;
        let network = network?;
        let runtime = &environment;
        let open_vision = move || Encoder::open(runtime, &network, provider, sessions, intra);
        // One prompt a search: not worth another device's start.
        let open_text = || Encoder::open(runtime, &text_network, Provider::Cpu, 1, intra);
        // Each keeps one processor busy.
        let (vision, text_encoder) = rayon::join(open_vision, open_text);
        let mut guide = Self {
            hash,
            classes,
            class_embeddings: OnceLock::new(),
            name,
            preprocess,
            text,
            vision: vision?,
            text_encoder: text_encoder?,
            dimension: 0,
            provider,
            provider_note: None,
            precision,
        };
        guide.dimension = guide.check_dimensions()?;
        Ok(guide)
    }

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
        check_prompt(text)?;
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

    /// Refuses a prompt that is empty, endless, or of unknown words alone.
    pub fn check_prompt(&self, prompt: &str) -> Result<(), GuideError> {
        check_prompt(prompt)?;
        let unknown = self.text.unknown_words(prompt)?;
        if text::naming_words(prompt, &unknown) > 0 {
            return Ok(());
        }
        let named = &unknown[..unknown.len().min(NAMED)];
        let nearest: Vec<String> = named.iter().flat_map(|word| self.nearest_words(word, 2)).collect();
        let hint = if !nearest.is_empty() {
            format!("The nearest it knows: {}", nearest.join(", "))
        } else if !self.classes.is_empty() {
            format!("It knows, for example: {}", self.examples().join(", "))
        } else {
            "Name an object".to_owned()
        };
        let words = if named.is_empty() { prompt.trim().to_owned() } else { named.join(", ") };
        Err(GuideError::UnknownPrompt { words, hint })
    }

    /// At most `count` words the guide knows that are spelled like `word`; none for a guide that spells
    /// words out.
    #[must_use]
    pub fn nearest_words(&self, word: &str, count: usize) -> Vec<String> {
        if self.classes.is_empty() {
            return Vec::new();
        }
        Vocabulary::new(self.text.vocabulary()).nearest(word, count)
    }

    /// Some names it was taught, from all over its list.
    fn examples(&self) -> Vec<String> {
        let step = (self.classes.len() / EXAMPLES).max(1);
        self.classes.iter().step_by(step).take(EXAMPLES).cloned().collect()
    }

    /// Runs both networks once, so that a guide whose parts do not fit is refused when opened.
    fn check_dimensions(&self) -> Result<usize, GuideError> {
        let mut text = self.text_encoder.encode_tokens(&self.text.encode("a chair")?)?;
        // Of all shades: a small network may well see nothing in a blank image.
        let shades: Vec<u8> = (0..(self.preprocess.size as usize).pow(2) * 3).map(|k| k as u8).collect();
        let mut image = self.vision.encode_images(&shades, &self.preprocess, 1)?;
        if text.len() != image.len() || text.is_empty() {
            return Err(GuideError::Dimensions { text: text.len(), image: image.len() });
        }
        normalise(&mut text)?;
        normalise(&mut image)?;
        Ok(text.len())
    }
}

fn available_threads() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

/// Refuses an image network that reads one size of images where another is made.
fn check_images(vision: &Network, size: u32) -> Result<(), GuideError> {
    if let Some(count) = vision.fixed_batch().filter(|count| *count != 1) {
        let reason = format!("it reads {count} images at a time; export it for any number");
        return Err(GuideError::BadModel { file: vision.file.clone(), reason });
    }
    match vision.fixed_image() {
        Some((height, width)) if (height, width) != (size as usize, size as usize) => {
            Err(GuideError::ImageSize { file: vision.file.clone(), width, height, size })
        }
        _ => Ok(()),
    }
}

/// Refuses a tokenizer that is not the text network's own.
fn check_vocabulary(text: &Network, tokens: usize) -> Result<(), GuideError> {
    match text.vocabulary {
        // Tables are rounded up in some models.
        Some(known) if !(tokens..=tokens + SPARE_ROWS).contains(&known) => {
            Err(GuideError::Vocabulary { file: text.file.clone(), tokens, known })
        }
        _ => Ok(()),
    }
}

fn check_prompt(prompt: &str) -> Result<(), GuideError> {
    if prompt.trim().is_empty() {
        return Err(GuideError::EmptyPrompt);
    }
    let length = prompt.chars().count();
    if length > MAX_PROMPT {
        return Err(GuideError::LongPrompt { length, most: MAX_PROMPT });
    }
    Ok(())
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
