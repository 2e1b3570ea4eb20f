# SPDX-License-Identifier: MIT OR Apache-2.0
"""What is over the case of a clock: bells, a gable, an arch, steps or a handle."""

import numpy as np

from .solids import bar, block, fit, lathe, tube, upright_slab


def add_bells(shape, rng, high, top, depth, eave):
    """Add two bells, and a handle over them or a hammer between them."""
    eave = np.clip(eave, 0.6, 1.2)
    r = eave * rng.uniform(0.2, 0.25)
    x = eave / 2 - r
    a = np.linspace(0, 0.47 * np.pi, 5)
    v, f = lathe([(np.cos(t), np.sin(t)) for t in a], sides=12)
    # The bells sit on the round shoulder and lean outwards.
    down = high - 0.5 + np.sqrt(max(0.25 - x * x, 0.0))
    v = v + v[:, 2:] * np.array([0.25, 0, 0])
    deep = min(r, 0.7 * depth)
    handle = rng.random() < 0.5
    peak = high + top * (0.7 if handle else 1.0)
    dome = fit((v, f), (x - r, -deep, down + 0.03), (x + r, deep, peak))
    shape.add_pair("bell", dome, (x, 0, down), "case")
    if handle:
        t = np.linspace(0, np.pi, 9)
        path = np.column_stack([x * np.cos(t), 0 * t, high + (top - 0.02) * np.sin(t)])
        shape.add("bell", tube(path, 0.02, 6), (0, 0, high), "case")
    else:
        shape.add("bell", bar((0, 0, high - 0.03), (0, 0, high + 0.8 * top), 0.03), (0, 0, high), "case")


def add_top(shape, rng, high, top, depth, eave, is_round):
    """Add a gable, an arch, steps or a handle."""
    at, half = (0, 0, high), eave / 2
    y = depth / 2 * np.clip(eave, 0.6, 1.2)
    style = rng.choice(["gable", "arch", "steps", "handle"], p=_top_odds(eave, top))
    if style == "handle":
        r = min(0.04, 0.3 * top)
        a = np.linspace(0, np.pi, 13)
        square = rng.choice([0.3, 0.6, 1.0])
        low = high - (0.2 if is_round else 0.02)
        path = np.column_stack(
            [
                np.sign(np.cos(a)) * np.abs(np.cos(a)) ** square * (half - r),
                0 * a,
                low + (high + top - r - low) * np.sin(a) ** square,
            ]
        )
        shape.add("top", tube(path, r, 6), at, "case")
        return
    if style == "gable":
        lip = 0.12 * top
        plan = np.array([[-half, 0], [half, 0], [half, lip], [0, top], [-half, lip]])
        solid = upright_slab(plan, -y, y)
    elif style == "arch":
        a = np.linspace(0, np.pi, 13)
        solid = upright_slab(np.column_stack([half * np.cos(a), top * np.sin(a)]), -y, y)
    else:
        count = int(rng.choice([1, 2, 3]))
        for i in range(count):
            k = 1 - 0.25 * i
            box = block(
                (-half * k, -y * k, high + top * i / count), (half * k, y * k, high + top * (i + 1) / count)
            )
            shape.add("top", box, at, "case")
        return
    shape.add("top", (solid[0] + np.array([0, 0, high]), solid[1]), at, "case")


def _top_odds(eave, top):
    """How likely the styles of a top are: gable, arch, steps, handle."""
    if eave > 1.15 and top > 0.2:
        return [1, 0, 0, 0]
    # A handle needs room to be gripped.
    return [0.15, 0.15, 0.15, 0.55] if eave < 0.85 and top > 0.15 else [0.3, 0.3, 0.4, 0.0]
