# SPDX-License-Identifier: MIT OR Apache-2.0
"""Seats: from a footstool to a pew. The front looks to -y; the unit is the smaller side of the seat."""

import numpy as np

from .axis import amount, outside, ratio
from .seat_backs import add_back, add_wings
from .seat_bases import add_base
from .shape import Shape
from .solids import bar, block, cushion, outline, slab

# Every parameter with the range it is drawn from when no kind is meant: far wider than any kind.
RANGES = {
    "aspect": ratio(0.25, 8.5),
    "rise": ratio(0.25, 3.4),
    "back": amount(0.0, 3.6),
    "arm": amount(0.0, 0.7),
    "slim": amount(0.03, 0.8),
    "open": amount(0.02, 0.97),
    "leg": ratio(0.045, 0.18),
}
# The share of the height below the seat.
MEASURED = {"legs": amount(0.0, 1.0)}
BASES = ("legs", "legs", "legs", "legs", "sled", "pedestal", "star", "panels", "plinth")


def build(p, traits, rng):
    """A seat with the parameters of `RANGES` and the traits base, round, soft (missing ones are drawn)."""
    width, depth = max(p["aspect"], 1.0), max(1.0 / p["aspect"], 1.0)
    rise, back = p["rise"], p["back"] if p["back"] > 0.1 else 0.0
    arm = p["arm"] if p["arm"] > 0.12 else 0.0
    thick = min(max(p["slim"], 0.04), 0.9 * rise * max(1 - p["open"], 0.04) + 0.02)
    bottom = rise - thick
    shape = Shape("seats")
    soft = traits.get("soft", thick > 0.16 and rng.random() < 0.8)
    base = traits.get("base", str(rng.choice(BASES)))
    if bottom < 0.06 * rise or p["open"] < 0.12:
        base = "plinth"
    elif (base == "plinth" and p["open"] > 0.35) or (base == "panels" and rise > 1.4):
        base = "legs"
    if max(width, depth) > 1.5 and base in ("pedestal", "star"):
        base = "legs" if rng.random() < 0.6 else "panels"
    is_round = traits.get(
        "round", back == 0 and arm == 0 and 0.8 < p["aspect"] < 1.25 and rng.random() < 0.45
    )
    if is_round and base in ("sled", "panels"):
        base = "legs"
    shape.traits.update(round=is_round, base=base, soft=soft)
    hx, hy = width / 2, depth / 2
    _seat(shape, rng, hx, hy, bottom, rise, soft, is_round)
    add_base(shape, rng, hx, hy, bottom, p["leg"], base, is_round)
    if back:
        add_back(shape, rng, hx, hy, rise, thick, back, soft, base, p["leg"])
        if arm and soft and back > 1.9 * arm and hx < 0.8 and rng.random() < 0.5:
            add_wings(shape, rng, hx, hy, rise, arm, back)
    if arm:
        low = bottom * (1.0 if base in ("pedestal", "star") else rng.choice([1.0, 1.0, 0.1]))
        _arms(shape, rng, hx, hy, rise, low, arm, soft and rise < 1.4, back)
    return shape


def _seat(shape, rng, hx, hy, bottom, rise, soft, is_round):
    """The seat itself: round, cushioned, rounded or a block."""
    thick = rise - bottom
    bevel = rng.uniform(0, 0.35) * thick
    if is_round:
        crown = rng.choice([0, 0.2]) * thick
        shape.add("seat", slab(outline(20) * (hx, hy), bottom, rise - crown, bevel, crown=crown))
    elif soft and thick > 0.1 and rng.random() < 0.6:
        count = int(rng.choice([1, 1, 2, 3])) if hx > 1.3 * hy else 1
        split = bottom + thick * rng.uniform(0.2, 0.5)
        shape.add("seat", block((-hx, -hy, bottom), (hx, hy, split + 0.02), 0.2 * thick))
        for i in range(count):
            w = hx / count
            center = (-hx + (2 * i + 1) * w, 0, (split + rise) / 2)
            shape.add("seat", cushion(center, (w, hy, (rise - split) / 2), rng.uniform(4, 8)))
    elif rng.random() < 0.3:
        plan = outline(24, rng.uniform(2.6, 6)) * (hx, hy)
        plan[:, 0] *= 1 - rng.uniform(0, 0.15) * (plan[:, 1] / hy + 1) / 2
        crown = rng.choice([0, 0.1, 0.3]) * thick
        shape.add("seat", slab(plan, bottom, rise - crown, bevel, crown=crown))
    else:
        corner = rng.choice([0.0, rng.uniform(0.02, 0.3)])
        shape.add("seat", block((-hx, -hy, bottom), (hx, hy, rise), bevel, corner))


def _arms(shape, rng, hx, hy, rise, low, arm, soft, back):
    """Padded arms, or rests on posts or side panels; on a high seat perhaps a tray."""
    at = (hx, 0, rise)
    front, top = -hy * rng.uniform(0.6, 1.0), rise + arm
    if soft:
        t = rng.uniform(0.14, 0.32)
        if rng.random() < 0.4:
            shape.add_pair("arm", block((hx, front, low), (hx + t, hy, rise + arm * 0.7), 0.03), at, "seat")
            y = (hx + t / 2, front, top - t * 0.6), (hx + t / 2, hy, top - t * 0.6)
            shape.add_pair("arm", bar(*y, t * 0.6, sides=12), at, "seat")
        else:
            bevel = rng.uniform(0.1, 0.45) * t
            shape.add_pair("arm", block((hx - 0.02, front, low), (hx + t, hy, top), bevel), at, "seat")
        return
    t, r = rng.uniform(0.08, 0.16), rng.uniform(0.035, 0.06)
    x = hx - rng.uniform(-0.02, 0.03)
    rest = block((x - t / 2, front, top - 2 * r), (x + t / 2, hy, top), r * 0.6)
    shape.add_pair("arm", rest, at, "seat")
    if rng.random() < 0.25:
        side = block((x - r / 2, front + r, rise - 0.05), (x + r / 2, hy, top - r))
        shape.add_pair("arm", side, at, "seat")
    else:
        post = front + r + rng.choice([0.0, rng.uniform(0, 0.5)]) * hy
        for y in (post, hy - r) if back < arm else (post,):
            shape.add_pair("arm", bar((x, y, rise - 0.05), (x, y, top - r), r), at, "seat")
    if rise > 1.4 and rng.random() < 0.5:
        tray = block((-x, -hy * 1.15, top - 2 * r), (x, -hy * 0.4, top), r * 0.6, 0.1)
        shape.add("arm", tray, (0, 0, rise), "seat")


def resembles(shape, proportions):
    """A seat without back and arms is a table to the eye; a thick one has a body under its top."""
    if proportions["back"] > 0.06 or proportions["arm"] > 0.06:
        return None
    aspect = max(proportions["aspect"], 1 / proportions["aspect"])
    rise, slim = proportions["rise"], proportions["slim"]
    table = {
        "aspect": aspect,
        "rise": rise,
        "body": min(slim / rise, 1.0),
        "leg": proportions["leg"],
        "slab": min(slim, 0.1),
        "stretch": aspect / np.sqrt(rise),
        "legs": max(rise - slim, 0.0) / np.sqrt(aspect),
    }
    absent = {"tilted": False, "mirror": False, "benches": False}
    return "tables", table, {"round": shape.traits["round"], "base": shape.traits["base"], **absent}


def measure(shape):
    """The proportions of `RANGES` and `MEASURED` read off the vertices, and the faults as log distances.

    On a plinth the seat counts as reaching the floor.
    """
    seat, leg = shape.points("seat"), shape.points("leg")
    back, arm, rail = shape.points("back"), shape.points("arm"), shape.points("rail")
    base = shape.traits["base"]
    lo, hi = seat.min(0), seat.max(0)
    width, depth = hi[:2] - lo[:2]
    unit = min(width, depth)
    floor = min(lo[2], leg[:, 2].min()) if leg is not None else lo[2]
    rise = hi[2] - floor
    m = {
        "aspect": width / depth,
        "rise": rise / unit,
        "back": 0.0 if back is None else max(back[:, 2].max() - hi[2], 0) / unit,
        "arm": 0.0 if arm is None else max(arm[:, 2].max() - hi[2], 0) / unit,
        "slim": (hi[2] - lo[2]) / unit,
        "open": max(lo[2] - floor, 0.0) / rise,
        "leg": 0.18,
    }
    if base == "plinth":
        m["slim"], m["open"] = m["rise"], 0.02
    m["legs"] = m["open"] * m["rise"] / (m["rise"] + max(m["back"], m["arm"]))
    faults = [] if base == "plinth" else [0.7 * outside(m["slim"] / m["rise"], 0.015, 0.93)]
    if leg is not None:
        stem = base in ("pedestal", "star")
        spread = np.ptp(leg, 0)[:2] / (width, depth)
        least = 0.4 if stem or shape.traits["round"] else 0.68
        faults += [outside(s, least, 1.35) for s in spread]
        sizes = np.array([_leg_thickness(p.vertices, stem) for p in shape.parts if p.label == "leg"]) / unit
        if base != "plinth":
            m["leg"] = np.median(sizes.min(1))
        if base == "legs":
            faults += [outside(np.median(sizes.mean(1)), 0.035, 0.2)]
            faults += [0.6 * outside(np.median(sizes[:, 0] / sizes[:, 1]), 0.35, 2.8)]
        elif stem:
            faults += [0.6 * outside(spread[0] / spread[1] * m["aspect"], 0.6, 1.6)]
    else:
        faults += [0.7]
    if rail is not None:
        faults += [0.6 * outside((rail[:, 2].min() - floor) / rise + 1, 1.0, 2.0)]
        faults += [0.6 * outside(np.ptp(rail[:, 0]) / width, 0.5, 1.35)]
    if back is not None:
        size = np.ptp(back, 0)
        faults += [outside(size[0] / width, 0.68, 1.25), 0.6 * outside(size[1] / depth, 0.01, 0.6)]
        faults += [0.8 * outside((back[:, 1].max() - hi[1]) / depth + 1, 0.9, 1.5)]
    if arm is not None:
        faults += [0.8 * outside(np.ptp(arm[:, 1]) / depth, 0.4, 1.2)]
        faults += [0.8 * outside((np.ptp(arm[:, 0]) - width) / unit + 1, 0.8, 1.9)]
    return m, faults


def _leg_thickness(vertices, stem):
    """How thick a leg is in x and y: at its top end, or a column at its waist."""
    if stem:
        across = np.abs(vertices[:, :2] - vertices[:, :2].mean(0))
        waist = np.sort(np.hypot(*across.T))[len(across) // 20 + 2]
        return np.array([2 * waist, 2 * waist])
    top = vertices[:, 2].max() - 0.1 * np.ptp(vertices[:, 2])
    return np.maximum(np.ptp(vertices[vertices[:, 2] >= top][:, :2], 0), 1e-6)
