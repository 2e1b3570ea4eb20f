// SPDX-License-Identifier: MIT OR Apache-2.0
//! What an object is to become, in words: one prompt or several with weights, what it should not look like, and
//! what it is now.

use std::sync::Arc;

use thiserror::Error;

use crate::guide::{Guide, GuideError};

/// What a prompt is put into, one after another, for a guide of general knowledge. It learned from captions,
/// which rarely are a bare name, and the mean of several readings is steadier than one (Radford et al. 2021, §3.1.4).
pub const TEMPLATES: [&str; 5] =
    ["{}", "a photo of {}", "a rendering of {}", "a 3d render of {}", "a grey 3d model of {}"];

/// How much a negative prompt counts against the prompt's 1, where it has no weight.
const NEGATIVE_WEIGHT: f64 = 0.5;

/// Parts that a prompt may have.
const MOST_PARTS: usize = 8;

/// Why a wording cannot be searched for.
#[derive(Debug, Error)]
pub enum PromptError {
    /// Some parts have weights, but not all.
    #[error(
        "\"{0}\" has no weight; write one behind each part, as in \"a stool:1, a throne:0.3\", or behind none"
    )]
    MissingWeight(String),
    /// A weight of 0 or less.
    #[error(
        "the weight of \"{0}\" must be above 0; what the object should not look like is a negative prompt of its own"
    )]
    Weight(String),
    /// Too many parts.
    #[error("the prompt has {0} parts with weights; {MOST_PARTS} are the most")]
    Parts(usize),
    /// Nothing is left of the prompt.
    #[error(
        "to the guide, \"{prompt}\" means nearly the same as \"{against}\", so there is no way from one to the other; say it in other words"
    )]
    Same {
        /// The prompt.
        prompt: String,
        /// What is taken from it.
        against: String,
    },
    /// The guide cannot read it.
    #[error(transparent)]
    Guide(#[from] Arc<GuideError>),
}

impl From<GuideError> for PromptError {
    fn from(error: GuideError) -> Self {
        Self::Guide(Arc::new(error))
    }
}

/// A prompt of several, and how much it counts.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its text, never blank at the ends.
    pub text: String,
    /// Its weight where it has one, above 0.
    pub weight: Option<f64>,
}

/// The parts of a prompt: `a stool:1, a throne:0.3` has two. Without a weight it is one part, whatever its commas.
pub fn parts(prompt: &str) -> Result<Vec<Part>, PromptError> {
    let pieces = prompt.split(',').map(part).filter(|part| part.weight.is_some() || !part.text.is_empty());
    let pieces: Vec<Part> = pieces.collect();
    if pieces.iter().all(|piece| piece.weight.is_none()) {
        return Ok(vec![Part { text: prompt.trim().to_owned(), weight: None }]);
    }
    if pieces.len() > MOST_PARTS {
        return Err(PromptError::Parts(pieces.len()));
    }
    match pieces.iter().find(|piece| piece.weight.is_none_or(|weight| weight <= 0.0)) {
        Some(Part { text, weight: Some(_) }) => Err(PromptError::Weight(text.clone())),
        Some(Part { text, weight: None }) => Err(PromptError::MissingWeight(text.clone())),
        None => Ok(pieces),
    }
}

/// Text and, behind its last colon, weight.
fn part(piece: &str) -> Part {
    let weighted = piece.rsplit_once(':').and_then(|(text, number)| {
        let number = number.trim();
        // Not "inf", which is a number to Rust, nor "1e9".
        let is_plain = number.chars().all(|c| c.is_ascii_digit() || c == '.' || c == '-');
        number.parse().ok().filter(|_| is_plain).map(|weight| (text, weight))
    });
    match weighted {
        Some((text, weight)) => Part { text: text.trim().to_owned(), weight: Some(weight) },
        None => Part { text: piece.trim().to_owned(), weight: None },
    }
}

/// What is asked for. All but the prompt may be left out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wording {
    /// What the object should become; several parts with weights are blended.
    pub prompt: String,
    /// What it should not look like. Weights count against the prompt's 1; one without counts a half.
    pub negative: Option<String>,
    /// What it is now: the target is then the direction from there to the prompt.
    pub source: Option<String>,
    /// Whether every text is read in the [`TEMPLATES`]; `None` leaves it to guide and preset.
    pub templates: Option<bool>,
}

impl Wording {
    /// A prompt and nothing else.
    #[must_use]
    pub fn plain(prompt: &str) -> Self {
        Self { prompt: prompt.to_owned(), ..Self::default() }
    }

    /// Refuses texts that are misshapen, or that the guide cannot read.
    pub fn check(&self, guide: &Guide) -> Result<(), PromptError> {
        // First as a whole, so that an endless one is refused for its length.
        for text in self.texts() {
            let parts = parts(text)?;
            parts.iter().try_for_each(|part| guide.check_prompt(&part.text))?;
        }
        Ok(())
    }

    /// The words of all texts that the guide has never seen, each once.
    pub fn unknown_words(&self, guide: &Guide) -> Result<Vec<String>, PromptError> {
        let mut words: Vec<String> = Vec::new();
        for text in self.texts() {
            for part in parts(text)? {
                let unknown = guide.unknown_words(&part.text)?;
                words.extend(unknown.into_iter().filter(|word| !words.contains(word)).collect::<Vec<_>>());
            }
        }
        Ok(words)
    }

    /// The same, with templates where they are to be used: as is said; else `usual`, for a guide of general
    /// knowledge.
    #[must_use]
    pub fn resolved(&self, guide: &Guide, usual: bool) -> Self {
        let templates = self.templates.unwrap_or(usual && guide.classes().is_empty());
        Self { templates: Some(templates), ..self.clone() }
    }

    /// The part of the prompt that counts most; of several, the first.
    pub fn heaviest(&self) -> Result<String, PromptError> {
        let parts = parts(&self.prompt)?;
        let most =
            parts.iter().rev().max_by(|a, b| a.weight.unwrap_or(1.0).total_cmp(&b.weight.unwrap_or(1.0)));
        Ok(most.map(|part| part.text.clone()).unwrap_or_default())
    }

    /// Weights of the prompt's parts, at length 1 together.
    pub fn shares(&self) -> Result<Vec<f64>, PromptError> {
        let weights: Vec<f64> = parts(&self.prompt)?.iter().map(|part| part.weight.unwrap_or(1.0)).collect();
        let length = weights.iter().map(|weight| weight * weight).sum::<f64>().sqrt();
        Ok(weights.iter().map(|weight| weight / length).collect())
    }

    /// Unit embedding of the prompt, its parts blended by their weights.
    pub fn prompt_embedding(&self, guide: &Guide) -> Result<Vec<f32>, PromptError> {
        self.blend(guide, &self.prompt)
    }

    /// Unit embeddings of the prompt's parts.
    pub fn part_embeddings(&self, guide: &Guide) -> Result<Vec<Vec<f32>>, PromptError> {
        parts(&self.prompt)?.iter().map(|part| self.read(guide, &part.text)).collect()
    }

    /// The unit vector that candidates are scored by: the prompt's, less the negatives' and what it has of the
    /// source.
    ///
    /// That is the way along the great circle from source to prompt. Between texts as near to each other as those
    /// of CLIP it is nearly their difference (Gal et al. 2022, StyleGAN-NADA, §4.1). Between names that a guide
    /// holds to be unlike, the difference rewards losing the source as much as nearing the prompt: a chair on its
    /// way "from a chair" to a sofa ended as neither (likeness to a sofa 0.00 and 0.12, against 0.41).
    pub fn target(&self, guide: &Guide) -> Result<Vec<f32>, PromptError> {
        let prompt = self.prompt_embedding(guide)?;
        let mut taken = vec![0.0; prompt.len()];
        if let Some(negative) = given(self.negative.as_ref()) {
            for part in parts(negative)? {
                add(&mut taken, &self.read(guide, &part.text)?, part.weight.unwrap_or(NEGATIVE_WEIGHT));
            }
        }
        if let Some(source) = given(self.source.as_ref()) {
            let source = self.blend(guide, source)?;
            let shared: f64 = prompt.iter().zip(&source).map(|(p, s)| f64::from(*p) * f64::from(*s)).sum();
            add(&mut taken, &source, shared.max(0.0));
        }
        if taken.iter().all(|x| *x == 0.0) {
            return Ok(prompt);
        }
        let left: Vec<f64> = prompt.iter().zip(&taken).map(|(p, t)| f64::from(*p) - t).collect();
        // Of texts that mean the same only the noise between them would be left.
        unit(&left, NOISE).ok_or_else(|| PromptError::Same {
            prompt: self.prompt.clone(),
            against: self.source.clone().or_else(|| self.negative.clone()).unwrap_or_default(),
        })
    }

    /// The texts that are given.
    fn texts(&self) -> impl Iterator<Item = &String> {
        let others = [&self.negative, &self.source].into_iter().filter_map(|text| given(text.as_ref()));
        std::iter::once(&self.prompt).chain(others)
    }

    fn blend(&self, guide: &Guide, text: &str) -> Result<Vec<f32>, PromptError> {
        let parts = parts(text)?;
        if let [part] = parts.as_slice() {
            return self.read(guide, &part.text);
        }
        let mut sum = vec![0.0; guide.dimension()];
        for part in &parts {
            add(&mut sum, &self.read(guide, &part.text)?, part.weight.unwrap_or(1.0));
        }
        Ok(unit(&sum, 0.0).ok_or(GuideError::BadEmbedding)?)
    }

    /// The unit embedding of a text, alone or as the mean over the templates.
    fn read(&self, guide: &Guide, text: &str) -> Result<Vec<f32>, PromptError> {
        if self.templates != Some(true) {
            return Ok(guide.text_embedding(text)?);
        }
        let mut sum = vec![0.0; guide.dimension()];
        for template in TEMPLATES {
            add(&mut sum, &guide.text_embedding(&template.replace("{}", text))?, 1.0);
        }
        Ok(unit(&sum, 0.0).ok_or(GuideError::BadEmbedding)?)
    }
}

/// Length up to which what is left of a prompt says nothing: texts that mean the same have a cosine above 0.98.
const NOISE: f64 = 0.2;

/// A text that is more than blanks.
fn given(text: Option<&String>) -> Option<&String> {
    text.filter(|text| !text.trim().is_empty())
}

fn add(sum: &mut [f64], embedding: &[f32], weight: f64) {
    for (sum, x) in sum.iter_mut().zip(embedding) {
        *sum += weight * f64::from(*x);
    }
}

/// The vector at length 1; none where it is no longer than `least`.
fn unit(vector: &[f64], least: f64) -> Option<Vec<f32>> {
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > least).then(|| vector.iter().map(|x| (x / length) as f32).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(prompt: &str) -> Vec<(String, Option<f64>)> {
        parts(prompt).unwrap().into_iter().map(|part| (part.text, part.weight)).collect()
    }

    #[test]
    fn a_prompt_without_weights_is_one_part_whatever_its_commas_and_colons() {
        for prompt in
            ["a tall, narrow chair", "a chair: modern", "a table, like this: low", "a chair:inf", ""]
        {
            assert_eq!(read(prompt), [(prompt.to_owned(), None)]);
        }
    }

    #[test]
    fn every_part_has_its_weight() {
        let two = [("a bar stool".to_owned(), Some(1.0)), ("a throne".to_owned(), Some(0.3))];
        assert_eq!(read("a bar stool:1, a throne:0.3"), two);
        assert_eq!(read(" a bar stool : 1,a throne:.3, "), two);
        assert_eq!(read("a stool:2"), [("a stool".to_owned(), Some(2.0))]);
    }

    #[test]
    fn weights_are_never_guessed() {
        let refused = |prompt| parts(prompt).expect_err("it is refused").to_string();
        assert!(refused("a stool, a throne:0.3").starts_with("\"a stool\" has no weight"));
        assert!(refused("a stool:1, a bench:-0.5").starts_with("the weight of \"a bench\" must be above 0"));
        assert!(refused("a stool:1, a throne:0,3").contains("weight of \"a throne\""));
        assert!(refused(&"a stool:1,".repeat(9)).contains("9 parts"));
    }

    #[test]
    fn the_heaviest_part_is_the_first_of_equals() {
        let heaviest = |prompt| Wording::plain(prompt).heaviest().unwrap();
        assert_eq!(heaviest("a stool:1, a taller throne:1.5, a bed:1.5"), "a taller throne");
        assert_eq!(heaviest("a tall, narrow chair"), "a tall, narrow chair");
    }
}
