// SPDX-License-Identifier: MIT OR Apache-2.0
//! Prompts to token ids, and the words a guide does not know.

use tokenizers::{Tokenizer, TruncationParams};

use super::GuideError;

/// Words that name nothing by themselves: a prompt needs another one that the guide knows.
const FILLERS: [&str; 24] = [
    "a", "an", "the", "of", "with", "and", "or", "in", "on", "at", "to", "for", "by", "from", "as", "is",
    "it", "its", "this", "that", "like", "very", "some", "my",
];

/// The names tokenizers give to a word outside their vocabulary.
const UNKNOWN_TOKENS: [&str; 2] = ["[UNK]", "<unk>"];

/// A guide's tokenizer.
pub struct Text {
    tokenizer: Tokenizer,
    /// The same without a longest text: a word beyond it is still to be named if unknown.
    whole: Tokenizer,
    unknown: Vec<u32>,
}

/// A prompt in the network's own terms; both vectors have the same length.
pub struct Tokens {
    pub ids: Vec<i64>,
    pub mask: Vec<i64>,
}

impl Text {
    pub fn new(json: &[u8], max_tokens: Option<usize>) -> Result<Self, GuideError> {
        let bad = |reason: String| GuideError::BadJson { file: "tokenizer.json", reason };
        let mut tokenizer = Tokenizer::from_bytes(json).map_err(|e| bad(e.to_string()))?;
        let mut whole = tokenizer.clone();
        whole.with_truncation(None).map_err(|e| bad(e.to_string()))?;
        if let Some(max_length) = max_tokens {
            let truncation = TruncationParams { max_length, ..Default::default() };
            tokenizer.with_truncation(Some(truncation)).map_err(|e| bad(e.to_string()))?;
        }
        let unknown = UNKNOWN_TOKENS.iter().filter_map(|token| tokenizer.token_to_id(token)).collect();
        Ok(Self { tokenizer, whole, unknown })
    }

    pub fn encode(&self, text: &str) -> Result<Tokens, GuideError> {
        let encoding = self.tokenizer.encode(text, true).map_err(|e| GuideError::Tokenize(e.to_string()))?;
        Ok(Tokens {
            ids: encoding.get_ids().iter().map(|id| i64::from(*id)).collect(),
            mask: encoding.get_attention_mask().iter().map(|m| i64::from(*m)).collect(),
        })
    }

    /// Every token of the vocabulary.
    pub fn vocabulary(&self) -> impl Iterator<Item = String> {
        self.tokenizer.get_vocab(false).into_keys()
    }

    pub fn unknown_words(&self, text: &str) -> Result<Vec<String>, GuideError> {
        let encoding = self.whole.encode(text, false).map_err(|e| GuideError::Tokenize(e.to_string()))?;
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

/// How many words of `text` name something: neither fillers nor among `unknown`.
pub fn naming_words(text: &str, unknown: &[String]) -> usize {
    text.split(|c: char| c.is_whitespace() || c.is_ascii_punctuation())
        .filter(|word| !word.is_empty())
        .filter(|word| !FILLERS.contains(&word.to_lowercase().as_str()))
        .filter(|word| !unknown.iter().any(|u| u == word))
        .count()
}
