# SPDX-License-Identifier: MIT OR Apache-2.0
"""Roofs of buildings: pitched, flat, in setbacks, round, or the tank of a water tower."""

import numpy as np

from .masonry import boxes, merge, stack
from .solids import cushion, lathe


def add_roof(shape, rng, half, rise, roof, over, axis, is_round, tank, keep):
    """Add the roof that the proportions and the kind of building ask for."""
    at = (0, 0, rise)
    x, y = half * over
    top = rise + roof
    if tank:
        solid = _tank(rng, half * over, rise, roof)
    elif is_round:
        solid = _round_roof(rng, half * over, rise, roof, over)
    elif roof < (0.14 if rng.random() < 0.6 else 0.06) or (rise > 1.4 and roof < 0.35 and rng.random() < 0.8):
        solid = _flat_roof(rng, x, y, rise, roof, keep)
    elif over < 0.88:
        solid = _setbacks(rng, x, y, rise, roof)
    else:
        solid = _pitched_roof(rng, x, y, rise, top, axis, keep)
    shape.add("roof", solid, at, "walls")


def _pitched_roof(rng, x, y, rise, top, axis, keep):
    """A roof of straight eaves: a level is a share of the height and what is left of both sides."""
    lip = min(0.05, 0.2 * (top - rise))
    long = rng.uniform(0.25, 0.8)
    styles = {
        "gable": [(1, 1.0, 0.01)],
        "hip": [(1, long, 0.01)],
        "pyramid": [(1, 0.01, 0.01)],
        "gambrel": [(0.62, 1.0, 0.66), (1, 1.0, 0.01)],
        "mansard": [(0.75, 0.86, 0.8), (1, 0.5, 0.3)],
        "barrel": [(np.sin(a), 1.0, max(np.cos(a), 0.02)) for a in np.linspace(0.2, np.pi / 2, 6)],
        "pent": [(1, 1.0, 0.0)],
    }
    odds = [0.48, 0.2, 0.06, 0.12, 0.05, 0.03, 0.06]
    if keep or top - rise > 1.2:
        odds = [0.1, 0.1, 0.8, 0, 0, 0, 0]
    elif top - rise < 0.3:
        odds = [0.4, 0.2, 0.02, 0, 0, 0.08, 0.3]
    style = rng.choice(list(styles), p=odds)
    levels = [(rise, x, y), (rise + lip, x, y)]
    for share, s, t in styles[style]:
        z = rise + lip + (top - rise - lip) * share
        sx, sy = (s, t) if axis == 0 else (t, s)
        levels.append((z, x * sx, y * sy) if style != "pent" else (z, x, 0.01 * y, 0.99 * y))
    return stack(levels)


def _flat_roof(rng, x, y, rise, roof, keep):
    """A slab, with battlements, a parapet or a rooftop room where there is height for it."""
    style = rng.choice(["battlements", "battlements", "slab"] if keep else ["slab", "parapet", "room"])
    if roof < 0.06 or style == "slab":
        return stack([(rise, x, y), (rise + roof, x, y)])
    low = rise + 0.4 * roof
    base = stack([(rise, x, y), (low, x, y)])
    if style == "room":
        low = rise + 0.04
        base = stack([(rise, x, y), (low, x, y)])
        k = rng.uniform(0.3, 0.7)
        return merge([base, stack([(low, k * x, k * y), (rise + roof, k * x, k * y)])])
    t = 0.06 * min(1, 2 * min(x, y))
    tall = (rise + roof - low) / 2
    z = low + tall
    if style == "parapet":
        return merge([base, *_edges(x, y, t, z, tall)])
    count = int(rng.integers(3, 6))
    u = np.linspace(-1, 1, count)
    at = [(a * (x - t), s * (y - t), z) for a in u for s in (-1, 1)]
    at += [(s * (x - t), a * (y - t), z) for a in u[1:-1] for s in (-1, 1)]
    return merge([base, boxes(at, (t, t, tall))])


def _edges(x, y, t, z, tall):
    """Four low walls along the edges of a rectangle."""
    return [
        boxes([(0, s * (y - t), z) for s in (-1, 1)], (x, t, tall)),
        boxes([(s * (x - t), 0, z) for s in (-1, 1)], (t, y, tall)),
    ]


def _setbacks(rng, x, y, rise, roof):
    """Ever smaller storeys, the last one sometimes pointed."""
    count = int(rng.integers(1, 4))
    z = rise + roof * np.linspace(0, 1, count + 1)
    k = np.linspace(1, rng.uniform(0.5, 0.85), count)
    levels = [(h, x * s, y * s) for i, s in enumerate(k) for h in (z[i], z[i + 1])]
    if rng.random() < 0.4:
        levels[-1] = (rise + roof, 0.02 * x, 0.02 * y)
    return stack(levels)


def _round_roof(rng, size, rise, roof, over):
    """A lantern on a slim top, battlements or a cap on a low one, otherwise a cone or a dome."""
    top, r = rise + roof, 1.0
    if over < 0.88:
        low, high, cap = rise + 0.12 * roof, rise + rng.uniform(0.5, 0.7) * roof, rng.uniform(0.7, 0.9)
        lamp = rng.uniform(0.5, 0.7)
        profile = [(r * 0.8, rise), (r, low - 0.05 * roof), (r, low), (lamp, low), (lamp, high), (cap, high)]
        profile += [(cap * 0.7, high + 0.5 * (top - high)), (0.05, top)]
    elif roof < 0.35 and rise > 0.8:
        low = rise + 0.45 * roof
        base = lathe([(r * 0.9, rise), (r, rise + 0.2 * roof), (r, low)], sides=20, squash=size)
        a = np.arange(8) * np.pi / 4
        t = 0.13 * size.mean()
        at = np.column_stack([(size - t) * np.stack([np.cos(a), np.sin(a)], 1), 0 * a + (low + top) / 2])
        return merge([base, boxes(at, (t, t, (top - low) / 2))])
    elif rng.random() < 0.7:
        bow = rng.uniform(-0.08, 0.08)
        profile = [(r, rise), (r, rise + 0.04 * roof), (0.5 + bow, rise + 0.5 * roof), (0.02, top)]
    else:
        profile = [(r * np.cos(a), rise + roof * np.sin(a)) for a in np.linspace(0, 0.49 * np.pi, 7)]
        profile[-1] = (0.03, top)
    return lathe(profile, sides=20, squash=size)


def _tank(rng, size, rise, roof):
    """The tank of a water tower, wider than what it stands on."""
    style = rng.choice(["drum", "drum", "bowl", "ball"])
    if style == "ball":
        return cushion((0, 0, rise + roof / 2), (*size, roof / 2 / 0.991), 2, 20, 9)
    low, high = rng.uniform(0.0, 0.2), rng.uniform(0.65, 0.9)
    foot = rng.uniform(0.4, 1.0) if low > 0.05 else 1.0
    if style == "bowl":
        low, high, foot = rng.uniform(0.4, 0.7), rng.uniform(0.75, 0.95), rng.uniform(0.3, 0.5)
    profile = [(foot, rise), (1, rise + low * roof + 1e-3), (1, rise + high * roof), (0.05, rise + roof)]
    return lathe(profile, sides=20, squash=size)
