// SPDX-License-Identifier: MIT OR Apache-2.0
//! Boxmorph deforms a manufactured object towards a text prompt.
//!
//! The modules stand in the order of the data's flow; each knows only those above it:
//!
//! ```text
//! mesh → boxdef → render → guide → search → job
//! ```
//!
//! `hub`, which brings guides to the disk, knows none of them and none knows it.
pub mod boxdef;
pub mod guide;
pub mod hub;
pub mod job;
pub mod mesh;
pub mod metrics;
pub mod render;
pub mod report;
pub mod search;
mod spare;
pub mod spectrum;

#[cfg(feature = "python")]
mod python;
