# SPDX-License-Identifier: MIT OR Apache-2.0
"""Towers, turrets, chimneys and antennas of buildings."""

import numpy as np

from .masonry import CORNERS, boxes, merge, moved, stack
from .solids import lathe

SLIM = 0.22  # thinner than this is a chimney or an antenna


def add_towers(shape, rng, half, rise, roof, tall, r, towers, axis):
    """Add a chimney, corner towers, or one or two towers before a nave, `tall` with their spires."""
    hx, hy = half
    body = rise + roof
    if 2 * r < SLIM:
        _chimney(shape, rng, half, rise, roof, tall, r, axis)
    elif towers == 4:
        is_round = rng.random() < 0.6
        pointed = rng.random() < 0.35
        solid = _round_turret(tall, r, pointed) if is_round else _turret(tall, r, pointed)
        for y in (-hy, hy):
            shape.add_pair("tower", moved(solid, hx, y), (hx, y, 0), "walls")
    else:
        cap = min(rng.choice([0.0, 0.12, rng.uniform(0.25, 0.6)]) * tall, tall - 0.9 * body)
        cap = cap if cap > 0.04 * tall else 0.0
        stem = tall - cap
        ends = np.array([(hx - r, 0.0), (0.0, hy - r)])[axis] * (1 if axis == 0 else -1)
        ends = ends + (np.array([(r, 0.0), (0.0, -r)])[axis]) * rng.choice([0, 0.5, 1])
        if towers == 2:
            ends = np.add(ends, (hx - r, 0))
        is_round = rng.random() < 0.15
        shaft = lathe([(r, 0), (r, stem)], sides=16) if is_round else stack([(0, r, r), (stem, r, r)])
        at = (*ends, 0.0)
        parts = [("tower", moved(shaft, *ends), at, "walls")]
        if cap:
            k = rng.choice([1.0, 1.12])
            levels = [(k * r, stem), (0.02 * r, tall)]
            tip = lathe(levels, sides=16) if is_round else stack([(z, w, w) for w, z in levels])
            parts.append(("spire", moved(tip, *ends), (*ends, stem), "tower"))
        elif rng.random() < 0.5:
            t = 0.2 * r
            tips = np.column_stack([CORNERS * (r - t), np.full(4, tall - 2 * t)])
            shaft = merge([stack([(0, r, r), (tall - 4 * t, r, r)]), boxes(tips, (t, t, 2 * t))])
            parts = [("tower", moved(shaft, *ends), at, "walls")]
        for part in parts:
            (shape.add_pair if towers == 2 else shape.add)(*part)


def _turret(tall, r, pointed):
    """A square corner tower of a castle."""
    if pointed:
        return stack(
            [(0, r, r), (0.75 * tall, r, r), (0.75 * tall, 1.1 * r, 1.1 * r), (tall, 0.02 * r, 0.02 * r)]
        )
    low = tall - 0.5 * r
    at = np.column_stack([CORNERS * 0.75 * r, np.full(4, tall - 0.25 * r)])
    return merge([stack([(0, r, r), (low, r, r)]), boxes(at, (0.25 * r, 0.25 * r, 0.25 * r))])


def _round_turret(tall, r, pointed):
    """A round corner tower of a castle."""
    if pointed:
        return lathe([(0.92 * r, 0), (0.92 * r, 0.7 * tall), (r, 0.7 * tall), (0.02 * r, tall)])
    low = tall - 0.5 * r
    a = np.arange(6) * np.pi / 3
    at = np.column_stack([0.75 * r * np.cos(a), 0.75 * r * np.sin(a), np.full(6, tall - 0.25 * r)])
    base = lathe([(0.9 * r, 0), (0.9 * r, low - r), (r, low - 0.7 * r), (r, low)])
    return merge([base, boxes(at, (0.22 * r, 0.22 * r, 0.25 * r))])


def _chimney(shape, rng, half, rise, roof, tall, r, axis):
    """A chimney through the roof, stacks beside a hall, or an antenna on a high-rise."""
    body = rise + roof
    spot = np.zeros(2)
    if rise < 1.8:
        spot[axis] = rng.uniform(-0.75, 0.75) * half[axis]
        spot[1 - axis] = rng.uniform(-0.4, 0.4) * half[1 - axis]
    low = rise
    if rise < 1.8 and tall > 1.5 * body:
        low, spot[1 - axis] = 0.0, rng.choice([0, 0.7]) * half[1 - axis]
    at = (*spot, low)
    is_round = low == 0 or rise >= 1.8 or rng.random() < 0.2
    thin = rng.uniform(0.5, 1.0) if low == 0 or rise >= 1.8 else 1.0
    count = int(rng.choice([1, 1, 2, 3])) if low == 0 and half[axis] > 0.6 else 1
    step = np.zeros(2)
    step[axis] = min(5 * r, 0.3)
    for i in range(count):
        x, y = spot * (0.3 if count > 1 else 1) + step * (i - (count - 1) / 2)
        if is_round:
            solid = lathe([(r, low), (r * thin, tall * 0.97), (r * thin * 1.1, tall)], sides=12)
        else:
            cap = tall - min(0.3 * (tall - rise), 0.06)
            k = rng.choice([0.8, 1.0])
            solid = stack([(low, k * r, k * r), (cap, k * r, k * r), (cap, r, r), (tall, r, r)])
        shape.add("chimney", moved(solid, x, y), at if count == 1 else (x, y, low), "walls")
