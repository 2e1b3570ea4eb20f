// SPDX-License-Identifier: MIT OR Apache-2.0
//! Functions with known optima, where searches of them start, and what a search of them costs.
//! `benches/cmaes.py` has the same ones for pycma, and holds the two together.
#![allow(dead_code, reason = "the tests and the bench use some of these each")]

use boxmorph::search::{Bounds, CmaEs, CmaEsOptions};

/// Seeds of every case.
pub const SEEDS: u64 = 21;

/// A function to be searched for its least value.
pub struct Case {
    pub name: &'static str,
    pub score: fn(&[f64]) -> f64,
    /// Numbers of coordinates.
    pub sizes: &'static [usize],
    /// The start, the same in every coordinate.
    pub start: f64,
    pub sigma: f64,
    pub bounds: Bounds,
    /// `None`: the usual for the number of coordinates.
    pub population: Option<usize>,
    /// The score at which it counts as solved.
    pub target: f64,
}

impl Case {
    const fn open(name: &'static str, score: fn(&[f64]) -> f64, start: f64) -> Self {
        let (sizes, population) = (&[2, 5, 10, 20], None);
        Self { name, score, sizes, start, sigma: 0.5, bounds: Bounds::None, population, target: 1e-8 }
    }

    pub fn options(&self, n: usize, seed: u64) -> CmaEsOptions {
        CmaEsOptions {
            start: vec![self.start; n],
            sigma: self.sigma,
            bounds: self.bounds.clone(),
            population: self.population,
            seed,
            ..CmaEsOptions::default()
        }
    }

    /// Evaluations until it is solved, from each seed; `None` where [`budget`] did not do. Stop rules are left
    /// aside.
    pub fn evaluations(&self, n: usize) -> Vec<Option<usize>> {
        (0..SEEDS)
            .map(|seed| evaluations_to(self.target, budget(n), self.options(n, seed), self.score))
            .collect()
    }
}

pub static CASES: [Case; 7] = [
    Case::open("sphere", sphere, 1.5),
    Case::open("ellipsoid", ellipsoid, 1.5),
    Case::open("cigar", cigar, 1.5),
    Case::open("tablet", tablet, 1.5),
    Case::open("Rosenbrock", rosenbrock, 0.0),
    Case::open("rotated ellipsoid", rotated_ellipsoid, 1.5),
    Case {
        name: "optimum on 8 of 15 bounds",
        score: beyond_bounds,
        sizes: &[15],
        start: 0.0,
        sigma: 1.0,
        bounds: Bounds::Same(-1.0, 3.0),
        population: Some(36),
        target: 64.0 + 1e-9,
    },
];

/// Evaluations after which a search for n coordinates counts as lost.
pub fn budget(n: usize) -> usize {
    3000 * n
}

/// Evaluations until the best score is at most `target`; `None` beyond `budget`.
pub fn evaluations_to(
    target: f64,
    budget: usize,
    options: CmaEsOptions,
    score: impl Fn(&[f64]) -> f64,
) -> Option<usize> {
    let mut search = CmaEs::new(options).unwrap();
    while search.evaluations() < budget {
        let scores: Vec<f64> = search.ask().iter().map(|x| score(x)).collect();
        search.tell(&scores).unwrap();
        if search.best().is_some_and(|(_, best)| best <= target) {
            return Some(search.evaluations());
        }
    }
    None
}

fn weight(i: usize, n: usize, condition: f64) -> f64 {
    condition.powf(i as f64 / (n - 1) as f64)
}

pub fn sphere(x: &[f64]) -> f64 {
    x.iter().map(|v| v * v).sum()
}

pub fn ellipsoid(x: &[f64]) -> f64 {
    x.iter().enumerate().map(|(i, v)| weight(i, x.len(), 1e6) * v * v).sum()
}

fn cigar(x: &[f64]) -> f64 {
    x[0] * x[0] + 1e6 * sphere(&x[1..])
}

fn tablet(x: &[f64]) -> f64 {
    1e6 * x[0] * x[0] + sphere(&x[1..])
}

fn rosenbrock(x: &[f64]) -> f64 {
    x.windows(2).map(|v| 100.0 * (v[0] * v[0] - v[1]).powi(2) + (v[0] - 1.0).powi(2)).sum()
}

/// Turns every pair of neighbouring coordinates by an angle of its own.
fn rotated(x: &[f64]) -> Vec<f64> {
    let mut turned = x.to_vec();
    for round in 0..x.len() {
        for i in 0..x.len() - 1 {
            let (sin, cos) = (1.0 + (round * x.len() + i) as f64).sin_cos();
            (turned[i], turned[i + 1]) =
                (cos * turned[i] - sin * turned[i + 1], sin * turned[i] + cos * turned[i + 1]);
        }
    }
    turned
}

pub fn rotated_ellipsoid(x: &[f64]) -> f64 {
    ellipsoid(&rotated(x))
}

/// Least squares to a target that lies outside on 8 of 15 coordinates: the optimum, 64, is on those bounds.
pub fn beyond_bounds(x: &[f64]) -> f64 {
    let reach = 8f64.sqrt();
    x.iter()
        .enumerate()
        .map(|(i, v)| {
            let target = match i {
                0..4 => 3.0 + reach,
                4..8 => -1.0 - reach,
                _ => 0.25 * (i as f64 - 8.0),
            };
            (v - target).powi(2)
        })
        .sum()
}
