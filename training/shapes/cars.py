# SPDX-License-Identifier: MIT OR Apache-2.0
"""Cars, vans, buses and lorries.

The front looks to -y, the length runs along y; the unit is the overall width.
"""

import numpy as np

from .axis import amount, outside, ratio
from .car_bodies import add_body, add_cargo
from .car_cabins import add_cabin
from .car_trim import add_trim, add_wheels
from .shape import Shape

RANGES = {
    "length": ratio(1.2, 8.0),
    "height": ratio(0.4, 2.2),
    "hood": amount(0.0, 0.5),
    "cabin": ratio(0.1, 1.0),
    "glass": ratio(0.12, 0.8),
    "wheel": ratio(0.16, 0.9),
    "clearance": amount(0.03, 0.7),
    "cargo": amount(0.0, 1.8),
    "track": ratio(0.85, 2.4),
}


def build(p, traits, rng):
    """A car with the parameters of `RANGES` and the trait open (no roof; drawn when missing)."""
    length, height = p["length"], p["height"]
    wheel = min(p["wheel"], 0.45 * length)
    belt = height * (1 - p["glass"])
    low = min(p["clearance"], 0.85 * wheel, 0.75 * belt)
    half = 0.5 / max(p["track"], 1.0)
    shape = Shape("cars")
    front = length * (p["hood"] - 0.5)
    back = min(front + length * p["cabin"], length / 2)
    deck = 0.5 - back / length
    cargo = p["cargo"] * (height - belt)
    bare = half < 0.37 and height < 0.8
    shape.traits["open"] = bool(traits.get("open", _may_open(p) and rng.random() < 0.4)) and not bare
    axles = _axles(rng, length, wheel)
    bed = deck > 0.26 and not bare and rng.random() < _bed_chance(p, height - belt)
    boxy = rng.random() if p["hood"] > 0.1 else rng.uniform(0.5, 1)
    ends = (-length / 2, front, back, length / 2)
    add_body(shape, rng, half, low, belt, ends, axles, wheel, p["track"], bed, boxy, bare)
    add_wheels(shape, rng, half * p["track"], wheel, axles, low, half)
    add_cabin(shape, rng, half, belt, height, ends, boxy, bare)
    if bed:
        add_cargo(shape, rng, half, low, belt, cargo, back, length / 2)
    add_trim(shape, rng, half, low, belt, height, ends, wheel, p["track"], bare, bed)
    return shape


def _may_open(p):
    """Whether the proportions suit a car without a roof."""
    return p["glass"] < 0.27 and p["cabin"] < 0.6 and p["height"] < 1


def _bed_chance(p, tall):
    """A long rear is an open bed or a load on most cars, but a boot on low ones and behind long bonnets."""
    if p["hood"] < 0.12 or p["cargo"] * tall > 0.12:
        return 1.0
    return 0.95 if p["height"] > 0.75 and p["hood"] < 0.31 and p["length"] < 3.5 else 0.05


def _axles(rng, length, wheel):
    """The places of the axles along y: two, or more under a long rear."""
    r = wheel / 2
    front = -length / 2 + max(length * rng.uniform(0.13, 0.22), 0.9 * r)
    rear = length / 2 - max(length * rng.uniform(0.15, 0.24), 0.9 * r)
    short = max(1.1 * wheel - (rear - front), 0) / 2
    axles = [front - short, rear + short]
    if length > 3.6 and rng.random() < 0.5 and axles[1] - axles[0] > 3.4 * wheel:
        axles.append(axles[1] - 1.08 * wheel)
    return axles


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    body, wheel = shape.points("body"), shape.points("wheel")
    cabin, cargo = shape.points("cabin"), shape.points("cargo")
    low, high = body.min(0), body.max(0)
    wide, length = high[:2] - low[:2]
    floor, span, across = low[2], wide, 0.0
    if wheel is not None:
        floor, span = wheel[:, 2].min(), np.ptp(wheel[:, 0])
        sizes = np.median([np.ptp(p.vertices, 0) for p in shape.parts if p.label == "wheel"], 0)
        across = sizes[1:].mean()
    unit = max(wide, span)
    roof = high[2] if cabin is None else max(cabin[:, 2].max(), high[2] + 1e-3)
    m = {
        "length": length / unit,
        "height": (roof - floor) / unit,
        "hood": 0.0 if cabin is None else max(cabin[:, 1].min() - low[1], 0) / length,
        "cabin": 0.1 if cabin is None else np.ptp(cabin[:, 1]) / length,
        "glass": max((roof - high[2]) / max(roof - floor, 1e-3), 1e-3),
        "wheel": max(across / unit, 0.05),
        "clearance": max(low[2] - floor, 0.0) / unit,
        "cargo": 0.0 if cargo is None else max(cargo[:, 2].max() - high[2], 0.0) / max(roof - high[2], 0.02),
        "track": span / wide,
    }
    faults = [0.6 * outside((high[2] - low[2]) / unit, 0.07, 1.2)]
    if wheel is None or cabin is None:
        faults += [1.0]
    if wheel is not None:
        axles = [p.vertices[:, 1].mean() for p in shape.parts if p.label == "wheel"]
        faults += [
            outside(sizes[1] / sizes[2], 0.9, 1.11),
            0.7 * outside(sizes[0] / across, 0.2, 0.75),
            outside(1 + (low[2] - floor) / across, 1.04, 1.95),
            0.8 * outside((max(axles) - min(axles)) / length, 0.4, 0.92),
            0.6 * outside(across / length, 0.03, 0.5),
        ]
    if cabin is not None:
        narrow = 0.22 if m["track"] > 1.3 else 0.7
        faults += [
            0.8 * outside(np.ptp(cabin[:, 0]) / wide, narrow, 1.06),
            outside(1 + (low[1] - cabin[:, 1].min()) / length, 0.1, 1.04),
            outside(1 + (cabin[:, 1].max() - high[1]) / length, 0.1, 1.04),
        ]
    if cargo is not None:
        faults += [
            0.8 * outside(np.ptp(cargo[:, 0]) / wide, 0.8, 1.12),
            0.8 * outside(1 + abs(cargo[:, 1].max() - high[1]) / length, 1.0, 1.08),
        ]
        if cabin is not None:
            faults += [0.8 * outside(1 + (cabin[:, 1].max() - cargo[:, 1].min()) / length, 0.7, 1.05)]
    return m, faults
