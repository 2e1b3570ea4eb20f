# SPDX-License-Identifier: MIT OR Apache-2.0
"""What carries a seat: legs with rails and aprons, a sled, panels, a plinth, a pedestal or a star."""

import numpy as np

from .solids import bar, block, cushion, lathe


def add_base(shape, rng, hx, hy, bottom, leg, base, is_round):
    """Add what carries the seat; the kind of it is `base`, its bars are `leg` thick."""
    half = leg / 2
    inset = rng.uniform(0, 0.12) if rng.random() < 0.7 else rng.uniform(0, 0.3)
    top = bottom + 0.02
    if base == "plinth":
        edge = 1 - rng.uniform(0, 0.15)
        shape.add(
            "leg", block((-hx * edge, -hy * edge, 0), (hx * edge, hy * edge, top), 0.02), (0, 0, top), "seat"
        )
    elif base in ("pedestal", "star"):
        foot = min(hx, hy) * rng.uniform(0.55, 1.0)
        r = half * rng.uniform(0.8, 1.6)
        low = 0.08 * bottom + 0.02
        if base == "star":
            count, turn = int(rng.choice([4, 5, 5])), rng.uniform(0, 1.5)
            for i in range(count):
                a = 2 * np.pi * i / count + turn
                tip = (foot * 1.1 * np.cos(a), foot * 1.1 * np.sin(a), half * 0.8)
                shape.add("leg", bar((0, 0, low + half), tip, half, half * 0.7, 6), (0, 0, top), "seat")
                if rng.random() < 0.7:
                    wheel = cushion((tip[0], tip[1], half * 0.6), (half, half, half * 0.8), 2.2, 8, 5)
                    shape.add("leg", wheel, (0, 0, top), "seat")
            profile = [(r * 1.2, low), (r * 1.2, bottom * 0.5), (r * 0.8, bottom * 0.52), (r * 0.8, top)]
        elif rng.random() < 0.6:
            profile = [
                (foot, 0),
                (foot, low * 0.5),
                (r * 1.5, low),
                (r, bottom * 0.2 + low),
                (r, bottom * 0.85),
                (r * 1.6, top),
            ]
        else:
            profile = [
                (foot, 0),
                (foot * 0.6, bottom * 0.15),
                (r * 0.9, bottom * 0.5),
                (foot * 0.5, bottom * 0.9),
                (foot * 0.6, top),
            ]
        shape.add("leg", lathe(profile, sides=14), (0, 0, top), "seat")
    elif base == "sled":
        x, sides = hx * (1 - inset) - half, rng.choice([4, 8])
        for y in (half - hy, hy - half):
            post = bar((x, y, top), (x, y, half), half * 0.8, sides=sides)
            shape.add_pair("leg", post, (x, 0, top), "seat")
        shape.add_pair("leg", bar((x, -hy, half), (x, hy, half), half * 0.8), (x, 0, top), "seat")
    elif base == "panels":
        x = hx - half
        shape.add_pair("leg", block((x - half, -hy, 0), (x + half, hy, top), 0.01), (x, 0, top), "seat")
    else:
        _legs(shape, rng, hx, hy, bottom, half, inset, is_round)


def _legs(shape, rng, hx, hy, bottom, half, inset, is_round):
    """Straight or bowed legs, perhaps with rails between them and an apron below the seat."""
    top = bottom + 0.02
    splay = rng.choice([0, rng.uniform(-0.05, 0.22)]) * min(1.0, bottom)
    taper = rng.choice([1.0, rng.uniform(0.45, 1.0)])
    sides = int(rng.choice([4, 4, 10]))
    bow = np.array([0, rng.choice([0, 0, 0.08]), 0]) * bottom
    k = 0.68 if is_round else 1.0
    x, y = (hx * (1 - inset) - half) * k, (hy * (1 - inset) - half) * k
    for s in (-1, 1):
        a, b = (x, s * y, top), (x + splay, s * (y + splay), 0)
        shape.add_pair("leg", bar(a, b, half, half * taper, sides, bow * s), a, "seat")
    if 2 * hx > 2.4 and rng.random() < 0.4:
        for s in (-1, 1):
            shape.add(
                "leg", bar((0, s * y, top), (0, s * y, 0), half, half * taper, sides), (0, s * y, top), "seat"
            )
    if rng.random() < (0.45 if bottom < 1.4 else 0.8):
        z, r = bottom * rng.uniform(0.12, 0.6), half * rng.uniform(0.4, 0.8)
        out = splay * (1 - z / bottom)
        rails = rng.choice(["sides", "ring", "h"])
        shape.add_pair("rail", bar((x + out, -y - out, z), (x + out, y + out, z), r), (x, 0, bottom), "seat")
        if rails == "ring":
            for s in (-1, 1):
                shape.add(
                    "rail",
                    bar((-x - out, s * (y + out), z), (x + out, s * (y + out), z), r),
                    (0, s * y, bottom),
                    "seat",
                )
        elif rails == "h":
            shape.add("rail", bar((-x - out, 0, z), (x + out, 0, z), r), (0, 0, bottom), "seat")
    if rng.random() < 0.35:
        low, r, at = bottom - min(rng.uniform(0.05, 0.14), 0.3 * bottom), half * 0.5, (0, 0, bottom)
        for i in (-1, 1):
            shape.add("apron", block((-x, i * y - r, low), (x, i * y + r, bottom)), at, "seat")
            shape.add("apron", block((i * x - r, -y, low), (i * x + r, y, bottom)), at, "seat")
