# SPDX-License-Identifier: MIT OR Apache-2.0
"""What a handle carries: blades, and the heads of axes, hammers, picks, shovels and wrenches.

Each is made in any box; the caller stretches it to its size.
"""

import numpy as np

from .solids import loft, outline

# Heads that the handle goes through, with their least and greatest thickness per height.
ACROSS = {"axe": (0.06, 0.7), "hammer": (0.42, 2.2), "pick": (0.2, 1.5)}


def _section(z, left, right, spine):
    """A loft along z from edge to edge; the section is thickest at the share `spine` of its width."""
    rings = []
    for t, a, b in zip(z, left, right, strict=True):
        x = a + (b - a) * spine
        rings.append([(a, 0, t), (x, -1, t), (b, 0, t), (x, 1, t)])
    return loft(rings)


def _double(rng, size):
    """Two edges: straight to the tip, or a leaf."""
    waist, tip = rng.uniform(0.75, 1.0), rng.uniform(0.08, 0.3)
    if size[0] > 0.12 * size[2] and rng.random() < 0.5:  # a leaf, as on a spear
        z, w = (0, 0.05, 0.3, 0.6, 1), (0.35, 0.5, 1, 0.7, 0.03)
    else:
        z, w = (0, 0.4, 1 - tip, 1 - tip / 2, 1), (1, (1 + waist) / 2, waist, 0.62 * waist, 0.03)
    w = np.array(w)
    return _section(z, -w, w, 0.5)


def _single(rng, size):
    """One edge and a straight or dropped back."""
    belly, drop = rng.uniform(0.55, 0.75), rng.choice([0.0, 0.3, 0.7])
    z = np.array([0, 0.04, 0.3, belly, (1 + belly) / 2 + 0.04, 1])
    edge = np.array([0.9, 1, 1, 0.96, 0.7, 0.0])
    back = drop * np.array([0, 0, 0, 0, 0.25, 1]) * 0.5
    return _section(z, back, np.maximum(edge, back + 0.03), rng.choice([0.03, 0.3]))


def _curved(rng, size):
    """One edge on a bow."""
    z = np.linspace(0, 1, 8)
    bow = rng.uniform(0.5, 1.4) * z**2
    w = np.array([1, 0.98, 0.95, 0.93, 0.9, 0.88, 0.75, 0.04]) * rng.uniform(0.9, 1)
    return _section(z, -bow, w - bow, rng.choice([0.05, 0.5]))


def _slab(rng, size):
    """One edge, wide to its end: a cleaver, a machete."""
    step = rng.choice([0.0, 0.06])
    z = (0, 0.02 + step, 0.05 + step, 0.5, 0.93, 1)
    edge = np.array([0.4 if step else 1, 0.42 if step else 1, 1, 1 + rng.uniform(0, 0.08), 1, 0.92])
    return _section(z, np.zeros(6), edge, rng.uniform(0.1, 0.4))


def _rod(rng, size):
    """The shaft of a screwdriver, flat or pointed at its end."""
    z = (0, 0.88, 0.94, 1)
    plan = outline(8)
    flat = (
        ((1, 1), (1, 1), (1.25, 0.5), (1.1, 0.15))
        if rng.random() < 0.5
        else ((1, 1),) * 2 + ((0.9, 0.9), (0.3, 0.3))
    )
    return loft([np.column_stack([plan * s, np.full(8, t)]) for s, t in zip(flat, z, strict=True)])


def _scoop(rng, size):
    """A dished sheet: a shovel."""
    x = np.linspace(-1, 1, 7)
    z, w = (0, 0.1, 0.16, 0.5, 0.8, 1), np.array([0.16, 0.22, 0.92, 1, 0.85, 0.15])
    if rng.random() < 0.4:
        w[-2:] = 0.95, 0.88
    dish, lean = rng.uniform(0.3, 1.0), rng.uniform(-0.5, 0.5)
    rings = []
    for t, half in zip(z, w, strict=True):
        y = dish * (x * half) ** 2 + lean * t
        front, back = np.stack([x * half, -y - 0.12], 1), np.stack([x * half, -y + 0.12], 1)[::-1]
        rings.append(np.column_stack([np.concatenate([front, back]), np.full(14, t)]))
    return loft(rings)


def _jaw(rng, size):
    """Two prongs on a base: a wrench."""
    flare, inside, depth = rng.uniform(0.75, 1.0), rng.uniform(0.3, 0.45), rng.uniform(0.4, 0.6)
    base = np.array([(-0.4, 0), (0.4, 0), (1, 0.35), (1, depth), (-1, depth), (-1, 0.35)])
    prong = np.array([(inside, depth - 0.1), (1, depth - 0.1), (flare, 0.95), (0.5, 1), (inside, 0.85)])
    made = []
    for plan in (base, prong, prong * (-1, 1)):
        made.append(loft([np.column_stack([plan[:, 0], np.full(len(plan), y), plan[:, 1]]) for y in (-1, 1)]))
    return made


def _axe(rng, size):
    """One bit with a beard, or two."""
    flare, eye = rng.uniform(0.35, 0.65), rng.uniform(0.3, 0.45)
    if rng.random() < 0.35:
        x, t = np.array([-1, -0.75, -0.2, 0.2, 0.75, 1]), (0.05, 0.3, 1, 1, 0.3, 0.05)
        up, down = np.array([0.8, 1, eye, eye, 1, 0.8]), np.array([0.8, 1, eye, eye, 1, 0.8])
    else:  # a beard hangs further down than the edge rises; x beyond 1 says that the bit is on one side
        x, t = np.array([-0.35, 0, 0.3, 0.8, 1.1]), (0.9, 1, 0.8, 0.3, 0.04)
        beard = rng.uniform(1.0, 1.8)
        up, down = np.array([eye, eye, flare * 0.9, 0.9, 1]), np.array([eye, eye, flare, beard, 0.95 * beard])
    return loft([np.array([(a, -y, -d), (a, y, -d), (a, y, u), (a, -y, u)])
                 for a, y, u, d in zip(x, t, up, down, strict=True)])  # fmt: skip


def _hammer(rng, size):
    """Two faces, a face and a claw, or a wedge."""
    style = rng.choice(["claw", "even", "even", "waisted", "wedge"])
    if size[0] < 2.2 * size[2]:
        style = rng.choice(["even", "even", "waisted"])
    plan = outline(12, rng.choice([2.0, 4.0, 8.0]), np.pi / 12)
    x = np.array([-1, -0.7, -0.62, -0.25, 0.25, 0.62, 0.7, 1])
    s, drop, flat = np.ones(8), np.zeros(8), np.ones(8)
    s[[0, 7]] = 0.94
    if style == "waisted":
        s[2:6] = 0.75, 0.8, 0.8, 0.75
    elif style in ("claw", "wedge"):
        s[2:4] = 0.7, 0.85
        flat[4:] = 0.9, 0.6, 0.45, 0.12
        if style == "claw":
            drop[5:] = 0.05, 0.15, 0.55
    rings = [np.column_stack([np.full(12, a), plan[:, 0] * k, plan[:, 1] * k * f - d])
             for a, k, d, f in zip(x, s, drop, flat, strict=True)]  # fmt: skip
    return loft(rings)


def _pick(rng, size):
    """Two points on a bow, one perhaps an adze."""
    x = np.linspace(-1, 1, 9)
    bow = rng.uniform(0.7, 2.0) * x**2
    tall = np.array([0.06, 0.24, 0.32, 0.4, 0.55, 0.4, 0.32, 0.24, 0.06])
    deep = np.array([0.15, 0.4, 0.5, 0.6, 1, 0.6, 0.5, 0.4, 0.15])
    if rng.random() < 0.4:  # an adze on one side
        deep[5:], tall[5:] = (0.7, 0.85, 0.95, 1.0), (0.3, 0.22, 0.15, 0.06)
    return loft([np.array([(a, -y, -d - t), (a, y, -d - t), (a, y, t - d), (a, -y, t - d)])
                 for a, y, t, d in zip(x, deep, tall, bow, strict=True)])  # fmt: skip


# What a handle carries: how it is made, and the widths per length at which it can be.
HEADS = {
    "double": (_double, 0.0, 0.9),
    "single": (_single, 0.0, 0.8),
    "curved": (_curved, 0.0, 0.4),
    "slab": (_slab, 0.1, 1.0),
    "rod": (_rod, 0.0, 0.45),
    "scoop": (_scoop, 0.4, 1.3),
    "jaw": (_jaw, 0.6, 2.0),
    "axe": (_axe, 0.75, 3.5),
    "hammer": (_hammer, 0.9, 10.0),
    "pick": (_pick, 2.5, 10.0),
}
