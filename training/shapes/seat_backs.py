# SPDX-License-Identifier: MIT OR Apache-2.0
"""Backs of seats: panels, cushions, slats, spindles and plates, and the ears of a wing chair."""

import numpy as np

from .solids import bar, block, cushion, outline, rounded_rectangle, slab


def add_back(shape, rng, hx, hy, rise, thick, back, soft, base, leg):
    """Add a back that rises by `back` over the seat, in a style that suits the rest."""
    lean = (rng.random() < 0.75) * rng.uniform(0.03, 0.3) * min(1, 1 / max(back, 0.5))
    t = rng.uniform(0.12, 0.35) if soft else rng.uniform(0.05, 0.12)
    wide = hx * rng.choice([1.0, rng.uniform(0.75, 1.0)])
    top, low, y = rise + back, rise - 0.5 * thick, hy - t / 2
    wrap = rng.choice([0, 0, rng.uniform(0.05, 0.3)])
    at = (0, hy - t / 2, rise)
    style = rng.choice(["panel", "panel", "cushion", "rails", "slats", "spindles", "floating", "arched"])
    if soft and style not in ("arched", "floating"):
        style = rng.choice(["panel", "cushion"])

    def put(solid):
        return shape.add("back", _lean(solid, rise, lean, wrap, hx), at, "seat")

    if style == "panel":
        n = 9 if wrap else 1
        plan = rounded_rectangle(wide, t / 2, min(0.3 * t, 0.06)) if n == 1 else _strip(wide, t / 2, n)
        put(slab(plan, low, top, rng.uniform(0, 0.3) * t, (0, y), divisions=4))
    elif style == "cushion":
        count = int(rng.choice([1, 2, 3])) if hx > 1.3 * hy else 1
        put(slab(_strip(wide, t / 4, 9), low, rise + back * 0.97, 0.02, (0, y + t / 4), divisions=4))
        for i in range(count):
            w = wide / count
            put(
                cushion(
                    (-wide + (2 * i + 1) * w, y - t / 4, rise + back / 2),
                    (w, t / 2, back / 2),
                    rng.uniform(3.5, 8),
                )
            )
    elif style == "arched":
        plan = outline(24, rng.uniform(2.2, 5)) * (wide, back * 0.55)
        v, f = slab(plan, -t / 2, t / 2, 0.2 * t, divisions=1)
        put((np.column_stack([v[:, 0], v[:, 2] + y, v[:, 1] + rise + back * 0.45]), f[:, ::-1]))
    else:
        _frame_back(put, rng, (hx, hy, wide), (low, rise, top), y, max(leg * 0.45, 0.035), style, base)


def _frame_back(put, rng, plan, levels, y, r, style, base):
    """Posts that carry a plate ("floating"), or a cap rail and what fills the frame below it."""
    (hx, hy, wide), (low, rise, top) = plan, levels
    x, back = wide - r, top - rise
    if style == "floating":
        if base in ("pedestal", "star"):
            put(bar((0, y, low), (0, y, rise + 0.6 * back), (0.12, 0.04)))
        else:
            for s in (-1, 1):
                put(bar((s * x, y, low), (s * x, y, top), r, r * 0.8, steps=5))
        put(slab(_strip(wide, r, 9), rise + back * rng.uniform(0.12, 0.45), top, 0.02, (0, y), divisions=3))
        return
    for s in (-1, 1):
        put(bar((s * x, y, low), (s * x, y, top), r, r * 0.8, steps=5))
    cap = max(rng.uniform(0.12, 0.25) * back, 0.06)
    put(slab(_strip(wide, r, 9), top - cap, top, 0.01, (0, y)))
    if style == "rails":
        count = int(rng.integers(1, 4))
        for z in np.linspace(rise + 0.12 * back, top - cap, count + 1)[:-1]:
            high = rng.uniform(0.45, 0.75) * (0.88 * back - cap) / count
            put(slab(_strip(x, r * 0.7, 9), z, z + high, 0.0, (0, y)))
    else:
        count = int(rng.integers(3, 6)) * max(1, round(hx / max(hy, 0.5)))
        w = max(r * 0.5, 0.022) if style == "spindles" else 0.6 * x / count
        for z in np.linspace(-x, x, count + 2)[1:-1]:
            put(bar((z, y, low), (z, y, top - cap / 2), (w, r * 0.6), steps=3))


def _lean(solid, base, amount, wrap, hx):
    """Tilt a back about its foot by `amount` per height and wrap its sides forward by `wrap`."""
    v, f = solid
    v = v.copy()
    v[:, 1] += (v[:, 2] - base) * amount - wrap * (v[:, 0] / hx) ** 2
    return v, f


def _strip(half_x, half_y, count):
    """A rectangle outline with `count` points along each long side, so that it can be wrapped."""
    x = np.linspace(-half_x, half_x, count)
    return np.concatenate(
        [np.column_stack([x, np.full(count, -half_y)]), np.column_stack([x[::-1], np.full(count, half_y)])]
    )


def add_wings(shape, rng, hx, hy, rise, arm, back):
    """The ears of a wing chair: panels that run forward from the back above the arms."""
    low, reach = rise + 0.8 * arm, hy - rng.uniform(0.3, 0.5) * 2 * hy
    wing = block((hx - 0.1, reach, low), (hx, hy, rise + back * rng.uniform(0.93, 1.0)), 0.03)
    shape.add_pair("back", wing, (hx, hy, rise), "seat")
