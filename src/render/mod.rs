// SPDX-License-Identifier: MIT OR Apache-2.0
//! Candidates to images: one interface, a CPU rasteriser and `wgpu`.
