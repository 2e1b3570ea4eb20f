// SPDX-License-Identifier: MIT OR Apache-2.0
//! What is asked of the hub.

/// A file at its address, and whose it is for the sentences of errors.
#[derive(Debug, Clone)]
pub struct Wanted {
    pub address: String,
    pub repository: String,
    pub file: String,
}
