// SPDX-License-Identifier: MIT OR Apache-2.0
//! Why a `BoxDefGraph` cannot be made or used.

use thiserror::Error;

/// Why a `BoxDefGraph` cannot be made or used; each sentence says what to do.
#[derive(Debug, Error, Clone, PartialEq, Eq)]
pub enum BoxDefError {
    /// The number of splits is out of range.
    #[error("the number of splits is {0}; it must be from 1 to 8")]
    Splits(u32),
    /// There is no boundary step of that name.
    #[error("unknown boundary \"{0}\": choose \"smooth\" or \"paper\"")]
    Boundary(String),
    /// There is no symmetry of that name.
    #[error("unknown symmetry \"{0}\": choose \"auto\", \"none\", \"x\", \"y\", \"z\" or \"xy\"")]
    Symmetry(String),
    /// There is no box.
    #[error("there are no boxes; give at least one")]
    NoBoxes,
    /// Arrays that belong together differ in length.
    #[error("{name} has {found} rows, but {expected} are needed: {why}")]
    Length {
        /// Name of the array.
        name: &'static str,
        /// Rows that it has.
        found: usize,
        /// Rows that it should have.
        expected: usize,
        /// What the number follows from.
        why: &'static str,
    },
    /// A number is NaN or infinite.
    #[error("{name} has a number that is not finite in row {row}; give finite numbers")]
    NotFinite {
        /// Name of the array.
        name: &'static str,
        /// First such row.
        row: usize,
    },
    /// A half size is below zero.
    #[error("box_half_size is below zero in row {row}; give half the box's extent an axis")]
    NegativeSize {
        /// First such row.
        row: usize,
    },
    /// A side is not 0, 1 or 2.
    #[error("box_side is {side} in row {row}; it must be 0 (mid), 1 (pos) or 2 (neg)")]
    Side {
        /// First such row.
        row: usize,
        /// What it says.
        side: i8,
    },
    /// There are not as many pos as neg boxes.
    #[error(
        "box_side names {pos} pos and {neg} neg boxes; each pos box needs its neg twin, in the same order"
    )]
    Twins {
        /// Number of pos boxes.
        pos: usize,
        /// Number of neg boxes.
        neg: usize,
    },
    /// A parameter row is not the one that a box can have.
    #[error("box_row is {found} in row {row}, where {expected} belongs")]
    BoxRow {
        /// First such row.
        row: usize,
        /// What it says.
        found: i32,
        /// What it should say.
        expected: String,
    },
    /// A box index is out of range.
    #[error("{name} names box {index} in row {row}, but there are {boxes} boxes; number them from 0")]
    BoxIndex {
        /// Name of the array.
        name: &'static str,
        /// First such row.
        row: usize,
        /// The index.
        index: i32,
        /// Number of boxes.
        boxes: usize,
    },
    /// The tree edges do not form a tree in order of execution.
    #[error("tree_edges row {row} ({parent} to {child}) is out of place: {why}")]
    TreeOrder {
        /// First such row.
        row: usize,
        /// Parent box.
        parent: i32,
        /// Child box.
        child: i32,
        /// What is wrong and what to do.
        why: &'static str,
    },
    /// An edge joins a box to itself.
    #[error("edges row {row} joins box {index} to itself; name two different boxes")]
    LoopEdge {
        /// First such row.
        row: usize,
        /// The box.
        index: i32,
    },
}
