// SPDX-License-Identifier: MIT OR Apache-2.0
//! What a search may change: the scale factors that are not locked, within their range.

use glam::Vec3;
use thiserror::Error;

use super::Bounds;

/// The range of scale factors where none is asked for: x from −1 to 3 (paper §4, reference protocol).
pub const SCALE_RANGE: (f32, f32) = (0.3, 3.1);

/// Scale change of one unit of the search variable x; a scale factor is `1 + 0.7 x`.
const SCALE_PER_X: f64 = 0.7;

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

/// The search variables of a graph: one for each parameter row and axis that is not locked.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchSpace {
    locked: Vec<[bool; 3]>,
    range: (f32, f32),
}

impl SearchSpace {
    /// Everything free, in the usual range.
    #[must_use]
    pub fn free(parameter_rows: usize) -> Self {
        Self { locked: vec![[false; 3]; parameter_rows], range: SCALE_RANGE }
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

    /// Number of search variables.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.locked.iter().flatten().filter(|&&locked| !locked).count()
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
        Bounds::Same(x_of(self.range.0), x_of(self.range.1))
    }

    /// The search point nearest to scale factors, one row a parameter row.
    #[must_use]
    pub fn point(&self, scales: &[Vec3]) -> Vec<f64> {
        let all = self.locked.iter().flatten().zip(scales.iter().flat_map(Vec3::to_array));
        all.filter(|(locked, _)| !**locked).map(|(_, c)| x_of(c.clamp(self.range.0, self.range.1))).collect()
    }

    /// The scale factors of a search point, one row a parameter row; 1 where locked.
    #[must_use]
    pub fn scales(&self, point: &[f64]) -> Vec<Vec3> {
        let mut variables = point.iter();
        let mut scale = |locked: bool| match if locked { None } else { variables.next() } {
            Some(x) => (1.0 + SCALE_PER_X * x) as f32,
            None => 1.0,
        };
        self.locked.iter().map(|row| Vec3::from_array(row.map(&mut scale))).collect()
    }
}

fn x_of(scale: f32) -> f64 {
    (f64::from(scale) - 1.0) / SCALE_PER_X
}
