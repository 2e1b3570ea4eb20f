# SPDX-License-Identifier: MIT OR Apache-2.0
"""Cabinets and shelves: a carcass with doors, drawers or open shelves.

The front looks to -y; the unit is the width.
"""

import numpy as np

from .axis import amount, outside, ratio
from .cabinet_fronts import add_fronts, add_glass, add_lid
from .shape import Shape
from .solids import bar, block, lathe

RANGES = {
    "height": ratio(0.15, 7.0),
    "deep": ratio(0.08, 2.2),
    "legs": amount(0.0, 0.6),
}
FRONTS = ("doors", "doors", "drawers", "mixed", "open", "open", "glass")
SEE_THROUGH = ("open", "glass")
BOARD = 0.035  # thickness of boards, as a share of the smaller side of the front


def build(p, traits, rng):
    """A cabinet with the parameters of `RANGES` and the traits front, ladder (missing ones are drawn)."""
    height, deep = p["height"], p["deep"]
    legs = p["legs"] * height if p["legs"] > 0.02 else 0.0
    front, ladder = _traits(traits, height, deep, rng)
    shape = Shape("cabinets", traits={"front": front, "ladder": ladder})
    if ladder:
        _ladder(shape, rng, height, deep)
        return shape
    foot = 0.0 if legs or rng.random() < 0.4 else rng.uniform(0.02, 0.06) * height
    top = height
    dome = 0.0
    if front == "lid":
        dome = rng.choice([0.0, rng.uniform(0.1, 0.3)]) * min(height - legs, deep)
        top -= dome
    elif rng.random() < 0.35:
        top -= rng.uniform(0.02, 0.05) * min(height, 2.0)
    box = (deep / 2, legs, top)
    if front in SEE_THROUGH:
        _open(shape, rng, box, foot)
    else:
        _closed(shape, rng, box, foot)
    if top < height and not dome:
        _plate(shape, rng, deep / 2, top, height)
    if front == "lid":
        add_lid(shape, rng, box, foot, dome)
    elif front == "glass":
        add_glass(shape, rng, box, foot)
    elif front != "open":
        add_fronts(shape, rng, box, foot, front)
    if legs:
        _legs(shape, rng, deep / 2, legs, height)
    return shape


def _traits(traits, height, deep, rng):
    """The wanted front and whether the sides lean, drawn where missing and kept to what can be built."""
    front = str(traits.get("front", rng.choice(FRONTS)))
    ladder = traits.get("ladder", front == "open" and rng.random() < 0.07)
    if ladder and 1.6 < height < 5 and 0.25 < deep < 1.2:
        return "open", True
    if (front == "lid" and height > 0.9) or (front in ("vent", "fridge") and height < 1):
        front = "doors"
    return front, False


def _plate(shape, rng, half, low, high):
    """A top that may stand out over the front and the sides."""
    over = rng.choice([0.0, 0.02, 0.05]) * min(1.0, 4 * half)
    plate = block((-0.5 - over, -half - over, low), (0.5 + over, half, high), 0.01)
    shape.add("top", plate, (0, 0, low), "carcass")


def _closed(shape, rng, box, foot):
    """A box, perhaps on a foot that stands back."""
    half, low, high = box
    shape.add("carcass", block((-0.5, -half, low + foot), (0.5, half, high), rng.choice([0.0, 0.0, 0.015])))
    if foot:
        inset = rng.choice([0.0, 0.02, 0.04]) * min(1.0, 2 * half)
        foot_box = block((-0.5 + inset, -half + inset, low), (0.5 - inset, half, low + foot))
        shape.add("carcass", foot_box)


def _open(shape, rng, box, foot):
    """Sides, boards, often a back, and a grid of shelves."""
    half, low, high = box
    t = BOARD * rng.uniform(0.7, 1.4) * min(1.0, high - low)
    if rng.random() < 0.8:
        shape.add_pair("carcass", block((0.5 - t, -half, low), (0.5, half, high)))
    else:
        post = min(t * 0.8, 0.3 * half)
        for s in (-1, 1):
            y = s * (half - post)
            shape.add_pair("carcass", block((0.5 - 2 * post, y - post, low), (0.5, y + post, high)))
    shape.add("carcass", block((-0.5, -half, high - t), (0.5, half, high)))
    shape.add("carcass", block((-0.5, -half, low + foot), (0.5, half, low + foot + t)))
    if rng.random() < 0.65:
        shape.add("carcass", block((-0.5, half - 0.3 * t, low + foot), (0.5, half, high)))
    rows = round((high - low) / rng.uniform(0.32, 0.55)) if high - low > 1.2 else int(rng.integers(1, 4))
    columns = max(1, round(rng.uniform(0.5, 1.6) / max(high - low, 0.35)))
    low += foot
    for z in np.linspace(low, high, min(max(rows, 1), 8) + 1)[1:-1]:
        shelf = block((-0.5 + t, -0.95 * half, z - t / 2), (0.5 - t, half, z + t / 2))
        shape.add("shelf", shelf, (0, 0, z), "carcass")
    for x in np.linspace(-0.5, 0.5, min(columns, 5) + 1)[1:-1]:
        board = block((x - t / 2, -0.95 * half, low), (x + t / 2, half, high))
        shape.add("divider", board, (x, 0, low), "carcass")


def _legs(shape, rng, half, legs, height):
    """Four legs: straight, splayed, turned, or joined to frames."""
    r = min(rng.uniform(0.018, 0.04), 0.28 * half) * (1 if height < 3 else 1.3)
    taper = rng.choice([1.0, rng.uniform(0.5, 1.0)])
    style = rng.choice(["four", "four", "splayed", "frame", "round"])
    splay = rng.uniform(0.1, 0.3) * min(legs, 0.3) if style == "splayed" else 0.0
    sides, x, y = (10 if style in ("splayed", "round") else 4), 0.48 - r, 0.94 * half - r
    for s in (-1, 1):
        at = (x, s * y, legs + 0.01)
        foot = (x + splay, s * (y + 0.3 * splay), 0)
        if style == "round":
            leg = lathe([(0.7 * r, 0), (r, 0.3 * legs), (1.4 * r, 0.7 * legs), (r, legs + 0.01)], at[:2], 10)
        else:
            leg = bar(at, foot, r, r * taper, sides)
        shape.add_pair("leg", leg, at, "carcass")
    if style == "frame":
        z = min(r, 0.4 * legs)
        shape.add_pair("leg", bar((x, -y, z), (x, y, z), (r, z)), (x, 0, legs), "carcass")


def _ladder(shape, rng, height, deep):
    """Shelves that grow shallower upwards, between leaning sides."""
    half, t, thin = deep / 2, 0.03, rng.uniform(0.2, 0.5)
    easel = rng.random() < 0.5  # stands like an easel, or leans on a wall
    back = np.array([half, half * thin if easel else half])
    front = np.array([-half, -half * thin if easel else half - thin * deep])
    x, r = 0.5 - t, t * rng.uniform(0.6, 1.0)
    for y in (front * (1 - r / half), back * (1 - r / half)):
        shape.add_pair("carcass", bar((x, y[0], 0), (x, y[1], height), r))
    for share in np.linspace(0.1, 0.97, int(rng.integers(3, 6))):
        a, b = (y[0] + (y[1] - y[0]) * share for y in (front, back))
        z = share * height
        shape.add("shelf", block((-x, a, z - 0.035), (x, b, z)), (0, 0, z), "carcass")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    carcass, leg = shape.points("carcass"), shape.points("leg")
    lo, hi = carcass.min(0), carcass.max(0)
    size = hi - lo
    every = np.concatenate([p.vertices for p in shape.parts])
    floor, top = every[:, 2].min(), every[:, 2].max()
    height = top - floor
    m = {
        "height": height / size[0],
        "deep": size[1] / size[0],
        "legs": 0.0 if leg is None else max(lo[2] - floor, 0.0) / height,
    }
    faults = [0.8 * outside(size[2] / height, 0.35, 1.0)]
    faults += _front_faults(shape, size) + _shelf_faults(shape, size, hi[2])
    top = shape.points("top")
    if top is not None:
        spread = np.ptp(top, 0) / size
        faults += [outside(s, 0.88, 1.2) for s in spread[:2]]
        faults += [0.7 * outside(spread[2], 0.004, 0.7)]
    if leg is not None:
        faults += _leg_faults(shape, leg, size)
        faults += [0.8 * outside(1 + 3 * (leg[:, 2].min() - floor) / height, 1.0, 1.05)]
    return m, faults


def _front_faults(shape, size):
    front = shape.points("front")
    if front is None:
        return []
    spread, lid = np.ptp(front, 0) / size, shape.traits["front"] == "lid"
    return [
        outside(spread[0], 0.78, 1.07),
        outside(spread[2], 0.02 if lid else 0.62, 1.05),
        0.6 * outside(np.ptp(front[:, 1]) / size[:2].min(), 0.01, 1.4 if lid else 0.6),
    ]


def _shelf_faults(shape, size, top):
    shelf, divider = shape.points("shelf"), shape.points("divider")
    faults = []
    if shelf is not None:
        thick = np.median([np.ptp(p.vertices[:, 2]) for p in shape.parts if p.label == "shelf"])
        spread = np.ptp(shelf, 0) / size
        faults += [outside(spread[0], 0.78, 1.05), outside(spread[1], 0.5, 1.06)]
        faults += [0.7 * outside(thick / size[[0, 2]].min(), 0.006, 0.1)]
        faults += [0.8 * outside(1 + (shelf[:, 2].max() - top) / size[2], 0.2, 1.02)]
    if divider is not None:
        spread = np.ptp(divider, 0) / size
        faults += [outside(spread[1], 0.5, 1.06), outside(spread[2], 0.6, 1.05)]
        faults += [0.7 * outside(spread[0], 0.001, 1.02)]
    return faults


def _leg_faults(shape, leg, size):
    sizes = np.array([np.ptp(p.vertices, 0) for p in shape.parts if p.label == "leg"])
    sizes = sizes[sizes[:, 2] > 0.5 * sizes[:, 2].max()]
    spread = np.ptp(leg, 0)[:2] / size[:2]
    faults = [outside(spread[0], 0.7, 1.25), outside(spread[1], 0.6, 1.4)]
    faults.append(0.9 * outside(np.median(sizes[:, :2].min(1)) / size[:2].min(), 0.008, 0.42))
    faults.append(0.7 * outside(np.median(sizes[:, 0] / sizes[:, 1]), 0.4, 2.5))
    return faults


def resembles(shape, proportions):
    """A cabinet seen as a table with a body of nearly its whole height."""
    if shape.traits["ladder"] or proportions["legs"] > 0.7:
        return None
    height, deep = proportions["height"], proportions["deep"]
    unit = min(1.0, deep)
    seen = {
        "aspect": max(1.0, deep) / unit,
        "rise": height / unit,
        "body": 1 - proportions["legs"],
        "leg": 0.06,
        "slab": 0.04,
        "stretch": max(1.0, deep) / np.sqrt(unit * height),
        "legs": proportions["legs"] * height / np.sqrt(deep),
    }
    return "tables", seen, {"round": False, "tilted": False, "mirror": False, "benches": False}
