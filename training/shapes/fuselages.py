# SPDX-License-Identifier: MIT OR Apache-2.0
"""Bodies of aircraft: the hull of an airship, fuselages with cabins and fairings."""

import numpy as np

from .aeroplane_wings import LEVELS
from .solids import block, cushion, loft, outline


def add_hull(shape, rng, radius):
    """Add the hull and the cabin of an airship."""
    t = np.linspace(0, 1, 17)
    profile = np.maximum(
        (4 * t * (1 - t)) ** rng.uniform(0.5, 0.75) * (1 + rng.uniform(0, 0.25) * (0.5 - t)), 0.04
    )
    profile /= profile.max()
    ring = outline(14, 2.0, 0.1) * radius
    shape.add(
        "fuselage",
        loft(
            [
                np.c_[ring[:, :1] * r, np.full(14, y - 0.5), ring[:, 1:] * r]
                for r, y in zip(profile, t, strict=True)
            ]
        ),
    )
    size = np.array([0.25 * radius, rng.uniform(0.06, 0.14), 0.2 * radius])
    at = np.array([0, rng.uniform(-0.2, 0), -radius * 1.08])
    shape.add("cabin", block(at - size, at + size, 0.1 * radius), at, "fuselage")


def add_fuselage(shape, rng, p, radius, tail_up, facts, flying_wing):
    """Add a fuselage whose end rises by `tail_up`, and a cockpit, a hump or a fairing on it."""
    fast = np.clip(p["sweep"] - 0.4, 0, 1) * np.clip((0.17 - p["slim"]) / 0.06, 0, 1)
    t = np.linspace(0, 1, 17)
    t = 0.5 * (t + (1 - np.cos(np.pi * t)) / 2)
    nose = rng.uniform(0.06, 0.14) + fast * rng.uniform(0.1, 0.3)
    profile = np.minimum(np.clip(t / nose, 0, 1) ** (0.5 + 0.35 * fast), 1)
    shuttle = p["slim"] > 0.14 and p["sweep"] > 0.8 and p["tail"] < 0.1
    end = (
        rng.uniform(0.7, 0.9) if shuttle else rng.uniform(0.4, 0.75) if fast > 0.2 else rng.uniform(0.08, 0.4)
    )
    length = rng.uniform(0.1, 0.2) if shuttle else rng.uniform(0.2, 0.55)
    k = np.clip((t - (1 - length)) / length, 0, 1)
    profile *= 1 - (1 - end) * k ** rng.uniform(1.2, 2.2)
    boom = facts["engines"] in ("none", "pusher") and p["chords"] > 9 and rng.random() < 0.7
    if boom:  # a glider's or drone's head before a thin boom
        profile = np.minimum(profile, 0.35 + 0.65 * np.clip((rng.uniform(0.4, 0.6) - t) / 0.22 + 0.5, 0, 1))
    drop = 0.25 * radius * (1 - np.clip(t / nose, 0, 1)) * rng.uniform(0, 1)
    z = tail_up * k**1.5 - drop
    profile = np.maximum(profile / profile.max(), 0.05)
    wide = (
        np.sqrt(rng.uniform(1.2, 2.0)) if flying_wing else np.sqrt(rng.choice([1.0, rng.uniform(0.8, 1.25)]))
    )
    ring = outline(14, rng.choice([2, 2, 2.4, 3.5]), 0.1) * (wide, 1 / wide)
    ring /= np.abs(ring).max(0) / (wide, 1 / wide)
    rings = [
        np.column_stack([ring[:, 0] * radius * r, np.full(14, y - 0.5), ring[:, 1] * radius * r + h])
        for r, y, h in zip(profile, t, z, strict=True)
    ]
    shape.add("fuselage", loft(rings))
    if rng.random() < (0.8 if fast > 0.3 or facts["engines"] in ("nose", "none") else 0.2):
        y = -0.5 + nose + rng.uniform(0.0, 0.12)
        half = (radius * 0.5, rng.uniform(0.06, 0.12), radius * rng.uniform(0.45, 0.7))
        shape.add("cabin", cushion((0, y, radius * 0.7), half, 2.2, 10, 6), (0, y, radius * 0.7), "fuselage")
    elif p["chords"] > 4 and p["sweep"] > 0.2 and rng.random() < 0.2:  # a jumbo's hump
        size = (radius * 0.7, rng.uniform(0.12, 0.18), radius * 0.5)
        shape.add(
            "cabin",
            cushion((0, -0.28, radius * 0.75), size, 2.2, 10, 6),
            (0, -0.28, radius * 0.7),
            "fuselage",
        )
    elif rng.random() < 0.3 and not flying_wing:  # a fairing where the wings meet the belly
        at = (0, rng.uniform(-0.08, 0.02), LEVELS[facts["level"]] * radius)
        shape.add(
            "root",
            cushion(at, (radius * 1.1, rng.uniform(0.1, 0.16), radius * 0.45), 2.5, 12, 6),
            at,
            "fuselage",
        )
