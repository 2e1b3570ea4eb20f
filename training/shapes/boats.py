# SPDX-License-Identifier: MIT OR Apache-2.0
"""Boats and ships. The bow looks to -y, the length runs along y; the unit is the beam of the hull."""

import numpy as np

from .axis import amount, outside, ratio
from .boat_decks import add_fittings, add_funnels, add_house
from .hulls import add_hull
from .rigs import add_rig
from .shape import Shape

RANGES = {
    "length": ratio(0.9, 14.0),
    "hull": ratio(0.06, 1.4),
    "sheer": amount(0.0, 1.4),
    "cabin": amount(0.0, 1.0),
    "house": amount(0.0, 2.0),
    "aft": ratio(0.2, 0.95),
    "mast": amount(0.0, 2.0),
    "sail": amount(0.0, 1.1),
    "funnel": amount(0.0, 0.9),
}
BODIES = ("open", "decked", "round", "raft")


def build(p, traits, rng):
    """A boat with the parameters of `RANGES`.

    The traits are body (one of `BODIES`) and masts (drawn when missing).
    """
    long, deep = p["length"], p["hull"]
    cabin = p["cabin"] if p["cabin"] > 0.04 and p["house"] > 0.06 else 0.0
    if cabin:
        cabin = min(max(cabin, p["house"] / (2.4 * long)), 1.0)
    mast = p["mast"] if p["mast"] > 0.09 else 0.0
    body = traits.get("body", _likely_body(p, rng))
    if (body == "round" and not 0.8 < deep < 1.25) or (body == "raft" and deep > 0.35):
        body = "decked"
    masts = int(traits.get("masts", 2 if mast and long > 3.3 and deep > 0.6 and rng.random() < 0.4 else 1))
    shape = Shape("boats", traits={"body": body, "masts": masts})
    bluff = p["cabin"] > 0.55 and deep < 0.5
    deck = add_hull(shape, rng, long, deep, p["sheer"], body, bluff)
    middle = (np.clip(p["aft"], cabin / 2, 1 - cabin / 2) - 0.5) * long
    if cabin:
        add_house(shape, rng, deck, middle, cabin * long, p["house"], body)
        if p["funnel"] > 0.09:
            add_funnels(shape, rng, deep + p["house"], middle, cabin * long, p["funnel"])
    if mast:
        add_rig(shape, rng, deck, deep, long, mast, p["sail"], masts, p["sheer"])
    add_fittings(shape, rng, deck, long, deep, cabin, body, mast)
    return shape


def _likely_body(p, rng):
    """The hull that the proportions suggest."""
    if p["length"] < 2.4 and p["hull"] < 0.25:
        return "raft" if rng.random() < 0.8 else "open"
    if p["length"] > 5 and p["hull"] > 0.75 and 0.05 < p["cabin"] < 0.25 and rng.random() < 0.4:
        return "round"
    bare = p["cabin"] < 0.05 and (p["mast"] < 0.09 or p["sheer"] > 0.35)
    return "open" if rng.random() < (0.75 if bare else 0.15) else "decked"


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    hull, cabin, mast = shape.points("hull"), shape.points("cabin"), shape.points("mast")
    sail, funnel, fitting = shape.points("sail"), shape.points("funnel"), shape.points("fitting")
    low, high = hull.min(0), hull.max(0)
    beam, long, _ = high - low
    middle = np.abs(hull[:, 1] - low[1] - 0.5 * long) < 0.12 * long
    flat = shape.traits["body"] == "raft"
    deck = high[2] if flat or not middle.any() else hull[middle, 2].max()
    deep = deck - low[2]
    m = {name: 0.0 for name in RANGES}
    m.update(length=long / beam, hull=deep / beam, sheer=max(high[2] - deck, 0.0) / beam, aft=0.5)
    faults = [0.6 * outside(long / beam, 0.9, 14.0), 0.6 * outside(deep / beam, 0.055, 1.45)]
    if shape.traits["body"] == "round":
        faults += [outside(deep / beam, 0.8, 1.25)]
    if fitting is not None:
        faults += [
            0.8 * _beyond(np.ptp(fitting[:, 0]) - beam, beam, 0.15),
            0.8 * _beyond(max(low[1] - fitting[:, 1].min(), fitting[:, 1].max() - high[1]), long, 0.03),
            0.8 * _beyond(fitting[:, 2].max() - high[2], beam, 0.45),
            0.8 * _beyond(low[2] - fitting[:, 2].min(), beam, 0.02),
        ]
    if cabin is not None:
        size = np.ptp(cabin, 0)
        m["cabin"] = size[1] / long
        m["house"] = max(cabin[:, 2].max() - deck, 0.0) / beam
        m["aft"] = np.clip((cabin[:, 1].min() + size[1] / 2 - low[1]) / long, 0.2, 0.95)
        slim = 0.15 if shape.traits["body"] == "round" else 0.38
        faults += [
            0.9 * outside(size[0] / beam, slim, 1.03),
            0.8 * _beyond(max(low[1] - cabin[:, 1].min(), cabin[:, 1].max() - high[1]), long, 0.02),
            0.8 * _beyond(cabin[:, 2].min() - high[2], beam, 0.02),
            0.8 * _beyond(low[2] - cabin[:, 2].min(), beam, 0.02),
            0.6 * outside(size[2] / size[1], 0.02, 2.6),
            0.6 * outside(deep / beam + m["house"], 0.1, 2.4),
        ]
    if mast is not None:
        m["mast"] = max(mast[:, 2].max() - deck, 0.0) / long
        thick = np.ptp(next(p.vertices for p in shape.parts if p.label == "mast"), 0)
        faults += [
            0.8 * outside(max(thick[0], thick[1]) / thick[2], 0.004, 0.085),
            0.7 * outside(thick[0] / thick[1], 0.7, 1.4),
            0.8 * _beyond(low[2] - mast[:, 2].min(), beam, 0.02),
        ]
    if sail is not None and mast is not None:
        m["sail"] = np.ptp(sail[:, :2], 0).max() / long
        faults += [
            0.8 * outside((sail[:, 2].max() - deck) / max(m["mast"] * long, 1e-3), 0.65, 1.06),
            0.8 * _beyond(deck - sail[:, 2].min(), beam, 0.05),
            0.6 * outside(np.ptp(sail[:, 0]) / beam, 0.005, 2.6),
        ]
    if funnel is not None and cabin is not None:
        m["funnel"] = max(funnel[:, 2].max() - cabin[:, 2].max(), 0.0) / beam
        pipe = np.ptp(next(p.vertices for p in shape.parts if p.label == "funnel"), 0)
        faults += [
            0.8 * outside(pipe[0] / beam, 0.12, 0.42),
            0.8 * outside(pipe[0] / pipe[1], 0.6, 1.2),
            0.6
            * _beyond(
                max(cabin[:, 1].min() - funnel[:, 1].min(), funnel[:, 1].max() - cabin[:, 1].max()),
                long,
                0.03,
            ),
        ]
    return m, faults


def _beyond(gap, unit, allowed):
    """How far something sticks out by more than the allowed share of a unit, as a log distance."""
    return outside(1 + max(gap, 0.0) / unit, 1.0, 1 + allowed)
