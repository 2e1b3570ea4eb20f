// SPDX-License-Identifier: MIT OR Apache-2.0
// Positions of a candidate: rest + sum over rows of (scale - 1) × basis, each axis by itself.

@group(0) @binding(0) var<uniform> batch: Batch;
@group(0) @binding(1) var<storage, read> rest: array<f32>;
@group(0) @binding(2) var<storage, read> basis: array<f32>;
@group(0) @binding(3) var<storage, read> scales: array<f32>;
@group(0) @binding(4) var<storage, read_write> positions: array<f32>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let vertex = id.x;
    let candidate = id.y;
    if (vertex >= batch.vertices) {
        return;
    }
    for (var axis = 0u; axis < 3u; axis++) {
        var position = rest[3u * vertex + axis];
        for (var row = 0u; row < batch.parameter_rows; row++) {
            let change = scales[3u * (candidate * batch.parameter_rows + row) + axis] - 1.0;
            position += change * basis[(axis * batch.parameter_rows + row) * batch.vertices + vertex];
        }
        positions[3u * (candidate * batch.vertices + vertex) + axis] = position;
    }
}
