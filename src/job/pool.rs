// SPDX-License-Identifier: MIT OR Apache-2.0
//! The candidates of all searches of a job, from which its variations are chosen.

use std::sync::Arc;

use glam::Vec3;
use rayon::prelude::*;

use super::outcome::Stage;
use crate::search::{Evaluation, Novelty};

/// Shapes that are nearer to each other look the same.
const DISTINCT: f64 = 0.03;

/// Candidates kept of all searches, at most.
const KEPT: usize = 4096;

/// A candidate that was evaluated in a search.
#[derive(Debug)]
struct Candidate {
    stage: Arc<Stage>,
    factors: Vec<Vec3>,
    worth: f64,
    /// Its loss, but for the nearness to others.
    loss: f64,
}

/// The candidates that variations are chosen from.
#[derive(Debug, Default)]
pub struct Pool(Vec<Candidate>);

impl Pool {
    /// Adds a generation. Where there are too many, those of the least worth go.
    pub fn add(&mut self, stage: &Arc<Stage>, candidates: &[Vec<Vec3>], evaluations: &[Evaluation]) {
        self.0.extend(candidates.iter().zip(evaluations).map(|(factors, evaluation)| Candidate {
            stage: stage.clone(),
            factors: factors.clone(),
            worth: evaluation.worth(),
            loss: evaluation.loss - evaluation.nearness,
        }));
        if self.0.len() > KEPT {
            self.0.sort_by(|a, b| b.worth.total_cmp(&a.worth));
            self.0.truncate(KEPT / 2);
        }
    }

    /// Drops the candidates of other stages.
    pub fn retain(&mut self, stage: &Arc<Stage>) {
        self.0.retain(|candidate| Arc::ptr_eq(&candidate.stage, stage));
    }

    /// Candidates worth at least `floor` that are distinct from the others: factors and drawings, those first
    /// that would be best to have.
    pub fn ranked(&self, novelty: &Novelty<'_>, floor: f64) -> Vec<(&[Vec3], Vec<Vec3>)> {
        let ranked = self.0.par_iter().filter(|candidate| candidate.worth >= floor).filter_map(|candidate| {
            let drawing = novelty.sketch.draw(&candidate.stage.scored.deform(&candidate.factors));
            let distance = novelty.distance(&drawing);
            let cost = candidate.loss + novelty.cost(distance, candidate.worth);
            (distance >= DISTINCT).then_some((cost, candidate.factors.as_slice(), drawing))
        });
        let mut ranked: Vec<_> = ranked.collect();
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
        ranked.into_iter().map(|(_, factors, drawing)| (factors, drawing)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxdef::{Boundary, BoxDefGraph, Symmetry};
    use crate::mesh::Mesh;
    use crate::search::Sketch;

    fn stage() -> Arc<Stage> {
        let corners = (0..8u8).map(|i| Vec3::from([0, 1, 2].map(|bit| f32::from(i >> bit & 1)))).collect();
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
        let mesh = Mesh::new(corners, triangles).expect("a cube is a mesh");
        let graph =
            BoxDefGraph::build(&mesh, 1, Symmetry::Auto, Boundary::Smooth).expect("a cube has a part");
        let (graph, whole) = (Arc::new(graph.clone()), graph.shared_field());
        Arc::new(Stage {
            splits: Some(1),
            graph,
            scored: whole.clone(),
            whole,
            triangles: Arc::default(),
            points_field: None,
        })
    }

    fn evaluation(score: f64) -> Evaluation {
        let loss = 0.5 - score;
        Evaluation { score, normal_error: 0.0, rivalry: 0.0, shortfall: 0.0, nearness: 0.5, loss }
    }

    /// A generation whose scores are those of `numbers`, in thousandths.
    fn generation(stage: &Stage, numbers: std::ops::Range<usize>) -> (Vec<Vec<Vec3>>, Vec<Evaluation>) {
        numbers.map(|i| (stage.whole.unchanged(), evaluation(i as f64 / 1000.0))).unzip()
    }

    #[test]
    fn a_pool_is_bounded_and_keeps_the_best() {
        let (stage, mut pool) = (stage(), Pool::default());
        for start in (0..3 * KEPT).step_by(16) {
            let (candidates, evaluations) = generation(&stage, start..start + 16);
            pool.add(&stage, &candidates, &evaluations);
            assert!(pool.0.len() <= KEPT);
        }
        let best = pool.0.iter().map(|candidate| candidate.worth).fold(0.0, f64::max);
        assert!((best - (3 * KEPT - 1) as f64 / 1000.0).abs() < 1e-9);
        let worst = pool.0.iter().map(|candidate| candidate.worth).fold(f64::INFINITY, f64::min);
        assert!(worst > KEPT as f64 / 1000.0, "{worst}");
    }

    #[test]
    fn candidates_are_ranked_by_loss_and_distance_and_the_same_shape_is_left_out() {
        let (stage, mut pool) = (stage(), Pool::default());
        let tall = |z: f32| stage.whole.unchanged().iter().map(|c| *c * Vec3::new(1.0, 1.0, z)).collect();
        let shapes: Vec<Vec<Vec3>> = vec![tall(1.0), tall(1.01), tall(1.3), tall(2.5)];
        pool.add(&stage, &shapes, &[0.6, 0.6, 0.6, 0.55].map(evaluation));
        let mesh = Mesh::new(stage.scored.rest().to_vec(), vec![[0, 3, 7], [1, 2, 4], [5, 6, 0]]);
        let mesh = mesh.expect("three triangles are a mesh");
        let sketch = Sketch::of(&mesh);
        let others = vec![sketch.draw(stage.scored.rest())];
        let novelty = Novelty { sketch: &sketch, others, far: 0.2, weight: 1.0, floor: 0.5, steep: 5.0 };
        let order = |floor: f64| -> Vec<f32> {
            pool.ranked(&novelty, floor).iter().map(|(factors, _)| factors[0].z).collect()
        };
        assert_eq!(order(0.5), [2.5, 1.3], "far before near");
        assert_eq!(order(0.58), [1.3], "what is worth too little is left out");
    }
}
