# SPDX-License-Identifier: MIT OR Apache-2.0
"""Fronts of cabinets: doors, drawers, vents, framed glass, and the lid of a chest."""

from itertools import pairwise

import numpy as np

from .solids import block, loft


def _panel(shape, half, x, z, pull, gap=0.012):
    """One door or drawer proud of the front; `pull` is the side of its handle: -1, 1 or 0 for a drawer."""
    gap = min(gap, 0.08 * (x[1] - x[0]), 0.08 * (z[1] - z[0]))
    proud = 0.015 + gap
    at = (0, -half, (z[0] + z[1]) / 2)
    low, high = (x[0] + gap, -half - proud, z[0] + gap), (x[1] - gap, -half + 0.01, z[1] - gap)
    shape.add("front", block(low, high), at, "carcass")
    wide, tall, y = x[1] - x[0], z[1] - z[0], -half - proud
    middle = np.array([(x[0] + x[1]) / 2, y, at[2]])
    if pull:
        middle[0] += pull * (wide / 2 - min(0.05, 0.2 * wide))
        size = np.array([0.008, 0.02, min(0.12, 0.2 * tall)])
    else:
        size = np.array([min(0.1, 0.25 * wide), 0.02, min(0.012, 0.1 * tall)])
    shape.add("front", block(middle - size, middle + size), at, "carcass")


def add_fronts(shape, rng, box, foot, style):
    """Add the doors and drawers of one style of front."""
    half, low, high = box
    low += foot
    tall = high - low
    rim = rng.choice([0.0, 0.02]) * min(1.0, tall)
    low, high, x0 = low + rim, high - rim, 0.5 - rim
    gap = rng.uniform(0.01, 0.03)
    split = low + tall * rng.uniform(0.55, 0.8) if tall > 0.5 else low + tall * 0.5
    if style == "fridge":
        split = low + tall * rng.choice([0.32, 0.4, 0.68, 0.75])
        side = rng.choice([-1, 1])
        _panel(shape, half, (-x0, x0), (low, split), side, gap)
        _panel(shape, half, (-x0, x0), (split, high), side, gap)
        return
    if style == "vent":
        _panel(shape, half, (-x0, x0), (low, high), 1)
        for k in range(4):
            for z in (low + tall * 0.1, low + tall * 0.8):
                slit = z + 0.05 * k
                box = block((-0.2, -half - 0.05, slit), (0.2, -half, slit + 0.02))
                shape.add("front", box, (0, -half, slit), "carcass")
        return
    doors, drawers = (low, high), None
    if style == "drawers":
        doors, drawers = None, (low, high)
    elif style == "mixed":
        doors, drawers = (
            ((low, split), (split, high)) if rng.random() < 0.6 else ((split, high), (low, split))
        )
    if doors:
        count = max(1, min(6, round(1 / (min(0.55, max(doors[1] - doors[0], 0.2)) * rng.uniform(0.75, 1.4)))))
        edges = np.linspace(-x0, x0, count + 1)
        for i, x in enumerate(pairwise(edges)):
            _panel(shape, half, x, doors, 1 if i % 2 == 0 else -1, gap)
    if drawers:
        size = drawers[1] - drawers[0]
        rows = max(1, min(7, round(size / rng.uniform(0.2, 0.4)))) if size > 0.25 else int(rng.integers(1, 3))
        rows = min(rows, 5) if size < 2 else rows
        columns = max(1, min(4, round(rng.uniform(0.3, 0.9) / max(size / rows, 0.1) / 2.2)))
        z, x = np.linspace(*drawers, rows + 1), np.linspace(-x0, x0, columns + 1)
        for r in range(rows):
            for c in range(columns):
                _panel(shape, half, (x[c], x[c + 1]), (z[r], z[r + 1]), 0, gap)


def add_glass(shape, rng, box, foot):
    """Add framed doors that show the shelves."""
    half, low, high = box
    low += foot
    wide = 0.05 * min(1.0, high - low)
    count = int(rng.choice([1, 2, 2, 3]))
    edges = np.linspace(-0.5, 0.5, count + 1)
    at = (0, -half, (low + high) / 2)
    for a, b in pairwise(edges):
        for x in ((a + 0.005, a + wide), (b - wide, b - 0.005)):
            shape.add("front", block((x[0], -half - 0.02, low), (x[1], -half, high)), at, "carcass")
        for z in ((low, low + wide), (high - wide, high)):
            shape.add("front", block((a, -half - 0.02, z[0]), (b, -half, z[1])), at, "carcass")
    if rng.random() < 0.5:
        split = low + (high - low) * rng.uniform(0.2, 0.4)
        shape.add("front", block((-0.5, -half - 0.025, low), (0.5, -half, split)), at, "carcass")


def add_lid(shape, rng, box, foot, dome):
    """Add the rim of a lid, perhaps bulging by `dome`, and straps."""
    half, low, high = box
    edge = high - (high - low - foot) * rng.uniform(0.12, 0.3)
    if dome:
        a = np.linspace(0, np.pi, 9)
        y, z = half * np.cos(a), high - 0.01 + (dome + 0.01) * np.sin(a)
        arch = loft([np.column_stack([np.full(9, x), y, z]) for x in (-0.5, 0.5)])
        shape.add("top", arch, (0, 0, high), "carcass")
    rim = block((-0.515, -half - 0.015, edge), (0.515, half, edge + 0.03))
    shape.add("front", rim, (0, 0, edge), "carcass")
    if rng.random() < 0.6:
        for x in (0.2, 0.36):
            strap = block((x, -half - 0.02, low + foot), (x + 0.05, -half, high))
            shape.add_pair("front", strap, (0, -half, edge), "carcass")
