# SPDX-License-Identifier: MIT OR Apache-2.0
"""Walls of buildings with their doors and windows, and the porch before them."""

import numpy as np

from .masonry import CORNERS, boxes, merge, moved, stack
from .solids import bar, lathe


def add_walls(shape, rng, half, rise, over, is_round, tank, keep):
    """Add a box, a round shaft or a trestle; a keep is mostly bare."""
    hx, hy = half
    if tank and rng.random() < 0.5:
        shape.add("walls", _trestle(rng, half, rise))
        return
    if is_round or tank:
        top = min(1.0, 0.95 * over) if over < 0.88 else rng.choice([1.0, rng.uniform(0.8, 1.0)])
        squash = half / min(half)
        bow = rng.uniform(-0.1, 0.0) * (1 - top)
        profile = [(0.5, 0), (0.25 * (1 + top) + bow, rise / 2), (0.5 * top, rise)]
        if rng.random() < 0.3:
            profile = [(0.5, 0), (0.5, 0.06 * rise), (0.5 * max(top, 0.9), 0.07 * rise), (0.5 * top, rise)]
        shape.add("walls", lathe(profile, sides=20, squash=squash))
        if not tank:
            _round_openings(shape, rng, rise, top)
        return
    taper = rng.uniform(max(0.6, over - 0.1), 1) if over < 0.8 and rise > 1.5 and rng.random() < 0.5 else 1.0
    shape.add("walls", stack([(0, hx, hy), (rise, hx * taper, hy * taper)]))
    if keep and rng.random() < 0.7:
        _loopholes(shape, rng, half, rise)
    elif taper == 1:
        _facade(shape, rng, half, rise)


def _trestle(rng, half, rise):
    """Posts and braces, as a water tank stands on."""
    r = rng.uniform(0.03, 0.07)
    lean = rng.uniform(0.6, 1.0)
    foot, top = half - r, (half - r) * lean
    bars = [bar((*(c * foot), 0), (*(c * top), rise), r, sides=4) for c in CORNERS]
    for t in np.linspace(0, 1, int(rng.integers(2, 4)) + 1)[1:]:
        level = foot + (top - foot) * t
        for a in range(4):
            c, d = CORNERS[a] * level, CORNERS[(a + 1) % 4] * level
            bars.append(bar((*c, rise * t - r), (*d, rise * t - r), r * 0.6))
    if rng.random() < 0.6:
        bars.append(bar((0, 0, 0), (0, 0, rise), r * 1.6, sides=8))
    return merge(bars)


def _round_openings(shape, rng, rise, top):
    """A door at the front and a column of windows above it."""
    door = min(0.35, 0.6 * rise)
    holes = [boxes([(0, -0.49, door / 2)], np.array([0.09, 0.06, door / 2]))]
    count = int(min(4, rise / 0.7))
    if count and rng.random() < 0.7:
        z = np.linspace(0.25, 0.85, count) * rise
        y = -0.49 * (1 + (top - 1) * z / rise)
        holes.append(boxes(np.column_stack([0 * z, y, z]), np.array([0.05, 0.05, 0.09])))
    shape.add("walls", merge(holes))


def _loopholes(shape, rng, half, rise):
    """A door and a few narrow windows above it."""
    z = np.linspace(0.4, 0.85, int(rng.integers(1, 4))) * rise
    at = [(0, s * half[1], q) for q in z for s in (-1, 1)]
    size = (0.06, 0.03, 0.1 * min(rise, 1))
    door = min(0.35, 0.6 * rise) / 2
    shape.add("walls", merge([boxes(at, size), boxes([(0, -half[1], door)], (0.12, 0.04, door))]))


def _facade(shape, rng, half, rise):
    """Windows, bands or ribs on a box of walls, and the door."""
    hx, hy = half
    depth = rng.uniform(0.012, 0.035)
    style = rng.choice(["windows", "windows", "bands", "ribs"] if rise > 1.5 else ["windows"] * 3 + ["plain"])
    if style == "bands":
        count = int(np.clip(rise / rng.uniform(0.2, 0.5), 3, 16))
        z = (np.arange(count) + 0.7) * rise / count
        shape.add("walls", boxes(np.column_stack([0 * z, 0 * z, z]), (hx + depth, hy + depth, z[0] * 0.4)))
    elif style == "ribs":
        count = int(rng.integers(3, 7))
        x, y = np.linspace(-hx, hx, count), np.linspace(-hy, hy, count)
        at = [(a, s * hy, rise / 2) for a in x for s in (-1, 1)]
        at += [(s * hx, a, rise / 2) for a in y[1:-1] for s in (-1, 1)]
        wide = 0.5 * min(hx, hy) / count
        shape.add("walls", boxes(at, (wide, wide, rise / 2)))
    elif style == "windows":
        storey = rng.uniform(0.3, 0.45) if rise < 1.5 else rng.uniform(0.25, 0.6)
        rows = int(np.clip(round(rise / storey), 1, 9))
        gap = rng.uniform(0.25, 0.45)
        share = rng.uniform(0.2, 0.33)
        z = (np.arange(rows) + 0.55) * rise / rows
        for a in (0, 1):
            count = int(np.clip(round(2 * half[a] / gap), 1, 6))
            u = ((np.arange(count) + 0.5) / count * 2 - 1) * half[a]
            grid = np.array([(p, s * half[1 - a], q) for p in u for q in z for s in (-1, 1)])
            size = np.array([share * 2 * half[a] / count, depth, share * 1.2 * rise / rows])
            if a == 1:
                grid, size = grid[:, [1, 0, 2]], size[[1, 0, 2]]
            shape.add("walls", boxes(grid, size))
    if rise < 2:
        tall = min(rng.uniform(0.25, 0.4), 0.8 * rise)
        wide = rng.choice([0.08, 0.3 * min(hx, 1)])
        at = (rng.choice([0, 0, 0.4]) * hx, -hy, tall / 2)
        shape.add("walls", boxes([at], (wide, 1.6 * depth, tall / 2)))


def add_porch(shape, rng, half, rise):
    """Add a lean-to, a bay or a roof on posts before the front."""
    hx, hy = half
    deep, wide = rng.uniform(0.12, 0.3), hx * rng.uniform(0.25, 0.9)
    tall = min(rise * rng.uniform(0.6, 0.95), 0.5)
    x = rng.choice([0, 0, -1, 1]) * (hx - wide)
    y = -hy - deep / 2
    if rng.random() < 0.5:
        solid = stack([(0, wide, deep / 2), (0.75 * tall, wide, deep / 2), (tall, wide, 0.02, 0.48 * deep)])
    else:
        roof = stack([(0.85 * tall, wide, deep / 2), (tall, wide, 0.3 * deep, 0.2 * deep)])
        post = np.array([(s * (wide - 0.03), 0.03 - deep / 2, 0.425 * tall) for s in (-1, 1)])
        solid = merge([roof, boxes(post, (0.025, 0.025, 0.425 * tall))])
    shape.add("porch", moved(solid, x, y), (x, -hy, 0), "walls")
