// SPDX-License-Identifier: MIT OR Apache-2.0
//! What candidates are to look like, and what else they could be taken for.

use super::{PromptError, Wording};
use crate::guide::Guide;

/// Names whose embedding is at least this near the prompt's mean the same ("a couch", "a sofa").
const SAME: f64 = 0.9;

/// How far the prompt should be ahead of every other name, in cosine.
pub const MARGIN: f64 = 0.03;

/// What is asked for and its rivals: all the names the guide was taught that mean something else. A sofa is to
/// look more like a sofa than like a park bench, and a taller chair more like that than like a chair.
#[derive(Debug, Clone)]
pub struct Target {
    text: String,
    /// What candidates are scored by; the prompt itself, unless something is to be taken from it.
    aim: Vec<f32>,
    /// What rivals are held against.
    prompt: Vec<f32>,
    rivals: Vec<f32>,
    /// Where several prompts are blended, their embeddings and, at length 1, their weights.
    parts: Vec<f32>,
    shares: Vec<f64>,
}

impl Target {
    /// Reads what is asked for. There are no rivals where the guide was taught no names.
    pub fn new(guide: &Guide, wording: &Wording) -> Result<Self, PromptError> {
        let (aim, prompt) = (wording.target(guide)?, wording.prompt_embedding(guide)?);
        let (mut wanted, mut shares) = (wording.part_embeddings(guide)?, wording.shares()?);
        // Only where a cosine of 0 means that a shape has nothing of a name, shares of a likeness can be told.
        if shares.len() < 2 || guide.classes().is_empty() {
            shares.clear();
        }
        let parts = wanted[..shares.len()].concat();
        wanted.push(prompt.clone());
        let names = guide.class_embeddings()?.chunks_exact(prompt.len());
        let rivals = names.filter(|name| wanted.iter().all(|text| dot(name, text) < SAME));
        let rivals = rivals.flatten().copied().collect();
        Ok(Self { text: wording.heaviest()?, aim, prompt, rivals, parts, shares })
    }

    /// The prompt; of several, the one that counts most.
    #[must_use]
    pub fn prompt(&self) -> &str {
        &self.text
    }

    /// Length of an embedding.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.prompt.len()
    }

    /// Mean cosine of unit embeddings (`k × d`) with what is asked for, and what speaks against them: by how much
    /// the strongest rival comes within the margin of the prompt (0 where none does), and how far the likenesses to
    /// blended prompts are from being as their weights. Of a stool and a throne, a blend has something of both.
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
        let score = cosine(&self.aim);
        let strongest =
            self.rivals.chunks_exact(self.dimension()).map(cosine).fold(f64::NEG_INFINITY, f64::max);
        let rivalry = (strongest + MARGIN - cosine(&self.prompt)).max(0.0);
        let likeness: Vec<f64> = self.parts.chunks_exact(self.dimension()).map(cosine).collect();
        (score, rivalry + imbalance(&likeness, &self.shares))
    }
}

/// How far likenesses are from the line of those that are as their shares, a unit vector.
fn imbalance(likeness: &[f64], shares: &[f64]) -> f64 {
    let along: f64 = likeness.iter().zip(shares).map(|(c, s)| c * s).sum();
    likeness.iter().zip(shares).map(|(c, s)| (c - along * s).powi(2)).sum::<f64>().sqrt()
}

fn dot(a: &[f32], b: &[f32]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn target() -> Target {
        let rivals = vec![0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        let prompt = vec![1.0, 0.0, 0.0];
        Target {
            text: String::new(),
            aim: prompt.clone(),
            prompt,
            rivals,
            parts: Vec::new(),
            shares: Vec::new(),
        }
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

    #[test]
    fn a_blend_is_to_be_like_its_parts_as_they_are_weighted() {
        let parts = vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let blend = Target { parts, shares: vec![0.8, 0.6], rivals: Vec::new(), ..target() };
        assert!(blend.appraise(&[0.8, 0.6, 0.0]).1 < 1e-7);
        assert!(blend.appraise(&[0.4, 0.3, 0.866]).1 < 1e-7);
        assert!((blend.appraise(&[1.0, 0.0, 0.0]).1 - 0.6).abs() < 1e-7);
        assert!((blend.appraise(&[0.0, 1.0, 0.0]).1 - 0.8).abs() < 1e-7);
    }

    #[test]
    fn what_is_taken_from_the_prompt_changes_the_score_and_not_its_rivals() {
        let aside = Target { aim: vec![0.8, -0.6, 0.0], ..target() };
        let images = [0.6, 0.8, 0.0];
        assert!(aside.appraise(&images).0.abs() < 1e-7);
        assert!((aside.appraise(&images).1 - target().appraise(&images).1).abs() < 1e-12);
    }
}
