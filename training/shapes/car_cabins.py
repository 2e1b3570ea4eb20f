# SPDX-License-Identifier: MIT OR Apache-2.0
"""Cabins of cars: closed, with a roof on pillars, or open."""

import numpy as np

from .solids import bar, block, cushion, loft, rounded_rectangle


def add_cabin(shape, rng, half, belt, height, ends, boxy, bare):
    """Add the cabin from the body's belt up to the height, its screens leaning inwards."""
    start, front, back, end = ends
    length, tall = end - start, height - belt
    at = (0, (front + back) / 2, belt)
    steep = tall * (rng.uniform(0.5, 1.7) * (1.15 - boxy) + rng.uniform(0, 0.2))
    steep = min(steep, 0.5)
    screen = steep if front - start > 0.05 * length else tall * rng.choice([0.02, rng.uniform(0.02, 0.3)])
    rear = tall * (
        (1.15 - boxy) * rng.uniform(0.4, 1.8) if end - back > 0.05 * length else rng.uniform(0, 0.35)
    )
    shrink = min(1.0, 0.65 * (back - front) / (screen + rear + 1e-6))
    screen, rear = screen * shrink, rear * shrink
    one_box = front - start < 0.05 * length
    base = half * (1.0 if one_box else rng.uniform(0.86, 0.98))
    roof = base * (rng.uniform(0.9, 1.0) if one_box or tall > 0.6 else rng.uniform(0.72, 0.95))
    if bare:
        base, roof = half * rng.uniform(0.3, 0.5), half * rng.uniform(0.15, 0.3)
    if shape.traits["open"]:
        _roofless(shape, rng, base, belt, height, front, back, screen, at)
        return
    levels = [
        (-0.15, 0.0, 0.0),
        (0.0, 0.0, 0.0),
        (0.5, 0.5, 0.0),
        (0.86, 0.86, 0.02),
        (0.96, 0.96, 0.07),
        (1.0, 1.0, 0.2),
    ]
    corner = 0.06 * (1.2 - boxy) * min(1, 4 * base)

    def rings(chosen):
        found = []
        for t, s, inset in chosen:
            y0, y1 = front + screen * s, back - rear * s
            inset = inset * (1.2 - boxy) * min(tall, 0.5)
            x, y = base + (roof - base) * s - inset * 0.6, max((y1 - y0) / 2 - inset, 0.02)
            plan = rounded_rectangle(max(x, 0.02), y, corner) + np.array([0, (y0 + y1) / 2])
            found.append(np.column_stack([plan, np.full(len(plan), belt + tall * t)]))
        return found

    if 0.15 < tall < 0.7 and not bare and rng.random() < 0.15:
        lid, foot = rings(levels[3:]), rings(levels[1:2])[0]
        shape.add("cabin", loft(lid), at, "body")
        shape.add("cabin", loft([foot, foot + np.array([0, 0, 0.03])]), at, "body")
        for i in (1, 4, 7, 10):
            shape.add("cabin", bar(foot[i] * (0.97, 1, 1), lid[0][i] * (0.97, 1, 1), 0.03), at, "body")
        if back - front > 0.8:
            for x in (-1, 1):
                shape.add(
                    "cabin",
                    bar((x * base * 0.95, at[1], belt), (x * roof * 0.95, at[1], height - 0.1 * tall), 0.03),
                    at,
                    "body",
                )
        return
    shape.add("cabin", loft(rings(levels)), at, "body")


def _roofless(shape, rng, base, belt, height, front, back, screen, at):
    """The windscreen, the seats and the folded roof of an open car."""
    tall, long = height - belt, back - front
    lean = min(max(screen, 0.3 * tall), 0.3 * long)
    w = base * 0.93
    glass = np.array(
        [
            (-w, front, belt - 0.02),
            (w, front, belt - 0.02),
            (0.9 * w, front + lean, height),
            (-0.9 * w, front + lean, height),
        ]
    )
    shape.add("cabin", loft([glass, glass + np.array([0, 0.03, 0])]), at, "body")
    rows = 2 if long > 1.1 and rng.random() < 0.6 else 1
    for y in np.linspace(front + 0.55 * long, front + 0.8 * long, rows):
        for x in (-0.45, 0.45):
            shape.add(
                "cabin",
                cushion((x * base, y, belt + 0.2 * tall), (0.3 * base, 0.06, 0.5 * tall), 4, 10, 5),
                at,
                "body",
            )
    fold = block((-w, back - 0.15 * long, belt - 0.05), (w, back, belt + rng.uniform(0.1, 0.3) * tall), 0.03)
    shape.add("cabin", fold, at, "body")
