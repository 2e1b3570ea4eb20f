// SPDX-License-Identifier: MIT OR Apache-2.0
//! Which images score a candidate: views, before backgrounds.

use crate::boxdef::Symmetry;
use crate::render::{BACKGROUNDS, View};

/// Two directions nearer than this, in degrees, are one.
const SAME_DIRECTION: f32 = 0.01;

/// The images that score one candidate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImagePlan {
    /// Every view before every background, as in the paper.
    All,
    /// Every view once, the backgrounds taken in turn: a third of the images, and no background favoured.
    InTurn,
    /// One of the views that are mirror images of each other, before one background; view and background change
    /// from generation to generation, so that in the long run all count. Within a generation all candidates are seen
    /// alike, and only their ranks move the search.
    Distinct,
}

/// The views of a shape, in groups that show mirror images of each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Views {
    count: usize,
    mirrored: Vec<Vec<usize>>,
}

impl Views {
    /// The views of a shape of this symmetry. About x mirrors left and right, about y front and back.
    #[must_use]
    pub fn of(views: &[View], symmetry: Symmetry) -> Self {
        let (x, y) = match symmetry {
            Symmetry::X => (true, false),
            Symmetry::Y => (false, true),
            Symmetry::Xy => (true, true),
            Symmetry::Auto | Symmetry::None | Symmetry::Z => (false, false),
        };
        let images = |view: &View| {
            let azimuth = view.azimuth;
            // Azimuths are counted from +x towards −y.
            let both = [(x, 180.0 - azimuth), (y, -azimuth), (x && y, 180.0 + azimuth)];
            both.into_iter().filter(|(holds, _)| *holds).map(|(_, azimuth)| azimuth).collect::<Vec<_>>()
        };
        let same = |a: f32, b: f32| {
            let turn = (a - b).rem_euclid(360.0);
            turn.min(360.0 - turn) < SAME_DIRECTION
        };
        let mut mirrored: Vec<Vec<usize>> = Vec::new();
        for (index, view) in views.iter().enumerate() {
            let shows = |group: &&mut Vec<usize>| {
                let first = &views[group[0]];
                let level = (first.elevation - view.elevation).abs() < SAME_DIRECTION;
                level && images(first).iter().any(|&azimuth| same(azimuth, view.azimuth))
            };
            match mirrored.iter_mut().find(shows) {
                Some(group) => group.push(index),
                None => mirrored.push(vec![index]),
            }
        }
        Self { count: views.len(), mirrored }
    }

    /// Generations after which the same images come again.
    #[must_use]
    pub fn period(&self, plan: ImagePlan) -> usize {
        match plan {
            ImagePlan::All | ImagePlan::InTurn => 1,
            // Groups are of one, two or four.
            ImagePlan::Distinct => BACKGROUNDS.len() * self.mirrored.iter().map(Vec::len).max().unwrap_or(1),
        }
    }

    /// The (view, background) pairs of one candidate in the generation of this number.
    #[must_use]
    pub fn pairs(&self, plan: ImagePlan, generation: usize) -> Vec<(usize, usize)> {
        let backgrounds = BACKGROUNDS.len();
        match plan {
            ImagePlan::All => (0..self.count).flat_map(|v| (0..backgrounds).map(move |b| (v, b))).collect(),
            ImagePlan::InTurn => (0..self.count).map(|v| (v, v % backgrounds)).collect(),
            ImagePlan::Distinct => {
                let groups = self.mirrored.iter().enumerate();
                groups.map(|(i, g)| (g[generation % g.len()], (i + generation) % backgrounds)).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::views_by_name;

    fn groups(symmetry: Symmetry) -> Vec<Vec<usize>> {
        Views::of(&views_by_name("paper").expect("the paper has views"), symmetry).mirrored
    }

    #[test]
    fn views_of_a_symmetric_shape_are_mirror_images() {
        // Front right, back right, back left, front left.
        assert_eq!(groups(Symmetry::None), [[0], [1], [2], [3]]);
        assert_eq!(groups(Symmetry::X), [[0, 3], [1, 2]]);
        assert_eq!(groups(Symmetry::Y), [[0, 1], [2, 3]]);
        assert_eq!(groups(Symmetry::Xy), [[0, 1, 2, 3]]);
    }

    #[test]
    fn every_view_and_background_takes_its_turn() {
        let views = Views::of(&views_by_name("paper").expect("the paper has views"), Symmetry::X);
        let mut seen: Vec<(usize, usize)> =
            (0..6).flat_map(|generation| views.pairs(ImagePlan::Distinct, generation)).collect();
        assert_eq!(seen.len(), 12, "two images a generation");
        seen.sort_unstable();
        let mut all = views.pairs(ImagePlan::All, 0);
        all.sort_unstable();
        assert_eq!(seen, all);
    }
}
