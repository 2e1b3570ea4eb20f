# SPDX-License-Identifier: MIT OR Apache-2.0
"""Engines of aircraft, on the wings or at the fuselage, and their propellers."""

import numpy as np

from .solids import bar, block, cushion, lathe


def add_wing_engines(shape, rng, engines, radius, w):
    """Add what hangs on the wings: two or four jets on pylons or propellers."""
    if engines not in ("under", "under4", "props", "props4"):
        return
    four, prop = engines.endswith("4"), engines.startswith("props")
    r = float(np.clip(rng.uniform(0.35, 0.6) * radius * (0.75 if four else 1.0), 0.012, 0.07))
    length = r * rng.uniform(2.6, 4.2)
    for share in (0.32, 0.6) if four else (rng.uniform(0.3, 0.4),):
        x = max(share * w.half, radius + 1.4 * r)
        if x > 0.8 * w.half:
            continue
        y, z = w.at(x)
        attach = (x, y + 0.02, z)
        y, z = y - length * rng.uniform(0.4, 0.7), z - (0.2 if prop else 1.25) * r
        shape.add_pair("engine", _pod(x, y, z, r, length), attach, "wing")
        if prop:
            _propeller(rng, (x, y, z), min(r * 3, x - radius * 0.8), attach, "wing", shape.add_pair)
        else:
            pylon = block((x - 0.1 * r, y + 0.5 * length, z), (x + 0.1 * r, y + 1.1 * length, z + 1.25 * r))
            shape.add_pair("pylon", pylon, attach, "wing")


def add_body_engines(shape, rng, engines, radius):
    """Add engines at the rear, intakes, or a propeller at the nose or the end."""
    if engines == "rear":
        r = radius * rng.uniform(0.4, 0.6)
        y, x = rng.uniform(0.12, 0.24), radius * 0.8 + r
        attach = (radius * 0.7, y + 1.5 * r, radius * 0.3)
        shape.add_pair("engine", _pod(x, y, radius * 0.35, r, r * rng.uniform(3, 4.6)), attach, "fuselage")
    elif engines == "intakes":
        w = radius * rng.uniform(0.35, 0.6)
        low, high = (
            (radius * 0.4, rng.uniform(-0.25, -0.05), -w),
            (radius * 0.75 + w, rng.uniform(0.3, 0.49), w * 0.8),
        )
        shape.add_pair(
            "intake", block(low, high, 0.15 * w), (radius * 0.5, (low[1] + high[1]) / 2, 0), "fuselage"
        )
    else:
        y, reach = -0.5 if engines == "nose" else 0.5, np.clip(radius * rng.uniform(1.5, 2.4), 0.09, 0.3)
        _propeller(rng, (0, y, 0), reach, (0, y * 0.97, 0), "fuselage", shape.add)


def _pod(x, y, z, r, length):
    """A nacelle whose front is at y."""
    v, f = lathe([(r * 0.8, 0), (r, 0.15 * length), (r, 0.55 * length), (r * 0.6, length)], sides=10)
    return np.column_stack([v[:, 0] + x, v[:, 2] + y, v[:, 1] + z]), f[:, ::-1]


def _propeller(rng, center, reach, attach, parent, put):
    """A hub with blades, added by `put` (one part or a pair)."""
    center = np.asarray(center)
    hub, blade = 0.16 * reach, 0.1 * reach
    put("propeller", cushion(center, (hub, 1.5 * hub, hub), 2, 8, 5), attach, parent)
    turn, count = rng.uniform(0, np.pi), int(rng.choice([2, 3, 4]))
    for i in range(count):
        a = turn + 2 * np.pi * i / count
        tip = center + reach * np.array([np.cos(a), 0, np.sin(a)])
        put("propeller", bar(center, tip, blade, blade * 0.5), attach, parent)
