// SPDX-License-Identifier: MIT OR Apache-2.0
//! A copy of a guide's image network in eight bits, beside the exact one or in a folder of its own.

use std::path::{Path, PathBuf};

use prost::Message;

use super::agreement::Agreement;
use super::files::GuideFiles;
use super::layout::{Layout, Networks};
use super::network::{Network, decode};
use super::quantize::quantize;
use super::{Guide, GuideError, Provider};

const VISION: &str = "vision_model_int8.onnx";
const TEXT: &str = "text_model.onnx";

/// Other files of a guide's folder, copied where there are any.
const COPIED: [&str; 7] = [
    "tokenizer.json",
    "tokenizer_config.json",
    "preprocessor_config.json",
    "processor_config.json",
    "config.json",
    "LICENSE",
    "README.md",
];

/// What is being done for a copy, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CopyStep {
    /// The exact guide is read.
    Reading,
    /// Its matrix products are brought to eight bits.
    Quantizing,
    /// The copy is written.
    Writing,
    /// Both are opened.
    Opening,
    /// Both see the same pictures.
    Comparing,
}

/// How far a copy is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CopyProgress {
    /// What is being done.
    pub step: CopyStep,
    /// Share of the work done, 0 to 1.
    pub fraction: f64,
}

/// Is told how far a copy is, and answers whether to go on.
pub type Watch<'a> = &'a (dyn Fn(CopyProgress) -> bool + Sync);

/// Shares of the work that are done when a step begins, about those of CLIP ViT-B/32.
const QUANTIZING: f64 = 0.03;
const WRITING: f64 = 0.12;
const OPENING: f64 = 0.14;
const COMPARING: f64 = 0.3;

/// A guide in eight bits, and what it is worth.
#[derive(Debug, Clone, PartialEq)]
pub struct EightBitCopy {
    /// The file that was written.
    pub file: PathBuf,
    /// Matrix products that are now in eight bits.
    pub products: usize,
    /// Size of the exact image network, in bytes.
    pub exact_bytes: usize,
    /// Size of the new one.
    pub bytes: usize,
    /// How far the two agree, and how fast they are.
    pub agreement: Agreement,
}

/// Writes a copy of the 32-bit image network of the guide in `folder` in eight bits, to be opened with the precision
/// "int8". The text network stays exact: it runs once a prompt.
///
/// `output` is the folder for a complete guide; None puts the copy beside the exact network. Nothing is left behind
/// where the copy cannot be used, or where `watch` ends it.
pub fn eight_bit_copy(
    folder: &Path,
    output: Option<&Path>,
    threads: Option<usize>,
    watch: Watch,
) -> Result<EightBitCopy, GuideError> {
    let reached = |step, fraction| {
        if watch(CopyProgress { step, fraction }) { Ok(()) } else { Err(GuideError::Cancelled) }
    };
    reached(CopyStep::Reading, 0.0)?;
    let files = GuideFiles::read(folder, Some("fp32"))?;
    let layout = Layout::find(folder, Some("fp32"))?;
    let (Networks::Separate { vision: source, .. } | Networks::Combined(source)) = &layout.networks;
    let place = source.parent().and_then(|parent| parent.strip_prefix(folder).ok()).unwrap_or(Path::new(""));
    let output = output.unwrap_or(folder);
    let target = output.join(place).join(VISION);
    reached(CopyStep::Quantizing, QUANTIZING)?;
    let mut model = decode(&files.vision.file, &files.vision.model)?;
    let products = quantize(&mut model, &files.vision.external).map_err(GuideError::Quantize)?;
    if products == 0 {
        return Err(GuideError::Quantize("it has no matrix products of 32-bit weights".into()));
    }
    let bytes = model.encode_to_vec();
    drop(model);
    reached(CopyStep::Writing, WRITING)?;
    let mut written = Written::default();
    if output != folder {
        written.folder(output)?;
        written.folder(&output.join(place))?;
        for name in COPIED.iter().filter(|name| folder.join(name).is_file()) {
            let content = std::fs::read(folder.join(name)).map_err(|e| unwritable(&folder.join(name), &e))?;
            written.file(&output.join(name), &content)?;
        }
        let Network { model, external, .. } = &files.text;
        written.file(&output.join(place).join(TEXT), model)?;
        for (name, data) in external {
            written.file(&output.join(place).join(name), data)?;
        }
    }
    written.file(&target, &bytes)?;
    let exact_bytes = files.vision.bytes();
    drop(files);
    reached(CopyStep::Opening, OPENING)?;
    let exact = Guide::open(Some(folder), threads, Some(Provider::Cpu), Some("fp32"))?;
    reached(CopyStep::Opening, f64::midpoint(OPENING, COMPARING))?;
    let fast = Guide::open(Some(output), threads, Some(Provider::Cpu), Some("int8"))?;
    let agreement = Agreement::measure(&exact, &fast, |share| {
        reached(CopyStep::Comparing, COMPARING + (1.0 - COMPARING) * share)
    })?;
    written.keep();
    Ok(EightBitCopy { file: target, products, exact_bytes, bytes: bytes.len(), agreement })
}

/// What was written so far; taken away again unless it is kept.
#[derive(Default)]
struct Written {
    files: Vec<PathBuf>,
    folders: Vec<PathBuf>,
}

impl Written {
    fn folder(&mut self, path: &Path) -> Result<(), GuideError> {
        if !path.is_dir() {
            std::fs::create_dir(path).map_err(|e| unwritable(path, &e))?;
            self.folders.push(path.to_owned());
        }
        Ok(())
    }

    /// Under another name first, so that a file of this name is whole. One that is there already is replaced.
    fn file(&mut self, path: &Path, content: &[u8]) -> Result<(), GuideError> {
        let mut partial = path.as_os_str().to_owned();
        partial.push(".partial");
        let partial = PathBuf::from(partial);
        let done = std::fs::write(&partial, content).and_then(|()| std::fs::rename(&partial, path));
        if let Err(error) = done {
            let _ = std::fs::remove_file(&partial);
            return Err(unwritable(path, &error));
        }
        self.files.push(path.to_owned());
        Ok(())
    }

    fn keep(&mut self) {
        self.files.clear();
        self.folders.clear();
    }
}

impl Drop for Written {
    fn drop(&mut self) {
        for file in &self.files {
            let _ = std::fs::remove_file(file);
        }
        for folder in self.folders.iter().rev() {
            let _ = std::fs::remove_dir(folder);
        }
    }
}

fn unwritable(path: &Path, error: &std::io::Error) -> GuideError {
    GuideError::Unwritable { path: path.display().to_string(), reason: error.to_string() }
}
