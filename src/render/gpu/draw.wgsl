// SPDX-License-Identifier: MIT OR Apache-2.0
// Triangles to triangle numbers: one instance a tile, the first triangle being 1.

@group(0) @binding(0) var<uniform> batch: Batch;
@group(0) @binding(1) var<storage, read> positions: array<f32>;
@group(0) @binding(2) var<storage, read> triangles: array<u32>;
@group(0) @binding(3) var<storage, read> frames: array<Frame>;
@group(0) @binding(4) var<storage, read> cameras: array<Camera>;

// Any constant below the least depth, 1.5: makes depth / w grow with nearness, inside 0 to 1.
const NEAR: f32 = 1.4;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) number: u32,
}

@vertex
fn vertex(@builtin(vertex_index) corner: u32, @builtin(instance_index) instance: u32) -> Vertex {
    let tile = batch.first_tile + instance;
    let candidate = tile / batch.views;
    let frame = frames[candidate];
    let number = corner / 3u + 1u;
    if (frame.inverse_radius < 0.0) {
        return Vertex(vec4f(0.0, 0.0, 0.0, 1.0), number);
    }
    let at = 3u * (candidate * batch.vertices + triangles[corner]);
    let position = vec3f(positions[at], positions[at + 1u], positions[at + 2u]);
    let p = (position - frame.centre) * frame.inverse_radius;
    let camera = cameras[tile % batch.views];
    let depth = DISTANCE - dot(p, camera.back);
    let screen = vec2f(dot(p, camera.right), dot(p, camera.up)) / TAN_HALF_FOV;
    // The middle of the tile in the atlas, whose rows go down.
    let cells = vec2f(f32(batch.columns), f32(batch.rows));
    let cell = vec2f(f32(instance % batch.columns), f32(instance / batch.columns));
    let middle = ((2.0 * cell + 1.0) / cells - 1.0) * vec2f(1.0, -1.0);
    return Vertex(vec4f(screen / cells + middle * depth, NEAR, depth), number);
}

@fragment
fn fragment(vertex: Vertex) -> @location(0) u32 {
    return vertex.number;
}
