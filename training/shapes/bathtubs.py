# SPDX-License-Identifier: MIT OR Apache-2.0
"""Tubs and basins: open vessels with a wall, low or on feet. A tap sits at +y; the unit is the shorter side.

`elong` is the vessel's plan, long side over short; `depth` its height; `lift` the share of the whole height
that feet, plinth or pedestal take; `base` their plan over the vessel's; `wall` its thickness at the rim.
"""

import numpy as np

from .axis import amount, outside, ratio
from .shape import Shape
from .solids import bar, lathe, loft, outline, rounded_rectangle, tube

RANGES = {
    "elong": ratio(1.0, 6.5),
    "depth": ratio(0.04, 2.0),
    "lift": amount(0.0, 0.93),
    "base": ratio(0.15, 1.15),
    "wall": ratio(0.012, 0.22),
}
SIDES = 24
INNER = 5  # the ring of the vessel's loft where the inner wall starts, always
NO_BASE = 0.75  # what a vessel on the floor measures: neither a pedestal nor a broad plinth
LEAST_LIFT = 0.03


def build(p, traits, rng):
    """A vessel with the parameters of `RANGES` and the traits round and tap (drawn when missing)."""
    elong, depth, wall = p["elong"], p["depth"], min(p["wall"], 0.3)
    lift = min(p["lift"], 0.95)
    low = depth * lift / (1 - lift) if lift >= LEAST_LIFT else 0.0
    is_round = bool(traits.get("round", rng.random() < (0.6 if elong < 1.15 else 0.35)))
    tap = bool(traits.get("tap", 0.24 < depth < 0.95 and elong < 3.2 and rng.random() < 0.3))
    axis = 0 if tap or rng.random() < 0.5 else 1
    half = np.array([0.5, 0.5])
    half[axis] *= elong
    shape = Shape("bathtubs", traits={"round": is_round, "tap": tap})
    plan = _plan(rng, half, is_round)
    floor = _vessel(shape, rng, plan, half, low, depth, wall, axis, p["base"])
    if rng.random() < 0.45:
        _rim(shape, rng, plan, half, low + depth, wall)
    if low:
        _base(shape, rng, plan, half, low, p["base"], floor, is_round)
    if tap:
        _tap(shape, rng, half, low + depth, wall, depth)
    return shape


def _plan(rng, half, is_round):
    """The outline over its half size: an oval, blunter the longer it is, or a rounded rectangle."""
    if is_round:
        plan = outline(SIDES, 2.0 if max(half) < 0.62 else rng.uniform(2.0, 3.0), np.pi / SIDES)
    elif rng.random() < 0.4:
        plan = outline(SIDES, rng.uniform(3.0, 6.0), np.pi / SIDES)
    else:
        plan = rounded_rectangle(*half, rng.uniform(0.03, 0.3), SIDES // 4) / half
    return plan / np.abs(plan).max(0)


def _vessel(shape, rng, plan, half, low, depth, wall, axis, base):
    """The shell, outside from its bottom up, over the rim and down the inside; returns the bottom's share."""
    bottom = rng.uniform(0.7, 1.0) if rng.random() < 0.75 else rng.uniform(0.5, 0.75)
    if depth < 0.35:
        bottom = max(bottom, 0.55 if low else 0.85)
    if low and base > 0.6:
        bottom = max(bottom, min(0.9 * base, 1.0))
    belly = rng.choice([0.5, rng.uniform(0.2, 0.9)])  # 0.5 is a straight flare, more is a bowl
    mid = bottom + (1 - bottom) * belly
    foot = rng.uniform(0.03, 0.12)
    thick = 1 - wall / half
    deep = rng.uniform(0.75, 0.95) if depth > 2 * wall else rng.uniform(0.5, 0.8)
    top = rng.choice([1.0, 0.96])
    levels = [
        (0.93 * bottom, 0.0),
        (bottom + (mid - bottom) * 2 * foot, foot),
        (mid, 0.5),
        (1.0, 0.93),
        (top, 1.0),
    ]
    rings = [plan * half * k for k, _ in levels]
    inner = (1.0, mid + (1 - mid) * 0.4, bottom * 0.85)
    rings += [plan * half * thick * k for k in inner]
    heights = np.array([z for _, z in levels] + [1.0, 1 - 0.5 * deep, 1 - deep])
    rings = [np.column_stack([ring, np.full(SIDES, z)]) for ring, z in zip(rings, heights, strict=True)]
    vertices, faces = loft(rings)
    if half[axis] > 0.8 and rng.random() < 0.25:
        vertices = _slipper(vertices, half[axis], axis, rng.uniform(0.1, 0.5), rng.random() < 0.4)
    shape.add("tub", (vertices * (1, 1, depth) + (0, 0, low), faces))
    return bottom


def _slipper(vertices, reach, axis, rise, both):
    """One end (or both) of the rim swung up, the height kept at 1."""
    u = vertices[:, axis] / reach
    share = u**2 if both else ((u + 1) / 2) ** 2
    lifted = vertices.copy()
    lifted[:, 2] *= (1 + rise * share) / (1 + rise)
    lifted[:, 2] /= lifted[:, 2].max()
    return lifted


def _rim(shape, rng, plan, half, top, wall):
    """A roll or a flat deck around the edge."""
    out, tall = rng.uniform(0.0, 0.06), rng.uniform(0.02, 0.07) * min(1, 4 * half.min())
    tall = min(tall, 0.3 * top)
    outer, inner = half + out, half - wall * rng.uniform(0.6, 1.0)
    soft = rng.uniform(0, 0.5) * out
    rings = [(inner, -1), (outer - soft, -1), (outer, -0.4), (outer, 0.4), (outer - soft, 0.6), (inner, 0.6)]
    rings.append((inner, -1))
    solid = loft([np.column_stack([plan * h, np.full(SIDES, top + tall * z)]) for h, z in rings], caps=False)
    shape.add("rim", solid, (0, 0, top), "tub")


def _base(shape, rng, plan, half, low, base, bottom, is_round):
    """A pedestal, a plinth, or legs and claws whose plan measures `base` of the vessel's."""
    size = half * base
    top, at = low * 1.001, (0, 0, low)
    slim = low / (2 * half.min())
    if base < 0.6:
        neck = rng.uniform(0.45, 0.85)
        cap = rng.uniform(0.8, 1.0) if neck < 0.7 else 1.0
        profile = [(1.0, 0), (1.0, 0.05 * low), (neck * 1.05, 0.15 * low), (neck, 0.6 * low)]
        profile += [(neck * 1.05, 0.85 * low), (cap, top)]
        roundness = 2.0 if is_round or rng.random() < 0.5 else 5.0
        shape.add("foot", lathe(profile, sides=16, squash=size, roundness=roundness), at, "tub")
        return
    claws = slim < 0.5
    odds = [0.55, 0.15, 0.3] if claws else [0.7, 0.2, 0.1]
    style = rng.choice(["legs", "sled", "plinth"], p=odds)
    if style == "plinth" or slim < 0.1:
        rings = [np.column_stack([plan * size, np.full(SIDES, z)]) for z in (0, top)]
        shape.add("foot", loft(rings), at, "tub")
        return
    r = rng.uniform(0.04, 0.09) if claws else rng.uniform(0.025, 0.06)
    spot = size * (0.72 if is_round else 1.0) - r
    spot = np.minimum(spot, half * 1.15 - r)
    reach = size - r
    inside = np.minimum(reach, half * bottom * (0.68 if is_round else 0.9))
    for s in (-1, 1):
        foot = np.array([reach[0], s * reach[1], 0.0])
        hip = np.array([inside[0], s * inside[1], low + 0.12 * low])
        if style == "sled":
            solid = bar(hip, (reach[0], s * reach[1], 0), r, sides=4)
        elif claws:
            knee = (foot + hip) / 2 + np.array([0.3, 0.3 * s, 0.3]) * r
            foot_at = foot + np.array([0, 0, 0.8 * r])
            solid = tube([hip, knee, foot_at, foot], [1.3 * r, 0.9 * r, 0.6 * r, r], 8)
        else:
            solid = bar(hip, foot, r, r * rng.choice([1.0, 0.7]), int(rng.choice([4, 8])))
        shape.add_pair("foot", solid, (inside[0], s * inside[1], low), "tub")
    if style == "sled":
        z = rng.uniform(0.1, 0.4) * low
        side = bar((reach[0], -reach[1], z), (reach[0], reach[1], z), 0.7 * r)
        shape.add_pair("foot", side, (inside[0], 0, low), "tub")


def _tap(shape, rng, half, top, wall, depth):
    """A spout over the back edge, sometimes with two handles."""
    tall = rng.uniform(0.18, 0.4) * min(1.0, 2.5 * depth)
    r = rng.uniform(0.02, 0.035)
    y = half[1] - 0.5 * wall
    at = (0, y, top)
    a = np.linspace(0, np.pi, 6)
    bend = 0.3 * tall
    arc = np.column_stack([0 * a, y - bend * (1 - np.cos(a)), top + tall - bend + bend * np.sin(a)])
    path = (
        np.concatenate([[(0, y, top - 0.02)], arc])
        if rng.random() < 0.7
        else np.array([(0, y, top - 0.02), (0, y, top + 0.5 * tall), (0, y - 0.9 * tall, top + 0.5 * tall)])
    )
    shape.add("tap", tube(path, r, 8), at, "tub")
    if rng.random() < 0.6:
        x = rng.uniform(0.12, 0.2)
        shape.add_pair("tap", bar((x, y, top - 0.02), (x, y, top + 0.35 * tall), 1.3 * r, sides=8), at, "tub")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    tub = shape.parts[0].vertices
    foot, rim, tap = shape.points("foot"), shape.points("rim"), shape.points("tap")
    lo, hi = tub.min(0), tub.max(0)
    size = np.maximum(hi - lo, 1e-6)
    short = size[:2].min()
    hole = np.ptp(tub[INNER * SIDES : (INNER + 1) * SIDES, :2], axis=0)
    wall = (size[:2] - hole) / 2 / short
    floor = lo[2] if foot is None else min(lo[2], foot[:, 2].min())
    m = {
        "elong": size[:2].max() / short,
        "depth": size[2] / short,
        "lift": (lo[2] - floor) / (hi[2] - floor),
        "base": NO_BASE,
        "wall": np.sqrt(max(wall[0], 1e-3) * max(wall[1], 1e-3)),
    }
    faults = [0.8 * outside(wall[0] / max(wall[1], 1e-3), 0.55, 1.8)]
    if shape.traits["round"] and m["elong"] < 1.6:
        faults.append(0.5 * outside(m["elong"], 1.0, 1.3))
    if foot is not None:
        spread = np.ptp(foot, 0)[:2] / size[:2]
        middle = (foot.min(0) + foot.max(0) - lo - hi)[:2] / 2 / size[:2]
        m["base"] = np.sqrt(spread.prod())
        faults += [
            0.8 * outside(spread[0] / spread[1], 0.75, 1.35),
            outside(m["base"], 0.14, 1.17),
            0.8 * outside(1 + abs(middle).max(), 0.9, 1.12),
            0.8 * outside(1 + (lo[2] - foot[:, 2].max()) / size[2], 1e-3, 1.03),
        ]
    if rim is not None:
        spread = np.ptp(rim, 0) / size
        gap = (rim[:, 2].mean() - hi[2]) / size[2]
        faults += [outside(spread[a], 0.95, 1.13) for a in (0, 1)]
        faults.append(outside(spread[0] / spread[1], 0.92, 1.09))
        faults += [0.7 * outside(spread[2] * m["depth"], 0.005, 0.15), 0.8 * outside(1 + gap, 0.75, 1.15)]
    if tap is not None:
        spread = np.ptp(tap, 0)
        faults += [
            0.7 * outside(spread[2] / short, 0.04, 0.55),
            0.6 * outside(spread[0] / size[0], 0.005, 0.7),
        ]
        faults.append(0.6 * outside(spread[1] / size[1], 0.03, 0.7))
        faults.append(0.7 * outside(1 + (tap[:, 2].min() - hi[2]) / short, 0.8, 1.08))
    return m, faults
