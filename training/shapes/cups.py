# SPDX-License-Identifier: MIT OR Apache-2.0
"""Cups, glasses, bowls, pots and pans: an open body, on a stem or not.

No front, though a handle may look along x or y; the unit is the width of the body (the mean of x and y).
"""

import numpy as np

from .axis import amount, outside, ratio
from .cup_handles import add_handle, add_spout, measure_handle
from .shape import Shape
from .solids import lathe
from .vessels import girth, grip, grip_width, inside, turn

RANGES = {
    "height": ratio(0.05, 6.0),
    "stem": amount(0.0, 0.75),
    "base": ratio(0.15, 1.3),
    "handle": amount(0.0, 1.4),
    "spout": amount(0.0, 0.8),
}
GRIPS = ("none", "ear", "ears", "stick", "bail")


def build(p, traits, rng):
    """A vessel with the parameters of `RANGES` and the traits grip (of `GRIPS`) and lid (else drawn)."""
    height, base = p["height"], p["base"] / 2
    rise = p["stem"] * height if p["stem"] > 0.035 else 0.0
    base = max(base, 0.16) if p["stem"] > 0.12 else min(base, 0.5)
    spouted = p["spout"] > 0.1
    held = "none"
    if p["handle"] > 0.08:
        held = traits.get("grip", "none")
        held = _usual_grip(p, rng) if held == "none" else held
        if held == "ear" and height - rise < 0.3:
            held = "stick" if p["handle"] > 0.35 else "ears"
    likely = 0.7 if spouted else 0.3 if held in ("ears", "stick") else 0.0
    lid = p["stem"] < 0.12 and traits.get("lid", rng.random() < likely)
    shape = Shape("cups", traits={"grip": held, "lid": lid})
    sides = int(rng.choice([12, 16, 20]))
    full = 1 / np.cos(np.pi / sides)
    plan = {"sides": sides, "squash": (full, full)}
    outer = _wall(rng, p, rise, base)
    _body(shape, rng, outer, plan, lid)
    if rise:
        _stand(shape, rng, rise, base, outer[0][0], plan)
    if held != "none":
        add_handle(shape, rng, outer, p, held, rise)
    if lid:
        _lid(shape, rng, height, outer[-1][0], plan)
    if spouted:
        add_spout(shape, rng, outer, p["spout"], rise)
    turn(shape, rng.choice(4, p=[0.4, 0.1, 0.4, 0.1]))
    return shape


def _usual_grip(p, rng):
    """The grip that the proportions suggest."""
    if p["spout"] > 0.1 or p["stem"] > 0.15:
        return "ear"
    if p["handle"] > 0.55:
        return "stick" if p["height"] < 0.85 else "bail"
    return str(rng.choice(["ear", "ear", "ears"]))


def _wall(rng, p, low, base):
    """The outside of the body as (radius, z), from the bottom up to the rim."""
    tall = p["height"] - low
    bottom, belly, mouth = base, 1.0, 0.5
    t = np.linspace(0, 1, 8)
    if p["stem"] > 0.12:
        bottom = rng.uniform(0.03, 0.08)
        style = rng.choice(["round", "tulip", "line"], p=[0.45, 0.4, 0.15])
        if p["stem"] > 0.52 and tall < 0.8:
            style = rng.choice(["line", "line", "round"])
    elif low and base > 0.33:
        bottom = base * rng.uniform(0.88, 1.0)
        style = rng.choice(["line", "straight", "round"])
    elif low:
        bottom = base * rng.uniform(0.7, 1.0)
        style = rng.choice(["round", "eased"])
    elif base < 0.33:
        style = rng.choice(["round", "round", "line"])
    else:
        style = rng.choice(["line", "straight", "round"], p=[0.5, 0.4, 0.1])
    if p["spout"] > 0.1:
        style = rng.choice(["pot", "pot", "straight"]) if p["height"] < 1.3 else rng.choice(["pot", "cone"])
    if style == "line":
        out = t
    elif style == "cone":
        return _cone(rng, low, tall)
    elif style == "eased":
        out = (1 - np.cos(t * np.pi)) / 2
    elif style == "straight":
        belly, out = min(0.25, 0.15 / tall), np.sin(t * np.pi / 2)
    else:
        belly = {"tulip": rng.uniform(0.3, 0.6), "pot": rng.uniform(0.3, 0.6)}.get(style, 1.0)
        out = np.sin(t * np.pi / 2) ** rng.uniform(0.6, 1.0)
    if style == "tulip":
        mouth = 0.5 * rng.uniform(0.7, 0.95)
    elif style == "pot":
        mouth = 0.5 * rng.uniform(0.4, 0.75)
    r, z = bottom + (0.5 - bottom) * out, belly * t
    if belly < 1:
        r = np.concatenate([r, mouth + (0.5 - mouth) * np.cos(t[1:] * np.pi / 2) ** 0.9])
        z = np.concatenate([z, belly + (1 - belly) * t[1:]])
    return list(zip(r, low + tall * z, strict=True))


def _cone(rng, low, tall):
    """The wall of a coffee pot, widest at its floor."""
    t = np.linspace(0, 1, 8)
    mouth = 0.5 * rng.uniform(0.5, 0.85)
    return list(zip(0.5 + (mouth - 0.5) * t, low + tall * t, strict=True))


def _body(shape, rng, outer, plan, lid):
    """A thick wall, a thin open one, or one filled nearly to the rim."""
    style = rng.choice(["thick", "thin", "filled"], p=[0.7, 0.15, 0.15])
    if lid or style == "filled":
        low, high = outer[0][1], outer[-1][1]
        level = high - min(0.06, 0.12 * (high - low))
        rim = 0.95 * outer[-1][0]
        solid = lathe([*outer, (rim, high), (rim, level)], **plan)
    elif style == "thin":
        solid = lathe([(1e-3, outer[0][1]), *outer], caps=False, **plan)
    else:
        solid = lathe(outer + inside(outer, rng), **plan)
    shape.add("body", solid)


def _stand(shape, rng, rise, base, joint, plan):
    """A stem on a foot, or a low foot alone."""
    if joint > 0.09:
        shape.add("foot", lathe([(base, 0), (base, rise * 0.3), (joint, rise)], **plan), (0, 0, rise), "body")
        return
    low = min(rng.uniform(0.02, 0.08), 0.2 * rise)
    t = np.linspace(0, 1, 6)
    slope = min(rng.uniform(0.04, 0.14), 0.35 * rise)
    thin = joint * rng.uniform(0.5, 0.95)
    edge = thin + (base - thin) * (1 - t) ** rng.uniform(0.9, 2.2)
    foot = [(base, 0), *zip(edge, low + slope * t, strict=True)]
    z = np.linspace(low + slope, rise, 7)
    r = np.full(7, thin)
    r[-1] = joint
    knob = rng.integers(1, 6)
    if rng.random() < 0.4:
        r[knob] *= rng.uniform(1.4, 2.6)
    shape.add("stem", lathe(list(zip(r, z, strict=True)), **plan), (0, 0, rise), "body")
    shape.add("foot", lathe(foot, **plan), (0, 0, z[0]), "stem")


def _lid(shape, rng, height, mouth, plan):
    """A dome with a knob over the mouth."""
    edge = mouth * rng.uniform(0.95, 1.08)
    tall = mouth * rng.choice([rng.uniform(0.04, 0.12), rng.uniform(0.15, 0.5)])
    t = np.linspace(0, 0.46 * np.pi, 5)
    dome = [(edge * np.cos(a), height + 0.02 * mouth + tall * np.sin(a)) for a in t]
    top, knob = dome[-1][1], mouth * rng.uniform(0.1, 0.22)
    neck = [
        (knob * 0.6, top),
        (knob * 0.6, top + 0.5 * knob),
        (knob, top + knob),
        (knob * 0.7, top + 1.7 * knob),
    ]
    shape.add("lid", lathe([(edge, height), *dome, *neck], **plan), (0, 0, height), "body")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    body, stem, foot = shape.points("body"), shape.points("stem"), shape.points("foot")
    lo, hi = body.min(0), body.max(0)
    size = hi - lo
    width = size[:2].mean()
    rest = np.concatenate([part for part in (body, stem, foot) if part is not None])
    floor = min(rest[:, 2].min(), hi[2])
    height = hi[2] - floor
    ground = rest[rest[:, 2] < floor + 0.012 * height + 1e-6]
    m = {
        "height": height / width,
        "stem": (lo[2] - floor) / height,
        "base": girth(ground) / width,
        "handle": 0.0,
        "spout": 0.0,
    }
    faults = [outside(size[0] / size[1], 0.87, 1.15), 0.8 * outside(m["base"], 0.14, 1.4)]
    if stem is not None:
        each = np.ptp(stem, 0)
        faults += [
            0.7 * outside(each[:2].mean() / width, 0.03, 0.42),
            0.6 * outside(each[0] / each[1], 0.6, 1.6),
        ]
        faults += [0.8 * outside(m["base"], 0.3, 1.4)]
    if foot is not None:
        each = np.ptp(foot, 0)
        faults += [0.8 * outside(each[0] / each[1], 0.85, 1.18), 0.7 * outside(each[2] / height, 0.002, 0.3)]
    middle = (lo + hi)[:2] / 2
    handle, lid, spout = shape.points("handle"), shape.points("lid"), shape.points("spout")
    if handle is not None:
        m["handle"], more = measure_handle(handle, shape.traits["grip"], body, middle, width, height)
        faults += more
        if shape.traits["grip"] in ("ear", "stick"):
            faults.append(0.8 * outside(grip_width(shape) / width, 0.02, 0.24))
    if lid is not None:
        mouth = girth(body[body[:, 2] > hi[2] - 0.02 * size[2]])
        cap = np.ptp(lid, 0)
        faults += [
            0.8 * outside(cap[:2].mean() / mouth, 0.8, 1.25),
            0.6 * outside(cap[0] / cap[1], 0.8, 1.25),
        ]
        faults += [0.7 * outside(cap[2] / mouth, 0.02, 0.6)]
    if spout is not None:
        m["spout"], root = grip(spout, middle, width)
        faults += [
            0.8 * outside(root, 0.1, 0.56),
            0.6 * outside(np.ptp(spout[:, 2]) / height, 0.15, 1.1),
            0.6 * outside((spout[:, 2].max() - floor) / height, 0.6, 1.35),
        ]
    return m, faults


def resembles(shape, m):
    """A tall straight vessel without a spout, seen as a jar."""
    if m["stem"] > 0.12 or m["spout"] > 0.05 or m["height"] < 0.8 or shape.traits["grip"] == "bail":
        return None
    body = shape.points("body")
    top = body[:, 2].max()
    rim = girth(body[body[:, 2] > top - 0.02 * np.ptp(body[:, 2])])
    width = np.ptp(body[:, :2], axis=0).mean()
    handles = {"none": 0, "ears": 2}.get(shape.traits["grip"], 1)
    seen = {
        "height": m["height"],
        "neck": 0.02,
        "throat": rim / width,
        "foot": m["base"],
        "handle": m["handle"],
    }
    return "bottles", seen, {"handles": handles, "squared": False, "stopper": shape.traits["lid"]}
