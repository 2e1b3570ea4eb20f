// SPDX-License-Identifier: MIT OR Apache-2.0
//! The words a guide knows that are spelled most like one it does not know.

use strsim::normalized_damerau_levenshtein;

/// Least similarity of a word worth suggesting: one slip in four letters.
const ALIKE: f64 = 0.7;

/// The words of a guide with a closed vocabulary.
pub struct Vocabulary {
    words: Vec<String>,
}

impl Vocabulary {
    /// From words in any order; those without a letter are left out.
    pub fn new(words: impl IntoIterator<Item = String>) -> Self {
        let mut words: Vec<String> =
            words.into_iter().filter(|w| w.len() > 2 && w.chars().all(char::is_alphabetic)).collect();
        words.sort_unstable();
        words.dedup();
        Self { words }
    }

    /// At most `count` known words that look like `word`, the most alike first.
    pub fn nearest(&self, word: &str, count: usize) -> Vec<String> {
        let word = word.to_lowercase();
        let mut alike: Vec<(f64, &String)> = self
            .words
            .iter()
            .map(|known| (normalized_damerau_levenshtein(&word, known), known))
            .filter(|(likeness, _)| *likeness >= ALIKE)
            .collect();
        alike.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(b.1)));
        alike.into_iter().take(count).map(|(_, known)| known.clone()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn furniture() -> Vocabulary {
        Vocabulary::new(["chair", "chairs", "stool", "table", "[UNK]", ","].map(str::to_owned))
    }

    #[test]
    fn a_slip_of_the_finger_is_mended() {
        assert_eq!(furniture().nearest("chiar", 1), ["chair"]);
        assert_eq!(furniture().nearest("Stol", 2), ["stool"]);
    }

    #[test]
    fn nothing_like_it_suggests_nothing() {
        assert!(furniture().nearest("unicorn", 3).is_empty());
        assert!(furniture().nearest("", 3).is_empty());
    }
}
