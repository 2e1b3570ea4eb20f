# SPDX-License-Identifier: MIT OR Apache-2.0
"""Wheels and axles of cars, and what sticks out of the body."""

import numpy as np

from .solids import bar, block, cushion, lathe, loft


def add_wheels(shape, rng, outer, wheel, axles, low, half):
    """Add a pair of wheels on every axle; axles and posts where the body is far from them."""
    r = wheel / 2
    wide = min(wheel * (rng.uniform(0.26, 0.4) if wheel < 0.5 else rng.uniform(0.4, 0.6)), 0.7 * outer)
    rim, dish, edge = rng.uniform(0.5, 0.75), rng.uniform(-0.1, 0.3), rng.uniform(0.9, 1.0)
    side = [(rim * r, 0.5 - dish), (rim * r * 1.02, 0.5), (edge * r, 0.5), (r, 0.38)]
    profile = [(a, -b * wide) for a, b in side] + [(a, b * wide) for a, b in side[::-1]]
    sides = 16 if len(axles) == 2 else 12
    vertices, faces = lathe(profile, sides=sides)
    round_up = 1 / np.cos(np.pi / sides)
    vertices = vertices[:, [2, 1, 0]] * (1, round_up, round_up)
    x = outer - wide / 2
    for a in axles:
        at = (min(x, half), a, r)
        shape.add_pair("wheel", (vertices + np.array([x, a, r]), faces[:, ::-1]), at, "body")
    if low > 1.1 * r or outer > 1.2 * half:
        thick = 0.1 * wheel
        for a in axles:
            shape.add("trim", bar((-x, a, r), (x, a, r), thick * 0.6, sides=6), (0, a, max(r, low)), "body")
            post = (0.6 * half, a, low + 0.05)
            shape.add_pair("trim", bar((0.6 * half, a, r), post, thick * 0.5), post, "body")


def add_trim(shape, rng, half, low, belt, height, ends, wheel, track, bare, bed):
    """Add bumpers, lamps, mirrors, wings and mudguards."""
    start, front, _, end = ends
    tall, length = belt - low, end - start
    at = (0, start, low + 0.3 * tall)
    if bare:
        for y, z, w in ((start + 0.04, low + 0.02, 0.48), (end - 0.1, belt * rng.uniform(1.0, 1.25), 0.36)):
            shape.add("trim", block((-w, y - 0.1, z), (w, y + 0.1, z + 0.03)), (0, y, z), "body")
            shape.add_pair(
                "trim", block((w - 0.02, y - 0.1, z - 0.1), (w, y + 0.1, z + 0.06)), (0, y, z), "body"
            )
        post = (0, end - 0.1, belt - 0.1)
        shape.add("trim", bar(post, (0, end - 0.1, belt * 1.1), 0.03), post, "body")
        return
    if rng.random() < 0.45:
        z, d = low + 0.25 * tall, rng.uniform(0.02, 0.05)
        shape.add(
            "trim",
            block((-half * 0.96, start - d, z - 0.04), (half * 0.96, start + 0.06, z + 0.05), 0.02),
            at,
            "body",
        )
        if not bed:
            shape.add(
                "trim",
                block((-half * 0.96, end - 0.06, z - 0.04), (half * 0.96, end + d, z + 0.05), 0.02),
                (0, end, z),
                "body",
            )
    if rng.random() < 0.4:
        lamp = (half * 0.7, start + 0.03, low + 0.55 * tall)
        shape.add_pair("trim", cushion(lamp, (0.07, 0.05, 0.05), 2.2, 8, 5), lamp, "body")
    if rng.random() < 0.4:
        z = belt + 0.25 * (height - belt) if height > 1.1 else belt + 0.04
        y = front + 0.08 * min(length, 3)
        root = (half * 0.9, y, z)
        shape.add_pair(
            "trim", block((half * 0.9, y - 0.03, z - 0.03), (half + 0.06, y + 0.02, z + 0.05)), root, "body"
        )
    if height < 0.72 and not bed and rng.random() < 0.3:
        z = belt + rng.uniform(0.04, 0.14)
        shape.add(
            "trim",
            block((-half * 0.85, end - 0.2, z), (half * 0.85, end - 0.04, z + 0.025)),
            (0, end, belt),
            "body",
        )
        shape.add_pair(
            "trim",
            block((half * 0.6, end - 0.16, belt - 0.08), (half * 0.65, end - 0.08, z)),
            (0, end, belt),
            "body",
        )
    if 1.1 < track < 1.6 and low < 0.6 * wheel and rng.random() < 0.75:
        _mudguards(shape, half, wheel)


def _mudguards(shape, half, wheel):
    """Arcs over the wheels that stand out of a narrow body."""
    wheels = [p for p in shape.parts if p.label == "wheel" and p.attach[0] > 0]
    a = np.linspace(0.05 * np.pi, 0.95 * np.pi, 7)
    for part in wheels:
        x0, x1 = half * 0.9, part.vertices[:, 0].max()
        y, z = part.attach[1], wheel / 2
        rings = []
        for t in a:
            c, s = np.cos(t), np.sin(t)
            ring = [
                (x, y + r * wheel * c, z + r * wheel * s)
                for x, r in ((x0, 0.55), (x1, 0.55), (x1, 0.6), (x0, 0.6))
            ]
            rings.append(ring)
        shape.add_pair("trim", loft(rings), (half * 0.9, y, z), "body")
