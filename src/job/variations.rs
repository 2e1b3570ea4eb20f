// SPDX-License-Identifier: MIT OR Apache-2.0
//! Variations: further outcomes that are nearly as good as the best, and far from it and from each other.
//!
//! Each is searched for in the boxes of the winner, with a loss that falls with the distance from what was found
//! before, as long as the worth is kept. It is then chosen among all candidates of all searches in these boxes:
//! where the usual search came by another design, that is taken.

use std::sync::Arc;

use glam::Vec3;
use rayon::prelude::*;

use super::JobError;
use super::finalist::{Finalist, improves};
use super::outcome::{Best, Stage};
use super::run::{AGAIN, Hunt, Run, WIDE, check};
use crate::search::{Evaluation, ImagePlan, Novelty, Sketch, Start};

/// Outcomes of one job at most.
pub const MOST_VARIATIONS: usize = 8;

/// A variation may lose this share of what the best gained, in score and in worth.
/// Of 36 outcomes asked for of nine objects, 22 were found with 0.05, 30 with 0.1, 33 with 0.15 and as many with 0.25.
const TOLERANCE: f64 = 0.15;

/// Searches aim at losing no more than this share of the tolerance: they see a third of the images.
const AIM: f64 = 0.6;

/// Shapes that are nearer to each other look the same.
const DISTINCT: f64 = 0.03;

/// Shapes that are farther from each other need not be.
const FAR: f64 = 0.1;

/// What it costs a candidate to be the same as another outcome, as a share of what the best gained,
const SAMENESS: f64 = 0.5;
/// and what it costs to be worth less than aimed at, a unit.
const STEEP: f64 = 5.0;

/// Candidates that are judged by every image for one variation, at most.
const JUDGED: usize = 40;

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

    /// Candidates worth at least `floor` that are distinct from the others: factors and drawings, those first
    /// that would be best to have.
    fn ranked(&self, novelty: &Novelty<'_>, floor: f64) -> Vec<(&[Vec3], Vec<Vec3>)> {
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

/// What variations are held to.
struct Bar {
    before: Evaluation,
    worth: f64,
    score: f64,
}

impl Bar {
    fn admits(&self, after: &Evaluation) -> bool {
        improves(after, &self.before) && after.worth() >= self.worth && after.score >= self.score
    }
}

impl Run<'_> {
    /// The variations of the winner, best first, each with its distance from it; as many as are asked for or as
    /// there are.
    pub fn vary(&mut self) -> Result<Vec<(f64, Finalist)>, JobError> {
        let Some(winner) = self.winner.as_ref().filter(|winner| winner.improved) else {
            return Ok(Vec::new());
        };
        let (before, after, stage) = (winner.before, winner.after, winner.best.stage.clone());
        let gain = (after.worth() - before.worth()).max(after.score - before.score);
        let slack = TOLERANCE * gain;
        let bar = Bar {
            before,
            worth: after.worth() - slack,
            score: after.score - TOLERANCE * (after.score - before.score).abs(),
        };
        let first = self.sketch.draw(&stage.scored.deform(&winner.best.factors));
        let mut novelty = Novelty {
            sketch: self.sketch,
            others: vec![first],
            far: FAR,
            weight: SAMENESS * gain,
            floor: after.worth() - AIM * slack,
            steep: STEEP,
        };
        self.pool.0.retain(|candidate| Arc::ptr_eq(&candidate.stage, &stage));
        let mut found = Vec::new();
        for variation in 1..self.spec.variations {
            let seed = !self.spec.seed.wrapping_add(variation as u64 * AGAIN);
            // Another design may be near what was given or far from it.
            let sigma = if variation % 2 == 1 { self.spec.preset.sigma } else { WIDE };
            let start = Start { factors: stage.whole.unchanged(), sigma, seed };
            let hunt = self.hunt(&stage, &start, Some(novelty.clone()))?;
            // A candidate may be worth more than a third of its images say.
            let ranked = std::mem::take(&mut self.pool);
            let chosen = self.choose(&stage, hunt, &ranked.ranked(&novelty, bar.worth - slack), &bar)?;
            self.pool = ranked;
            if let Some((drawing, finalist)) = chosen {
                found.push((Sketch::distance(&drawing, &novelty.others[0]), finalist));
                novelty.others.push(drawing);
            }
        }
        found.sort_by(|(_, a), (_, b)| b.after.score.total_cmp(&a.after.score));
        Ok(found)
    }

    /// The first of the ranked candidates that all images find good enough and that is sound.
    fn choose(
        &mut self,
        stage: &Arc<Stage>,
        hunt: Hunt<'_>,
        ranked: &[(&[Vec3], Vec<Vec3>)],
        bar: &Bar,
    ) -> Result<Option<(Vec<Vec3>, Finalist)>, JobError> {
        let Hunt { mut objective, found, .. } = hunt;
        let mut chosen = None;
        for (factors, drawing) in ranked.iter().take(JUDGED) {
            check(self.harness)?;
            let factors = factors.to_vec();
            let after = objective.evaluate(std::slice::from_ref(&factors), ImagePlan::All)?[0];
            self.spent.evaluations += 1;
            if bar.admits(&after) && self.soundness.holds(&stage.scored.deform(&factors)) {
                let best = Best { score: after.score, factors, stage: stage.clone() };
                let (before, stop) = (bar.before, found.stop);
                let finalist = Finalist { best, before, after, improved: true, sound: true, stop };
                chosen = Some((drawing.clone(), finalist));
                break;
            }
        }
        self.spent.images += objective.images_encoded();
        Ok(chosen)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxdef::{Boundary, BoxDefGraph, Symmetry};
    use crate::mesh::Mesh;

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
