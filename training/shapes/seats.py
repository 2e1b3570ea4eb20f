# SPDX-License-Identifier: MIT OR Apache-2.0
"""Seats: from a bar stool to a sofa. The front looks to -y; the unit is the smaller side of the seat."""

import numpy as np

from .shape import Shape
from .solids import bar, block, cushion, lathe, mirrored, outline, rounded_rectangle, slab

# Every parameter with the range it is drawn from when no kind is meant: far wider than any kind.
RANGES = {
    "aspect": (0.25, 4.6),
    "rise": (0.25, 3.4),
    "back": (0.0, 3.6),
    "arm": (0.0, 0.7),
    "slim": (0.03, 0.8),
    "open": (0.02, 0.97),
    "leg": (0.03, 0.2),
}
BASES = ("legs", "legs", "legs", "legs", "sled", "pedestal", "star", "panels", "plinth")


def build(p, traits, rng):
    """A seat with the parameters of `RANGES` and the traits base, round, soft (missing ones are drawn)."""
    width, depth = max(p["aspect"], 1.0), max(1.0 / p["aspect"], 1.0)
    rise, back = p["rise"], p["back"] if p["back"] > 0.06 else 0.0
    arm = p["arm"] if p["arm"] > 0.06 else 0.0
    thick = min(max(p["slim"], 0.04), 0.9 * rise * max(1 - p["open"], 0.04) + 0.02)
    bottom = rise - thick
    shape = Shape("seat")
    soft = traits.get("soft", thick > 0.16 and rng.random() < 0.8)
    base = traits.get("base", rng.choice(BASES))
    if bottom < 0.06 * rise:
        base = "plinth"
    elif base == "plinth" and p["open"] > 0.35:
        base = "legs"
    if max(width, depth) > 1.8 and base in ("pedestal", "star"):
        base = "legs"
    is_round = traits.get(
        "round", back == 0 and arm == 0 and 0.8 < p["aspect"] < 1.25 and rng.random() < 0.45
    )
    shape.traits.update(round=is_round, base=base, soft=soft)
    hx, hy = width / 2, depth / 2
    _seat(shape, rng, hx, hy, bottom, rise, soft, is_round)
    _base(shape, rng, hx, hy, bottom, p["leg"], base, is_round)
    if back:
        _back(shape, rng, hx, hy, rise, thick, back, soft, base, p["leg"])
    if arm:
        _arms(shape, rng, hx, hy, rise, bottom, arm, soft)
    return shape


def _seat(shape, rng, hx, hy, bottom, rise, soft, is_round):
    thick = rise - bottom
    bevel = rng.uniform(0, 0.35) * thick
    if is_round:
        shape.add("seat", slab(outline(20) * (hx, hy), bottom, rise, bevel, crown=rng.choice([0, 0.03])))
    elif soft and thick > 0.1 and rng.random() < 0.6:
        count = int(rng.choice([1, 1, 2, 3])) if hx > 1.3 * hy else 1
        split = bottom + thick * rng.uniform(0.2, 0.5)
        shape.add("seat", block((-hx, -hy, bottom), (hx, hy, split + 0.02), 0.2 * thick))
        for i in range(count):
            w = hx / count
            center = (-hx + (2 * i + 1) * w, 0, (split + rise) / 2)
            shape.add("seat", cushion(center, (w, hy, (rise - split) / 2 * 1.05), rng.uniform(4, 8)))
    elif rng.random() < 0.3:
        plan = outline(24, rng.uniform(2.6, 6)) * (hx, hy)
        plan[:, 0] *= 1 - rng.uniform(0, 0.15) * (plan[:, 1] / hy + 1) / 2
        shape.add("seat", slab(plan, bottom, rise, bevel, crown=rng.choice([0, 0.02, 0.05])))
    else:
        corner = rng.choice([0.0, rng.uniform(0.02, 0.3)])
        shape.add("seat", block((-hx, -hy, bottom), (hx, hy, rise), bevel, corner))


def _base(shape, rng, hx, hy, bottom, leg, base, is_round):
    half = leg / 2
    inset = rng.uniform(0, 0.12) if rng.random() < 0.7 else rng.uniform(0, 0.3)
    top = bottom + 0.02
    if base == "plinth":
        edge = 1 - rng.uniform(0, 0.15)
        shape.add(
            "leg", block((-hx * edge, -hy * edge, 0), (hx * edge, hy * edge, top), 0.02), (0, 0, top), "seat"
        )
    elif base in ("pedestal", "star"):
        foot = min(hx, hy) * rng.uniform(0.55, 1.0)
        r = half * rng.uniform(0.8, 1.6)
        low = 0.08 * bottom + 0.02
        if base == "star":
            count, turn = int(rng.choice([4, 5, 5])), rng.uniform(0, 1.5)
            for i in range(count):
                a = 2 * np.pi * i / count + turn
                tip = (foot * 1.1 * np.cos(a), foot * 1.1 * np.sin(a), half * 0.8)
                shape.add("leg", bar((0, 0, low + half), tip, half, half * 0.7, 6), (0, 0, top), "seat")
                if rng.random() < 0.7:
                    wheel = cushion((tip[0], tip[1], half * 0.6), (half, half, half * 0.8), 2.2, 8, 5)
                    shape.add("leg", wheel, (0, 0, top), "seat")
            profile = [(r * 1.2, low), (r * 1.2, bottom * 0.5), (r * 0.8, bottom * 0.52), (r * 0.8, top)]
        elif rng.random() < 0.6:
            profile = [
                (foot, 0),
                (foot, low * 0.5),
                (r * 1.5, low),
                (r, bottom * 0.2 + low),
                (r, bottom * 0.85),
                (r * 1.6, top),
            ]
        else:
            profile = [
                (foot, 0),
                (foot * 0.6, bottom * 0.15),
                (r * 0.9, bottom * 0.5),
                (foot * 0.5, bottom * 0.9),
                (foot * 0.6, top),
            ]
        shape.add("leg", lathe(profile, sides=14), (0, 0, top), "seat")
    elif base == "sled":
        x = hx * (1 - inset) - half
        for y in (-1, 1):
            foot = (x, y * (hy - half), half)
            shape.add_pair(
                "leg",
                bar((x, y * (hy - half), top), foot, half * 0.8, sides=rng.choice([4, 8])),
                (x, 0, top),
                "seat",
            )
        shape.add_pair("leg", bar((x, -hy, half), (x, hy, half), half * 0.8), (x, 0, top), "seat")
    elif base == "panels":
        x = hx - half
        shape.add_pair("leg", block((x - half, -hy, 0), (x + half, hy, top), 0.01), (x, 0, top), "seat")
    else:
        _legs(shape, rng, hx, hy, bottom, half, inset, is_round)


def _legs(shape, rng, hx, hy, bottom, half, inset, is_round):
    top = bottom + 0.02
    splay = rng.choice([0, rng.uniform(-0.05, 0.22)]) * min(1.0, bottom)
    taper = rng.choice([1.0, rng.uniform(0.45, 1.0)])
    sides = int(rng.choice([4, 4, 10]))
    bow = np.array([0, rng.choice([0, 0, 0.08]), 0]) * bottom
    k = 0.68 if is_round else 1.0
    x, y = (hx * (1 - inset) - half) * k, (hy * (1 - inset) - half) * k
    for s in (-1, 1):
        a, b = (x, s * y, top), (x + splay, s * (y + splay), 0)
        shape.add_pair("leg", bar(a, b, half, half * taper, sides, bow * s), a, "seat")
    if 2 * hx > 2.4 and rng.random() < 0.4:
        for s in (-1, 1):
            shape.add(
                "leg", bar((0, s * y, top), (0, s * y, 0), half, half * taper, sides), (0, s * y, top), "seat"
            )
    if rng.random() < 0.45:
        z, r = bottom * rng.uniform(0.12, 0.6), half * rng.uniform(0.4, 0.8)
        out = splay * (1 - z / bottom)
        rails = rng.choice(["sides", "ring", "h"])
        shape.add_pair("rail", bar((x + out, -y - out, z), (x + out, y + out, z), r), (x, 0, bottom), "seat")
        if rails == "ring":
            for s in (-1, 1):
                shape.add(
                    "rail",
                    bar((-x - out, s * (y + out), z), (x + out, s * (y + out), z), r),
                    (0, s * y, bottom),
                    "seat",
                )
        elif rails == "h":
            shape.add("rail", bar((-x - out, 0, z), (x + out, 0, z), r), (0, 0, bottom), "seat")
    if rng.random() < 0.35:
        d = rng.uniform(0.05, 0.14)
        for s in (-1, 1):
            shape.add("seat", block((-x, s * y - half * 0.5, bottom - d), (x, s * y + half * 0.5, bottom)))
            shape.add("seat", block((s * x - half * 0.5, -y, bottom - d), (s * x + half * 0.5, y, bottom)))


def _lean(solid, base, amount, wrap, hx):
    """Tilt a back about its foot by `amount` per height and wrap its sides forward by `wrap`."""
    v, f = solid
    v = v.copy()
    v[:, 1] += (v[:, 2] - base) * amount - wrap * (v[:, 0] / hx) ** 2
    return v, f


def _back(shape, rng, hx, hy, rise, thick, back, soft, base, leg):
    lean = rng.choice([0, rng.uniform(0, 0.3)]) * min(1, 1 / max(back, 0.5))
    t = rng.uniform(0.1, 0.35) if soft else rng.uniform(0.03, 0.12)
    wide = hx * rng.choice([1.0, rng.uniform(0.75, 1.0)])
    top, low, y = rise + back, rise - 0.5 * thick, hy - t / 2
    wrap = rng.choice([0, 0, rng.uniform(0.05, 0.3)])
    at = (0, hy - t / 2, rise)
    style = rng.choice(["panel", "panel", "cushion", "rails", "slats", "spindles", "floating", "arched"])
    if soft and style not in ("arched", "floating"):
        style = rng.choice(["panel", "cushion"])

    def put(solid):
        return shape.add("back", _lean(solid, rise, lean, wrap, hx), at, "seat")

    if style == "panel":
        n = 9 if wrap else 1
        plan = rounded_rectangle(wide, t / 2, min(0.3 * t, 0.06)) if n == 1 else _strip(wide, t / 2, n)
        put(slab(plan, low, top, rng.uniform(0, 0.3) * t, (0, y), divisions=4))
    elif style == "cushion":
        count = int(rng.choice([1, 2, 3])) if hx > 1.3 * hy else 1
        put(slab(_strip(wide, t / 4, 9), low, rise + back * 0.97, 0.02, (0, y + t / 4), divisions=4))
        for i in range(count):
            w = wide / count
            put(
                cushion(
                    (-wide + (2 * i + 1) * w, y - t / 4, rise + back / 2),
                    (w, t / 2, back / 2),
                    rng.uniform(3.5, 8),
                )
            )
    elif style == "arched":
        plan = outline(24, rng.uniform(2.2, 5)) * (wide, back * 0.55)
        v, f = slab(plan, -t / 2, t / 2, 0.2 * t, divisions=1)
        put((np.column_stack([v[:, 0], v[:, 2] + y, v[:, 1] + rise + back * 0.45]), f[:, ::-1]))
    else:
        r = max(leg * 0.45, 0.02)
        x = wide - r
        if style == "floating" and base in ("pedestal", "star"):
            put(bar((0, y, low), (0, y, rise + 0.6 * back), (0.06, 0.03)))
        else:
            for s in (-1, 1):
                put(bar((s * x, y, low), (s * x, y, top), r, r * 0.8, steps=5))
        if style == "floating":
            put(
                slab(
                    _strip(wide, t / 2, 9),
                    rise + back * rng.uniform(0.35, 0.6),
                    top,
                    0.02,
                    (0, y),
                    divisions=3,
                )
            )
            return
        cap = max(0.1 * back, 0.05)
        put(slab(_strip(wide, r, 9), top - cap, top, 0.01, (0, y)))
        if style == "rails":
            for z in np.linspace(rise + 0.15 * back, top - 0.3 * back, int(rng.integers(1, 4))):
                put(slab(_strip(x, r * 0.6, 9), z, z + cap * rng.uniform(0.6, 1.2), 0.0, (0, y)))
        else:
            count = int(rng.integers(2, 6)) * max(1, round(hx / max(hy, 0.5)))
            w = r * 0.5 if style == "spindles" else 0.55 * x / count
            for z in np.linspace(-x, x, count + 2)[1:-1]:
                put(bar((z, y, low), (z, y, top - cap / 2), (w, r * 0.5), steps=3))


def _strip(half_x, half_y, count):
    """A rectangle outline with `count` points along each long side, so that it can be wrapped."""
    x = np.linspace(-half_x, half_x, count)
    return np.concatenate(
        [np.column_stack([x, np.full(count, -half_y)]), np.column_stack([x[::-1], np.full(count, half_y)])]
    )


def _arms(shape, rng, hx, hy, rise, bottom, arm, soft):
    at = (hx, 0, rise)
    front = -hy * rng.uniform(0.5, 1.0)
    if soft:
        t = rng.uniform(0.12, 0.32)
        low = bottom * rng.choice([1.0, 1.0, 0.1])
        if rng.random() < 0.4:
            shape.add_pair("arm", block((hx, front, low), (hx + t, hy, rise + arm * 0.7), 0.03), at, "seat")
            roll = bar(
                (hx + t / 2, front, rise + arm - t / 2),
                (hx + t / 2, hy, rise + arm - t / 2),
                t * 0.6,
                sides=12,
            )
            shape.add_pair("arm", roll, at, "seat")
        else:
            shape.add_pair(
                "arm",
                block((hx - 0.02, front, low), (hx + t, hy, rise + arm), rng.uniform(0.1, 0.45) * t),
                at,
                "seat",
            )
        return
    t, r = rng.uniform(0.06, 0.14), rng.uniform(0.025, 0.06)
    x = hx - rng.uniform(-0.02, 0.03)
    shape.add_pair(
        "arm", block((x - t / 2, front, rise + arm - r), (x + t / 2, hy, rise + arm + r), r * 0.6), at, "seat"
    )
    post = -hy * rng.uniform(0.3, 0.9) if rng.random() < 0.8 else 0.0
    shape.add_pair(
        "arm",
        bar((x, max(post, front + r), rise - 0.05), (x, max(post, front + r), rise + arm), r),
        at,
        "seat",
    )


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults of the build as log distances
    (list).
    """
    seat, leg = shape.points("seat"), shape.points("leg")
    back, arm = shape.points("back"), shape.points("arm")
    lo, hi = seat.min(0), seat.max(0)
    width, depth = hi[:2] - lo[:2]
    unit = min(width, depth)
    floor = min(lo[2], leg[:, 2].min()) if leg is not None else lo[2]
    rise = hi[2] - floor
    legs = [p.vertices for p in shape.parts if p.label == "leg"]
    across = np.array([np.sort(np.ptp(v, 0))[:2].mean() for v in legs]) if legs else np.array([0.0])
    m = {
        "aspect": width / depth,
        "rise": rise / unit,
        "back": 0.0 if back is None else max(back[:, 2].max() - hi[2], 0) / unit,
        "arm": 0.0 if arm is None else max(arm[:, 2].max() - hi[2], 0) / unit,
        "slim": (hi[2] - lo[2]) / unit,
        "open": max(lo[2] - floor, 0.0) / rise,
    }
    if shape.traits["base"] == "plinth":
        m["slim"], m["open"] = m["rise"], 0.02
    faults = []
    if leg is not None:
        spread = np.ptp(leg, 0)[:2] / (width, depth)
        stem = shape.traits["base"] in ("pedestal", "star")
        faults += [
            _outside(spread[0], 0.4 if stem else 0.68, 1.3),
            _outside(spread[1], 0.4 if stem else 0.68, 1.35),
        ]
        if shape.traits["base"] == "legs":
            sizes = np.array([np.ptp(v, 0)[:2] for v in legs]) / unit
            faults += [_outside(np.median(across) / unit, 0.025, 0.2)]
            faults += [0.6 * _outside(np.median(sizes[:, 0] / sizes[:, 1]), 0.35, 2.8)]
    else:
        faults += [0.7]
    if back is not None:
        size = np.ptp(back, 0)
        faults += [_outside(size[0] / width, 0.68, 1.25), 0.6 * _outside(size[1] / depth, 0.01, 0.55)]
        faults += [0.8 * _outside((back[:, 1].max() - hi[1]) / depth + 1, 0.9, 1.5)]
    if arm is not None:
        faults += [0.8 * _outside(np.ptp(arm[:, 1]) / depth, 0.4, 1.2)]
        faults += [0.8 * _outside((np.ptp(arm[:, 0]) - width) / unit + 1, 0.8, 1.9)]
    if shape.traits["base"] != "plinth":
        faults += [0.7 * _outside(m["slim"] / m["rise"], 0.015, 0.75)]
    return m, faults


def _outside(value, low, high):
    """Log distance of a positive value to a range, 0 inside."""
    value = max(value, 1e-3)
    return max(np.log(low / value), np.log(value / high), 0.0)


__all__ = ["RANGES", "build", "measure", "mirrored"]
