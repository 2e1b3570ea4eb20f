# SPDX-License-Identifier: GPL-3.0-or-later
"""An airliner with its gear up. A Mirror makes its left half."""

import numpy as np

from .modelling import Model, circle, rounded_rectangle

MATERIALS = {
    "White Paint": (0.68, 0.69, 0.7, 0.0, 0.3),
    "Blue Paint": (0.02, 0.1, 0.32, 0.0, 0.3),
    "Metal": (0.6, 0.61, 0.63, 1.0, 0.3),
    "Glass": (0.02, 0.025, 0.03, 0.0, 0.1),
}
_RADIUS, _HALF_LENGTH = 2.0, 18.8
_SPAN, _ROOT, _SWEEP, _DIHEDRAL = 17.0, -4.8, 0.52, 0.09


def build():
    """Build the aeroplane, 37.6 m long and 35 m wide. Returns the object."""
    model = Model("Airliner", MATERIALS)
    body = model.loft([_body_ring(t) for t in np.linspace(0.004, 0.996, 61)], "White Paint", "Fuselage")
    model.paint(body, "Blue Paint", _is_livery)
    model.paint(body, "Glass", _is_window)
    model.loft([_fairing_ring(t) for t in np.linspace(-1, 1, 17)], "White Paint", "Fuselage")
    fin = [_section((0, 13.0 + 0.72 * h, 1.1 + h), 4.6 - 0.5 * h, 0.1, 90) for h in np.linspace(0, 5.6, 8)]
    model.loft(_tipped(fin), "Blue Paint", "Tail")
    model.halve()
    model.loft(_tipped(_wing()), "White Paint", "Wing")
    across = np.linspace(0.3, 6.3, 8)
    tail = [_section((x, 14.0 + 0.6 * x, 1.0 + 0.1 * x), 3.5 - 0.33 * x, 0.09, 0) for x in across]
    model.loft(_tipped(tail), "White Paint", "Tail")
    at = (5.9, -3.7, -2.25)
    nacelle = model.lathe(_NACELLE, "Blue Paint", at, (0, 1, 0), 28, "Engines", loop=True)
    model.paint(nacelle, "Metal", lambda c: c.y < at[1] - 1.85 or np.hypot(c.x - at[0], c.z - at[2]) < 0.93)
    model.lathe(_FAN, "Metal", at, (0, 1, 0), 28, "Engines")
    model.loft(_pylon(at), "White Paint", "Engines")
    return model.finish(mirror=True)


# Outside from the lip to the nozzle, then back through the duct; (radius, distance along the axis) in metres.
_NACELLE = [
    (0.99, -2.2),
    (1.07, -2.15),
    (1.14, -1.95),
    (1.22, -1.4),
    (1.24, -0.6),
    (1.2, 0.4),
    (1.08, 1.3),
    (0.86, 2.2),
    (0.81, 2.2),
    (0.88, 1.4),
    (0.95, 0.4),
    (0.97, -1.0),
    (0.93, -1.9),
    (0.94, -2.12),
]
_FAN = [
    (0.02, -1.95),
    (0.14, -1.8),
    (0.3, -1.4),
    (0.32, -1.3),
    (0.98, -1.25),
    (0.98, -1.1),
    (0.6, -0.6),
    (0.55, 1.0),
    (0.58, 1.8),
    (0.35, 2.4),
    (0.04, 3.0),
]


def _body(t):
    """Radius and height of the middle of the fuselage at t = 0 (nose, dropped) to 1 (tail, swept up)."""
    nose = np.clip(t / 0.15, 0, 1)
    radius = _RADIUS * (1 - (1 - nose) ** 2.2) ** 0.62
    aft = np.clip((t - 0.66) / 0.34, 0, 1)
    radius *= 1 - 0.9 * aft**1.7
    return radius, -0.5 * (1 - nose) ** 1.6 + 0.62 * _RADIUS * aft**1.8


def _body_ring(t):
    radius, middle = _body(t)
    return [(-x * radius, (2 * t - 1) * _HALF_LENGTH, z * radius + middle) for x, z in circle(32)]


def _is_livery(center):
    radius, middle = _body(center.y / _HALF_LENGTH / 2 + 0.5)
    return center.z - middle < -0.37 * radius or center.y > 15.5


def _is_window(center):
    """The cockpit's panes, and every second face of one row along the cabin."""
    row = 0.15 < center.z < 0.5 and -14 < center.y < 10.5
    second = round((center.y + _HALF_LENGTH) / 0.622) % 2 == 0
    return (row and second) or (-17.4 < center.y < -16.2 and 0.45 < center.z < 1.15)


def _fairing_ring(t):
    """The belly fairing from t = -1 to 1, where the wings meet the fuselage."""
    size = max(1 - abs(t) ** 3, 0.02) ** 0.6
    xz = rounded_rectangle(2.05 * size, 0.85 * size, 0.6 * size, 4)
    return [(-x, 0.2 + 5.6 * t, z - 1.35 + 0.25 * (1 - size)) for x, z in xz]


def _wing():
    """Sections from the root to the tip of the winglet; the trailing edge has its kink behind the engine."""
    sections = []
    for x in (0.8, 2.0, 3.1, 4.2, 5.3, 6.4, 7.7, 9.0, 10.3, 11.6, 12.9, 14.2, 15.5, 16.4, _SPAN):
        chord = np.interp(x, [0.8, 6.4, _SPAN], [7.3, 4.2, 1.7])
        thickness = np.interp(x, [0.8, 9], [0.13, 0.1])
        sections.append(_section((x, _ROOT + _SWEEP * (x - 0.8), _wing_height(x)), chord, thickness, 0))
    x, y, z = _SPAN, _ROOT + _SWEEP * (_SPAN - 0.8), _wing_height(_SPAN)
    winglet = ((0.22, 0.1, 1.55, 30), (0.4, 0.4, 1.4, 60), (0.52, 1.0, 1.1, 78), (0.66, 1.9, 0.7, 80))
    for out, up, chord, cant in winglet:
        sections.append(_section((x + out, y + 0.35 * (out + up) + 0.15 * up, z + up), chord, 0.09, cant))
    return sections


def _wing_height(x):
    return -1.15 + _DIHEDRAL * (x - 0.8)


def _section(lead, chord, thickness, cant):
    """A wing section (18, 3) that begins at its leading edge; cant is 0 for a wing, 90 degrees for a fin."""
    s = (1 - np.cos(np.linspace(0, np.pi, 10))) / 2
    # The NACA 00xx thickness curve.
    half = 5 * thickness * (0.2969 * np.sqrt(s) - 0.126 * s - 0.3516 * s**2 + 0.2843 * s**3 - 0.1015 * s**4)
    along = np.concatenate([s[::-1], s[1:]]) * chord
    across = np.concatenate([half[::-1], -half[1:]]) * chord
    c, d = np.cos(np.radians(cant)), np.sin(np.radians(cant))
    return np.column_stack([-across * d, along, across * c]) + lead


def _tipped(sections):
    """Sections with one more that rounds off the tip."""
    last = np.array(sections[-1])
    middle = last.mean(axis=0)
    step = 0.25 * (middle - np.mean(sections[-2], axis=0)) * 0.3
    return [*sections, middle + (last - middle) * (0.8, 0.9, 0.8) + step]


def _pylon(at):
    """Rings of the strut from inside the nacelle up into the wing."""
    x, y, z = at
    rings = []
    for up, back, half in ((1.0, 0.3, 1.7), (1.35, 0.8, 1.75), (1.6, 1.2, 1.6)):
        outline = rounded_rectangle(0.16, half, 0.15, 3)
        rings.append(np.column_stack([outline + np.array((x, y + back)), np.full(len(outline), z + up)]))
    return rings
