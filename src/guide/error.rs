// SPDX-License-Identifier: MIT OR Apache-2.0
//! What can be wrong with a guide, or with what it is asked.

use thiserror::Error;

/// Longest message of ONNX Runtime shown, in characters.
const MAX_REASON: usize = 300;

/// Why a guide cannot be opened or used.
#[derive(Debug, Error)]
pub enum GuideError {
    /// The folder is not there.
    #[error("there is no guide folder at \"{0}\"; choose the folder that holds vision_model.onnx")]
    NoFolder(String),
    /// A file of the layout is missing.
    #[error("the guide folder \"{folder}\" has no {file}; copy the whole folder of the model's ONNX export")]
    MissingFile {
        /// The guide's folder.
        folder: String,
        /// The missing file's name.
        file: String,
    },
    /// No precision has this name.
    #[error("unknown precision \"{name}\": choose {known}")]
    UnknownPrecision {
        /// The name given.
        name: String,
        /// Those there are.
        known: String,
    },
    /// The networks are there in other precisions.
    #[error(
        "the guide folder \"{folder}\" has no networks in the precision \"{precision}\"; \
         choose another precision, or copy its files there"
    )]
    NoPrecision {
        /// The guide's folder.
        folder: String,
        /// The precision asked for.
        precision: String,
    },
    /// Something else is where a file should be.
    #[error("\"{path}\" is {what}, not a file; copy the model's own file there")]
    NotAFile {
        /// The place.
        path: String,
        /// What is there.
        what: &'static str,
    },
    /// A file is larger than any guide's.
    #[error("the guide's file \"{path}\" is larger than {most} MB; choose a smaller model")]
    TooLarge {
        /// The file.
        path: String,
        /// The largest size, in MiB.
        most: u64,
    },
    /// A file with a network's weights is missing or cut short.
    #[error(
        "the weights of the guide's {file} lie in \"{data}\", which {reason}; copy that file again, beside it"
    )]
    Weights {
        /// The network's file.
        file: String,
        /// The file with its weights.
        data: String,
        /// What is wrong with it.
        reason: String,
    },
    /// The image network reads images of one size, and its settings name another.
    #[error(
        "the guide's {file} reads images of {width} × {height} pixels and its preprocessor_config.json makes \
         {size} × {size}; take both from the same model"
    )]
    ImageSize {
        /// The network's file.
        file: String,
        /// Width of its images.
        width: usize,
        /// Height of its images.
        height: usize,
        /// Side of the images that are made.
        size: u32,
    },
    /// The tokenizer is not the text network's.
    #[error(
        "the guide's tokenizer.json has {tokens} tokens and its {file} knows {known}; \
         take both from the same model"
    )]
    Vocabulary {
        /// The text network's file.
        file: String,
        /// Tokens of the tokenizer.
        tokens: usize,
        /// Rows of the network's table.
        known: usize,
    },
    /// A file cannot be read.
    #[error("the guide's file \"{path}\" cannot be read ({reason}); check its permissions")]
    Unreadable {
        /// The file.
        path: String,
        /// What the system says.
        reason: String,
    },
    /// A JSON file is not what it should be.
    #[error("the guide's {file} is damaged ({reason}); copy it from the model's source again")]
    BadJson {
        /// The file's name.
        file: &'static str,
        /// What is wrong.
        reason: String,
    },
    /// The network cannot be loaded.
    #[error(
        "the guide's {file} is not a network that can be used ({reason}); copy it from the model's source again"
    )]
    BadModel {
        /// The file's name.
        file: String,
        /// What ONNX Runtime says.
        reason: String,
    },
    /// No copy in eight bits can be made.
    #[error("the guide's image network cannot be made smaller ({0}); use it as it is")]
    Quantize(String),
    /// The copy was cancelled.
    #[error("the copy in eight bits was cancelled; nothing of it is left")]
    Cancelled,
    /// A file cannot be written.
    #[error("\"{path}\" cannot be written ({reason}); choose another folder, or make room there")]
    Unwritable {
        /// The file.
        path: String,
        /// What the system says.
        reason: String,
    },
    /// Text and image embeddings differ in length.
    #[error(
        "the guide's text embeddings have {text} numbers and its image embeddings {image}; \
         take both networks from the same model"
    )]
    Dimensions {
        /// Length of a text embedding.
        text: usize,
        /// Length of an image embedding.
        image: usize,
    },
    /// The network gave zeros, NaN or infinities.
    #[error("the guide gave an embedding without a direction; its network is damaged, copy it again")]
    BadEmbedding,
    /// A run failed.
    #[error("the guide's {file} failed while running ({reason})")]
    Run {
        /// The file's name.
        file: String,
        /// What ONNX Runtime says.
        reason: String,
    },
    /// ONNX Runtime's library cannot be opened.
    #[error(
        "ONNX Runtime's library cannot be opened at \"{path}\" ({reason}); \
         reinstall Boxmorph, or set ORT_DYLIB_PATH to a libonnxruntime of version 1.24 or later"
    )]
    Library {
        /// Where it was sought.
        path: String,
        /// What the loader says.
        reason: String,
    },
    /// No execution provider has this name.
    #[error("unknown execution provider \"{name}\": choose {known}")]
    UnknownProvider {
        /// The name given.
        name: String,
        /// Those there are.
        known: String,
    },
    /// The image array has the wrong size.
    #[error(
        "the guide reads RGB images of {size} × {size} pixels; {bytes} bytes are not a whole number of them"
    )]
    ImageBytes {
        /// Side of its images.
        size: u32,
        /// Bytes given.
        bytes: usize,
    },
    /// There is no prompt.
    #[error("the prompt is empty; type what the object should become, such as \"a bar stool\"")]
    EmptyPrompt,
    /// The prompt is too long.
    #[error("the prompt has {length} characters; say it in at most {most}")]
    LongPrompt {
        /// Its length.
        length: usize,
        /// The longest taken.
        most: usize,
    },
    /// No word of the prompt is known.
    #[error("the guide knows no word of this prompt that names a shape ({words}). {hint}")]
    UnknownPrompt {
        /// The unknown words, or the prompt where it has none that could name anything.
        words: String,
        /// The nearest words it knows, or examples.
        hint: String,
    },
    /// The tokenizer fails on this text.
    #[error("the guide's tokenizer cannot read this text ({0}); type it in other words")]
    Tokenize(String),
}

impl GuideError {
    /// What ONNX Runtime says, in one line of moderate length.
    pub(super) fn reason(error: &ort::Error) -> String {
        let line = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
        match line.char_indices().nth(MAX_REASON) {
            Some((end, _)) => format!("{} …", &line[..end]),
            None => line,
        }
    }

    /// True where the caller's input is wrong rather than the guide.
    #[must_use]
    pub fn is_input(&self) -> bool {
        matches!(
            self,
            Self::ImageBytes { .. }
                | Self::EmptyPrompt
                | Self::UnknownProvider { .. }
                | Self::UnknownPrecision { .. }
                | Self::LongPrompt { .. }
                | Self::UnknownPrompt { .. }
        )
    }
}
