# SPDX-License-Identifier: GPL-3.0-or-later
"""A writing table in walnut: bevelled top, tapered legs, an apron, two drawers with brass knobs."""

import numpy as np

from .modelling import Model, rounded_rectangle, rounding

MATERIALS = {
    "Walnut": (0.24, 0.12, 0.06, 0.0, 0.4),
    "Brass": (0.8, 0.58, 0.25, 1.0, 0.25),
}
_LEG_X, _LEG_Y, _UNDER = 0.62, 0.34, 0.72


def build():
    """Build the table, 1.4 m by 0.8 m and 0.75 m tall. Returns the object."""
    model = Model("Table", MATERIALS)
    model.slab(_top, _UNDER, rounding(0.03, 0.01), "Walnut", "Top", cut=0.1)
    for x in (-1, 1):
        for y in (-1, 1):
            model.loft(_leg(x * _LEG_X, y * _LEG_Y), "Walnut", "Legs")
        low, high = sorted((x * (_LEG_X - 0.012), x * (_LEG_X + 0.012)))
        model.block((low, -_LEG_Y, 0.6), (high, _LEG_Y, _UNDER), "Walnut", 0.003, "Apron", cut=0.1)
    for y in (-1, 1):
        low, high = sorted((y * (_LEG_Y - 0.012), y * (_LEG_Y + 0.012)))
        model.block((-_LEG_X, low, 0.6), (_LEG_X, high, _UNDER), "Walnut", 0.003, "Apron", cut=0.1)
    front = -_LEG_Y - 0.012
    for x in (-1, 1):
        low, high = sorted((x * 0.02, x * 0.56))
        model.block(
            (low, front - 0.012, 0.612), (high, front + 0.002, 0.71), "Walnut", 0.003, "Drawers", cut=0.1
        )
        model.block(
            (low + 0.01, front, 0.615), (high - 0.01, 0.31, 0.705), "Walnut", 0.003, "Drawers", cut=0.1
        )
        model.lathe(_KNOB, "Brass", (x * 0.29, front - 0.012, 0.661), (0, -1, 0), 16, "Drawers")
    return model.finish()


_KNOB = [
    (0.008, -0.002),
    (0.006, 0.008),
    (0.008, 0.012),
    (0.013, 0.016),
    (0.0145, 0.02),
    (0.013, 0.025),
    (0.006, 0.028),
]


def _top(inset):
    return rounded_rectangle(0.7 - inset, 0.4 - inset, 0.025 - inset)


def _leg(x, y):
    """Rings of a square leg that tapers on its two inner sides, from the floor up."""
    rings = []
    for z in (0, 0.003, *np.linspace(0.06, 0.6, 10), 0.66, _UNDER):
        half = np.interp(z, [0, 0.6], [0.017, 0.028]) - (0.003 if z == 0 else 0)
        inward = np.interp(z, [0, 0.6], [0.011, 0]) * -np.sign((x, y))
        xy = rounded_rectangle(half, half, 0.004, 2) + np.array((x, y)) - inward
        rings.append(np.column_stack([xy, np.full(len(xy), z)]))
    return rings
