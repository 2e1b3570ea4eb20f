# SPDX-License-Identifier: MIT OR Apache-2.0
"""Tops of tables, the mirror on them and the body under them: aprons, drawers, doors."""

from itertools import pairwise

import numpy as np

from .solids import block, outline, slab


def add_top(shape, rng, hx, hy, under, rise, sides):
    """Add the top from `under` to `rise`: round with that many `sides`, or in a style of its own."""
    bevel = rng.choice([0.0, rng.uniform(0.1, 0.45) * (rise - under)])
    style = rng.choice(
        ["block", "block", "corners", "planks", "oval", "boat"], p=[0.35, 0.25, 0.2, 0.1, 0.05, 0.05]
    )
    if sides:
        shape.add("top", slab(outline(sides, 2, np.pi / sides) * (hx, hy), under, rise, bevel))
    elif style == "planks":
        edges = np.linspace(-hy, hy, int(rng.integers(3, 7)))
        for a, b in pairwise(edges):
            shape.add("top", block((-hx, a + 0.012, under), (hx, b - 0.012, rise)))
    elif style == "oval":
        shape.add("top", slab(outline(28, rng.uniform(2.2, 6)) * (hx, hy), under, rise, bevel))
    elif style == "boat":
        x = np.linspace(-1, 1, 9)
        y = hy * (1 - rng.uniform(0.1, 0.35) * x**2)
        plan = np.concatenate([np.column_stack([x * hx, -y]), np.column_stack([x * hx, y])[::-1]])
        shape.add("top", slab(plan, under, rise, bevel))
    else:
        corner = rng.uniform(0.02, 0.45) if style == "corners" else 0.0
        shape.add("top", block((-hx, -hy, under), (hx, hy, rise), bevel, corner))


def add_mirror(shape, rng, hx, hy, rise):
    """Add a mirror that stands at the back of the top."""
    wide, high = hx * rng.uniform(0.4, 0.85), rng.uniform(0.35, 0.75)
    plan = outline(20, rng.choice([2.0, 3.0, 9.0])) * (wide, high)
    v, f = slab(plan, -0.04, 0.04)
    v = np.column_stack([v[:, 0], 0.85 * hy - v[:, 2], v[:, 1] + rise + high * rng.uniform(0.95, 1.1)])
    shape.add("mirror", (v, f), (0, 0.85 * hy, rise), "top")


def add_body(shape, rng, hx, hy, low, under, sides):
    """Add what fills the space from `low` to the top: an apron, a pillar on a foot, or a box."""
    at = (0, 0, under)
    tall = under - low
    if sides:
        shape.add("body", slab(outline(sides, 2, np.pi / sides) * (hx, hy), low, under, 0.01), at, "top")
        return
    if tall < 0.35 * under and rng.random() < 0.5:
        _apron(shape, hx, hy, low, under)
        return
    if tall > 1.4 and hx < 0.8 and low == 0 and rng.random() < 0.6:
        inset, foot = rng.uniform(0.03, 0.16), rng.uniform(0.04, 0.2) * tall
        shape.add("body", block((-hx, -hy, 0), (hx, hy, foot), rng.choice([0.0, 0.04])), at, "top")
        hx, hy = hx - inset, hy - inset
        shape.add("body", block((-hx, -hy, foot), (hx, hy, under)), at, "top")
        return
    shape.add("body", block((-hx, -hy, low), (hx, hy, under), rng.choice([0.0, 0.015])), at, "top")
    if rng.random() < 0.8:
        rows = max(1, min(5, round(tall / rng.uniform(0.25, 0.5)))) if rng.random() < 0.65 else 1
        add_fronts(shape, rng, "body", (-hx, hx), -hy, (low, under), rows, at)


def add_fronts(shape, rng, label, x, y, z, rows, at):
    """Add drawers or doors in front of a box from x[0] to x[1] and z[0] to z[1]."""
    columns = max(1, min(5, round((x[1] - x[0]) / rng.uniform(0.55, 1.3))))
    proud, gap = rng.uniform(0.01, 0.04), min(0.03, 0.1 * (z[1] - z[0]) / rows)
    high, knob = (z[1] - z[0]) / rows, rng.random() < 0.7
    wide = (x[1] - x[0]) / columns
    for r in range(rows):
        for c in range(columns):
            a = np.array([x[0] + c * wide + gap, y - proud, z[0] + r * high + gap])
            b = np.array([x[0] + (c + 1) * wide - gap, y + 0.02, z[0] + (r + 1) * high - gap])
            shape.add(label, block(a, b), at, "top")
            if knob:
                mid = (a + b) / 2
                half = (0.16 * wide, 0.0, 0.014) if rows > 1 else (0.014, 0.0, 0.1 * high)
                shape.add(label, block((mid - half) - (0, 0.06, 0), (mid + half) - (0, 0.01, 0)), at, "top")


def _apron(shape, x, y, low, under):
    """Four boards below the edge of the top."""
    at, t = (0, 0, under), 0.03
    for s in (-1, 1):
        shape.add("body", block((-x, s * y - t * (s > 0), low), (x, s * y + t * (s < 0), under)), at, "top")
    shape.add_pair("body", block((x - t, -y, low), (x, y, under)), at, "top")
