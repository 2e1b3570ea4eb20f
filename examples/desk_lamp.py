# SPDX-License-Identifier: GPL-3.0-or-later
"""A jointed desk lamp: a weighted foot, two arms of twin rods, a bell shade. A Subdivision smooths it."""

import numpy as np
from mathutils import Vector

from .modelling import Model

MATERIALS = {
    "Enamel": (0.55, 0.07, 0.04, 0.0, 0.3),
    "Brass": (0.8, 0.58, 0.25, 1.0, 0.25),
    "Bulb": (0.95, 0.9, 0.75, 0.0, 0.4),
}
_HIP, _ELBOW, _HEAD = Vector((0, 0.0, 0.045)), Vector((0, 0.085, 0.235)), Vector((0, -0.095, 0.405))
_SHADE_AXIS = Vector((0, 0.12, 0.99)).normalized()


def build():
    """Build the lamp, 0.18 m wide and 0.46 m tall. Returns the object."""
    model = Model("Desk Lamp", MATERIALS)
    model.lathe(_FOOT, "Enamel", sides=24, group="Foot")
    model.lathe(_SWITCH, "Brass", (0, -0.062, 0.016), sides=10, group="Foot")
    for low, high, apart in ((_HIP, _ELBOW, 0.011), (_ELBOW, _HEAD, 0.017)):
        for side in (-1, 1):
            offset = Vector((side * apart, 0, 0))
            points = [low.lerp(high, t) + offset for t in np.linspace(0, 1, 9)]
            model.tube(points, [0.0042] * 9, "Brass", 8, "Arms")
    for at, width in ((_HIP, 0.018), (_ELBOW, 0.026), (_HEAD, 0.026)):
        model.lathe(_hub(0.014, width), "Enamel", at - Vector((width, 0, 0)), (1, 0, 0), 14, "Arms")
    rim = _HEAD - _SHADE_AXIS * 0.115 + Vector((0, -0.036, 0))
    model.lathe(_SHADE, "Enamel", rim, _SHADE_AXIS, 24, "Shade", loop=True)
    model.lathe(_SOCKET, "Brass", rim, _SHADE_AXIS, 16, "Shade")
    model.lathe(_BULB, "Bulb", rim, _SHADE_AXIS, 14, "Shade")
    return model.finish(subdivisions=1)


# (radius, height) pairs; pairs that lie close together keep an edge crisp under the Subdivision.
_FOOT = [
    (0.05, 0),
    (0.085, 0),
    (0.09, 0.001),
    (0.09, 0.005),
    (0.088, 0.013),
    (0.08, 0.0175),
    (0.05, 0.02),
    (0.026, 0.0225),
    (0.019, 0.03),
    (0.017, 0.034),
    (0.016, 0.036),
    (0.01, 0.036),
]
_SWITCH = [(0.006, 0), (0.006, 0.006), (0.0055, 0.007), (0.003, 0.0075)]
_SHADE = [
    (0.0735, 0),
    (0.074, 0.002),
    (0.07, 0.018),
    (0.061, 0.045),
    (0.046, 0.07),
    (0.031, 0.086),
    (0.026, 0.094),
    (0.025, 0.12),
    (0.023, 0.126),
    (0.018, 0.127),
    (0.018, 0.123),
    (0.0225, 0.09),
    (0.028, 0.083),
    (0.043, 0.067),
    (0.058, 0.043),
    (0.067, 0.018),
    (0.0715, 0.001),
]
_SOCKET = [
    (0.01, 0.07),
    (0.014, 0.071),
    (0.0145, 0.075),
    (0.0195, 0.12),
    (0.0195, 0.133),
    (0.017, 0.136),
    (0.008, 0.137),
]
_BULB = [
    (0.004, 0.016),
    (0.012, 0.018),
    (0.022, 0.028),
    (0.025, 0.04),
    (0.021, 0.054),
    (0.0135, 0.066),
    (0.0125, 0.074),
    (0.006, 0.0745),
]


def _hub(radius, width):
    """A joint's drum, 2·width long, with crisp edges."""
    return [
        (radius * 0.6, 0),
        (radius * 0.9, 0.0003),
        (radius, 0.0015),
        (radius, 2 * width - 0.0015),
        (radius * 0.9, 2 * width - 0.0003),
        (radius * 0.6, 2 * width),
    ]
