# SPDX-License-Identifier: MIT OR Apache-2.0
"""Outlines of the bodies of stringed instruments."""

import numpy as np

from .solids import outline

# Half outlines as (height, half width) pairs from the tail to the neck.
VIOL = (
    (0, 0.3),
    (0.015, 0.5),
    (0.06, 0.8),
    (0.13, 0.95),
    (0.22, 1),
    (0.31, 0.97),
    (0.355, 0.9),
    (0.37, 0.93),
    (0.39, 0.8),
    (0.44, 0.66),
    (0.51, 0.6),
    (0.58, 0.64),
    (0.62, 0.74),
    (0.635, 0.79),
    (0.66, 0.76),
)
SHOULDERS = (
    ((0.73, 0.81), (0.82, 0.82), (0.9, 0.72), (0.96, 0.5), (1, 0.2)),
    ((0.71, 0.72), (0.78, 0.66), (0.85, 0.52), (0.92, 0.34), (1, 0.16)),
)
HORN = ((0.69, 0.62), (0.76, 0.74), (0.76, 0.9), (0.64, 1.0), (0.46, 0.97), (0.36, 0.84), (0.16, 0.76))
SHOULDER = ((0.66, 0.6), (0.72, 0.74), (0.68, 0.9), (0.5, 0.98), (0.16, 1.0))
TAIL = ((0.3, 0.02), (0.72, 0.03), (0.97, 0.14), (1.0, 0.3), (0.82, 0.47))
VEE = ((0.0, 0.36), (0.62, 0.0), (0.98, 0.02), (0.94, 0.14), (0.3, 0.94), (0.14, 1.0))
WEDGE = ((0.4, 0.0), (0.97, 0.0), (1.0, 0.04), (0.93, 0.12), (0.5, 0.56), (0.14, 1.0))


def body_outline(form, rng):
    """The body's outline as (n, 2) of x from -1 to 1 and z from 0 to 1."""
    if form == "round":
        return outline(28, rng.choice([2.0, 2.0, 2.2])) * (1, 0.5) + (0, 0.5)
    if form == "horned":
        style = rng.choice(["double", "double", "single", "vee"], p=[0.4, 0.2, 0.28, 0.12])
        if style == "vee":
            return _smooth(np.array([*VEE, *[(-x, z) for x, z in VEE[:0:-1]]]))
        longer = rng.uniform(0.82, 1.0)
        right = [(x, 0.62 + (z - 0.62) * longer if z > 0.62 else z) for x, z in HORN]
        left = HORN if style == "double" else SHOULDER
        return _smooth(np.array([*TAIL, *right, *[(-x, z) for x, z in (*TAIL, *left)[::-1]]]))
    if form == "triangle":
        return _smooth(np.array([*WEDGE, *[(-x, z) for x, z in WEDGE[::-1]]]))
    if form == "viol":
        t, w = np.array([*VIOL, *SHOULDERS[rng.integers(2)]]).T
    else:
        t = (1 - np.cos(np.linspace(0.06, np.pi - 0.06, 20))) / 2
        low = rng.uniform(0.28, 0.33) if form == "waisted" else rng.uniform(0.33, 0.42)

        def bulge(middle, reach):
            return np.sqrt(np.maximum(1 - ((t - middle) / reach) ** 2, 0))

        if form == "waisted":
            upper, waist = rng.uniform(0.68, 0.8), rng.uniform(0.56, 0.68)
            sides = np.stack([bulge(low, low), waist * bulge(0.59, 0.35), upper * bulge(0.78, 0.225)])
            w = (sides**7).sum(0) ** (1 / 7)
        else:
            s = np.maximum((t - low) / (1 - low), 0)
            w = np.where(t < low, bulge(low, low), 1 - 0.84 * s ** rng.uniform(1.5, 2.2))
    return np.concatenate([np.column_stack([w, t]), np.column_stack([-w, t])[::-1]])


def _smooth(points, rounds=2):
    """A closed polygon with its corners cut twice."""
    for _ in range(rounds):
        after = np.roll(points, -1, 0)
        points = np.stack([0.75 * points + 0.25 * after, 0.25 * points + 0.75 * after], 1).reshape(-1, 2)
    return points
