// SPDX-License-Identifier: MIT OR Apache-2.0
//! The record of a job: everything needed to make the same outcome again, and what it cost.

use serde::Serialize;

/// Which guide judged.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GuideRecord {
    /// Its name.
    pub name: String,
    /// SHA-256 over its files.
    pub sha256: String,
    /// The precision of its image network, such as "fp32" or "int8".
    pub precision: String,
    /// What encoded the images: "cpu", or another execution provider of ONNX Runtime.
    pub provider: String,
}

/// The record of one outcome. Lengths are in the object's unit, times in seconds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// Version of Boxmorph.
    pub boxmorph: String,
    /// The prompt.
    pub prompt: String,
    /// What it should not look like.
    pub negative: Option<String>,
    /// What it was.
    pub source: Option<String>,
    /// Whether texts were read in templates.
    pub templates: bool,
    /// Words of these that the guide does not know.
    pub unknown_words: Vec<String>,
    /// The guide.
    pub guide: GuideRecord,
    /// The preset's name.
    pub preset: String,
    /// Whether the score and the normal error alone counted.
    pub paper_loss: bool,
    /// Images that might be encoded, in a search on a budget. Where seconds were asked for, what they came to on
    /// this machine: as a budget of images it gives the same outcome anywhere, if the time sufficed.
    pub image_budget: Option<usize>,
    /// Seconds that were asked for.
    pub seconds_budget: Option<f64>,
    /// The seed.
    pub seed: u64,
    /// The split count that won; none where the parts were given.
    pub splits: Option<u32>,
    /// Whether each parameter row kept its scale on x, y and z, where there were locks.
    pub locked: Option<Vec<[bool; 3]>>,
    /// Least and greatest scale factor.
    pub scale_range: [f32; 2],
    /// The symmetry: "x", "y", "z", "xy" or "none".
    pub symmetry: String,
    /// The boundary step.
    pub boundary: String,
    /// The renderer.
    pub renderer: String,
    /// Outcomes that were asked for.
    pub variations_asked: usize,
    /// Which of them this is; 0 is the best.
    pub variation: usize,
    /// How far it is from the best: root mean square over the surface, as a share of the bounding box's diagonal.
    pub distance: f64,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Triangles of what was scored of it: fewer, where a light proxy stood in for a dense mesh.
    pub scored_triangles: usize,
    /// Part boxes.
    pub boxes: usize,
    /// Rows of `scales`.
    pub parameter_rows: usize,
    /// Score of the unchanged object, by all images: mean cosine with what was asked for.
    pub score_before: f64,
    /// Score of the outcome, by all images.
    pub score_after: f64,
    /// Mean of 1 − cos between vertex normals before and after, of what was scored.
    pub normal_error: f64,
    /// Generations, over all split counts.
    pub generations: usize,
    /// Candidates evaluated, over all split counts.
    pub evaluations: usize,
    /// Images encoded, over all split counts.
    pub images_encoded: usize,
    /// Wall time.
    pub seconds: f64,
    /// Why the winning search ended.
    pub stop_reason: String,
    /// Scale factors per parameter row and axis.
    pub scales: Vec<[f32; 3]>,
    /// Shifts per parameter row and axis, where parts were allowed to be shifted.
    pub shifts: Option<Vec<[f32; 3]>>,
    /// The gauge's factor on positions.
    pub gauge_scale: f32,
    /// The gauge's shift of positions, after its factor.
    pub gauge_shift: [f32; 3],
    /// Lowest slider value.
    pub slider_min: f32,
    /// Highest slider value.
    pub slider_max: f32,
}
