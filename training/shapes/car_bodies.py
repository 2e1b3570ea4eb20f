# SPDX-License-Identifier: MIT OR Apache-2.0
"""Bodies of cars with bonnet, boot and wheel arches, and what lorries carry behind the cabin."""

import numpy as np

from .solids import block, loft, outline


def add_body(shape, rng, half, low, belt, ends, axles, wheel, track, bed, boxy, bare):
    """Add a loft along y: bonnet, boot and wheel arches are where its top and bottom run."""
    start, front, back, end = ends
    length, tall = end - start, belt - low
    r = wheel / 2
    nose = rng.uniform(0.55, 0.95) if front - start > 0.08 * length else 1.0
    tail = rng.uniform(0.8, 1.0) if end - back > 0.04 * length else 1.0
    round_off = min(0.12, 0.1 * length) * (1 - 0.85 * boxy)
    y = [start, start + round_off, start + 2 * round_off, front, back, end - 2 * round_off]
    y += [end - round_off, end, front + 0.01, back + 0.01, *np.linspace(start, end, 6)]
    arch = r * rng.uniform(1.08, 1.2)
    arched = track < 1.05 or rng.random() < 0.4
    for a in axles if arched else ():
        y += [*(a + arch * np.cos(np.linspace(0, np.pi, 7))), a - arch * 1.01, a + arch * 1.01]
    y = np.unique(np.clip(y, start, end))
    top = np.interp(y, [start, front, back, end], [low + tall * nose, belt, belt, low + tall * tail])
    if bed:
        top[y > back + 0.02 * length] = low + tall * 0.55
    bottom = np.full(len(y), low)
    if arched:
        for a in axles:
            inside = np.abs(y - a) <= arch * 1.001
            rise = r + np.sqrt(np.maximum(arch**2 - (y - a) ** 2, 0))
            bottom[inside] = np.maximum(bottom, np.minimum(rise, top - 0.1 * tall))[inside]
    gap = np.minimum(y - start, end - y)
    soft = np.clip(1 - gap / (2 * round_off + 1e-6), 0, 1) ** 2
    wide = half * (1 - soft * rng.uniform(0.1, 0.3))
    if bare:
        point = np.clip((y - start) / (0.55 * length), 0, 1)
        wide = half * np.minimum(0.3 + 0.9 * point**1.5, 1.0) * np.interp(y, [0, end], [1, 0.55])
        wide *= half / wide.max()
        top = np.interp(
            y, [start, start + 0.08 * length, front, end], [low + 0.45 * tall, low + 0.5 * tall, belt, belt]
        )
    bottom, top = bottom + soft * 0.25 * tall, top - soft * 0.2 * tall
    top = np.maximum(top, bottom + 0.02)
    ring = outline(16, rng.uniform(3.5, 5) + 8 * boxy, np.pi / 16)
    lean = 1 - rng.uniform(0, 0.1) * np.clip(ring[:, 1], 0, 1)
    middle, reach = (top + bottom) / 2, (top - bottom) / 2
    rings = np.stack(
        [
            ring[:, 0] * lean * wide[:, None],
            np.repeat(y[:, None], 16, 1),
            middle[:, None] + ring[:, 1] * reach[:, None],
        ],
        2,
    )
    shape.add("body", loft(rings))


def add_cargo(shape, rng, half, low, belt, cargo, back, end):
    """Add the walls of a bed, or a box, a tank or a tipper behind the cabin."""
    floor = low + 0.55 * (belt - low)
    y0, y1 = back + 0.02 * (end - back), end * rng.choice([1.0, 0.995])
    top, wide = belt + cargo, half * rng.uniform(0.95, 1.0)
    at = (0, (y0 + y1) / 2, floor)
    deep = top - floor
    style = "walls" if cargo < 0.35 else rng.choice(["box", "box", "box", "tank", "tipper"])
    if cargo < 0.1 and belt - low < 0.25:
        style = "flat"
    if style == "flat":
        shape.add("cargo", block((-wide, y0, floor), (wide, y1, top), 0.01), at, "body")
    elif style == "box":
        shape.add("cargo", block((-wide, y0, floor), (wide, y1, top), rng.uniform(0.005, 0.06)), at, "body")
    elif style == "tank":
        ring = outline(16, rng.uniform(2, 3), np.pi / 16) * (wide, deep * 0.46)
        stations = [(y0, 0.7), (y0 + 0.08, 1.0), (y1 - 0.08, 1.0), (y1, 0.7)]
        rings = [
            np.column_stack([ring[:, 0] * s, np.full(16, y), ring[:, 1] * s + top - 0.46 * deep])
            for y, s in stations
        ]
        shape.add("cargo", loft(rings), at, "body")
        shape.add("cargo", block((-0.5 * wide, y0, floor), (0.5 * wide, y1, floor + 0.3 * deep)), at, "body")
    else:
        t = 0.03 + 0.02 * rng.random()
        splay = rng.choice([0.0, 0.15]) * deep if style == "tipper" else 0.0
        for s in (-1, 1):
            shape.add(
                "cargo",
                block((s * wide - t * (s > 0), y0, floor), (s * wide + t * (s < 0), y1, top)),
                at,
                "body",
            )
            v, f = block((-wide, (y0 if s < 0 else y1 - t), floor), (wide, (y0 + t if s < 0 else y1), top))
            v[:, 1] -= s * splay * (top - v[:, 2]) / deep * (s > 0)
            shape.add("cargo", (v, f), at, "body")
        shape.add("cargo", block((-wide, y0, floor - 0.02), (wide, y1 - splay, floor + 0.03)), at, "body")
