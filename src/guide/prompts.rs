// SPDX-License-Identifier: MIT OR Apache-2.0
//! Prompts that a guide refuses, and the words it offers in their place.

use super::suggest::Vocabulary;
use super::{Guide, GuideError, text};

/// Longest prompt taken, in characters: guides read some tens of words at most.
const MAX_PROMPT: usize = 1000;

/// Unknown words named in one refusal.
const NAMED: usize = 6;

/// Names given as examples where nothing the guide knows is spelled like the prompt.
const EXAMPLES: usize = 8;

impl Guide {
    /// Refuses a prompt that is empty, endless, or of unknown words alone.
    pub fn check_prompt(&self, prompt: &str) -> Result<(), GuideError> {
        check_text(prompt)?;
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
}

/// Refuses a text that is empty or endless.
pub(super) fn check_text(prompt: &str) -> Result<(), GuideError> {
    if prompt.trim().is_empty() {
        return Err(GuideError::EmptyPrompt);
    }
    let length = prompt.chars().count();
    if length > MAX_PROMPT {
        return Err(GuideError::LongPrompt { length, most: MAX_PROMPT });
    }
    Ok(())
}
