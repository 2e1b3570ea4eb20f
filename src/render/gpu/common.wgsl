// SPDX-License-Identifier: MIT OR Apache-2.0
// What all shaders share; put before each of them.

const DISTANCE: f32 = 2.5;
const TAN_HALF_FOV: f32 = 0.57735026;

// Tiles first_tile .. first_tile + tiles of a submission, drawn into one atlas of columns × rows tiles.
// A tile is a candidate in a view: tile = candidate × views + view.
struct Batch {
    vertices: u32,
    parameter_rows: u32,
    used: u32,
    size: u32,
    views: u32,
    columns: u32,
    rows: u32,
    first_tile: u32,
}

// Axes in object coordinates.
struct Camera {
    right: vec3f,
    up: vec3f,
    back: vec3f,
}

// inverse_radius is negative where a position is not finite.
struct Frame {
    centre: vec3f,
    inverse_radius: f32,
}
