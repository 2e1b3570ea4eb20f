# SPDX-License-Identifier: MIT OR Apache-2.0
"""Tables and boxy things that stand like one. The unit is the shorter side of the top.

Built with the long side along x and drawers towards -y; some are then turned by a quarter.
"""

import numpy as np

from .axis import amount, outside, ratio
from .shape import Shape
from .table_bases import add_base, add_benches
from .table_tops import add_body, add_mirror, add_top

RANGES = {
    "aspect": ratio(1.0, 9.0),
    "rise": ratio(0.15, 5.0),
    "body": amount(0.0, 1.0),
    "leg": ratio(0.02, 0.26),
    "slab": ratio(0.015, 0.3),
}
# How far the top stretches (its longer side over the middle of the other two), and the legs' clear length.
MEASURED = {"stretch": ratio(0.5, 8.0), "legs": amount(0.0, 4.0)}
BASES = ("legs",) * 5 + (
    "curved",
    "hairpin",
    "pedestal",
    "tee",
    "panels",
    "cross",
    "sled",
    "trestle",
    "drawers",
)
STEMS = ("pedestal", "tee", "trestle")  # bases that can carry a tilted top
CABINET = 0.8  # a body of more than this share of the height looks like a cabinet's


def build(p, traits, rng):
    """A table with the parameters of `RANGES`.

    The traits are round, tilted, mirror and benches (drawn when missing).
    """
    long, rise = p["aspect"], p["rise"]
    top = min(p["slab"], 0.3 * rise)
    body = max(p["body"] * rise, top)
    under, low = rise - top, rise - body
    if low < 0.04 * rise:
        low = 0.0
    have = _traits(traits, long, rise, body / rise, rng)
    base = _base_for(have, long, rise, low, p["leg"], rng)
    shape = Shape("tables", traits={**have, "base": base})
    hx, hy = long / 2, 0.5
    sides = int(rng.choice([24, 24, 24, 8])) if have["round"] else 0
    over = rng.uniform(0, 0.06) if rng.random() < 0.7 else rng.uniform(0.06, 0.16)
    add_top(shape, rng, hx, hy, under, rise, sides)
    if body > 1.2 * top + 0.01 and base != "benches":
        add_body(shape, rng, hx - over, hy - over, low, under, sides)
    if low and base == "benches":
        add_benches(shape, rng, hx, rise, under, p["leg"])
    elif low:
        add_base(shape, rng, hx - over, hy - over, low + min(0.02, 0.5 * top), p["leg"], base, sides)
    if have["tilted"]:
        _tilt(shape, under, rng.uniform(0.2, 0.65))
    if have["mirror"]:
        add_mirror(shape, rng, hx, hy, rise)
    if rng.random() < 0.18:
        _quarter_turn(shape)
    return shape


def _traits(traits, long, rise, body, rng):
    """The wanted traits, the missing ones drawn; those that these proportions cannot have are left out."""
    have = {
        "round": traits.get("round", rng.random() < (0.3 if long < 1.2 else 0.06)),
        "tilted": traits.get("tilted", rng.random() < 0.02),
        "mirror": traits.get("mirror", rng.random() < 0.02),
        "benches": traits.get("benches", rng.random() < 0.02),
    }
    have["round"] = bool(have["round"] and long < 2.5)
    have["tilted"] = bool(have["tilted"] and long < 2.6 and rise > 0.8 and body < 0.45 and not have["round"])
    have["mirror"] = bool(have["mirror"] and 1.3 < long < 4 and rise > 0.9 and not have["tilted"])
    have["benches"] = bool(
        have["benches"] and 1.4 < long < 4 and 0.6 < rise < 1.5 and body < 0.3 and not have["tilted"]
    )
    return have


def _base_for(have, long, rise, low, leg, rng):
    """A base that suits a table of these proportions whose body ends at `low`."""
    if have["benches"]:
        return "benches"
    if have["tilted"]:
        return str(rng.choice(STEMS))
    base = str(rng.choice(BASES))
    if have["round"] and base not in ("hairpin", "curved"):
        base = "pedestal" if base in ("pedestal", "tee", "trestle", "drawers") else "legs"
    suits = {
        "drawers": 1.5 < long < 3.2 and 0.9 < rise < 1.8 and low > 0.6 * rise,
        "pedestal": long < 4.5 and low > 0.55 * rise,
        "tee": low > 0.55 * rise,
        "trestle": low > 0.55 * rise and low > 0.5,
        "cross": low > 0.55 * rise and low > 0.9,
        "panels": low > 0.4 * rise,
        "hairpin": leg < 0.06,
    }
    return base if suits.get(base, True) else "legs"


def _quarter_turn(shape):
    """Turn the whole about z, in place."""
    spin = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    for part in shape.parts:
        part.vertices, part.attach = part.vertices @ spin, part.attach @ spin


def _tilt(shape, under, slope):
    """Tilt the top and what lies on it; cut what carries it below the slope."""
    for part in shape.parts:
        v = part.vertices
        if part.label in ("top", "body"):
            v[:, 2] += slope * v[:, 1]
        else:
            v[:, 2] = np.minimum(v[:, 2], under + slope * v[:, 1] + 0.01)


def measure(shape):
    """The proportions of `RANGES` and `MEASURED` read off the vertices, and the faults as log distances."""
    top, leg, body = shape.points("top"), shape.points("leg"), shape.points("body")
    drawers = shape.points("drawers")
    lo, hi = top.min(0), top.max(0)
    size = hi[:2] - lo[:2]
    long = int(size[1] > size[0])
    unit = size.min()
    floor = min(p.vertices[:, 2].min() for p in shape.parts)
    thick = _thickness(top) if shape.traits["tilted"] else hi[2] - lo[2]
    rise = (lo[2] + hi[2] + thick) / 2 - floor
    solid = thick if body is None else max(thick, rise + floor - body[:, 2].min())
    if body is not None and shape.traits["tilted"]:
        solid -= (hi[2] - lo[2] - thick) / 2
    faults = []
    if drawers is not None:
        fill, low = _fill(drawers[:, long], lo[long], hi[long]), drawers[:, 2].min()
        solid += max(rise + floor - low - solid, 0.0) * np.clip((fill - 0.7) / 0.25, 0, 1)
        depth = np.ptp(drawers[:, 1 - long]) / unit
        faults += [0.8 * outside(fill, 0.12, 1.1), 0.8 * outside(depth, 0.5, 1.15)]
        faults += [0.8 * outside(1 + 3 * (low - floor) / rise, 1.0, 1.3)]
    m = {
        "aspect": size.max() / unit,
        "rise": rise / unit,
        "body": min(solid / rise, 1.0),
        "leg": 0.06,
        "slab": thick / unit,
        "stretch": size.max() / np.sqrt(unit * rise),
        "legs": max(rise - solid, 0.0) / np.sqrt(size.prod()),
    }
    faults += [0.8 * outside(m["slab"] / m["rise"], 0.003, 0.34)]
    if body is not None:
        faults += [outside(s, 0.58, 1.06) for s in np.ptp(body, 0)[:2] / size]
    if leg is not None:
        m["leg"] = _leg_thickness(shape) / unit
        faults += _leg_faults(shape, leg, m["leg"], size, rise, floor)
    elif m["body"] < 0.8 and drawers is None:
        faults += [0.9]
    faults += _extra_faults(shape, size, rise, floor, long)
    return m, faults


def _thickness(top):
    """Thickness of a tilted top: what lies off its best plane."""
    base = np.column_stack([top[:, :2] - top[:, :2].mean(0), np.ones(len(top))])
    return np.ptp(top[:, 2] - base @ np.linalg.lstsq(base, top[:, 2], rcond=None)[0])


def _fill(x, low, high):
    """Share of the top's length above drawers."""
    ends = [x[x < (low + high) / 2], x[x >= (low + high) / 2]]
    return sum(np.ptp(e) for e in ends if len(e)) / (high - low)


def _leg_thickness(shape):
    """Median thickness of the upright legs, at their ends and middle (a stem: in the middle)."""
    found = []
    legs = [p.vertices for p in shape.parts if p.label == "leg"]
    tallest = max(np.ptp(v[:, 2]) for v in legs)
    for v in legs[:6]:
        z = v[:, 2]
        t = (z - z.min()) / max(np.ptp(z), 1e-9)
        if np.ptp(z) < 0.6 * tallest:
            continue
        middle = np.abs(t - 0.5) < 0.07
        if shape.traits["base"] == "pedestal" and middle.sum() >= 4:
            found.append(np.ptp(v[middle, :2], 0).min())
        else:
            slices = [v[s, :2] for s in (t < 0.1, middle, t > 0.9) if s.sum() >= 4]
            found.append(
                np.median([np.ptp(s, 0).min() for s in slices]) if slices else np.ptp(v[:, :2], 0).min()
            )
    return np.median(found)


def _leg_faults(shape, leg, thick, size, rise, floor):
    base = shape.traits["base"]
    spread = np.ptp(leg, 0)[:2] / size
    ends = leg[leg[:, 2] > leg[:, 2].max() - 0.1 * np.ptp(leg[:, 2])]
    faults = [outside(s, 0.02, 1.04) for s in np.ptp(ends, 0)[:2] / size]  # legs end under the top
    lift = 1 + 3 * (leg[:, 2].min() - floor) / rise
    if base == "drawers":
        return [*faults, 0.8 * outside(thick, 0.015, 0.3), 0.8 * outside(lift, 1.0, 1.2)]
    if base == "benches":
        faults += [outside(spread.min(), 0.45, 1.2), outside(spread.max(), 1.2, 2.9)]
    else:
        faults += [outside(s, 0.2 if base == "pedestal" else 0.58, 1.25) for s in spread]
    if shape.points("body") is None or leg[:, 2].min() < shape.points("body")[:, 2].min():
        faults.append(0.8 * outside(lift, 1.0, 1.1))
    if base == "hairpin":
        return [*faults, outside(thick, 0.006, 0.27)]
    faults.append(outside(thick, 0.012 if base == "panels" else 0.016, 0.3))
    if base in ("legs", "curved", "pedestal"):
        sizes = [np.ptp(p.vertices, 0) for p in shape.parts if p.label == "leg"]
        oval = np.median([s[0] / s[1] for s in sizes])
        faults.append(0.7 * outside(oval, 0.45, 2.2))
    return faults


def _extra_faults(shape, size, rise, floor, long):
    faults = []
    bench, mirror = shape.points("bench"), shape.points("mirror")
    between = shape.points("shelf", "rail")
    if between is not None:
        faults += [0.9 * outside(s, 0.001, 1.1) for s in np.ptp(between, 0)[:2] / size]
        faults += [0.6 * outside((between[:, 2].max() - floor) / rise, 0.02, 1.0)]
    if bench is not None:
        high = (bench[:, 2].max() - floor) / rise
        faults += [outside(high, 0.38, 0.8), 0.8 * outside(np.ptp(bench[:, long]) / size.max(), 0.55, 1.3)]
        faults += [outside(np.ptp(bench[:, 1 - long]) / size.min(), 1.5, 3.6)]
    if mirror is not None:
        spread = np.ptp(mirror, 0)
        faults += [0.8 * outside(spread[long] / size.max(), 0.25, 1.05)]
        faults += [0.8 * outside(spread[1 - long] / size.min(), 0.02, 0.25)]
        faults += [0.6 * outside(spread[2] / size.min(), 0.4, 2.2)]
    return faults


def resembles(shape, proportions):
    """A table seen as a seat without a back, or as a cabinet where its body is nearly its whole height."""
    if any(shape.traits[t] for t in ("tilted", "mirror", "benches")):
        return None
    aspect, rise, body = (proportions[n] for n in ("aspect", "rise", "body"))
    if body > CABINET:
        if shape.traits["round"]:
            return None
        seen = {"height": rise / aspect, "deep": 1 / aspect, "legs": 1 - body}
        return "cabinets", seen, {"front": "doors", "ladder": False}
    seen = {
        "aspect": aspect,
        "rise": rise,
        "back": 0.0,
        "arm": 0.0,
        "slim": body * rise,
        "open": 1 - body,
        "leg": proportions["leg"],
        "legs": 1 - body,
    }
    return "seats", seen, {"base": "legs"}
