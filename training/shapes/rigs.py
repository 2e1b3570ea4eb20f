# SPDX-License-Identifier: MIT OR Apache-2.0
"""Masts and sails of boats."""

from itertools import pairwise

import numpy as np

from .solids import bar, loft


def add_rig(shape, rng, deck, deep, long, mast, sail, masts, sheer):
    """Add masts to the height asked (a share of the length), with sails as long as asked."""
    top = mast * long
    r = min(0.012 * top + 0.012, 0.06, 0.03 * top)
    square = masts > 1 or (sail * long < 3.2 and sheer > 0.3)
    places = (
        np.linspace(-0.3, 0.28, masts)
        if masts > 1
        else [rng.uniform(-0.15, 0.05) if sail > 0.05 else rng.uniform(-0.2, 0.3)]
    )
    for i, share in enumerate(places):
        y = share * long
        tall = top * (1 if i == masts // 2 else rng.uniform(0.75, 0.95))
        base = deck(y)[1]
        at = (0, y, base)
        shape.add("mast", bar((0, y, 0.6 * base), (0, y, deep + tall), r, 0.6 * r, 6), at, "hull")
        if sail < 0.05:
            if rng.random() < 0.6:
                boom = (0, y + 0.35 * tall, deep + 0.5 * tall)
                shape.add("mast", bar((0, y, deep + 0.2 * tall), boom, 0.6 * r, sides=6), at, "hull")
        elif square:
            _square_sails(shape, rng, y, deep, tall, sail * long, masts, r, at)
        else:
            _triangles(shape, rng, y, deep, tall, sail * long, long, r, at)


def _square_sails(shape, rng, y, deep, tall, across, masts, r, at):
    """Sails on yards; with several masts they reach along the boat together, with one across it."""
    wide = across / 2 if masts == 1 else min(rng.uniform(0.55, 0.9), 0.45 * tall)
    count = 1 if masts == 1 else int(rng.integers(2, 4))
    levels = deep + tall * np.linspace(rng.uniform(0.15, 0.3), 0.96, count + 1)
    for z0, z1 in pairwise(levels):
        x = np.linspace(-wide, wide, 5)
        belly = 0.3 * (z1 - z0) * rng.uniform(0.3, 1)
        rings = []
        for t in np.linspace(0, 1, 4):
            out = y - r - belly * np.sin(np.pi * t) * (1 - 0.5 * (x / wide) ** 2)
            line = np.column_stack([x * (1 - 0.12 * t), out, np.full(5, z0 + (z1 - z0) * (0.02 + 0.94 * t))])
            rings.append(np.concatenate([line, line[::-1] + np.array([0, 0.015, 0])]))
        shape.add("sail", loft(rings), at, "mast")
        shape.add("sail", bar((-wide, y, z1 - 0.03), (wide, y, z1 - 0.03), 0.6 * r, sides=6), at, "mast")
        wide *= rng.uniform(0.75, 0.95)


def _triangles(shape, rng, y, deep, tall, along, long, r, at):
    """A mainsail behind the mast and, mostly, a jib before it."""
    jib = min(rng.uniform(0.3, 0.5) * along, y + 0.55 * long) if rng.random() < 0.75 else 0.0
    main = max(along - jib, 0.1)
    foot, head = deep + rng.uniform(0.08, 0.2) * tall, deep + rng.uniform(0.9, 0.98) * tall
    swing = rng.choice([0.0, rng.uniform(-0.5, 0.5)])
    aside, back = main * np.sin(swing), main * np.cos(swing)
    bulge = rng.uniform(0.0, 0.12) * main * rng.choice([-1, 1])
    shape.add("sail", _sail((0, y + r, foot), (aside, y + back, foot), (0, y + r, head), bulge), at, "mast")
    shape.add("mast", bar((0, y, foot), (0.98 * aside, y + 0.98 * back, foot), 0.7 * r, sides=6), at, "hull")
    if jib:
        luff = deep + tall * rng.uniform(0.7, 0.95)
        shape.add(
            "sail",
            _sail((0, y - 0.06, foot), (0.6 * aside, y - jib, deep + 0.1), (0, y - 0.06, luff), -bulge),
            at,
            "mast",
        )


def _sail(tack, clew, head, bulge):
    """A thin triangle, bulged sideways."""
    tack, clew, head = (np.asarray(p, float) for p in (tack, clew, head))
    rings = []
    for t in np.linspace(0, 0.97, 6):
        line = [tack + (head - tack) * t + (clew - tack) * (1 - t) * u for u in np.linspace(0, 1, 4)]
        line = np.array(line)
        line[:, 0] += bulge * np.sin(np.pi * np.linspace(0, 1, 4)) * (1 - t)
        rings.append(np.concatenate([line + np.array([0.008, 0, 0]), line[::-1] - np.array([0.008, 0, 0])]))
    return loft(rings)
