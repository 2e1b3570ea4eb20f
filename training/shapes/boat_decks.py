# SPDX-License-Identifier: MIT OR Apache-2.0
"""What stands and lies on the hull of a boat: cabins, conning towers, funnels, fittings, loads."""

import numpy as np

from .solids import bar, block, cushion, lathe, outline, slab, tube


def add_house(shape, rng, deck, middle, long, tall, body):
    """Add storeys that step back, the lowest as long as asked, all as high as asked together."""
    beam, base = deck(middle)
    at = (0, middle, base)
    y0, y1 = middle - long / 2, middle + long / 2
    top = deck(0.0)[1] + tall
    if body == "round":
        _conning_tower(shape, rng, beam, base, middle, long, top, at)
        return
    wide = beam * rng.uniform(0.7, 0.95)
    storeys = int(np.clip(round(tall / rng.uniform(0.22, 0.45)), 1, 4))
    lean = rng.choice([0.05, rng.uniform(0.0, 0.9)])
    start = min(*(deck(y)[1] for y in (y0, middle, y1)), top - 0.1 * tall) - 0.03
    levels = start + (top - start) * np.linspace(0, 1, storeys + 1)
    trim = rng.uniform(0.0, 0.16, 2)
    straight_stern = rng.random() < 0.5
    for i in range(storeys):
        z0, z1 = levels[i], levels[i + 1]
        a, b = y0 + long * trim[0] * i, y1 - long * trim[1] * i
        y = np.linspace(a, b, 7)
        half = np.minimum(wide * (1 - 0.06 * i), np.maximum(0.95 * deck(y)[0], 0.12 * beam))
        half[0] *= rng.uniform(0.7, 1.0)
        plan = np.concatenate([np.column_stack([half, y]), np.column_stack([-half[::-1], y[::-1]])])
        middle_y = (a + b) / 2
        v, f = slab(plan - (0, middle_y), z0, z1, 0.12 * rng.random() * (z1 - z0), (0, middle_y))
        share = (v[:, 2] - z0) / (z1 - z0)
        ahead = np.clip((middle_y - v[:, 1]) / (b - a) * 2, -1, 1)
        ahead = np.maximum(ahead, 0.0) if straight_stern else np.maximum(ahead, 0.4 * ahead)
        v[:, 1] += ahead * min(lean * (z1 - z0), 0.3 * (b - a)) * share
        shape.add("cabin", (v, f), at, "hull")


def _conning_tower(shape, rng, beam, base, middle, long, top, at):
    """The conning tower of a submarine, sometimes with planes."""
    w = min(rng.uniform(0.12, 0.2), 0.8 * beam)
    plan = outline(16, 2.0) * (w, long / 2)
    shape.add("cabin", slab(plan, base - 0.2 * beam, top, 0.02, (0, middle)), at, "hull")
    if rng.random() < 0.6:
        z = (base + top) / 2
        plane = block((-2.2 * w, middle - 0.3 * long, z), (2.2 * w, middle + 0.1 * long, z + 0.04))
        shape.add("plane", plane, (0, middle, z), "cabin")


def add_funnels(shape, rng, roof, middle, long, tall):
    """Add one to three funnels on the roof."""
    count = int(rng.choice([1, 1, 1, 2, 3])) if long > 1.6 and tall > 0.15 else 1
    r = min(rng.uniform(0.09, 0.17), 0.4 * long / count)
    rake = rng.choice([0.0, 0.25]) * tall
    places = (
        [middle + rng.uniform(-0.05, 0.25) * long]
        if count == 1
        else middle + np.linspace(-0.28, 0.28, count) * long
    )
    for y in places:
        v, f = lathe(
            [
                (r * 1.05, roof - 0.05),
                (r, roof + 0.8 * tall),
                (r * 1.1, roof + 0.82 * tall),
                (r * 1.1, roof + tall),
            ],
            sides=12,
            squash=(1, rng.uniform(1, 1.4)),
        )
        v[:, 1] += y + rake * (v[:, 2] - roof) / tall
        shape.add("funnel", (v, f), (0, y, roof), "cabin")


def add_fittings(shape, rng, deck, long, deep, cabin, body, mast):
    """Add what lies on the hull: thwarts, oars, the rim of a cockpit, a load, a hump on the bow."""
    if body == "open":
        for y in np.linspace(-0.25, 0.28, int(rng.integers(2, 5))) * long:
            half, z = deck(y)
            z -= 0.3 * deep
            seat = block(
                (-0.88 * half, y - 0.03 * min(long, 4), z - 0.03), (0.88 * half, y + 0.03 * min(long, 4), z)
            )
            shape.add("fitting", seat, (0, y, z), "hull")
        if long < 4.5 and not cabin and not mast and rng.random() < 0.4:
            half, z = deck(0.0)
            shape.add_pair(
                "oar",
                bar((half, 0, z), (half + 0.6, rng.uniform(-0.4, 0.4), 0.4 * z), 0.025, sides=6),
                (half, 0, z),
                "hull",
            )
    elif body == "decked" and not cabin and long > 4.5 and not mast:
        half, z = deck(0.0)
        rim = outline(14) * (0.6 * half, min(0.07 * long, 0.6))
        path = np.column_stack([rim, np.full(14, z + 0.09)])
        shape.add("fitting", tube(np.concatenate([path, path[:2]]), 0.07, 6, caps=False), (0, 0, z), "hull")
    elif body == "decked" and cabin and cabin < 0.25 and long > 4.8 and rng.random() < 0.6:
        _load(shape, rng, deck, long)
    elif body == "decked" and rng.random() < 0.3:
        y = -0.42 * long
        half, z = deck(y)
        lump = cushion((0, y, z), (0.4 * half, 0.02 * long + 0.05, 0.08), 4, 8, 5)
        shape.add("fitting", lump, (0, y, z), "hull")


def _load(shape, rng, deck, long):
    """Containers or hatches along the deck of a freighter, clear of its cabin."""
    cabin = shape.points("cabin")
    a, b = -0.36 * long, 0.4 * long
    if cabin[:, 1].mean() > 0:
        b = cabin[:, 1].min() - 0.1
    else:
        a = cabin[:, 1].max() + 0.1
    count = int(rng.integers(2, 7))
    if b - a < 0.2 * long:
        return
    tall = rng.choice([0.06, rng.uniform(0.2, 0.5), rng.uniform(0.2, 0.5)])
    for i in range(count):
        y0, y1 = a + (b - a) * i / count, a + (b - a) * (i + 0.9) / count
        half, z = min(deck(y0)[0], deck(y1)[0]), deck((y0 + y1) / 2)[1]
        high = tall * rng.uniform(0.8, 1.0)
        crate = block((-0.85 * half, y0, z - 0.05), (0.85 * half, y1, z + high))
        shape.add("fitting", crate, (0, (y0 + y1) / 2, z), "hull")
