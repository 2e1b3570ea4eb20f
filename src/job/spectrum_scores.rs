// SPDX-License-Identifier: MIT OR Apache-2.0
//! The score along the spectrum: how much each shape between object and outcome looks like the prompt.

use std::sync::Arc;

use glam::Vec3;

use super::JobError;
use super::proxy::Proxy;
use crate::boxdef::DeformField;
use crate::guide::Guide;
use crate::mesh::Mesh;
use crate::render::{Backend, View};
use crate::search::{ImagePlan, Objective, Preset, Target, Wording};

/// Shapes drawn and encoded at a time: a bound on memory.
const BATCH: usize = 16;

/// Scores of the shapes at `alphas`, rest + α·(outcome − rest), one per α: the mean cosine of all images (every
/// one of the `views` before every background) with what is asked for; from the paper's views, as a job's record
/// holds it.
///
/// `outcome` are positions of the mesh's vertices, in its coordinates. Dense meshes are scored by the light proxy
/// that a job takes. Templates are used as the wording says, else as the guide has them. Fails for a prompt the
/// guide cannot read, for positions of another number or that are not
/// finite, for an α that is not finite, and where guide or renderer fail.
pub fn spectrum_scores(
    mesh: &Mesh,
    outcome: &[Vec3],
    wording: &Wording,
    guide: &Guide,
    alphas: &[f32],
    views: &[View],
    backend: Backend,
) -> Result<Vec<f64>, JobError> {
    wording.check(guide)?;
    let rest = mesh.vertices();
    if outcome.len() != rest.len() {
        return Err(JobError::OtherOutcome { expected: rest.len(), found: outcome.len() });
    }
    if outcome.iter().any(|p| !p.is_finite()) || alphas.iter().any(|a| !a.is_finite()) {
        return Err(JobError::BadSpectrum);
    }
    // The spectrum is a field of one row: with the change as its basis, the factor 1 + α gives the shape at α.
    let basis = (0..3).flat_map(|axis| rest.iter().zip(outcome).map(move |(a, b)| b[axis] - a[axis]));
    let line = Arc::new(DeformField::new(rest.to_vec(), 1, basis.collect()));
    let proxy = Proxy::of(mesh);
    let target = Target::new(guide, &wording.resolved(guide, true))?;
    // Of what is evaluated only the score is read, which no preset changes.
    let preset = &Preset::STANDARD;
    let mut objective =
        Objective::new(proxy.mesh(), proxy.field(line), guide, &target, backend, views, preset)?;
    let factors: Vec<Vec<Vec3>> = alphas.iter().map(|&alpha| vec![Vec3::splat(1.0 + alpha)]).collect();
    let mut scores = Vec::with_capacity(alphas.len());
    for batch in factors.chunks(BATCH) {
        scores.extend(objective.evaluate(batch, ImagePlan::All)?.iter().map(|e| e.score));
    }
    Ok(scores)
}
