// SPDX-License-Identifier: MIT OR Apache-2.0
//! Prompts to token ids, and the words a guide does not know.

use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};

use tokenizers::models::ModelWrapper;
use tokenizers::{
    NormalizedString, PaddingDirection, PaddingParams, PaddingStrategy, Tokenizer, TruncationParams,
};

use super::GuideError;
use super::files::{GuideFiles, MAX_TOKENS};

/// Words that name nothing by themselves: a prompt needs another one that the guide knows.
const FILLERS: [&str; 24] = [
    "a", "an", "the", "of", "with", "and", "or", "in", "on", "at", "to", "for", "by", "from", "as", "is",
    "it", "its", "this", "that", "like", "very", "some", "my",
];

/// The names tokenizers give to a word outside their vocabulary.
const UNKNOWN_TOKENS: [&str; 2] = ["[UNK]", "<unk>"];

/// Longest texts of CLIP and `SigLIP`, whose configurations often leave it out.
const CLIP_TOKENS: usize = 77;
const SIGLIP_TOKENS: usize = 64;

/// A guide's tokenizer.
pub struct Text {
    tokenizer: Tokenizer,
    /// The same without a longest text: a word beyond it is still to be named if unknown.
    whole: Tokenizer,
    unknown: Vec<u32>,
    form: Form,
}

/// A prompt in the network's own terms; both vectors have the same length.
pub struct Tokens {
    pub ids: Vec<i64>,
    pub mask: Vec<i64>,
}

/// What happens to a text before its tokenizer, and to its padding after it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// As its tokenizer says.
    Plain,
    /// `SigLIP`: lower case, no punctuation; it was trained on padding as if it were text.
    Siglip,
    /// `SigLIP` 2: the same, but punctuation stays.
    Siglip2,
}

impl Text {
    pub fn new(files: &GuideFiles) -> Result<Self, GuideError> {
        let bad = |reason: String| GuideError::BadJson { file: "tokenizer.json", reason };
        let mut tokenizer = guarded(|| Tokenizer::from_bytes(files.tokenizer())).map_err(bad)?;
        let long = |length: usize| length > MAX_TOKENS;
        if tokenizer.get_padding().is_some_and(|padding| {
            matches!(padding.strategy, PaddingStrategy::Fixed(length) if long(length))
                || padding.pad_to_multiple_of.is_some_and(long)
        }) {
            return Err(bad(format!("it fills texts up beyond {MAX_TOKENS} tokens")));
        }
        let form = match (files.model_type().starts_with("siglip"), tokenizer.get_model()) {
            (false, _) => Form::Plain,
            (true, ModelWrapper::Unigram(_)) => Form::Siglip,
            (true, _) => Form::Siglip2,
        };
        let mut whole = tokenizer.clone();
        whole.with_padding(None);
        whole.with_truncation(None).map_err(|e| bad(e.to_string()))?;
        let usual = match (form, files.model_type()) {
            (Form::Siglip | Form::Siglip2, _) => Some(SIGLIP_TOKENS),
            (Form::Plain, "clip") => Some(CLIP_TOKENS),
            _ => None,
        };
        let fixed = files.text.fixed_tokens();
        let positions = fixed.or(files.max_positions()).or(usual);
        let most = [positions, files.tokenizer_length()].into_iter().flatten().min();
        if let Some(max_length) = most {
            let truncation = TruncationParams { max_length, ..Default::default() };
            tokenizer.with_truncation(Some(truncation)).map_err(|e| bad(e.to_string()))?;
        }
        // Without a mask the network was trained on texts of one length.
        let filled = if form == Form::Plain && files.text.has_mask() { fixed } else { fixed.or(most) };
        if let Some(length) = filled {
            let padding = padding(&tokenizer, files, length);
            tokenizer.with_padding(Some(padding));
        }
        let unknown = UNKNOWN_TOKENS.iter().filter_map(|token| tokenizer.token_to_id(token)).collect();
        Ok(Self { tokenizer, whole, unknown, form })
    }

    pub fn encode(&self, text: &str) -> Result<Tokens, GuideError> {
        let text = self.form.of(text);
        let encoding =
            guarded(|| self.tokenizer.encode(text.as_ref(), true)).map_err(GuideError::Tokenize)?;
        let mask = encoding.get_attention_mask().iter();
        Ok(Tokens {
            ids: encoding.get_ids().iter().map(|id| i64::from(*id)).collect(),
            mask: mask.map(|m| if self.form == Form::Plain { i64::from(*m) } else { 1 }).collect(),
        })
    }

    /// One more than the greatest token id.
    pub fn vocabulary_size(&self) -> usize {
        self.tokenizer.get_vocab(true).into_values().max().map_or(0, |id| id as usize + 1)
    }

    /// Every token of the vocabulary.
    pub fn vocabulary(&self) -> impl Iterator<Item = String> {
        self.tokenizer.get_vocab(false).into_keys()
    }

    pub fn unknown_words(&self, text: &str) -> Result<Vec<String>, GuideError> {
        let text = self.form.of(text);
        let encoding = guarded(|| self.whole.encode(text.as_ref(), false)).map_err(GuideError::Tokenize)?;
        let mut words: Vec<String> = Vec::new();
        for (id, (start, end)) in encoding.get_ids().iter().zip(encoding.get_offsets()) {
            let word = text.get(*start..*end).unwrap_or_default();
            if self.unknown.contains(id) && !words.iter().any(|w| w == word) {
                words.push(word.to_owned());
            }
        }
        Ok(words)
    }
}

/// What a tokenizer does, or why it does not: some damaged files make the library panic.
fn guarded<T>(work: impl FnOnce() -> tokenizers::Result<T>) -> Result<T, String> {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(done) => done.map_err(|e| e.to_string()),
        Err(_) => Err("no tokenizer can be made of it".into()),
    }
}

/// Padding to `length`, with the token that the guide's files name.
fn padding(tokenizer: &Tokenizer, files: &GuideFiles, length: usize) -> PaddingParams {
    let own = tokenizer.get_padding().cloned().unwrap_or_default();
    let named = files.pad_token().and_then(|token| tokenizer.token_to_id(token));
    let own_id = tokenizer.get_padding().map(|padding| padding.pad_id);
    PaddingParams {
        strategy: PaddingStrategy::Fixed(length),
        direction: if files.pads_left() { PaddingDirection::Left } else { PaddingDirection::Right },
        pad_to_multiple_of: None,
        pad_id: named.or(own_id).or(files.pad_id()).unwrap_or(0),
        ..own
    }
}

impl Form {
    fn of(self, text: &str) -> Cow<'_, str> {
        match self {
            Self::Plain => text.into(),
            Self::Siglip => {
                let bare: String =
                    text.to_lowercase().chars().filter(|c| !c.is_ascii_punctuation()).collect();
                let words = bare.split(is_blank).filter(|word| !word.is_empty());
                let mut joined = NormalizedString::from(words.collect::<Vec<_>>().join(" "));
                // Its tokenizer composes letters and accents in short groups only.
                joined.nfc();
                joined.get().to_owned().into()
            }
            Self::Siglip2 => text.chars().flat_map(char::to_lowercase).collect::<String>().into(),
        }
    }
}

/// White space as Python sees it, and what `SentencePiece` makes a space of at last.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || ('\u{1c}'..='\u{1f}').contains(&c) || c == '\u{200c}'
}

/// How many words of `text` name something: neither fillers nor among `unknown`.
pub fn naming_words(text: &str, unknown: &[String]) -> usize {
    text.split(|c: char| c.is_whitespace() || c.is_ascii_punctuation())
        .filter(|word| !word.is_empty())
        .filter(|word| !FILLERS.contains(&word.to_lowercase().as_str()))
        .filter(|word| !unknown.iter().any(|u| u == word))
        .count()
}
