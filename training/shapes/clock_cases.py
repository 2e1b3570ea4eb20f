# SPDX-License-Identifier: MIT OR Apache-2.0
"""Cases of clocks and the dials on them."""

import numpy as np

from .solids import bar, fit, loft, outline, rounded_rectangle, upright_slab


def add_case(shape, rng, low, high, depth, is_round, top):
    """Add the case from `low` to `high`, as wide as the unit."""
    rise = high - low
    bevel = rng.choice([0.0, rng.uniform(0.02, 0.25)]) * min(depth, rise)
    if is_round:
        plan = outline(28, rng.choice([2.0, 2.0, 2.0, 3.0]))
    elif 0.42 < rise < 0.9 and not top and rng.random() < 0.65:
        plan = _hat(rng)
    else:
        style = rng.choice(["box", "arch", "arch", "soft", "octagon"]) if not top else "box"
        if style == "box":
            plan = rounded_rectangle(1, rise, 0.02, 2)
        elif style == "arch":
            a = np.linspace(0, np.pi, 15)
            sill = max(rise - rng.uniform(0.2, 0.5), 0.2 * rise)
            arc = np.column_stack([0.5 * np.cos(a), sill + (rise - sill) * np.sin(a)])
            plan = np.concatenate([[[-0.5, 0.0], [0.5, 0.0]], arc])
        else:
            plan = outline(8 if style == "octagon" else 28, 2.0 if style == "octagon" else 6.0, np.pi / 8)
    half = depth / 2
    solid = fit(upright_slab(plan, -half, half, bevel), (-0.5, -half, low), (0.5, half, high))
    shape.add("case", solid)


def _hat(rng):
    """The outline of a hat: a hump in the middle, shoulders that fall to both sides."""
    x = np.linspace(1, -1, 19)
    wide, edge = rng.uniform(0.3, 0.6), rng.uniform(0.15, 0.6)
    z = edge + (1 - edge) * np.exp(-((np.abs(x) / wide) ** rng.uniform(2, 3)))
    return np.concatenate([[[-1, 0], [1, 0]], np.column_stack([x, z])])


def add_dial(shape, rng, low, high, depth, dial, is_round, both):
    """Add a dial at the front, and one at the back too for `both`."""
    rise = high - low
    flat = rise < 0.62 and dial > 1.2 * rise
    room = rise * (0.97 if is_round else 0.94)
    size = np.array([dial / 2, min(dial, room) / 2])
    if not flat:
        size[0] = size[1]
    middle = low + rise * (0.5 if rise < 1.2 or rng.random() < 0.5 else rng.uniform(0.5, 0.65))
    middle = min(middle, high - size[1] - 0.02 * rise)
    shape.traits["flat"] = bool(flat)
    proud = rng.uniform(0.01, 0.05)
    plan = rounded_rectangle(*size, 0.2 * size[1]) if flat else outline(28) * size
    if not flat and not is_round and rng.random() < 0.15:
        plan = rounded_rectangle(*size, 0.1 * size[1])
    at = np.array([0, -depth / 2, middle])
    for side in (-1, 1) if both else (-1,):
        face = side * depth / 2
        _face(shape, rng, plan, size, face, side * proud, at * (1, -side, 1), flat)


def _face(shape, rng, plan, size, face, proud, at, flat):
    """One dial on the plane y = `face`: a disc, a rim or a step, perhaps with hands."""

    def put(solid):
        shape.add("dial", (solid[0] + np.array([0, 0, at[2]]), solid[1]), at, "case")

    rim = rng.uniform(0.82, 0.93)
    style = rng.choice(["disc", "rim", "step"])
    if style == "disc":
        put(upright_slab(plan, face, face + proud, 0.3 * abs(proud)))
    elif style == "step":
        put(upright_slab(plan, face, face + 0.5 * proud))
        put(upright_slab(plan * rim, face, face + proud))
    else:
        put(upright_slab(plan * rim, face, face + 0.25 * proud))
        rings = [(1, 0), (1, 0.7), (0.95, 1), (rim, 0.6), (rim, 0)]
        ring = [np.insert(plan * k, 1, face + proud * y, axis=1) for k, y in rings]
        put(loft(ring, caps=False))
    if not flat and rng.random() < 0.6:
        y, r = face + 1.15 * proud, 0.05 * size[1]
        for angle, reach in zip(rng.uniform(0, 2 * np.pi, 2), (0.5, 0.8), strict=True):
            tip = np.array([np.sin(angle), 0, np.cos(angle)]) * reach * size[1]
            put(bar((0, y, 0), tip + np.array([0, y, 0]), r))
