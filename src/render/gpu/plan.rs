// SPDX-License-Identifier: MIT OR Apache-2.0
//! How much goes into one submission and into one atlas.

use crate::render::RenderError;

/// Bytes a sample takes in the atlas and its depth.
const SAMPLE_BYTES: u64 = 8;
/// Largest atlas with its depth; more tiles than fit are drawn in turn.
const ATLAS_BYTES: u64 = 256 << 20;
/// Larger sides bring nothing and cost screen precision.
const ATLAS_SIDE: u32 = 8192;
/// Of workgroups in one dimension.
const DISPATCH: u64 = 65_535;

/// What is drawn and what the adapter allows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Demand {
    pub vertices: u64,
    pub views: u64,
    pub size: u32,
    /// Largest storage binding and buffer, bytes.
    pub buffer_limit: u64,
    /// Largest texture side.
    pub texture_limit: u32,
}

/// How candidates are cut into submissions, and tiles into atlases.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Plan {
    /// Most candidates in one submission.
    pub candidates: usize,
    /// Tiles across the atlas.
    pub columns: u32,
    /// Tiles down the atlas.
    pub rows: u32,
}

impl Plan {
    /// The plan for a call of `candidates` candidates.
    pub fn new(demand: Demand, candidates: usize) -> Result<Self, RenderError> {
        let Demand { vertices, views, size, buffer_limit, texture_limit } = demand;
        let pixels = views * u64::from(size) * u64::from(size) * 4;
        let largest = pixels.max(vertices * 12);
        let fit = (buffer_limit / largest.max(1)).min(DISPATCH).min(candidates.max(1) as u64);
        let side = 2 * size;
        let across = u64::from(texture_limit.min(ATLAS_SIDE) / side);
        if fit == 0 || across == 0 {
            return Err(RenderError::TooLargeForGpu(format!(
                "one candidate needs buffers of {} MiB and textures of {side} pixels",
                largest.div_ceil(1 << 20)
            )));
        }
        let tile_bytes = u64::from(side) * u64::from(side) * SAMPLE_BYTES;
        let tiles = (fit * views).min(ATLAS_BYTES / tile_bytes).clamp(1, DISPATCH);
        // As square as the tiles allow, so that neither side runs into its limit first.
        let columns = tiles.isqrt().min(across);
        let rows = (tiles / columns).min(across);
        Ok(Self { candidates: fit as usize, columns: columns as u32, rows: rows as u32 })
    }

    /// Tiles in one atlas.
    pub fn tiles(&self) -> u32 {
        self.columns * self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEMAND: Demand =
        Demand { vertices: 20_000, views: 4, size: 224, buffer_limit: 128 << 20, texture_limit: 16_384 };

    #[test]
    fn a_usual_generation_is_one_submission_of_few_atlases() {
        let plan = Plan::new(DEMAND, 36).unwrap();
        assert_eq!(plan.candidates, 36);
        assert_eq!(36 * 4_u32.div_ceil(plan.tiles()), 36);
        assert_eq!((36 * 4_u32).div_ceil(plan.tiles()), 1);
    }

    #[test]
    fn buffers_textures_and_dispatches_stay_inside_the_limits() {
        for size in [8, 64, 224, 500, 2048] {
            for vertices in [3, 20_000, 3_000_000] {
                for candidates in [1, 36, 1_000_000] {
                    let demand = Demand { vertices, size, texture_limit: 8192, ..DEMAND };
                    let plan = Plan::new(demand, candidates).unwrap();
                    let chosen = plan.candidates as u64;
                    assert!(chosen >= 1 && chosen <= candidates as u64);
                    assert!(chosen * vertices * 12 <= demand.buffer_limit);
                    assert!(chosen * 4 * u64::from(size) * u64::from(size) * 4 <= demand.buffer_limit);
                    assert!(plan.columns.max(plan.rows) * 2 * size <= 8192);
                    assert!(plan.tiles() >= 1 && u64::from(plan.tiles()) <= DISPATCH);
                }
            }
        }
    }

    #[test]
    fn what_cannot_fit_is_said() {
        let demand = Demand { vertices: 20_000_000, ..DEMAND };
        assert!(matches!(Plan::new(demand, 1), Err(RenderError::TooLargeForGpu(_))));
        let demand = Demand { size: 2048, texture_limit: 2048, ..DEMAND };
        assert!(matches!(Plan::new(demand, 1), Err(RenderError::TooLargeForGpu(_))));
    }
}
