# SPDX-License-Identifier: MIT OR Apache-2.0
"""What is under the case of a clock: a trunk or a post, a foot, or hanging weights."""

import numpy as np

from .solids import bar, block, cushion, fit, lathe, outline, rounded_rectangle, slab, upright_slab


def add_trunk(shape, rng, foot, low, depth, neck):
    """Add a post, or a trunk perhaps with a door, columns and a pendulum."""
    at = (0, 0, low)
    half = neck / 2
    if neck < 0.35:
        a = rng.uniform(0.1, 0.3)
        profile = [(1, 0), (1, a), (0.6, a + 0.02), (0.6, 0.9), (0.85, 0.92), (0.85, 1)]
        solid = lathe(profile if rng.random() < 0.6 else [(1, 0), (1, 1)], sides=12)
        solid = fit(solid, (-half, -half, 0.9 * foot), (half, half, low + 0.02))
        shape.add("trunk", solid, at, "case")
        return
    back = depth * min(1.0, max(neck, 0.6)) / 2 * rng.uniform(0.85, 1.0)
    corner = rng.choice([0.0, 0.04])
    shape.add("trunk", block((-half, -back, 0.9 * foot), (half, back, low + 0.01), 0.0, corner), at, "case")
    rise = low - foot
    if rng.random() < 0.6:
        w, z = 0.7 * half, (foot + 0.1 * rise, foot + 0.9 * rise)
        if rng.random() < 0.5:
            shape.add("trunk", block((-w, -back - 0.02, z[0]), (w, -back, z[1])), at, "case")
        else:
            for x in (-w, w):
                shape.add("trunk", bar((x, -back, z[0]), (x, -back, z[1]), 0.05 * neck, sides=6), at, "case")
    if rng.random() < 0.5:
        r = rng.uniform(0.14, 0.28) * neck
        z = foot + rng.uniform(0.25, 0.5) * rise
        bob = upright_slab(outline(16) * r, -back - 0.05, -back)
        rod = bar((0, -back - 0.03, z), (0, -back - 0.03, low), 0.025)
        for v, f in ((bob[0] + np.array([0, 0, z]), bob[1]), rod):
            shape.add("pendulum", (v, f), at, "trunk")


def add_foot(shape, rng, foot, depth, spread, trunk, neck, is_round):
    """Add a plate under a post, a plinth, a saddle, legs or balls."""
    at, parent = (0, 0, foot), "trunk" if trunk else "case"
    x = spread / 2
    if trunk and neck < 0.35:
        if rng.random() < 0.6:
            profile = [(1, 0), (1, 0.3), (0.7, 0.5), (0.35, 1)]
            solid = lathe(profile[: rng.choice([2, 4])], sides=20)
        else:
            solid = block((-1, -1, 0), (1, 1, 1), 0.1)
        shape.add("foot", fit(solid, (-x, -x, 0), (x, x, foot)), at, parent)
        return
    y = depth / 2 * rng.uniform(0.95, 1.15)
    if trunk or (not is_round and rng.random() < 0.5):
        shape.add("foot", block((-x, -y, 0), (x, y, foot), rng.uniform(0, 0.3) * foot, 0.02), at, parent)
        if trunk and rng.random() < 0.5:
            shape.add("foot", block((-0.9 * x, -0.9 * y, 0), (0.9 * x, 0.9 * y, 1.1 * foot)), at, parent)
    elif is_round and rng.random() < 0.5:
        plan = rounded_rectangle(x, y, 0.3 * y)
        shape.add("foot", slab(plan, 0, 0.6 * foot, 0.1 * foot), at, parent)
        shape.add("foot", block((-0.5 * x, -0.6 * y, 0), (0.5 * x, 0.6 * y, foot + 0.08)), at, parent)
    elif is_round:
        r = min(0.09, 0.3 * x)
        lean = rng.uniform(0.1, 0.3)
        for side in (-1, 1) if depth > 0.3 else (0,):
            end = np.array([x - 0.8 * r, side * 0.3 * depth, 0])
            leg = bar(end, end + np.array([-lean * x, 0, foot + 0.25]), 0.8 * r, r, 8)
            shape.add_pair("foot", leg, (end[0], end[1], foot), parent)
    else:
        r = min(0.1, 0.4 * y, 0.4 * x)
        half = np.array([r, r, foot / 2])
        for side in (-1, 1):
            center = np.array([x - r, side * (y - r), foot / 2])
            ball = cushion(center, half, rng.choice([2, 6]), 8, 5)
            shape.add_pair("foot", fit(ball, center - half, center + half), at, parent)


def add_weights(shape, rng, low, height):
    """Add what hangs below a clock on a wall: a pendulum, perhaps two weights on chains."""
    at, drop = (0, 0, low), height * rng.uniform(0.2, 0.5)
    bob = upright_slab(outline(14) * 0.12, -0.03, 0.03)
    shape.add("pendulum", (bob[0] + np.array([0, 0, low - drop + 0.12]), bob[1]), at, "case")
    shape.add("pendulum", bar((0, 0, low - drop + 0.12), (0, 0, low), 0.02), at, "case")
    if rng.random() < 0.6:
        drop *= rng.uniform(0.6, 1.3)
        shape.add_pair("pendulum", bar((0.2, 0, low - drop), (0.2, 0, low), 0.015), at, "case")
        cone = lathe([(0.03, low - drop), (0.07, low - drop + 0.12), (0.02, low - drop + 0.24)], (0.2, 0), 8)
        shape.add_pair("pendulum", cone, at, "case")
