# SPDX-License-Identifier: MIT OR Apache-2.0
"""Shades of lamps, and the lid and ring over the glass of a lantern."""

import numpy as np

from .solids import fit, lathe, loft, tube


def lampshade(rng, size, tilt=0.0, up=False, cap=False, ball=False, dome=False):
    """A shade that fills a box of the given size about x = y = 0, its floor at z = 0."""
    slim = size[2] / size[:2].mean()
    half = np.append(size[:2] / 2, 0)
    box = (-half, half + np.array([0, 0, size[2]]))
    sides, soft = (20, 2.0) if rng.random() < 0.8 else (20, 12.0)
    if up:
        z = np.linspace(0, 1, 6)
        flare = rng.choice([0.5, 0.7, 1.0])
        profile = [(0.1 + 0.9 * a**flare, a) for a in z]
        profile += [(0.9, 0.97), (0.08, 0.15)]
    elif size[0] > 1.5 * size[1]:
        if rng.random() < 0.6:
            return fit(_trough(rng), *box)
        profile, soft = [(1, 0), (0.97, 0.1), (rng.uniform(0.45, 0.9), 0.9), (0.4, 1)], 5.0
    elif cap and slim > 1.6:
        profile = [(0.85, 0), (1, 0.15), (0.95, 0.35), (rng.uniform(0.45, 0.7), 1)]
    elif cap:
        sides, soft = [(4, 2.0), (6, 2.0), (20, 2.0), (8, 2.0)][rng.integers(4)]
        low = rng.uniform(0.6, 1.0)
        bulge = [(low, 0), (1, 0.45), (low * 0.9, 1)] if sides == 20 else [(low, 0), (1, 1)]
        profile = bulge if rng.random() < 0.7 else [(1, 0), (1, 1)]
    elif slim > 1.6:
        style = rng.choice(["drum", "drum", "spindle", "ribs", "cone"])
        a = np.linspace(0, 1, 13)
        if style == "spindle":
            profile = [(0.55 + 0.45 * np.sin(np.pi * (0.08 + 0.8 * x)), x) for x in a]
        elif style == "ribs":
            profile = [(1 - 0.12 * (i % 2), x) for i, x in enumerate(a)]
        else:
            profile = [(1, 0), (1 if style == "drum" else rng.uniform(0.6, 0.9), 1)]
    else:
        profile, round_only = _profile(rng, slim, ball, dome)
        soft = 2.0 if round_only else soft
    solid = lathe(profile, sides=sides, roundness=soft, caps=up or rng.random() < 0.75)
    if tilt and slim > 0.4:
        c, s = np.cos(tilt), np.sin(tilt)
        solid = solid[0] @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]]), solid[1]
    return fit(solid, *box)


def _profile(rng, slim, ball, dome):
    """A unit profile for a shade of ordinary proportions, and whether it is always round."""
    likely = np.array([1, 0.6, 0.5, 0.5, 0.6 if 0.8 < slim < 1.25 else 0.05])
    if ball or dome:
        likely = np.array([0, 0, 0, 0, 1.0]) if ball else np.array([0.25, 0, 0.25, 2, 0.7])
    style = rng.choice(["cone", "drum", "bell", "dome", "ball"], p=likely / likely.sum())
    if style == "cone":
        return [(1, 0), (rng.uniform(0.3, 0.8), 1)], False
    if style == "drum":
        return [(1, 0), (1, 1)], False
    if style == "bell":
        return [(1, 0), (0.75, 0.3), (0.5, 0.65), (0.3, 1)], True
    if style == "dome":
        return [(np.cos(x), np.sin(x)) for x in np.linspace(0, 0.48 * np.pi, 7)], True
    return [(np.cos(x), 0.5 + 0.5 * np.sin(x)) for x in np.linspace(-0.46, 0.46, 10) * np.pi], True


def _trough(rng):
    """Half a cylinder along x, open below: a banker's shade."""
    a = np.linspace(0, np.pi, 9)
    flat = rng.choice([0.0, 0.3])
    arc = np.column_stack([np.cos(a), np.maximum(np.sin(a), flat * np.sin(a) ** 0.2)])
    inner = arc[::-1] * 0.9
    section = np.concatenate([arc, inner])
    return loft([np.column_stack([np.full(len(section), x), section]) for x in (-1, 1)])


def add_cap(shape, rng, size, z, lid, ring):
    """Add the lid over a shade, and its ring where there is room."""
    over = rng.uniform(0.75, 0.85) if size[2] > 1.6 * size[0] else rng.uniform(0.85, 1.2)
    half = size[:2].max() / 2 * over
    slim = size[2] > 1.6 * size[0]
    sides = 16 if slim else int(rng.choice([4, 6, 16]))
    top = half * (rng.uniform(0.55, 0.75) if slim else rng.uniform(0.15, 0.6))
    profile = [(half, 0), (half, 0.15 * lid), (top, 0.9 * lid), (0.8 * top if slim else 0.1 * half, lid)]
    v, f = lathe(profile, sides=sides)
    v = fit((v, f), (-half, -half, z), (half, half, z + lid))[0]
    shape.add("cap", (v, f), (0, 0, z), "shade")
    if ring:
        a = np.linspace(-0.1, 1.1, 11) * np.pi
        r = 0.035 * size[0]
        w = half * rng.uniform(0.3, 0.95)
        path = np.column_stack([w * np.cos(a), 0 * a, z + 0.6 * lid + (ring + 0.4 * lid - r) * np.sin(a)])
        shape.add("cap", tube(path, r, 6), (0, 0, z), "shade")
