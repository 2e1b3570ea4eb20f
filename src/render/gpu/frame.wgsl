// SPDX-License-Identifier: MIT OR Apache-2.0
// The sphere that becomes the unit sphere: one workgroup a candidate, see frame.rs.

@group(0) @binding(0) var<uniform> batch: Batch;
@group(0) @binding(1) var<storage, read> positions: array<f32>;
@group(0) @binding(2) var<storage, read> used: array<u32>;
@group(0) @binding(3) var<storage, read_write> frames: array<Frame>;

const THREADS: u32 = 256u;
const SMALLEST_NORMAL: f32 = 1.1754944e-38;

var<workgroup> lows: array<vec3f, THREADS>;
var<workgroup> highs: array<vec3f, THREADS>;
var<workgroup> broken: array<u32, THREADS>;
var<workgroup> farthest: array<f32, THREADS>;

fn position(candidate: u32, index: u32) -> vec3f {
    let at = 3u * (candidate * batch.vertices + used[index]);
    return vec3f(positions[at], positions[at + 1u], positions[at + 2u]);
}

// By its bits, since a compiler may take it that there is neither NaN nor infinity.
fn is_broken(p: vec3f) -> bool {
    let exponents = bitcast<vec3u>(p) & vec3u(0x7f800000u);
    return any(exponents == vec3u(0x7f800000u));
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_id) local: vec3u) {
    let candidate = group.x;
    let thread = local.x;
    var low = position(candidate, 0u);
    var high = low;
    var any_broken = false;
    for (var i = thread; i < batch.used; i += THREADS) {
        let p = position(candidate, i);
        low = min(low, p);
        high = max(high, p);
        any_broken = any_broken || is_broken(p);
    }
    lows[thread] = low;
    highs[thread] = high;
    broken[thread] = select(0u, 1u, any_broken);
    workgroupBarrier();
    for (var step = THREADS / 2u; step > 0u; step /= 2u) {
        if (thread < step) {
            lows[thread] = min(lows[thread], lows[thread + step]);
            highs[thread] = max(highs[thread], highs[thread + step]);
            broken[thread] |= broken[thread + step];
        }
        workgroupBarrier();
    }

    let centre = 0.5 * lows[0] + 0.5 * highs[0];
    let half = 0.5 * highs[0] - 0.5 * lows[0];
    let extent = max(half.x, max(half.y, half.z));
    var far = 0.0;
    for (var i = thread; i < batch.used; i += THREADS) {
        let p = (position(candidate, i) - centre) / extent;
        far = max(far, dot(p, p));
    }
    farthest[thread] = far;
    workgroupBarrier();
    for (var step = THREADS / 2u; step > 0u; step /= 2u) {
        if (thread < step) {
            farthest[thread] = max(farthest[thread], farthest[thread + step]);
        }
        workgroupBarrier();
    }
    if (thread == 0u) {
        var inverse_radius = 1.0 / extent / sqrt(farthest[0]);
        if (extent < SMALLEST_NORMAL) {
            inverse_radius = 0.0;
        }
        if (broken[0] != 0u) {
            inverse_radius = -1.0;
        }
        frames[candidate] = Frame(centre, inverse_radius);
    }
}
