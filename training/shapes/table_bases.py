# SPDX-License-Identifier: MIT OR Apache-2.0
"""What carries a table: legs, pedestals, trestles, panels, sleds, chests of drawers, benches."""

import numpy as np

from .solids import bar, block, lathe, rounded_rectangle, slab
from .table_tops import add_fronts


def add_base(shape, rng, hx, hy, top, leg, base, sides):
    """Add what carries the table up to `top`; the kind of it is `base`, its bars are `leg` thick."""
    half = leg / 2
    x, y = hx - half, hy - half
    if base == "pedestal":
        _pedestal(shape, rng, hx, hy, top, half)
    elif base == "tee":
        _tee(shape, rng, hx, hy, top, half)
    elif base == "trestle":
        out = x * 0.85
        for side in (-1, 1):
            at = (out, side * 0.12 * y, top)
            shape.add_pair("leg", bar(at, (out, side * y, 0), half), at, "top")
        if rng.random() < 0.7:
            z = top * rng.uniform(0.25, 0.5)
            rail = bar((out, -0.7 * y, z), (out, 0.7 * y, z), half * 0.6)
            shape.add_pair("rail", rail, (out, 0, top), "top")
    elif base == "panels":
        shape.add_pair("leg", block((hx - leg, -hy, 0), (hx, hy, top)), (hx, 0, top), "top")
        if rng.random() < 0.5:
            back = hy * rng.uniform(0, 0.9)
            shape.add("rail", block((-hx, back, top * 0.3), (hx, back + 0.03, top)), (0, back, top), "top")
    elif base == "cross":
        for s in (-1, 1):
            shape.add_pair("leg", bar((x, s * y, top), (x, -s * y, 0), half), (x, 0, top), "top")
    elif base == "sled":
        for s in (-1, 1):
            shape.add_pair("leg", bar((x, s * y, top), (x, s * y, 0), half), (x, 0, top), "top")
        shape.add_pair("leg", bar((x, -y, half), (x, y, half), half * 0.95), (x, 0, top), "top")
    elif base == "drawers":
        _drawers(shape, rng, hx, hy, top, half)
    else:
        _legs(shape, rng, hx, hy, top, half, base, sides)


def _pedestal(shape, rng, hx, hy, top, half):
    """One or two columns on a foot or on claws."""
    foot = max(min(hx, hy) * rng.uniform(0.5, 0.9), 1.3 * half)
    count = 1 if hx < 1.3 * hy else 2 if hx > 2.2 * hy else int(rng.integers(1, 3))
    claws = rng.random() < 0.4
    for i in range(count):
        x = 0 if count == 1 else (2 * i - 1) * 0.55 * hx
        at = (x, 0, top)
        if claws:
            for a in np.linspace(0, 2 * np.pi, 5)[:4] + np.pi / 4:
                tip = (x + foot * np.cos(a), foot * np.sin(a), half * 0.5)
                shape.add("leg", bar((x, 0, 0.2 * top + half), tip, half * 0.9, half * 0.6), at, "top")
            profile = [
                (half * 1.4, 0.08 * top),
                (half, 0.35 * top),
                (half, 0.5 * top),
                (half, 0.85 * top),
                (half * 1.6, top),
            ]
        elif rng.random() < 0.25:
            profile = [
                (foot, 0),
                (foot * 0.7, 0.12 * top),
                (half, 0.5 * top),
                (foot * 0.5, 0.9 * top),
                (foot * 0.8, top),
            ]
        else:
            profile = [
                (foot, 0),
                (foot, 0.03 * top + 0.01),
                (half * 1.3, 0.1 * top + 0.02),
                (half, 0.3 * top),
                (half, 0.5 * top),
                (half, 0.88 * top),
                (half * 2, top),
            ]
        shape.add("leg", lathe(profile, (x, 0), sides=14, roundness=rng.choice([2, 2, 8])), at, "top")


def _tee(shape, rng, hx, hy, top, half):
    """A post on a foot at both ends, perhaps with a rail between."""
    x, foot, thin = hx * rng.uniform(0.75, 0.95) - half, hy * rng.uniform(0.75, 1.0), min(half, 0.12 * top)
    at, capped = (x, 0, top), rng.random() < 0.5
    shape.add_pair("leg", bar(at, (x, 0, thin), half), at, "top")
    shape.add_pair("leg", bar((x, -foot, thin), (x, foot, thin), (half, thin)), at, "top")
    if capped:
        z = top - thin * 0.6
        shape.add_pair("leg", bar((x, -foot * 0.8, z), (x, foot * 0.8, z), (half, thin * 0.6)), at, "top")
    if rng.random() < 0.4:
        z = top * rng.uniform(0.15, 0.7)
        shape.add("rail", bar((-x, 0, z), (x, 0, z), half * 0.6), (0, 0, top), "top")


def _drawers(shape, rng, hx, hy, top, half):
    """Drawers down to the floor at one end or both, and legs where there are none."""
    wide, both = hx * rng.uniform(0.42, 0.64), rng.random() < 0.5
    inner, lift = hx - wide, rng.choice([0.0, 0.06]) * top
    side = rng.choice([-1, 1])
    for s in (-1, 1) if both else (side,):
        x = (inner, hx) if s > 0 else (-hx, -inner)
        at = (s * (inner + hx) / 2, 0, top)
        shape.add("drawers", block((x[0], -hy, lift), (x[1], hy, top)), at, "top")
        add_fronts(shape, rng, "drawers", x, -hy, (lift, top), int(rng.integers(2, 5)), at)
    if not both:
        for y in (-1, 1):
            at = (-side * (hx - half), y * (hy - half), top)
            shape.add("leg", bar(at, (*at[:2], 0), half), at, "top")
    if rng.random() < 0.5:
        shape.add("rail", block((-hx, 0.7 * hy, 0.4 * top), (hx, 0.7 * hy + 0.03, top)), (0, 0, top), "top")


def _legs(shape, rng, hx, hy, top, half, base, round_sides):
    """Straight, bowed or hairpin legs, perhaps with a shelf or rails between them."""
    sides, taper = int(rng.choice([4, 4, 10])), rng.choice([1.0, rng.uniform(0.4, 1.0)])
    splay, bow = rng.choice([0, 0, rng.uniform(0, 0.15)]) * min(1, top), np.zeros(3)
    if base == "hairpin":
        taper, sides, splay = 1.0, 6, 0.05
    if base == "curved":
        out = rng.uniform(0.08, 0.2) * min(top, 0.8)
        bow, splay, sides = np.array([out, out, 0]), rng.uniform(-0.5, 0.6) * out, 8
    k = 0.68 if round_sides else 1.0
    x, y = max(hx * k - half, half), max(hy * k - half, half)
    wide = half * 2 / (1 + taper)
    for s in (-1, 1):
        at, foot = (x, s * y, top), (x + splay, s * (y + splay), 0)
        shape.add_pair("leg", bar(at, foot, wide, wide * taper, sides, bow * (1, s, 1)), at, "top")
        if base == "hairpin":
            shape.add_pair("leg", bar((x, s * (y - 0.12), top), foot, half, None, 6), at, "top")
    if hx > 1.6 and base == "legs" and rng.random() < 0.3:
        for s in (-1, 1):
            at = (0, s * y, top)
            shape.add("leg", bar(at, (0, s * y, 0), wide, wide * taper, sides), at, "top")
    choice = rng.random()
    if choice < 0.2 and top > 0.25:
        z = top * rng.uniform(0.12, 0.5)
        shape.add("shelf", slab(rounded_rectangle(x, y, 0.02), z, z + 0.04), (0, 0, top), "top")
    elif choice < 0.35 and top > 0.25:
        z, r = top * rng.uniform(0.1, 0.4), min(half * 0.6, 0.06)
        shape.add_pair("rail", bar((x, -y, z), (x, y, z), r), (x, 0, top), "top")
        shape.add("rail", bar((-x, 0, z), (x, 0, z), r), (0, 0, top), "top")


def add_benches(shape, rng, hx, rise, under, leg):
    """Add splayed legs at both ends that carry a bench on either side of the top."""
    half, x = leg / 2, hx * rng.uniform(0.6, 0.85)
    seat, out = rise * rng.uniform(0.54, 0.64), rng.uniform(0.85, 1.1)
    thin = min(half, 0.06)
    for s in (-1, 1):
        at = (x, s * 0.35, under + 0.02)
        shape.add_pair("leg", bar(at, (x, s * rng.uniform(0.8, 0.95) * out, 0), half), at, "top")
        plank = block((-hx, s * out - 0.16, seat - 0.06), (hx, s * out + 0.16, seat))
        shape.add("bench", plank, (0, s * out, seat - 0.06), "leg")
    shape.add_pair(
        "leg", bar((x, -out, seat - 0.06 - thin), (x, out, seat - 0.06 - thin), thin), (x, 0, under), "top"
    )
