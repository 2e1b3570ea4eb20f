# SPDX-License-Identifier: MIT OR Apache-2.0
"""Bottles, jars, vases and jugs: a body that carries a neck.

No front, though a handle or a lip may look along x or y; the unit is the width of the body (the mean of x
and y).
"""

import numpy as np

from .axis import amount, outside, ratio
from .shape import Shape
from .solids import cushion, lathe
from .vessels import ear, girth, grip, grip_width, inside, pour, turn

RANGES = {
    "height": ratio(0.5, 7.0),
    "neck": amount(0.02, 0.75),
    "throat": ratio(0.1, 1.1),
    "foot": ratio(0.15, 1.1),
    "handle": amount(0.0, 0.6),
}
SIDES = 16
FULL = 1 / np.cos(np.pi / SIDES)  # makes a polygon as wide as its circle


def build(p, traits, rng):
    """A bottle with the parameters of `RANGES`.

    The traits are handles, squared and stopper (drawn when missing).
    """
    height, throat, base = p["height"], p["throat"] / 2, p["foot"] / 2
    shoulder = height * (1 - p["neck"])
    handles = traits.get("handles") or int(rng.choice([1, 1, 2])) if p["handle"] > 0.08 else 0
    squared = traits.get(
        "squared", handles == 0 and p["foot"] > 0.75 and (throat < 0.3 or height < 1.7) and rng.random() < 0.2
    )
    stopper = traits.get("stopper", p["foot"] > 0.7 and rng.random() < (0.1 if handles else 0.35))
    shape = Shape("bottles", traits={"handles": handles, "squared": squared, "stopper": stopper})
    aspect = rng.choice([1.0, rng.uniform(1, 2.2)]) if squared else 1.0
    plan = {"roundness": rng.uniform(4, 8) if squared else 2.0, "sides": 20 if squared else SIDES}
    full = 1.0 if squared else FULL
    plan["squash"] = (2 * full * aspect / (1 + aspect), 2 * full / (1 + aspect))
    rise, bottom = 0.0, base
    if p["foot"] < 0.82 and shoulder > 0.5 and rng.random() < 0.45:
        rise = min(rng.uniform(0.03, 0.14) * shoulder, 0.25)
        bottom = base * rng.uniform(0.5, 0.95)
    root = throat * (rng.uniform(1.0, 1.12) if rng.random() < 0.6 else rng.uniform(1.0, 1.6))
    root = min(root, max(0.47, throat))
    outer = _wall(rng, rise, shoulder, bottom, root, height)
    hollow = throat > 0.2 and not stopper
    shape.add("body", lathe(outer + (inside(outer, rng) if hollow else []), **plan))
    if rise:
        profile = [(base, 0), (base, 0.3 * rise), (0.5 * (base + bottom), 0.5 * rise), (bottom, rise)]
        shape.add("foot", lathe(profile, **plan), (0, 0, rise), "body")
    # A neck as wide as the body follows the body's plan; a narrow one is round.
    neck_plan = plan if p["throat"] > 0.6 else {"sides": SIDES, "squash": (FULL, FULL)}
    bottle = stopper or (p["foot"] > 0.78 and height > 1.4)
    neck = _neck(rng, shoulder, height, throat, root, hollow, 1.15 if bottle else 1.9)
    mouth = neck[10][0]
    spout = handles == 1 and not stopper and rng.random() < 0.7
    solid = lathe(neck, caps=not hollow, **neck_plan)
    if spout:
        solid = pour(solid, shoulder, height, rng.uniform(0.15, 0.5) * mouth)
    shape.add("neck", solid, (0, 0, shoulder), "body")
    if handles:
        _ears(shape, rng, outer + neck[:11], p["handle"], handles, rise, shoulder, height)
    if stopper:
        _stopper(shape, rng, height, mouth)
    turn(shape, rng.choice(4, p=[0.4, 0.1, 0.4, 0.1]))
    return shape


def _wall(rng, low, high, bottom, top, height):
    """The outside of the body as (radius, z): out to the belly, then in to the root of the neck."""
    style = "belly"
    if bottom > 0.39:
        style = rng.choice(
            ["straight", "globe", "cone"], p=[0.92, 0.05, 0.03] if height > 2.4 else [0.7, 0.2, 0.1]
        )
    tall = high - low
    if style == "straight":
        drop = max(0.5 - top, 0.02) * rng.uniform(0.5, 1.8)
        begin, end = min(0.12 / tall, 0.2) * rng.uniform(0.4, 1), 1 - min(drop / tall, 0.5)
    elif style == "cone":
        begin = end = 0.05
    else:
        begin = end = rng.uniform(0.4, 0.6) if style == "globe" else rng.uniform(0.35, 0.8)
    t = np.linspace(0, 1, 7)
    out = np.sin(t * np.pi / 2) ** rng.uniform(0.7, 1.1)
    if style == "belly" and rng.random() < 0.25:
        out = (1 - np.cos(t * np.pi)) / 2
    shoulder = rng.choice(["round", "eased", "line"], p=[0.45, 0.45, 0.1])
    if style == "cone" or shoulder == "line":
        back = 1 - t
    elif shoulder == "round":
        back = np.cos(t * np.pi / 2) ** rng.uniform(0.6, 1.0)
    else:
        back = (1 + np.cos(t * np.pi)) / 2
    r = np.concatenate([bottom + (0.5 - bottom) * out, top + (0.5 - top) * back])
    z = np.concatenate([begin * t, end + (1 - end) * t])
    return list(zip(r, low + tall * z, strict=True))


def _neck(rng, low, high, throat, root, hollow, most):
    """The neck as (radius, z), waisted to `throat`: eleven points up the outside, then the bore."""
    u = np.linspace(0, 1, 11)
    waist = rng.uniform(0.35, 0.65)
    flare = min(
        rng.choice([1.0, rng.uniform(1.0, 1.25), rng.uniform(1.2, 1.9)]),
        most,
        max(1.0, 0.58 / throat),
        1 + 2 * (high - low) / throat,
    )
    below, above = np.clip(1 - u / waist, 0, 1), np.clip((u - waist) / (1 - waist), 0, 1)
    r = throat + (root - throat) * below**1.5 + throat * (flare - 1) * above**2
    if rng.random() < 0.5:
        r[-2:] += min(0.12 * throat, 0.03)
    z = low + (high - low) * u
    profile = list(zip(r, z, strict=True))
    bore = max(1 - 0.05 / throat, 0.7)
    if hollow:
        return profile + [(r[i] * bore, z[i]) for i in (-1, -3, -6, -9, 0)]
    return [*profile, (r[-1] * bore, z[-1]), (r[-1] * bore * 0.95, z[-3])]


def _ears(shape, rng, wall, reach, count, rise, shoulder, height):
    """One or two handles between a point of the body and one higher up."""
    radius, z = np.array(wall).T
    across = np.ptp(shape.points("body")[:, 0]) / 2
    size = min(rng.uniform(0.03, 0.06), 0.25 * reach)
    head = shoulder + (height - shoulder) * rng.uniform(0.5, 0.9)
    if height - shoulder < 0.15 * height:
        head = rise + (height - rise) * rng.uniform(0.75, 0.95)
    top = np.interp(head, z, radius)
    foot = rise + (head - rise) * np.linspace(rng.uniform(0.15, 0.6), 0.93, 12)
    spread = np.interp(foot, z, radius)
    # The lower end climbs the shoulder until the handle bows out beyond it.
    fits = (np.abs(spread - top) < 0.55 * reach) & (head - foot > 3 * size)
    i = np.argmax(fits) if fits.any() else int(np.argmin(np.abs(spread - top)))
    inner = np.array([spread[i], top]) * across / 0.5
    outer = inner.min() + reach
    solid = ear(rng, inner, outer, foot[i], head, size)
    attach = (inner[0], 0, foot[i])
    if count == 2:
        shape.add_pair("handle", solid, attach, "body")
    else:
        shape.add("handle", solid, attach, "body")


def _stopper(shape, rng, height, mouth):
    """A cap over the rim, a cork or a ball."""
    style = rng.choice(["cap", "cap", "cork", "ball"])
    tall = min(mouth * rng.uniform(0.5, 1.6), 0.22 * height)
    if style == "ball":
        wide = mouth * rng.uniform(0.8, 1.25)
        solid = cushion((0, 0, height + tall * 0.6), (wide, wide, tall * 0.7), rng.uniform(2, 4), 12)
    elif style == "cork":
        solid = lathe([(mouth * 0.8, height - 0.01), (mouth * 0.9, height + tall * 0.6)], sides=12)
    else:
        wide, low = mouth * rng.uniform(1.02, 1.2), height - min(0.05, 0.3 * mouth)
        solid = lathe([(wide, low), (wide, height + tall * 0.8), (wide * 0.9, height + tall * 0.9)], sides=12)
    shape.add("stopper", solid, (0, 0, height), "neck")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    body, neck, stand = shape.points("body"), shape.points("neck"), shape.points("foot")
    handle, stopper = shape.points("handle"), shape.points("stopper")
    size = np.ptp(body, 0)
    width = size[:2].mean()
    top = body[:, 2].max()
    rest = body if stand is None else np.concatenate([body, stand])
    floor = rest[:, 2].min()
    height = top - floor
    aspect = size[0] / size[1]
    most = 2.6 if shape.traits["squared"] else 1.15
    ground = rest[rest[:, 2] < floor + 0.015 * height + 1e-6]
    m = {"foot": girth(ground) / width, "handle": 0.0, "neck": 0.02, "throat": 0.1}
    faults = [outside(aspect, 1 / most, most), 0.8 * outside(m["foot"], 0.14, 1.2)]
    if neck is None:
        m["height"] = height / width
        faults.append(0.8)
    else:
        rings, spread = _rings(neck)
        height = max(neck[:, 2].max(), top) - floor
        m["neck"], m["throat"] = max(neck[:, 2].max() - top, 0) / height, rings.min() / width
        collar = body[body[:, 2] > top - 0.02 * size[2]]
        faults += [
            0.8 * outside(spread, min(0.85, 0.85 * aspect), max(1.18, 1.18 * aspect)),
            outside(rings[0] / girth(collar), 0.75, 1.4),
            0.8 * outside(rings.max() / width, 0.09, 1.25),
        ]
        if stopper is not None:
            cap = np.ptp(stopper, 0)
            faults += [
                0.7 * outside(cap[:2].mean() / rings[-1], 0.5, 1.6),
                0.6 * outside(cap[0] / cap[1], 0.8, 1.25),
            ]
            faults += [0.7 * outside(cap[2] / height, 0.005, 0.35)]
    m["height"] = height / width
    if stand is not None:
        each = np.ptp(stand, 0)
        faults += [
            0.8 * outside(each[0] / each[1] / aspect, 0.85, 1.18),
            0.7 * outside(each[2] / height, 0.005, 0.3),
        ]
    if handle is not None:
        middle = (body.min(0) + body.max(0))[:2] / 2
        m["handle"], root = grip(handle, middle, width)
        tall = np.ptp(handle[:, 2])
        faults += [
            0.8 * outside(tall / height, 0.1, 1.0),
            0.8 * outside(grip_width(shape) / width, 0.02, 0.22),
            0.8 * outside(m["handle"], 0.02, 0.65),
            0.8 * outside(root, 0.04, 0.58),
            0.6 * outside((handle[:, 2].max() - floor) / height, 0.3, 1.06),
        ]
    return m, faults


def _rings(neck):
    """Widths of the neck up its height, and its x extent over its y extent."""
    low, high = neck[:, 2].min(), neck[:, 2].max()
    level = np.minimum((neck[:, 2] - low) / max(high - low, 1e-9) * 8, 7).astype(int)
    widths = np.array([girth(neck[level == i]) for i in range(8) if (level == i).any()])
    size = np.ptp(neck, 0)
    return widths, size[0] / size[1]


def resembles(shape, m):
    """A jar or a jug with a mouth as wide as its body, seen as a cup."""
    if m["throat"] < 0.75 or m["neck"] > 0.14 or m["height"] > 3 or shape.traits["stopper"]:
        return None
    seen = {"height": m["height"], "stem": 0.0, "base": m["foot"], "handle": m["handle"], "spout": 0.0}
    return "cups", seen, {"grip": ("none", "ear", "ears")[shape.traits["handles"]], "lid": False}
