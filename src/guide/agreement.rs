// SPDX-License-Identifier: MIT OR Apache-2.0
//! How far two guides agree on the pictures of a search: the same candidates, seen from the same views.

use std::time::Instant;

use glam::Vec3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{Guide, GuideError};
use crate::render::{BACKGROUNDS, Backend, composite, render_positions, views_by_name};

/// Candidates that are ranked.
const CANDIDATES: usize = 24;

/// What they are ranked by.
const PROMPTS: [&str; 8] =
    ["a chair", "a bar stool", "a sofa", "a table", "an armchair", "a bench", "a throne", "a wide chair"];

/// Centres and half sizes of the boxes of a chair, z up, in metres: seat, back, legs.
const CHAIR: [([f32; 3], [f32; 3]); 6] = [
    ([0.0, 0.0, 0.44], [0.22, 0.22, 0.025]),
    ([0.0, 0.2, 0.7], [0.21, 0.02, 0.24]),
    ([-0.18, -0.18, 0.21], [0.02, 0.02, 0.21]),
    ([0.18, -0.18, 0.21], [0.02, 0.02, 0.21]),
    ([-0.18, 0.18, 0.21], [0.02, 0.02, 0.21]),
    ([0.18, 0.18, 0.21], [0.02, 0.02, 0.21]),
];

/// Corners of a box's faces, by bits of x, y and z.
const FACES: [[u32; 4]; 6] =
    [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];

/// How far a faster guide agrees with the exact one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Images that both encoded.
    pub images: usize,
    /// Cosine between the two embeddings of an image: the mean.
    pub cosine_mean: f64,
    /// The same: the least.
    pub cosine_min: f64,
    /// Spearman's correlation of the two orders in which a prompt puts the candidates: the mean over prompts.
    pub rank_mean: f64,
    /// The same: the least.
    pub rank_min: f64,
    /// Images a second of the exact guide.
    pub exact_speed: f64,
    /// Images a second of the faster one.
    pub fast_speed: f64,
}

impl Agreement {
    /// Encodes the pictures with both. Both texts are the exact guide's. `reached` is told the share that is done,
    /// and may end it.
    pub fn measure(
        exact: &Guide,
        fast: &Guide,
        reached: impl Fn(f64) -> Result<(), GuideError>,
    ) -> Result<Self, GuideError> {
        let images = pictures(exact.image_size())?;
        let total = 2 * images.len();
        let mut done = 0;
        let mut timed = |guide: &Guide| -> Result<(Vec<f32>, f64), GuideError> {
            let start = Instant::now();
            let mut embeddings = Vec::new();
            for images in images.chunks(guide.bytes_at_once()) {
                reached(done as f64 / total as f64)?;
                embeddings.extend(guide.image_embeddings(images)?);
                done += images.len();
            }
            Ok((embeddings, start.elapsed().as_secs_f64()))
        };
        let ((of_exact, exact_time), (of_fast, fast_time)) = (timed(exact)?, timed(fast)?);
        let length = exact.dimension();
        let cosines: Vec<f64> = of_exact.chunks(length).zip(of_fast.chunks(length)).map(cosine).collect();
        let mut ranks = Vec::new();
        for prompt in PROMPTS {
            let text = exact.text_embedding(prompt)?;
            let scores = |embeddings: &[f32]| -> Vec<f64> {
                let views = embeddings.len() / length / CANDIDATES;
                let score = |views: &[f32]| views.chunks(length).map(|view| cosine((view, &text))).sum();
                embeddings.chunks(length * views).map(score).collect()
            };
            ranks.push(spearman(&scores(&of_exact), &scores(&of_fast)));
        }
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
        Ok(Self {
            images: cosines.len(),
            cosine_mean: mean(&cosines),
            cosine_min: least(&cosines),
            rank_mean: mean(&ranks),
            rank_min: least(&ranks),
            exact_speed: cosines.len() as f64 / exact_time,
            fast_speed: cosines.len() as f64 / fast_time,
        })
    }
}

/// RGB images of chairs whose boxes are scaled at random, in the views of a search.
fn pictures(size: u32) -> Result<Vec<u8>, GuideError> {
    let drawn = |e: crate::render::RenderError| GuideError::Quantize(e.to_string());
    let views = views_by_name("paper").map_err(drawn)?;
    let mut random = ChaCha8Rng::seed_from_u64(0);
    let triangles: Vec<[u32; 3]> = (0..CHAIR.len() as u32)
        .flat_map(|number| FACES.map(|face| face.map(|corner| corner + 8 * number)))
        .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    let plane = (size as usize).pow(2);
    let mut images = Vec::new();
    for _ in 0..CANDIDATES {
        let mut positions = Vec::new();
        for (center, half) in CHAIR {
            let scale = Vec3::from_array(std::array::from_fn(|_| random.random_range(0.5..2.0)));
            for corner in 0..8u8 {
                let sign = |bit: u8| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
                let side = Vec3::new(sign(0), sign(1), sign(2));
                positions.push(Vec3::from_array(center) + side * Vec3::from_array(half) * scale);
            }
        }
        let rgba = render_positions(Backend::Cpu, &positions, &triangles, &views, size).map_err(drawn)?;
        for view in rgba.chunks_exact(4 * plane) {
            let start = images.len();
            images.resize(start + 3 * plane, 0);
            composite(view, BACKGROUNDS[0], &mut images[start..]);
        }
    }
    Ok(images)
}

fn cosine((a, b): (&[f32], &[f32])) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
}

/// The correlation of the ranks of two lists.
fn spearman(a: &[f64], b: &[f64]) -> f64 {
    let ranks = |values: &[f64]| {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|i, j| values[*i].total_cmp(&values[*j]));
        let mut ranks = vec![0.0; values.len()];
        for (rank, index) in order.into_iter().enumerate() {
            ranks[index] = rank as f64;
        }
        ranks
    };
    let middle = (a.len() as f64 - 1.0) / 2.0;
    let (a, b) = (ranks(a), ranks(b));
    let product =
        |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| (x - middle) * (y - middle)).sum::<f64>();
    product(&a, &b) / product(&a, &a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_agree_fully_not_at_all_or_in_reverse() {
        assert!((spearman(&[1.0, 2.0, 5.0], &[0.1, 0.2, 0.3]) - 1.0).abs() < 1e-12);
        assert!((spearman(&[1.0, 2.0, 5.0], &[0.3, 0.2, 0.1]) + 1.0).abs() < 1e-12);
        assert!((spearman(&[1.0, 2.0, 3.0, 4.0], &[2.0, 1.0, 4.0, 3.0]) - 0.6).abs() < 1e-12);
    }

    #[test]
    fn the_pictures_differ_and_show_something() {
        let images = pictures(32).unwrap();
        let each: Vec<&[u8]> = images.chunks(32 * 32 * 3).collect();
        assert_eq!(each.len(), CANDIDATES * 4);
        assert!(each.iter().all(|image| image.iter().any(|byte| *byte != image[0])));
        assert!(each[..4] != each[12..16]);
    }
}
