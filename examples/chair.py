# SPDX-License-Identifier: GPL-3.0-or-later
"""A dining chair: oak frame, upholstered seat and back. A Mirror makes its left half."""

import numpy as np

from .modelling import Model, rounded_rectangle, rounding

MATERIALS = {
    "Oak": (0.55, 0.33, 0.16, 0.0, 0.45),
    "Wool": (0.09, 0.2, 0.24, 0.0, 0.9),
}


def build():
    """Build the chair, 0.46 m wide and 0.86 m tall. Returns the object."""
    model = Model("Dining Chair", MATERIALS)
    model.slab(_plan(0.213, 0.213, 0.05), 0.375, rounding(0.055, 0.008), "Oak", "Frame", cut=0.07)
    model.slab(_plan(0.23, 0.225, 0.07), 0.42, _cushion(0.07), "Wool", "Upholstery", cut=0.06)
    model.loft(_back(), "Wool", "Upholstery")
    model.tube([(-0.19, 0.0, 0.2), (0, 0, 0.2), (0.19, 0, 0.2)], [0.009] * 3, "Oak", 8, "Frame")
    model.halve()
    leg = np.linspace((0.205, -0.205, 0), (0.182, -0.178, 0.4), 8)
    model.tube(leg, np.linspace(0.013, 0.021, 8), "Oak", 12, "Frame")
    heights = np.linspace(0, 0.83, 15)
    thickness = np.interp(heights, [0, 0.42, 0.83], [0.014, 0.022, 0.013])
    model.tube([_post(z) for z in heights], thickness, "Oak", 12, "Frame")
    side = [(0.1935, -0.191, 0.2), (0.19, 0, 0.2), _post(0.2)]
    model.tube(side, [0.008, 0.01, 0.008], "Oak", 8, "Frame")
    return model.finish(mirror=True)


def _post(z):
    """The middle of a rear post at height z: splayed below the seat, raked above it."""
    y = np.interp(z, [0, 0.42, 0.5, 0.83], [0.225, 0.187, 0.192, 0.268])
    return (np.interp(z, [0, 0.42, 0.83], [0.2, 0.185, 0.178]), y, z)


def _plan(half_x, half_y, radius):
    """The seat seen from above, a little narrower at the back."""

    def outline(inset):
        xy = rounded_rectangle(half_x - inset, half_y - inset, max(radius - inset, 0.004), 5)
        xy[:, 0] *= 1 - 0.06 * (xy[:, 1] / half_y + 1) / 2
        return xy

    return outline


def _cushion(thickness):
    """(inset, height) of an upholstered seat: a tight lower edge, a full round upper one, a slight crown."""
    return [
        (0.02, 0),
        (0.006, 0.004),
        (0, 0.016),
        (0, 0.038),
        (0.005, 0.052),
        (0.018, 0.062),
        (0.045, 0.067),
        (0.1, thickness),
        (0.16, thickness + 0.001),
    ]


def _back():
    """Rings of the padded back from left to right: curved in plan, raked with the posts."""
    rings = []
    for t in np.linspace(-1, 1, 19):
        edge = 1 - 0.5 * np.clip((abs(t) - 0.86) / 0.14, 0, 1) ** 2
        section = rounded_rectangle(0.019 * edge, 0.135 * (0.9 + 0.1 * edge), 0.0185 * edge, 3)
        section = _lengthen(section)
        z = 0.72 + section[:, 1] - 0.008 * t * t
        y = np.interp(z, [0.5, 0.83], [0.192, 0.268]) + 0.014 - 0.035 * t * t + section[:, 0]
        rings.append(np.column_stack([np.full(len(z), 0.212 * t), y, z]))
    return rings


def _lengthen(section, steps=5):
    """Points added on the two long sides of a section, so that it can bend."""
    out = []
    for a, b in zip(section, np.roll(section, -1, axis=0), strict=True):
        out.append(a)
        if np.linalg.norm(b - a) > 0.1:
            out.extend(a + (b - a) * k / steps for k in range(1, steps))
    return np.array(out)
