// SPDX-License-Identifier: MIT OR Apache-2.0
// Triangle numbers to pixels: shade the 2 × 2 samples of a pixel and average them, see shading.rs.

@group(0) @binding(0) var<uniform> batch: Batch;
@group(0) @binding(1) var<storage, read> positions: array<f32>;
@group(0) @binding(2) var<storage, read> triangles: array<u32>;
@group(0) @binding(3) var<storage, read> frames: array<Frame>;
@group(0) @binding(4) var<storage, read> cameras: array<Camera>;
@group(0) @binding(5) var atlas: texture_2d<u32>;
@group(0) @binding(6) var<storage, read_write> pixels: array<u32>;

const ALBEDO: f32 = 0.6;
const BAND_0: f32 = 0.28209;
const BAND_1: f32 = 0.48860;

fn corner(candidate: u32, index: u32) -> vec3f {
    let at = 3u * (candidate * batch.vertices + triangles[index]);
    return vec3f(positions[at], positions[at + 1u], positions[at + 2u]);
}

fn grey(triangle: u32, candidate: u32, camera: Camera) -> f32 {
    let frame = frames[candidate];
    let a = corner(candidate, 3u * triangle);
    let to_b = (corner(candidate, 3u * triangle + 1u) - a) * frame.inverse_radius;
    let to_c = (corner(candidate, 3u * triangle + 2u) - a) * frame.inverse_radius;
    let normal = cross(to_b, to_c);
    let size = length(normal);
    if (size == 0.0) {
        return ALBEDO * BAND_0;
    }
    let towards = DISTANCE * camera.back - (a - frame.centre) * frame.inverse_radius;
    let facing = select(size, -size, dot(normal, towards) < 0.0);
    let light = camera.right + camera.up + camera.back;
    return ALBEDO * clamp(BAND_0 + BAND_1 * (dot(normal, light) / facing), 0.0, 1.0);
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (id.x >= batch.size || id.y >= batch.size) {
        return;
    }
    let tile = batch.first_tile + id.z;
    let candidate = tile / batch.views;
    let camera = cameras[tile % batch.views];
    let cell = vec2u(id.z % batch.columns, id.z / batch.columns);
    let sample = 2u * (cell * batch.size + id.xy);
    var sum = 0.0;
    var covered = 0u;
    for (var i = 0u; i < 4u; i++) {
        let number = textureLoad(atlas, sample + vec2u(i % 2u, i / 2u), 0).r;
        if (number > 0u) {
            sum += grey(number - 1u, candidate, camera);
            covered++;
        }
    }
    var pixel = 0u;
    if (covered > 0u) {
        let value = u32(sum / f32(covered) * 255.0 + 0.5);
        let alpha = u32(f32(covered) / 4.0 * 255.0 + 0.5);
        pixel = value * 0x010101u | alpha << 24u;
    }
    pixels[(tile * batch.size + id.y) * batch.size + id.x] = pixel;
}
