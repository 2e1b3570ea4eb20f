# SPDX-License-Identifier: MIT OR Apache-2.0
"""Tables and boxy things that stand like one. The unit is the shorter side of the top."""

import numpy as np

from .seats import _outside
from .shape import Shape
from .solids import bar, block, lathe, outline, rounded_rectangle, slab

RANGES = {
    "aspect": (1.0, 6.0),
    "rise": (0.18, 3.8),
    "body": (0.02, 1.0),
    "leg": (0.02, 0.2),
}
BASES = ("legs", "legs", "legs", "legs", "pedestal", "tee", "panels", "cross", "sled", "hairpin")


def build(p, traits, rng):
    """A table with the parameters of `RANGES` and the traits base, round (missing ones are drawn)."""
    long, rise = p["aspect"], p["rise"]
    is_round = traits.get("round", rng.random() < (0.3 if long < 1.2 else 0.08))
    base = traits.get("base", rng.choice(BASES))
    if is_round and base in ("panels", "tee", "sled"):
        base = "legs"
    turned = traits.get("turned", rng.random() < 0.18)
    hx, hy = (0.5, long / 2) if turned else (long / 2, 0.5)
    shape = Shape("table", traits={"round": is_round, "base": base})
    top = min(rng.uniform(0.02, 0.12), 0.3 * rise)
    body = p["body"] * rise
    under = rise - top
    sides = int(rng.choice([24, 24, 8, 6])) if is_round else 0
    over = rng.uniform(0, 0.06) if rng.random() < 0.7 else rng.uniform(0.06, 0.18)
    _top(shape, rng, hx, hy, under, rise, sides)
    if body > top + 0.02:
        _body(shape, rng, hx - over, hy - over, max(rise - body, 0.0), under, sides)
    floor_gap = rise - max(body, top)
    if floor_gap > 0.03 * rise:
        _base(shape, rng, hx - over, hy - over, min(floor_gap + 0.02, under + 0.01), p["leg"], base, is_round)
    return shape


def _top(shape, rng, hx, hy, under, rise, sides):
    bevel = rng.choice([0.0, rng.uniform(0.1, 0.45) * (rise - under)])
    if sides:
        shape.add("top", slab(outline(sides, 2, np.pi / sides) * (hx, hy), under, rise, bevel))
    elif rng.random() < 0.12:
        shape.add("top", slab(outline(28, rng.uniform(2.6, 6)) * (hx, hy), under, rise, bevel))
    else:
        shape.add(
            "top",
            block((-hx, -hy, under), (hx, hy, rise), bevel, rng.choice([0.0, 0.0, rng.uniform(0.02, 0.2)])),
        )


def _body(shape, rng, hx, hy, low, under, sides):
    at = (0, 0, under)
    if sides:
        shape.add("body", slab(outline(sides, 2, np.pi / sides) * (hx, hy), low, under, 0.01), at, "top")
        return
    shape.add("body", block((-hx, -hy, low), (hx, hy, under), rng.choice([0.0, 0.015])), at, "top")
    rows = max(1, min(4, round((under - low) / rng.uniform(0.25, 0.5))))
    columns = max(1, round(2 * hx / rng.uniform(0.8, 1.4)))
    if rng.random() < 0.75:
        step, wide = (under - low) / rows, 2 * hx / columns
        for r in range(rows):
            for c in range(columns):
                a = np.array([-hx + c * wide + 0.03, -hy - 0.025, low + r * step + 0.025])
                b = np.array([-hx + (c + 1) * wide - 0.03, -hy + 0.02, low + (r + 1) * step - 0.025])
                shape.add("body", block(a, b, 0.006), at, "top")
                mid = (a + b) / 2
                knob = block(
                    mid - (0.05, 0, 0.012) - np.array([0, 0.06, 0]), mid + np.array([0.05, 0, 0.012])
                )
                shape.add("body", knob, at, "top")


def _base(shape, rng, hx, hy, top, leg, base, is_round):
    half = leg / 2
    if base == "pedestal":
        foot, r = min(hx, hy) * rng.uniform(0.5, 0.9), half * rng.uniform(1, 2.2)
        count = int(rng.choice([1, 2])) if max(hx, hy) > 1.3 * min(hx, hy) else 1
        wide = hx >= hy
        for i in range(count):
            at = (0 if count == 1 else (i - 0.5) * max(hx, hy)) * np.array([wide, not wide])
            if rng.random() < 0.4:
                for a in np.linspace(0, 2 * np.pi, 5)[:4] + rng.choice([0, np.pi / 4]):
                    tip = (at[0] + foot * np.cos(a), at[1] + foot * np.sin(a), half * 0.6)
                    shape.add("leg", bar((*at, 0.15 * top + half), tip, half, half * 0.6), (*at, top), "top")
                profile = [(r, 0.1 * top), (r * 1.3, 0.4 * top), (r * 0.8, 0.8 * top), (r * 1.6, top)]
            else:
                profile = [
                    (foot, 0),
                    (foot, 0.04 * top + 0.01),
                    (r * 1.4, 0.1 * top + 0.02),
                    (r, 0.3 * top),
                    (r, 0.9 * top),
                    (r * 2, top),
                ]
            shape.add("leg", lathe(profile, at), (*at, top), "top")
    elif base == "tee":
        along_x = hx >= hy
        reach = max(hx, hy) * rng.uniform(0.75, 0.95)
        foot = min(hx, hy) * rng.uniform(0.75, 1.0)
        swap = (lambda x, y, z: (x, y, z)) if along_x else (lambda x, y, z: (y, x, z))
        for s in (-1, 1):
            at = swap(s * reach, 0, top)
            shape.add("leg", bar(at, swap(s * reach, 0, half), half * 0.8), at, "top")
            shape.add(
                "leg",
                bar(swap(s * reach, -foot, half * 0.6), swap(s * reach, foot, half * 0.6), half * 0.7),
                at,
                "top",
            )
            if rng.random() < 0.5:
                shape.add(
                    "leg",
                    bar(
                        swap(s * reach, -foot * 0.8, top - 0.02),
                        swap(s * reach, foot * 0.8, top - 0.02),
                        half * 0.5,
                    ),
                    at,
                    "top",
                )
        if rng.random() < 0.4:
            z = top * rng.uniform(0.15, 0.7)
            shape.add("rail", bar(swap(-reach, 0, z), swap(reach, 0, z), half * 0.6), (0, 0, top), "top")
    elif base == "panels":
        if hx >= hy:
            shape.add_pair("leg", block((hx - leg, -hy, 0), (hx, hy, top)), (hx, 0, top), "top")
        else:
            for s in (-1, 1):
                shape.add(
                    "leg",
                    block((-hx, s * (hy - half) - half, 0), (hx, s * (hy - half) + half, top)),
                    (0, s * hy, top),
                    "top",
                )
        if rng.random() < 0.4:
            shape.add("rail", block((-hx, -0.02, top * 0.3), (hx, 0.02, top)), (0, 0, top), "top")
    elif base == "cross":
        x, y = hx * 0.9, hy * 0.85
        if hx >= hy:
            for s in (-1, 1):
                shape.add_pair("leg", bar((x, s * y, top), (x, -s * y, 0), half), (x, 0, top), "top")
        else:
            for s in (-1, 1):
                shape.add_pair("leg", bar((x, s * y, top), (-x, s * y, 0), half), (0, s * y, top), "top")
    elif base == "sled":
        x, y = hx - half, hy - half
        for s in (-1, 1):
            shape.add_pair("leg", bar((x, s * y, top), (x, s * y, 0), half), (x, 0, top), "top")
        shape.add_pair("leg", bar((x, -y, half), (x, y, half), half * 0.95), (x, 0, top), "top")
    else:
        _legs(shape, rng, hx, hy, top, half, base, is_round)


def _legs(shape, rng, hx, hy, top, half, base, is_round):
    sides, taper = int(rng.choice([4, 4, 10])), rng.choice([1.0, rng.uniform(0.4, 1.0)])
    splay = rng.choice([0, 0, rng.uniform(0, 0.15)]) * min(1, top)
    if base == "hairpin":
        half, taper, sides, splay = half * 0.5, 1.0, 6, 0.05
    k = 0.68 if is_round else 1.0
    x, y = max(hx * k - half, half), max(hy * k - half, half)
    for s in (-1, 1):
        at = (x, s * y, top)
        shape.add_pair("leg", bar(at, (x + splay, s * (y + splay), 0), half, half * taper, sides), at, "top")
        if base == "hairpin":
            shape.add_pair(
                "leg",
                bar((x, s * (y - 0.12), top), (x + splay, s * (y + splay), 0), half, None, 6),
                at,
                "top",
            )
    if max(hx, hy) > 1.6 and rng.random() < 0.3:
        for s in (-1, 1):
            at = (0, s * y, top) if hx > hy else (s * x, 0, top)
            shape.add("leg", bar(at, (at[0], at[1], 0), half, half * taper, sides), at, "top")
    if rng.random() < 0.5:
        d = min(rng.uniform(0.05, 0.16), 0.25 * top)
        for s in (-1, 1):
            shape.add(
                "apron",
                block((-x, s * y - half * 0.5, top - d), (x, s * y + half * 0.5, top + 0.01)),
                (0, 0, top),
                "top",
            )
            shape.add(
                "apron",
                block((s * x - half * 0.5, -y, top - d), (s * x + half * 0.5, y, top + 0.01)),
                (0, 0, top),
                "top",
            )
    choice = rng.random()
    if choice < 0.15 and top > 0.25:
        z = top * rng.uniform(0.12, 0.5)
        shape.add("shelf", slab(rounded_rectangle(x, y, 0.02), z, z + 0.04), (0, 0, top), "top")
    elif choice < 0.35:
        z = top * rng.uniform(0.1, 0.4)
        shape.add_pair("rail", bar((x, -y, z), (x, y, z), half * 0.6), (x, 0, top), "top")
        shape.add("rail", bar((-x, 0, z), (x, 0, z), half * 0.6), (0, 0, top), "top")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults of the build as log distances
    (list).
    """
    top, leg, body = shape.points("top"), shape.points("leg"), shape.points("body", "apron")
    lo, hi = top.min(0), top.max(0)
    sides = np.sort(hi[:2] - lo[:2])
    floor = min(p.vertices[:, 2].min() for p in shape.parts)
    rise = hi[2] - floor
    block_low = lo[2] if body is None else min(lo[2], body[:, 2].min())
    m = {
        "aspect": sides[1] / sides[0],
        "rise": rise / sides[0],
        "body": max(hi[2] - block_low, 0.0) / rise,
    }
    faults = []
    if body is not None:
        spread = np.ptp(body, 0)[:2] / (hi[:2] - lo[:2])
        faults += [0.8 * _outside(spread.min(), 0.5, 1.15), 0.8 * _outside(spread.max(), 0.5, 1.15)]
    if leg is not None:
        spread = np.ptp(leg, 0)[:2] / (hi[:2] - lo[:2])
        stem = shape.traits["base"] == "pedestal"
        faults += [_outside(s, 0.3 if stem else 0.55, 1.3) for s in spread]
        legs = [p.vertices for p in shape.parts if p.label == "leg"]
        if shape.traits["base"] in ("legs", "tee", "hairpin"):
            sizes = np.array([np.ptp(v, 0)[:2] for v in legs]) / sides[0]
            faults += [_outside(np.median(sizes.min(1)), 0.015, 0.24)]
            if shape.traits["base"] == "legs":
                faults += [0.6 * _outside(np.median(sizes[:, 0] / sizes[:, 1]), 0.3, 3.3)]
    elif m["body"] < 0.8:
        faults += [0.7]
    return m, faults
