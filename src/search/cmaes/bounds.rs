// SPDX-License-Identifier: MIT OR Apache-2.0
//! Bounds by a smooth change of coordinates, so that an optimum *on* a bound is found like any other.
//!
//! CMA-ES walks in an unbounded *inner* space; every candidate is folded into the bounds before it is
//! scored. The idea is that of pycma's `BoundTransform`: the fold is the identity well inside, bends
//! quadratically within `w` of a bound, touches the bound with slope 0 at `w` beyond it, and is reflected
//! from there on. A function that only falls towards the bound so becomes a smooth valley whose floor
//! lies on the bound, and the step size shrinks into it as into any other valley. Clamping, by contrast,
//! leaves a plateau on which the step size grows without end.
//!
//! ```text
//!   outer ▲
//!   upper ┤             .-‾‾‾-.            slope 0 at upper + w, mirrored after it
//!         │           /
//!         │         /   identity
//!         │       /
//!   lower ┤ `-_-'
//!         └───┬────────────┬──▶ inner
//!         lower − w    upper + w
//! ```

use serde::{Deserialize, Serialize};

use super::{error::SearchError, exact};

/// Width of the bend at a bound: the fraction of the range between both bounds or, where the other side
/// is open, of 1 + |bound|.
const BEND: f64 = 0.05;

/// The greatest standard deviation, as a fraction of the range between both bounds: beyond it, samples
/// wrap around so often that their scores no longer say where to go.
const GREATEST_DEVIATION: f64 = 1.0 / 3.0;

/// Where the coordinates of a search may lie. Infinite values leave a side open.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub enum Bounds {
    /// Anywhere.
    #[default]
    None,
    /// All coordinates between the same lower and upper bound.
    Same(#[serde(with = "exact")] f64, #[serde(with = "exact")] f64),
    /// One (lower, upper) for each coordinate.
    Each(#[serde(with = "exact")] Vec<(f64, f64)>),
}

/// The fold of inner coordinates into the bounds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BoundTransform {
    folds: Vec<Fold>,
}

/// The fold of one coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fold {
    lower: f64,
    upper: f64,
    /// Half the width, in inner coordinates, over which the fold bends at the lower bound.
    lower_bend: f64,
    /// The same at the upper bound.
    upper_bend: f64,
}

impl BoundTransform {
    /// The fold for `n` coordinates.
    pub(super) fn new(bounds: &Bounds, n: usize) -> Result<Self, SearchError> {
        let folds = match bounds {
            Bounds::None => vec![Fold::new(f64::NEG_INFINITY, f64::INFINITY)?; n],
            Bounds::Same(lower, upper) => vec![Fold::new(*lower, *upper)?; n],
            Bounds::Each(pairs) if pairs.len() == n => {
                pairs.iter().map(|&(lower, upper)| Fold::new(lower, upper)).collect::<Result<_, _>>()?
            }
            Bounds::Each(pairs) => return Err(SearchError::BoundsCount { expected: n, got: pairs.len() }),
        };
        Ok(Self { folds })
    }

    /// Folds inner coordinates into the bounds. The result never leaves them, by not even one bit.
    pub(super) fn outer(&self, inner: &[f64]) -> Vec<f64> {
        self.folds.iter().zip(inner).map(|(fold, &x)| fold.outer(x)).collect()
    }

    /// The inner coordinates nearest the middle that fold to `outer`, which must lie within the bounds.
    pub(super) fn inner(&self, outer: &[f64]) -> Vec<f64> {
        self.folds.iter().zip(outer).map(|(fold, &y)| fold.inner(y)).collect()
    }

    /// The first coordinate outside its bounds, with them.
    pub(super) fn first_outside(&self, outer: &[f64]) -> Option<(usize, f64, f64)> {
        let outside = |(fold, y): (&Fold, &f64)| !(fold.lower..=fold.upper).contains(y);
        let coordinate = self.folds.iter().zip(outer).position(outside)?;
        Some((coordinate, self.folds[coordinate].lower, self.folds[coordinate].upper))
    }

    /// The greatest standard deviation that makes sense in each inner coordinate; infinite where open.
    pub(super) fn greatest_deviation(&self, coordinate: usize) -> f64 {
        let fold = &self.folds[coordinate];
        GREATEST_DEVIATION * (fold.upper - fold.lower)
    }
}

impl Fold {
    fn new(lower: f64, upper: f64) -> Result<Self, SearchError> {
        let room = lower < upper && lower != f64::INFINITY && upper != f64::NEG_INFINITY;
        if !room {
            return Err(SearchError::EmptyBounds { lower, upper });
        }
        let range = upper - lower;
        let bend = |bound: f64| match (bound.is_finite(), range.is_finite()) {
            (false, _) => 0.0,
            (true, false) => BEND * (1.0 + bound.abs()),
            (true, true) => BEND * range,
        };
        Ok(Self { lower, upper, lower_bend: bend(lower), upper_bend: bend(upper) })
    }

    fn outer(&self, inner: f64) -> f64 {
        let x = self.reflected(inner);
        let y = if x < self.lower + self.lower_bend {
            self.lower + (x - (self.lower - self.lower_bend)).powi(2) / (4.0 * self.lower_bend)
        } else if x > self.upper - self.upper_bend {
            self.upper - (x - (self.upper + self.upper_bend)).powi(2) / (4.0 * self.upper_bend)
        } else {
            x
        };
        // Rounding alone can put `y` outside.
        y.clamp(self.lower, self.upper)
    }

    /// Mirrors `inner` into the stretch on which the fold is monotone.
    fn reflected(&self, inner: f64) -> f64 {
        let (low, high) = (self.lower - self.lower_bend, self.upper + self.upper_bend);
        match (low.is_finite(), high.is_finite()) {
            (false, false) => inner,
            (true, false) => low + (inner - low).abs(),
            (false, true) => high - (high - inner).abs(),
            (true, true) if (low..=high).contains(&inner) => inner,
            (true, true) => {
                let length = high - low;
                let along = (inner - low).rem_euclid(2.0 * length);
                low + if along > length { 2.0 * length - along } else { along }
            }
        }
    }

    fn inner(&self, outer: f64) -> f64 {
        if outer < self.lower + self.lower_bend {
            self.lower - self.lower_bend + 2.0 * (self.lower_bend * (outer - self.lower)).sqrt()
        } else if outer > self.upper - self.upper_bend {
            self.upper + self.upper_bend - 2.0 * (self.upper_bend * (self.upper - outer)).sqrt()
        } else {
            outer
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn fold(bounds: &Bounds) -> BoundTransform {
        BoundTransform::new(bounds, 1).unwrap()
    }

    #[test]
    fn every_inner_point_lands_within_the_bounds() {
        let closed = fold(&Bounds::Same(-1.0, 3.0));
        let below = fold(&Bounds::Same(f64::NEG_INFINITY, 3.0));
        let above = fold(&Bounds::Same(-1.0, f64::INFINITY));
        for step in -4000..4000 {
            let x = [f64::from(step) * 0.037];
            assert!((-1.0..=3.0).contains(&closed.outer(&x)[0]));
            assert!(below.outer(&x)[0] <= 3.0);
            assert!(above.outer(&x)[0] >= -1.0);
        }
    }

    #[test]
    fn the_fold_is_continuous_and_its_slope_stays_within_one() {
        let fold = fold(&Bounds::Same(-1.0, 3.0));
        let step = 1e-3;
        for i in -20_000..20_000 {
            let x = f64::from(i) * step;
            let change = (fold.outer(&[x + step])[0] - fold.outer(&[x])[0]).abs();
            assert!(change <= step * (1.0 + 1e-9), "jump of {change} at {x}");
        }
    }

    #[test]
    fn inner_undoes_outer_and_both_bounds_are_reached() {
        for bounds in [Bounds::Same(-1.0, 3.0), Bounds::Same(-1.0, f64::INFINITY), Bounds::None] {
            let fold = fold(&bounds);
            for i in 0..=400 {
                let y = -1.0 + f64::from(i) * 0.01;
                assert_relative_eq!(fold.outer(&fold.inner(&[y]))[0], y, epsilon = 1e-14);
            }
        }
    }

    #[test]
    fn the_middle_is_left_alone() {
        assert_eq!(fold(&Bounds::Same(-1.0, 3.0)).outer(&[0.25]), [0.25]);
    }

    #[test]
    fn bounds_without_room_are_refused() {
        for (lower, upper) in [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::NAN)] {
            assert!(matches!(
                BoundTransform::new(&Bounds::Same(lower, upper), 1),
                Err(SearchError::EmptyBounds { .. })
            ));
        }
        let two = Bounds::Each(vec![(0.0, 1.0); 2]);
        assert_eq!(BoundTransform::new(&two, 3), Err(SearchError::BoundsCount { expected: 3, got: 2 }));
    }
}
