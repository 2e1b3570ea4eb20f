// SPDX-License-Identifier: MIT OR Apache-2.0
//! What candidates are to look like, and what else they could be taken for.

use crate::guide::{Guide, GuideError};

/// Names whose embedding is at least this near the prompt's mean the same ("a couch", "a sofa").
const SAME: f64 = 0.9;

/// How far the prompt should be ahead of every other name, in cosine.
const MARGIN: f64 = 0.05;

/// A prompt and its rivals: all the names the guide was taught that mean something else. A sofa is to look
/// more like a sofa than like a park bench, and a taller chair more like that than like a chair.
#[derive(Debug, Clone)]
pub struct Target {
    text: String,
    prompt: Vec<f32>,
    rivals: Vec<f32>,
}

impl Target {
    /// Reads the prompt. There are no rivals where the guide was taught no names.
    pub fn new(guide: &Guide, prompt: &str) -> Result<Self, GuideError> {
        let text = prompt.to_owned();
        let prompt = guide.text_embedding(prompt)?;
        let names = guide.class_embeddings()?.chunks_exact(prompt.len());
        let rivals = names.filter(|name| dot(name, &prompt) < SAME).flatten().copied().collect();
        Ok(Self { text, prompt, rivals })
    }

    /// The prompt.
    #[must_use]
    pub fn prompt(&self) -> &str {
        &self.text
    }

    /// Length of an embedding.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.prompt.len()
    }

    /// Mean cosine of unit embeddings (`k × d`) with the prompt, and by how much the strongest rival comes
    /// within the margin of it (0 where none does).
    #[must_use]
    pub fn appraise(&self, images: &[f32]) -> (f64, f64) {
        let count = (images.len() / self.dimension()) as f64;
        let mut mean = vec![0.0; self.dimension()];
        for image in images.chunks_exact(self.dimension()) {
            for (sum, x) in mean.iter_mut().zip(image) {
                *sum += f64::from(*x) / count;
            }
        }
        let cosine = |text: &[f32]| mean.iter().zip(text).map(|(a, b)| a * f64::from(*b)).sum::<f64>();
        let score = cosine(&self.prompt);
        let strongest =
            self.rivals.chunks_exact(self.dimension()).map(cosine).fold(f64::NEG_INFINITY, f64::max);
        (score, (strongest + MARGIN - score).max(0.0))
    }
}

fn dot(a: &[f32], b: &[f32]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn target() -> Target {
        let rivals = vec![0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        Target { text: String::new(), prompt: vec![1.0, 0.0, 0.0], rivals }
    }

    #[test]
    fn the_score_is_the_mean_cosine_whatever_the_rivals() {
        let images = [0.6, 0.8, 0.0, 1.0, 0.0, 0.0];
        let (score, _) = target().appraise(&images);
        assert!((score - 0.8).abs() < 1e-7);
        let alone = Target { rivals: Vec::new(), ..target() };
        assert_eq!(alone.appraise(&images), (score, 0.0));
    }

    #[test]
    fn the_strongest_rival_counts_from_the_margin_on() {
        let (score, rivalry) = target().appraise(&[0.6, 0.8, 0.0]);
        assert!((rivalry - (0.8 + MARGIN - score)).abs() < 1e-7);
        assert!(target().appraise(&[0.8, 0.0, 0.6]).1 <= 0.0);
        let level = 0.5_f32.sqrt();
        assert!((target().appraise(&[level, 0.0, level]).1 - MARGIN).abs() < 1e-7);
    }
}
