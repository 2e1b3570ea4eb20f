// SPDX-License-Identifier: MIT OR Apache-2.0
//! A model of the loss that guesses where it is least: a Gaussian process over the candidates of the last generations,
//! in the coordinates in which the search's own distribution is round.
//!
//! Its guess is a candidate of the next generation, beside those that are drawn: the fewer images there are, the more
//! it is worth. After lq-CMA-ES (Hansen, *A Global Surrogate Assisted CMA-ES*, 2019), with a process in the place of the
//! quadratic, as it needs hardly more candidates than there are variables.

use std::collections::VecDeque;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::cmaes::CmaEs;

/// Candidates that are remembered.
const REMEMBERED: usize = 150;

/// Candidates that are needed, beyond the number of variables.
const NEEDED: usize = 8;

/// Candidates farther off than this, in √n standard deviations, say nothing about the loss here.
const FAR: f64 = 6.0;

/// How far off the guess may be, in √n standard deviations.
const REACH: f64 = 1.0;

/// The kernels that are tried: widths in √n standard deviations, and shares of noise in the variance.
const WIDTHS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];
const NOISES: [f64; 3] = [0.01, 0.05, 0.2];

/// Generations between two choices of the kernel.
const CHOICES: usize = 5;

/// Variance of what images make of the loss, whatever the candidate, over that of the loss.
const IMAGES: f64 = 4.0;

/// Steps towards the least value of the model, and the shortest that is worth it.
const STEPS: usize = 60;
const SHORTEST: f64 = 1e-4;

/// What is known of the loss, and the model's kernel.
#[derive(Debug, Clone, Default)]
pub struct Surrogate {
    seen: VecDeque<Seen>,
    kernel: Option<Kernel>,
    guesses: usize,
}

#[derive(Debug, Clone)]
struct Seen {
    x: Vec<f64>,
    /// Number of the images that it was seen by.
    images: usize,
    loss: f64,
}

#[derive(Debug, Clone, Copy)]
struct Kernel {
    width: f64,
    noise: f64,
}

impl Surrogate {
    /// Remembers a generation's candidates and their losses. Those seen by the same `images` are compared with each
    /// other; others have a constant between them. What is not finite is left out.
    pub fn learn(&mut self, candidates: &[Vec<f64>], losses: &[f64], images: usize) {
        let told = candidates.iter().zip(losses).filter(|(_, loss)| loss.is_finite());
        self.seen.extend(told.map(|(x, &loss)| Seen { x: x.clone(), images, loss }));
        self.seen.drain(..self.seen.len().saturating_sub(REMEMBERED));
    }

    /// Where the loss should be least near the middle of the search; `None` while too little is known.
    pub fn guess(&mut self, search: &CmaEs) -> Option<Vec<f64>> {
        let data = Data::of(&self.seen, search)?;
        let fit = match self.kernel {
            Some(kernel) if !self.guesses.is_multiple_of(CHOICES) => Fit::of(&data, kernel)?,
            _ => {
                let kernels = WIDTHS.iter().flat_map(|&width| NOISES.map(|noise| Kernel { width, noise }));
                let fits = kernels.filter_map(|kernel| Fit::of(&data, kernel));
                fits.min_by(|a, b| a.unlikelihood.total_cmp(&b.unlikelihood))?
            }
        };
        self.kernel = Some(fit.kernel);
        self.guesses += 1;
        Some(search.unwhitened(&fit.least(&data)))
    }
}

/// What the model is fitted to.
struct Data {
    /// Whitened candidates.
    points: Vec<DVector<f64>>,
    /// Squared distances between them.
    squares: DMatrix<f64>,
    /// Whether they were seen by the same images: 1 or 0.
    alike: DMatrix<f64>,
    /// Losses, of mean 0 and variance 1.
    losses: DVector<f64>,
}

impl Data {
    fn of(seen: &VecDeque<Seen>, search: &CmaEs) -> Option<Self> {
        let n = seen.front()?.x.len();
        let far = FAR * (n as f64).sqrt();
        let whitened = seen.iter().map(|seen| (seen, search.whitened(&seen.x)));
        let (seen, points): (Vec<_>, Vec<_>) = whitened.filter(|(_, z)| z.norm() < far).unzip();
        let count = points.len();
        if count < n + NEEDED {
            return None;
        }
        let losses = DVector::from_fn(count, |i, _| seen[i].loss);
        let losses = losses.add_scalar(-losses.mean());
        let deviation = losses.norm() / (count as f64).sqrt();
        let squares = DMatrix::from_fn(count, count, |i, j| points[i].metric_distance(&points[j]).powi(2));
        let alike = DMatrix::from_fn(count, count, |i, j| f64::from(seen[i].images == seen[j].images));
        (deviation > 0.0).then(|| Self { points, squares, alike, losses: losses / deviation })
    }

    fn variables(&self) -> f64 {
        self.points[0].len() as f64
    }
}

/// The model with one kernel.
struct Fit {
    kernel: Kernel,
    /// Minus the logarithm of the likelihood, but for a constant.
    unlikelihood: f64,
    /// Weight of each candidate.
    weights: DVector<f64>,
}

impl Fit {
    fn of(data: &Data, kernel: Kernel) -> Option<Self> {
        let count = data.losses.len();
        let twice = 2.0 * kernel.width.powi(2) * data.variables();
        let mut covariance =
            data.squares.zip_map(&data.alike, |square, alike| (-square / twice).exp() + IMAGES * alike);
        for i in 0..count {
            covariance[(i, i)] += kernel.noise;
        }
        let factor: Cholesky<f64, Dyn> = Cholesky::new(covariance)?;
        let weights = factor.solve(&data.losses);
        let amplitude = data.losses.dot(&weights) / count as f64;
        let volume: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
        let unlikelihood = 0.5 * count as f64 * amplitude.ln() + volume;
        Some(Self { kernel, unlikelihood, weights })
    }

    /// The model's value at a whitened point, but for a constant, and its slope.
    fn at(&self, data: &Data, z: &DVector<f64>) -> (f64, DVector<f64>) {
        let variance = self.kernel.width.powi(2) * data.variables();
        let mut value = 0.0;
        let mut slope = DVector::zeros(z.len());
        for (point, weight) in data.points.iter().zip(&self.weights) {
            let part = weight * (-z.metric_distance(point).powi(2) / (2.0 * variance)).exp();
            value += part;
            slope.axpy(part / variance, point, 1.0);
            slope.axpy(-part / variance, z, 1.0);
        }
        (value, slope)
    }

    /// The whitened point of least value within reach, downhill from the middle of the search.
    fn least(&self, data: &Data) -> DVector<f64> {
        let reach = REACH * data.variables().sqrt();
        let mut z = DVector::zeros(data.points[0].len());
        let (mut value, mut slope) = self.at(data, &z);
        let mut length = 0.5 * reach / slope.norm().max(f64::MIN_POSITIVE);
        for _ in 0..STEPS {
            let mut there = &z - length * &slope;
            let far = there.norm() / reach;
            if far > 1.0 {
                there /= far;
            }
            let step = &there - &z;
            if step.norm() < SHORTEST * reach {
                break;
            }
            let (lower, steeper) = self.at(data, &there);
            if lower >= value {
                length *= 0.3;
                continue;
            }
            // Barzilai and Borwein's length, where the model is convex along the step.
            let bend = step.dot(&(&steeper - &slope));
            length = if bend > 0.0 { step.norm_squared() / bend } else { 2.0 * length };
            (z, value, slope) = (there, lower, steeper);
        }
        z
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::{Bounds, CmaEsOptions};

    const OPTIMUM: [f64; 6] = [0.8, -0.6, 0.3, 1.4, -0.9, 0.1];

    /// A valley along a diagonal that levels off far from its floor, as scores do.
    fn loss(x: &[f64]) -> f64 {
        let away: Vec<f64> = x.iter().zip(OPTIMUM).map(|(x, o)| x - o).collect();
        let along = away.iter().sum::<f64>();
        let square = away.iter().map(|d| d * d).sum::<f64>() + along * along;
        -1.0 / (1.0 + square)
    }

    fn search(seed: u64) -> CmaEs {
        let options = CmaEsOptions {
            start: vec![0.0; OPTIMUM.len()],
            sigma: 0.5,
            bounds: Bounds::Same(-1.0, 3.0),
            seed,
            ..CmaEsOptions::default()
        };
        CmaEs::new(options).expect("the options are sound")
    }

    /// The mean of the least losses of five searches with so many evaluations, over the least that there is. Each
    /// generation's losses are raised by its `offset`.
    fn searched(guided: bool, evaluations: usize, offset: f64) -> f64 {
        let least = |seed| {
            let (mut search, mut surrogate) = (search(seed), Surrogate::default());
            let mut least = f64::INFINITY;
            while search.evaluations() < evaluations {
                let images = search.generation() % 2;
                let candidates = search.ask();
                let losses: Vec<f64> = candidates.iter().map(|x| loss(x)).collect();
                least = losses.iter().copied().fold(least, f64::min);
                let seen: Vec<f64> = losses.iter().map(|loss| loss + offset * images as f64).collect();
                search.tell(&seen).expect("a loss for each");
                surrogate.learn(&candidates, &seen, images);
                if let Some(guess) = surrogate.guess(&search).filter(|_| guided) {
                    search.inject(&guess).expect("the guess is within bounds");
                }
            }
            least - loss(&OPTIMUM)
        };
        (0..5).map(least).sum::<f64>() / 5.0
    }

    #[test]
    fn guesses_save_a_third_of_the_evaluations() {
        let (alone, guided) = (searched(false, 300, 0.0), searched(true, 200, 0.0));
        assert!(guided < alone, "{guided} with guesses, {alone} without and half as many evaluations again");
    }

    #[test]
    fn what_images_make_of_the_loss_is_no_matter() {
        let (alone, guided) = (searched(false, 300, 0.0), searched(true, 200, 0.3));
        assert!(guided < alone, "{guided} with guesses, {alone} without and half as many evaluations again");
    }

    #[test]
    fn nothing_is_guessed_of_too_little() {
        let mut search = search(0);
        let candidates = search.ask();
        let mut surrogate = Surrogate::default();
        assert!(surrogate.guess(&search).is_none(), "nothing was seen");
        let losses: Vec<f64> = candidates.iter().map(|x| loss(x)).collect();
        surrogate.learn(&candidates, &losses, 0);
        assert!(surrogate.guess(&search).is_none(), "fewer were seen than there are variables");
        let mut flat = Surrogate::default();
        for _ in 0..4 {
            let candidates = search.ask();
            flat.learn(&candidates, &vec![1.0; candidates.len()], 0);
            surrogate.learn(&candidates, &vec![f64::NAN; candidates.len()], 0);
        }
        assert!(flat.guess(&search).is_none(), "all were alike");
        assert!(surrogate.guess(&search).is_none(), "no more was told");
    }
}
