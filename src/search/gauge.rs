// SPDX-License-Identifier: MIT OR Apache-2.0
//! The gauge: pins size and place of an outcome, which no score can see.
//!
//! Every candidate is centred and scaled before it is rendered, so a scale and shift of the whole drift
//! freely during the search. The gauge is the one uniform scale and shift that undo the drift. Both
//! become part of the shape key, so the spectrum stays linear.

use glam::{DVec3, Vec3};
use serde::{Deserialize, Serialize};

/// Extents under this fraction of the bounding-box diagonal count as flat.
const FLAT: f64 = 1e-4;

/// Which size of the rest shape the outcome keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum KeepSize {
    /// The diagonal of the bounding box.
    #[default]
    Diagonal,
    /// The extent along z; of a flat shape, the diagonal.
    Height,
    /// The diagonal of the floor rectangle, x by y; of a shape without one, of the bounding box.
    Footprint,
    /// None: the size is left as the search found it.
    Off,
}

/// Which place of the rest shape the outcome keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum KeepPlace {
    /// The centre of the bounding box's bottom face (least z): a chair stays on its floor.
    #[default]
    BottomCenter,
    /// None: the bottom centre is left where the search put it.
    Off,
}

/// A uniform scale and a shift: v ↦ scale·v + shift, in object coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gauge {
    /// The scale; positive.
    pub scale: f32,
    /// The shift, in the mesh's unit.
    pub shift: Vec3,
}

impl Gauge {
    /// Changes nothing.
    pub const IDENTITY: Self = Self { scale: 1.0, shift: Vec3::ZERO };

    /// The gauge that gives `deformed` the size and place of `rest` (each any number of points, z up).
    ///
    /// Where a size is not there to be compared (a single point, positions that are not finite), the
    /// scale is 1. An undeformed shape gets [`Gauge::IDENTITY`] exactly.
    #[must_use]
    pub fn new(rest: &[Vec3], deformed: &[Vec3], size: KeepSize, place: KeepPlace) -> Self {
        let (Some(rest), Some(deformed)) = (Extent::of(rest), Extent::of(deformed)) else {
            return Self::IDENTITY;
        };
        let scale = match size {
            KeepSize::Off => None,
            KeepSize::Height => rest.height_over(&deformed).or_else(|| rest.diagonal_over(&deformed)),
            KeepSize::Footprint => rest.footprint_over(&deformed).or_else(|| rest.diagonal_over(&deformed)),
            KeepSize::Diagonal => rest.diagonal_over(&deformed),
        };
        // Rounded first, so that the shift belongs to the scale that is applied.
        let scale = scale.map_or(1.0, |scale| scale as f32);
        if !(scale > 0.0 && scale.is_finite()) {
            return Self::IDENTITY;
        }
        let kept = match place {
            KeepPlace::BottomCenter => rest.bottom_center(),
            KeepPlace::Off => deformed.bottom_center(),
        };
        let shift = (kept - f64::from(scale) * deformed.bottom_center()).as_vec3();
        Self { scale, shift }
    }

    /// The diagonal of the bounding box of points; 1 where there is none to measure by.
    #[must_use]
    pub fn diagonal(points: &[Vec3]) -> f32 {
        let diagonal = Extent::of(points).map_or(0.0, |extent| extent.diagonal() as f32);
        if diagonal > 0.0 { diagonal } else { 1.0 }
    }

    /// Applies the gauge to points: the deformed ones it was made from, or others deformed by the same
    /// field.
    pub fn apply(&self, points: &mut [Vec3]) {
        for point in points {
            *point = self.scale * *point + self.shift;
        }
    }
}

/// A bounding box.
struct Extent {
    min: DVec3,
    max: DVec3,
}

impl Extent {
    /// `None` without points or with any that is not finite.
    fn of(points: &[Vec3]) -> Option<Self> {
        let first = points.first()?.as_dvec3();
        let (mut min, mut max, mut finite) = (first, first, true);
        for point in points {
            finite &= point.is_finite();
            min = min.min(point.as_dvec3());
            max = max.max(point.as_dvec3());
        }
        finite.then_some(Self { min, max })
    }

    fn diagonal(&self) -> f64 {
        self.min.distance(self.max)
    }

    fn height(&self) -> Option<f64> {
        let height = self.max.z - self.min.z;
        (height > FLAT * self.diagonal()).then_some(height)
    }

    fn height_over(&self, other: &Self) -> Option<f64> {
        Some(self.height()? / other.height()?)
    }

    fn footprint(&self) -> Option<f64> {
        let footprint = self.min.truncate().distance(self.max.truncate());
        (footprint > FLAT * self.diagonal()).then_some(footprint)
    }

    fn footprint_over(&self, other: &Self) -> Option<f64> {
        Some(self.footprint()? / other.footprint()?)
    }

    fn diagonal_over(&self, other: &Self) -> Option<f64> {
        (self.diagonal() > 0.0 && other.diagonal() > 0.0).then(|| self.diagonal() / other.diagonal())
    }

    fn bottom_center(&self) -> DVec3 {
        let center = self.min.midpoint(self.max);
        DVec3::new(center.x, center.y, self.min.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box of 2 × 1 × 4 that stands on z = 10.
    fn rest() -> Vec<Vec3> {
        vec![Vec3::new(0.0, 0.0, 10.0), Vec3::new(2.0, 1.0, 14.0), Vec3::new(1.5, 0.25, 12.0)]
    }

    fn deformed() -> Vec<Vec3> {
        rest().iter().map(|v| Vec3::new(3.0 * v.x - 7.0, 0.5 * v.y + 2.0, 1.5 * v.z + 20.0)).collect()
    }

    fn gauged(size: KeepSize, place: KeepPlace) -> Extent {
        let mut points = deformed();
        Gauge::new(&rest(), &points, size, place).apply(&mut points);
        Extent::of(&points).unwrap()
    }

    #[test]
    fn size_and_place_are_those_of_the_rest_shape() {
        let rest = Extent::of(&rest()).unwrap();
        for size in [KeepSize::Diagonal, KeepSize::Height, KeepSize::Footprint, KeepSize::Off] {
            let extent = gauged(size, KeepPlace::BottomCenter);
            assert!(extent.bottom_center().distance(rest.bottom_center()) < 1e-5);
        }
        let same_diagonal = gauged(KeepSize::Diagonal, KeepPlace::BottomCenter).diagonal();
        assert!((same_diagonal - rest.diagonal()).abs() < 1e-5);
        let same_height = gauged(KeepSize::Height, KeepPlace::BottomCenter).height().unwrap();
        assert!((same_height - 4.0).abs() < 1e-5);
        let same_footprint = gauged(KeepSize::Footprint, KeepPlace::BottomCenter).footprint().unwrap();
        assert!((same_footprint - 5.0_f64.sqrt()).abs() < 1e-5);
    }

    #[test]
    fn with_place_off_the_outcome_is_scaled_where_it_stands() {
        let before = Extent::of(&deformed()).unwrap();
        let after = gauged(KeepSize::Diagonal, KeepPlace::Off);
        assert!(after.bottom_center().distance(before.bottom_center()) < 1e-5);
        assert!((after.diagonal() - before.diagonal()).abs() > 1.0);
    }

    #[test]
    fn proportions_stay() {
        let (before, after) =
            (Extent::of(&deformed()).unwrap(), gauged(KeepSize::Height, KeepPlace::BottomCenter));
        let ratio = (after.max - after.min) / (before.max - before.min);
        assert!((ratio.x - ratio.z).abs() < 1e-5 && (ratio.y - ratio.z).abs() < 1e-5);
    }

    #[test]
    fn with_both_off_or_nothing_deformed_nothing_changes() {
        assert_eq!(Gauge::new(&rest(), &deformed(), KeepSize::Off, KeepPlace::Off), Gauge::IDENTITY);
        for size in [KeepSize::Diagonal, KeepSize::Height, KeepSize::Footprint, KeepSize::Off] {
            for place in [KeepPlace::BottomCenter, KeepPlace::Off] {
                let mut points = rest();
                Gauge::new(&rest(), &points, size, place).apply(&mut points);
                assert_eq!(points, rest());
            }
        }
    }

    #[test]
    fn a_flat_shape_keeps_its_diagonal_instead_of_its_height() {
        let flat = [Vec3::ZERO, Vec3::new(3.0, 4.0, 0.0)];
        let doubled = [Vec3::ZERO, Vec3::new(6.0, 8.0, 0.0)];
        let gauge = Gauge::new(&flat, &doubled, KeepSize::Height, KeepPlace::BottomCenter);
        assert!((gauge.scale - 0.5).abs() < 1e-6);
    }

    #[test]
    fn what_has_no_size_is_only_moved() {
        let (here, there) = ([Vec3::ONE], [Vec3::new(5.0, 5.0, 5.0)]);
        let gauge = Gauge::new(&here, &there, KeepSize::Diagonal, KeepPlace::BottomCenter);
        assert_eq!(gauge, Gauge { scale: 1.0, shift: Vec3::splat(-4.0) });
        let broken = [Vec3::ZERO, Vec3::NAN];
        for (rest, deformed) in [(&broken[..], &here[..]), (&here[..], &broken[..]), (&[], &[])] {
            assert_eq!(Gauge::new(rest, deformed, KeepSize::Height, KeepPlace::Off), Gauge::IDENTITY);
        }
    }
}
