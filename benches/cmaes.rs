// SPDX-License-Identifier: MIT OR Apache-2.0
//! What our CMA-ES needs or, with `--time`, what a generation of it takes: one line of JSON for
//! `benches/cmaes.py`, which sets pycma beside it.
#![allow(clippy::print_stdout, reason = "what it prints is what it is for")]

#[path = "../tests/functions/mod.rs"]
mod functions;

use std::time::Instant;

use boxmorph::search::{Bounds, CmaEs, CmaEsOptions};
use functions::{CASES, beyond_bounds};
use serde_json::json;

/// What is timed: coordinates, candidates a generation, generations.
const TIMED: (usize, usize, usize) = (45, 46, 200);

/// Seconds of ask and tell for one generation within bounds; scores are not counted.
fn seconds_a_generation() -> f64 {
    let (n, population, generations) = TIMED;
    let options = CmaEsOptions {
        start: vec![0.0; n],
        bounds: Bounds::Same(-1.0, 3.0),
        population: Some(population),
        ..CmaEsOptions::default()
    };
    let mut search = CmaEs::new(options).expect("the options are sound");
    let mut seconds = 0.0;
    for _ in 0..generations {
        let start = Instant::now();
        let candidates = search.ask();
        seconds += start.elapsed().as_secs_f64();
        let scores: Vec<f64> = candidates.iter().map(|x| beyond_bounds(x)).collect();
        let start = Instant::now();
        search.tell(&scores).expect("as many scores as candidates");
        seconds += start.elapsed().as_secs_f64();
    }
    seconds / generations as f64
}

fn main() {
    if std::env::args().any(|argument| argument == "--time") {
        let (n, population, generations) = TIMED;
        println!(
            "{}",
            json!({
                "n": n,
                "population": population,
                "generations": generations,
                "generation_seconds": seconds_a_generation(),
            })
        );
        return;
    }
    let cases: Vec<_> = CASES
        .iter()
        .flat_map(|case| {
            case.sizes.iter().map(|&n| {
                // A value by which the peer can tell whether it searches the same function.
                let probe: Vec<f64> = (0..n).map(|i| 0.1 + 0.3 * i as f64).collect();
                json!({
                    "function": case.name,
                    "n": n,
                    "value": (case.score)(&probe),
                    "evaluations": case.evaluations(n),
                })
            })
        })
        .collect();
    println!("{}", json!({ "cases": cases }));
}
