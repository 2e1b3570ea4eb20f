// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a search may change: the scale factors that are not locked, within their range, and shifts.

use glam::Vec3;
use thiserror::Error;

use super::Bounds;

/// The range of scale factors where none is asked for: x from −1 to 3 (paper §4, reference protocol).
pub const SCALE_RANGE: (f32, f32) = (0.3, 3.1);

/// Scale change of one unit of the search variable x; a scale factor is `1 + 0.7 x`.
const SCALE_PER_X: f64 = 0.7;

/// Shift of one unit of the search variable, in reaches.
const SHIFT_PER_X: f64 = 0.3;

/// Less room than this, in reaches, is none.
const LEAST_ROOM: f64 = 0.01;

/// Why there is nothing to search.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpaceError {
    /// The locks are not those of the graph.
    #[error("locked has {found} rows, but the graph has {expected} parameter rows; give three for each")]
    Locks {
        /// Rows given.
        found: usize,
        /// Parameter rows.
        expected: usize,
    },
    /// Nothing may change.
    #[error("every axis of every part is locked; unlock one")]
    AllLocked,
    /// The range does not hold the unchanged object, or nothing else.
    #[error(
        "the range of scale factors is {0} to {1}; give one from above 0 to 1 up to 1 or more, not 1 to 1"
    )]
    Range(f32, f32),
}

/// The search variables of a graph: one for each parameter row and axis that is not locked and, where parts may be
/// shifted, one for each that has room.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchSpace {
    locked: Vec<[bool; 3]>,
    range: (f32, f32),
    /// Least and greatest shift of each parameter row, in reaches; empty where parts may not be shifted.
    room: Vec<[(f64, f64); 3]>,
}

impl SearchSpace {
    /// All scale factors free, in the usual range.
    #[must_use]
    pub fn free(parameter_rows: usize) -> Self {
        Self { locked: vec![[false; 3]; parameter_rows], range: SCALE_RANGE, room: Vec::new() }
    }

    /// `locked` has a row a parameter row: whether x, y and z keep their scale. `range` are the least and the
    /// greatest scale factor of what is free.
    pub fn new(
        parameter_rows: usize,
        locked: Option<&[[bool; 3]]>,
        range: (f32, f32),
    ) -> Result<Self, SpaceError> {
        // Written so that NaN fails.
        let (least, most) = range;
        if !(least > 0.0 && least <= 1.0 && most >= 1.0 && most > least && most < f32::INFINITY) {
            return Err(SpaceError::Range(range.0, range.1));
        }
        let free = Self { range, ..Self::free(parameter_rows) };
        let Some(locked) = locked else { return Ok(free) };
        if locked.len() != parameter_rows {
            return Err(SpaceError::Locks { found: locked.len(), expected: parameter_rows });
        }
        if locked.iter().flatten().all(|&locked| locked) {
            return Err(SpaceError::AllLocked);
        }
        Ok(Self { locked: locked.to_vec(), ..free })
    }

    /// Lets parts be shifted as well: a row of `room` for each parameter row, least and greatest shift along each
    /// axis, in object units; `reach` is their unit among the factors. What is locked keeps its place.
    #[must_use]
    pub fn with_shifts(self, room: &[[(f32, f32); 3]], reach: f32) -> Self {
        let in_reaches = |(least, most): (f32, f32)| (f64::from(least / reach), f64::from(most / reach));
        let worth = |(least, most): &(f64, f64)| most - least >= LEAST_ROOM;
        let room = self.locked.iter().zip(room).map(|(locked, room)| {
            std::array::from_fn(|axis| {
                let free = Some(in_reaches(room[axis])).filter(|room| !locked[axis] && worth(room));
                free.unwrap_or((0.0, 0.0))
            })
        });
        Self { room: room.collect(), ..self }
    }

    /// Number of search variables.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.locked.iter().flatten().filter(|&&locked| !locked).count() + self.free_room().count()
    }

    /// Least and greatest scale factor.
    #[must_use]
    pub fn range(&self) -> (f32, f32) {
        self.range
    }

    /// Whether a parameter row keeps its scale on an axis.
    #[must_use]
    pub fn is_locked(&self, row: usize, axis: usize) -> bool {
        self.locked[row][axis]
    }

    /// Bounds of the search variables.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let scales = (x_of(self.range.0), x_of(self.range.1));
        if self.room.is_empty() {
            return Bounds::Same(scales.0, scales.1);
        }
        let free = self.locked.iter().flatten().filter(|&&locked| !locked).map(|_| scales);
        let room = self.free_room().map(|(least, most)| (least / SHIFT_PER_X, most / SHIFT_PER_X));
        Bounds::Each(free.chain(room).collect())
    }

    /// The search point nearest to some factors.
    #[must_use]
    pub fn point(&self, factors: &[Vec3]) -> Vec<f64> {
        let (scales, shifts) = factors.split_at(self.locked.len());
        let all = self.locked.iter().flatten().zip(scales.iter().flat_map(Vec3::to_array));
        let scales =
            all.filter(|(locked, _)| !**locked).map(|(_, c)| x_of(c.clamp(self.range.0, self.range.1)));
        let all = self.room.iter().flatten().zip(shifts.iter().flat_map(Vec3::to_array));
        let shifts = all.filter(|(room, _)| has_room(room));
        let shifts = shifts.map(|(room, c)| (f64::from(c) - 1.0).clamp(room.0, room.1) / SHIFT_PER_X);
        scales.chain(shifts).collect()
    }

    /// The factors of a search point: scale factors, one row a parameter row, 1 where locked; then shifts, where
    /// there are any.
    #[must_use]
    pub fn factors(&self, point: &[f64]) -> Vec<Vec3> {
        let mut variables = point.iter();
        let mut factor = |free: bool, per_x: f64| match if free { variables.next() } else { None } {
            Some(x) => (1.0 + per_x * x) as f32,
            None => 1.0,
        };
        let scales = self.locked.iter().map(|row| row.map(|locked| factor(!locked, SCALE_PER_X)));
        let mut factors: Vec<Vec3> = scales.map(Vec3::from_array).collect();
        let shifts = self.room.iter().map(|row| row.map(|room| factor(has_room(&room), SHIFT_PER_X)));
        factors.extend(shifts.map(Vec3::from_array));
        factors
    }

    fn free_room(&self) -> impl Iterator<Item = (f64, f64)> {
        self.room.iter().flatten().copied().filter(has_room)
    }
}

fn has_room(room: &(f64, f64)) -> bool {
    room.1 > room.0
}

fn x_of(scale: f32) -> f64 {
    (f64::from(scale) - 1.0) / SCALE_PER_X
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shifts_have_variables_where_there_is_room_and_no_lock() {
        let locked = [[false, true, false], [false; 3]];
        let room = [[(-1.0, 1.0), (-1.0, 1.0), (0.0, 0.0)], [(-0.5, 2.0), (0.0, 0.01), (0.0, 0.0)]];
        let space = SearchSpace::new(2, Some(&locked), (0.5, 2.0)).expect("five are free");
        let space = space.with_shifts(&room, 2.0);
        assert_eq!(space.dimensions(), 5 + 2, "not y of the first, which is locked, nor y of the second");
        let point = [0.1, -0.2, 0.3, -0.4, 0.5, 0.6, -0.7];
        let factors = space.factors(&point);
        assert_eq!(factors.len(), 4);
        assert!((factors[2] - Vec3::new(1.18, 1.0, 1.0)).abs().max_element() < 1e-6, "{}", factors[2]);
        assert!((factors[3] - Vec3::new(0.79, 1.0, 1.0)).abs().max_element() < 1e-6, "{}", factors[3]);
        let back = space.point(&factors);
        assert!(back.iter().zip(&point).all(|(a, b)| (a - b).abs() < 1e-6), "{back:?}");
        let Bounds::Each(bounds) = space.bounds() else { panic!("bounds of their own") };
        assert_eq!(bounds.len(), 7);
        assert!((bounds[6].1 * SHIFT_PER_X - 1.0).abs() < 1e-12, "2 of a reach of 2");
    }
}
