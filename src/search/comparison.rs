// SPDX-License-Identifier: MIT OR Apache-2.0
//! Words that compare with what is there: a taller chair is to be taller than this one.
//!
//! Pictures alone cannot say that. A bench that is very wide already looks as much like "a wider seat" as
//! anything can, and narrowing it may even help. But what such a word asks for can be measured.

use glam::Vec3;

/// Comparatives of the whole object, the axis of the extent that they ask for, and its direction.
const COMPARATIVES: [(&str, usize, f64); 6] = [
    ("taller", 2, 1.0),
    ("higher", 2, 1.0),
    ("lower", 2, -1.0),
    ("wider", 0, 1.0),
    ("broader", 0, 1.0),
    ("narrower", 0, -1.0),
];

/// What follows one of these belongs to a part: a chair with a higher back.
const OF_A_PART: [&str; 2] = ["with", "and"];

/// The least change asked for, as the logarithm of a proportion: a fifth more.
const LEAST: f64 = 0.18;

/// A proportion that a prompt asks to change, measured on the object as it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    axis: usize,
    direction: f64,
    rest: f64,
}

impl Comparison {
    /// The first comparative in a prompt, before anything that is said of a part; none if there is none.
    #[must_use]
    pub fn of(prompt: &str, rest: &[Vec3]) -> Option<Self> {
        let lower = prompt.to_lowercase();
        let words = lower.split_whitespace().take_while(|word| !OF_A_PART.contains(word));
        let mut found = words.filter_map(|word| COMPARATIVES.into_iter().find(|known| known.0 == word));
        found.next().map(|(_, axis, direction)| Self { axis, direction, rest: proportion(rest, axis) })
    }

    /// By how much positions fall short of the change that is asked for; 0 where they do not.
    #[must_use]
    pub fn shortfall(&self, positions: &[Vec3]) -> f64 {
        (LEAST - self.direction * (proportion(positions, self.axis) - self.rest)).max(0.0)
    }
}

/// Logarithm of an extent over the geometric mean of the other two.
fn proportion(positions: &[Vec3], axis: usize) -> f64 {
    let (low, high) = positions
        .iter()
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    let size = (high - low).as_dvec3();
    // Flat shapes have extents of 0, whose logarithm is none.
    let log = size
        .max(glam::DVec3::splat(1e-6 * size.max_element().max(f64::MIN_POSITIVE)))
        .to_array()
        .map(f64::ln);
    1.5 * (log[axis] - log.iter().sum::<f64>() / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape() -> [Vec3; 2] {
        [Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0)]
    }

    #[test]
    fn what_is_asked_for_is_measured_against_what_is_there() {
        let taller = Comparison::of("A taller bar stool", &shape()).unwrap();
        assert!((taller.shortfall(&shape()) - LEAST).abs() < 1e-12);
        assert!(taller.shortfall(&shape().map(|p| p * Vec3::new(1.0, 1.0, 1.3))) <= 0.0);
        assert!(taller.shortfall(&shape().map(|p| p * Vec3::new(1.0, 1.0, 0.8))) > LEAST);
        // Larger is not taller.
        assert!((taller.shortfall(&shape().map(|p| p * 3.0)) - LEAST).abs() < 1e-6);
        let narrower = Comparison::of("a narrower bed", &shape()).unwrap();
        assert!(narrower.shortfall(&shape().map(|p| p * Vec3::new(0.5, 1.0, 1.0))) <= 0.0);
    }

    #[test]
    fn only_comparatives_of_the_whole_count() {
        for prompt in ["a tall chair", "a chair", "a chair with a higher back", "a bed with wider legs"] {
            assert_eq!(Comparison::of(prompt, &shape()), None, "{prompt}");
        }
    }
}
