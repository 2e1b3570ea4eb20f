// SPDX-License-Identifier: MIT OR Apache-2.0
//! Opening a guide: its files become sessions, and what does not fit together is refused.

use std::path::Path;
use std::sync::OnceLock;

use super::encoder::Encoder;
use super::files::GuideFiles;
use super::network::Network;
use super::preprocess::Preprocess;
use super::text::Text;
use super::{Guide, GuideError, Provider, normalise, prologue, provider, runtime};

/// Networks up to this size are opened once a thread; larger ones share one session.
const SMALL_MODEL_BYTES: usize = 64 << 20;

/// Most rows of a text network's table that no token of its tokenizer uses.
const SPARE_ROWS: usize = 1024;

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
