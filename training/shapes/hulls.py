# SPDX-License-Identifier: MIT OR Apache-2.0
"""Hulls of boats: open or decked, round as a submarine's, or a raft."""

import numpy as np

from .solids import bar, block, loft, outline, rounded_rectangle, slab, tube


def add_hull(shape, rng, long, deep, sheer, body, bluff):
    """Add the hull, full at both ends when `bluff`.

    Returns the deck as a function of y: (half its width, its height).
    """
    if body == "round":
        return _round_hull(shape, rng, long, deep)
    if body == "raft":
        return _raft(shape, rng, long, deep)
    s = np.array([0, 0.02, 0.07, 0.15, 0.25, 0.36, 0.5, 0.64, 0.76, 0.86, 0.94, 0.98, 1.0])
    y = (s - 0.5) * long
    both = sheer > 0.3 or (long > 4.6 and deep < 0.55 and rng.random() < 0.7)
    stern = 0.0 if both else rng.uniform(0.5, 0.95)
    bow = rng.uniform(0.25, 0.5) if long < 5 else rng.uniform(0.1, 0.4)
    if bluff:
        stern, bow = rng.uniform(0.75, 0.95), rng.uniform(0.05, 0.22)
    fine = rng.uniform(1.6, 2.6)
    front = (
        np.sqrt(np.maximum(1 - np.clip(1 - s / bow, 0, 1) ** fine, 0))
        if long > 3
        else 1 - np.clip(1 - s / bow, 0, 1) ** fine
    )
    aft = rng.uniform(0.25, 0.5)
    back = 1 - (1 - stern) * np.clip((s - 1 + aft) / aft, 0, 1) ** (fine if stern else 2)
    half = np.maximum(0.5 * np.minimum(front, back), 0.012)
    if rng.random() < 0.12 and long < 4 and sheer < 0.1:
        half = np.maximum(half, 0.3)
    rise = np.clip((np.abs(2 * s - 1) - 0.45) / 0.55, 0, 1) ** rng.uniform(1.5, 2.6)
    rise[s > 0.5] *= rng.uniform(0.7, 1.0) if both else rng.uniform(0.0, 0.5)
    rim = deep + sheer * rise
    stem = np.clip(1 - s / rng.uniform(0.12, 0.35), 0, 1) ** rng.uniform(1.3, 2.5) * rng.uniform(0.4, 0.95)
    counter = np.clip((s - 0.8) / 0.2, 0, 1) ** 2 * (0.8 if both else rng.uniform(0, 0.5))
    keel = (deep + 0.6 * sheer * rise) * np.maximum(stem, counter)
    around = np.linspace(-1, 1, 9)
    flat = rng.uniform(1.4, 4.5)
    across = np.sign(around) * (1 - (1 - np.abs(around)) ** rng.uniform(1.3, 2.2))
    down = np.abs(across) ** flat
    rings = []
    for i in range(len(s)):
        x, z = across * half[i], keel[i] + (rim[i] - keel[i]) * down
        outer = np.column_stack([x, np.full(9, y[i]), z])
        if body == "open":
            floor = min(0.12 + 0.1 * deep, 0.4 * (rim[i] - keel[i]))
            if i in (0, 1, len(s) - 1):
                floor = rim[i] - keel[i]
            inner = outer[::-1] * (0.9, 1, 1)
            inner[:, 2] = np.maximum(inner[:, 2], keel[i] + floor)
        else:
            camber = 1 - np.linspace(1, -1, 9) ** 2
            inner = np.column_stack(
                [np.linspace(1, -1, 9) * half[i] * 0.97, np.full(9, y[i]), rim[i] + 0.015 * camber * half[i]]
            )
        rings.append(np.concatenate([outer, inner]))
    shape.add("hull", loft(rings))
    return lambda at: (np.interp(at, y, half), np.interp(at, y, rim))


def _round_hull(shape, rng, long, deep):
    """A hull round about its axis, with a cross of planes at its end."""
    s = np.array([0, 0.01, 0.04, 0.1, 0.2, 0.4, 0.6, 0.75, 0.88, 0.96, 1.0])
    nose, tail = rng.uniform(0.08, 0.2), rng.uniform(0.25, 0.45)
    wide = np.minimum(
        np.sqrt(1 - np.clip(1 - s / nose, 0, 1) ** 2), 1 - np.clip((s - 1 + tail) / tail, 0, 1) ** 2
    )
    wide = np.maximum(wide, 0.03)
    ring = outline(16, rng.uniform(2, 2.6)) * (0.5, deep / 2)
    y = (s - 0.5) * long
    rings = [
        np.column_stack([ring[:, 0] * w, np.full(16, at), ring[:, 1] * w + deep / 2])
        for w, at in zip(wide, y, strict=True)
    ]
    shape.add("hull", loft(rings))
    root = (0, 0.44 * long, deep / 2)
    span = rng.uniform(0.35, 0.55)
    fin = block((-span, 0.42 * long, deep / 2 - 0.03), (span, 0.48 * long, deep / 2 + 0.03), 0.02)
    shape.add("fitting", fin, root, "hull")
    shape.add(
        "fitting",
        block((-0.03, 0.42 * long, deep * 0.05), (0.03, 0.48 * long, deep * 0.98), 0.01),
        root,
        "hull",
    )
    return lambda at: (np.interp(at, y, 0.4 * wide), deep * (0.5 + 0.5 * np.interp(at, y, wide)))


def _raft(shape, rng, long, deep):
    """Logs, planks on floats, or a rubber ring with a floor."""
    style = rng.choice(["logs", "logs", "planks", "rubber"])
    if style == "logs":
        count = int(rng.integers(5, 10))
        r = 0.5 / count
        for i in range(count):
            x, jut = (2 * i + 1) * r - 0.5, rng.uniform(0.94, 1.0) if i else 1.0
            ends = long / 2 * jut
            log = bar((x, -ends, deep / 2), (x, ends, deep / 2), (r, deep / 2), sides=8)
            v, f = log
            v[:, 2] = deep / 2 + (v[:, 2] - deep / 2) * deep / np.ptp(v[:, 2])
            v[:, 0] = x + (v[:, 0] - x) * 2 * r / np.ptp(v[:, 0])
            shape.add("hull", (v, f))
        for y in (-0.35 * long, 0.35 * long):
            cross = bar((-0.5, y, deep), (0.5, y, deep), min(0.4 * r, 0.1), sides=6)
            shape.add("fitting", cross, (0, y, deep), "hull")
    elif style == "planks":
        shape.add("hull", block((-0.5, -long / 2, 0.6 * deep), (0.5, long / 2, deep), 0.01))
        for x in (-0.32, 0.32):
            shape.add(
                "hull",
                bar(
                    (x, -0.48 * long, 0.35 * deep),
                    (x, 0.48 * long, 0.35 * deep),
                    (0.13, 0.25 * deep),
                    sides=8,
                ),
            )
        shape.add("hull", block((-0.4, -0.45 * long, 0), (0.4, 0.45 * long, 0.1 * deep)))
    else:
        r = deep / 2
        corner = rounded_rectangle(0.5 - r, long / 2 - r, 0.35, 5)
        path = np.column_stack([corner, np.full(len(corner), r)])
        ring = tube(np.concatenate([path, path[:2]]), r, 8, caps=False)
        ring[0][:, :2] *= (1, long) / np.ptp(ring[0][:, :2], 0)
        ring[0][:, 2] *= deep / np.ptp(ring[0][:, 2])
        ring[0][:, 2] -= ring[0][:, 2].min()
        shape.add("hull", ring)
        shape.add("hull", slab(corner, 0.1 * deep, 0.3 * deep))
    return lambda at: (np.full(np.shape(at), 0.46), np.full(np.shape(at), deep))
