// SPDX-License-Identifier: MIT OR Apache-2.0
//! One search: CMA-ES over the box scales of one graph, and over shifts where parts may be shifted.

use glam::Vec3;

use super::cmaes::{CmaEs, CmaEsOptions};
use super::surrogate::Surrogate;
use super::{
    Evaluation, Footing, ImagePlan, Objective, ObjectiveError, Preset, SearchError, SearchSpace, StopReason,
};

/// Where a search starts.
#[derive(Debug, Clone)]
pub struct Start {
    /// Factors.
    pub factors: Vec<Vec3>,
    /// First step size, in units of the search variable.
    pub sigma: f64,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// A search under way. It goes on a generation at a time, for as long as it is worth it.
pub struct Search<'a> {
    objective: Objective<'a>,
    space: SearchSpace,
    /// Levels the feet of every candidate before it is evaluated.
    footing: Option<Footing>,
    images: ImagePlan,
    cma: CmaEs,
    /// Guesses one candidate of every generation.
    surrogate: Option<Surrogate>,
    candidates: Vec<Vec<Vec3>>,
    evaluations: Vec<Evaluation>,
    leader: Vec<Vec3>,
    best: (f64, Vec<Vec3>),
    highest: (f64, Vec<Vec3>),
}

impl<'a> Search<'a> {
    /// Sets up the search for factors of least loss in the `space`. The `objective` is to judge nothing else
    /// meanwhile but by [`Search::judge`].
    pub fn new(
        objective: Objective<'a>,
        space: SearchSpace,
        footing: Option<Footing>,
        preset: &Preset,
        start: &Start,
    ) -> Result<Self, SearchError> {
        let cma = CmaEs::new(CmaEsOptions {
            start: space.point(&start.factors),
            sigma: start.sigma,
            bounds: space.bounds(),
            population: Some(preset.population(space.dimensions())),
            seed: start.seed,
            max_generations: preset.max_generations,
            tol_fun: preset.tol_fun,
            ..CmaEsOptions::default()
        })?;
        Ok(Self {
            objective,
            space,
            footing,
            images: preset.images,
            cma,
            surrogate: None,
            candidates: Vec::new(),
            evaluations: Vec::new(),
            leader: start.factors.clone(),
            best: (f64::INFINITY, start.factors.clone()),
            highest: (f64::NEG_INFINITY, start.factors.clone()),
        })
    }

    /// Has a model of the loss guess one candidate of every generation.
    #[must_use]
    pub fn guided(self) -> Self {
        Self { surrogate: Some(Surrogate::default()), ..self }
    }

    /// One generation. Does nothing once there is a [`Search::stop_reason`].
    pub fn step<E: From<SearchError> + From<ObjectiveError>>(&mut self) -> Result<(), E> {
        if self.cma.stop_reason().is_some() {
            return Ok(());
        }
        let points = self.cma.ask();
        self.candidates = points.iter().map(|x| factors(&self.space, self.footing.as_ref(), x)).collect();
        let images = self.objective.images_number(self.images);
        let evaluations = self.objective.evaluate(&self.candidates, self.images)?;
        self.evaluations.clear();
        self.evaluations.extend_from_slice(evaluations);
        let mut least = f64::INFINITY;
        for (evaluation, factors) in self.evaluations.iter().zip(&self.candidates) {
            if evaluation.loss < least {
                least = evaluation.loss;
                self.leader.clone_from(factors);
            }
            if evaluation.score > self.highest.0 {
                self.highest = (evaluation.score, factors.clone());
            }
        }
        if least < self.best.0 {
            self.best = (least, self.leader.clone());
        }
        let losses: Vec<f64> = self.evaluations.iter().map(|e| e.loss).collect();
        self.cma.tell(&losses)?;
        if let Some(surrogate) = &mut self.surrogate {
            surrogate.learn(&points, &losses, images);
            if let Some(guess) = surrogate.guess(&self.cma) {
                self.cma.inject(&guess)?;
            }
        }
        Ok(())
    }

    /// Evaluates factors by every image.
    pub fn judge(&mut self, factors: &[Vec<Vec3>]) -> Result<&[Evaluation], ObjectiveError> {
        self.objective.evaluate(factors, ImagePlan::All)
    }

    /// The last generation's candidates, and what each of them is worth by the images of that generation.
    #[must_use]
    pub fn generation(&self) -> (&[Vec<Vec3>], &[Evaluation]) {
        (&self.candidates, &self.evaluations)
    }

    /// Generations done.
    #[must_use]
    pub fn generations(&self) -> usize {
        self.cma.generation()
    }

    /// Candidates of a generation.
    #[must_use]
    pub fn population(&self) -> usize {
        self.cma.population()
    }

    /// Images encoded so far.
    #[must_use]
    pub fn images_encoded(&self) -> usize {
        self.objective.images_encoded()
    }

    /// The renderer's name.
    #[must_use]
    pub fn backend_name(&self) -> String {
        self.objective.backend_name()
    }

    /// Why it is over, once it is.
    #[must_use]
    pub fn stop_reason(&self) -> Option<StopReason> {
        self.cma.stop_reason()
    }

    /// Factors of least loss in the last generation.
    #[must_use]
    pub fn leader(&self) -> &[Vec3] {
        &self.leader
    }

    /// Factors of least loss in all generations: the best where each generation is seen by the same images.
    #[must_use]
    pub fn best(&self) -> &[Vec3] {
        &self.best.1
    }

    /// Factors of the highest score, whatever their loss.
    #[must_use]
    pub fn highest(&self) -> &[Vec3] {
        &self.highest.1
    }

    /// Factors in the middle of the next generation.
    #[must_use]
    pub fn middle(&self) -> Vec<Vec3> {
        factors(&self.space, self.footing.as_ref(), &self.cma.mean())
    }
}

fn factors(space: &SearchSpace, footing: Option<&Footing>, x: &[f64]) -> Vec<Vec3> {
    let mut factors = space.factors(x);
    if let Some(footing) = footing {
        footing.level(&mut factors, space.range());
    }
    factors
}
