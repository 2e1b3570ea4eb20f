# SPDX-License-Identifier: MIT OR Apache-2.0
"""Handles and spouts of cups, pots and pans: built, and the handles measured."""

import numpy as np

from .axis import outside
from .solids import bar, tube
from .vessels import ear, grip


def add_handle(shape, rng, outer, p, held, rise):
    """Add a bail over the mouth, a stick, flat ears, or one or two ears like a cup's."""
    radius, z = np.array(outer).T
    height, reach = p["height"], p["handle"]
    tall = height - rise

    def wall(level):
        return float(np.interp(level, z, radius))

    if held == "bail":
        t = np.linspace(0, np.pi, 15)
        size = rng.uniform(0.012, 0.03)
        low = height - 0.08 * tall
        arch = (low + size) + (reach - 2 * size) * np.sin(t) ** rng.uniform(0.6, 1.0)
        path = np.column_stack([-wall(low) * np.cos(t), 0 * t, arch])
        shape.add("handle", tube(path, size, 6), (0, 0, low), "body")
    elif held == "stick":
        level = rise + tall * rng.uniform(0.72, 0.92)
        thick = min(rng.uniform(0.03, 0.06), 0.3 * tall)
        start, lift = wall(level), rng.uniform(-0.02, 0.22) * reach
        end = (start + reach, 0, level + lift)
        solid = bar(
            (start, 0, level), end, (thick, 0.6 * thick), (thick * rng.uniform(0.8, 1.5), thick * 0.7), 8
        )
        shape.add("handle", solid, (start, 0, level), "body")
    elif held == "ears" and height < 1.2:
        level = rise + tall * rng.uniform(0.65, 0.9)
        size = min(rng.uniform(0.02, 0.04), 0.25 * reach, 0.3 * tall)
        t = np.linspace(-np.pi / 2, np.pi / 2, 9)
        wide = rng.uniform(0.1, 0.22)
        path = np.column_stack(
            [wall(level) * 0.96 + (reach - size) * np.cos(t) ** 0.7, wide * np.sin(t), np.full(9, level)]
        )
        shape.add_pair("handle", tube(path, size, 6), (wall(level), 0, level), "body")
    else:
        size = min(rng.uniform(0.03, 0.06), 0.25 * reach, 0.12 * tall)
        low = rise + tall * rng.uniform(0.12, 0.32)
        high = rise + tall * rng.uniform(0.72, 0.92)
        low += (high - low) * 0.6 * min(1, abs(wall(low) - wall(high)) / max(reach, 0.1))
        inner = np.array([wall(low), wall(high)])
        solid = ear(rng, inner, inner.min() + reach, low, high, size)
        add = shape.add_pair if held == "ears" else shape.add
        add("handle", solid, (inner[0], 0, low), "body")


def add_spout(shape, rng, outer, reach, rise):
    """Add a spout towards -x that reaches `reach` from the body."""
    radius, z = np.array(outer).T
    tall = z[-1] - rise
    low = rise + tall * rng.uniform(0.3, 0.55)
    tip = rise + tall * rng.uniform(0.8, 1.05)
    thick = min(rng.uniform(0.07, 0.13), 0.2 * tall)
    start = float(np.interp(low, z, radius)) * 0.97
    t = np.linspace(0, 1, 8)
    size = thick * (1 - 0.55 * t)
    # Most spouts leave the body flat and then rise; some are straight.
    up = t ** rng.choice([1.0, 1.4, 2.0])
    path = np.column_stack([-start - (reach - 0.5 * size[-1]) * t, 0 * t, low + (tip - low) * up])
    vertices, faces = tube(path, size, 8)
    # The ends of the tube lean: bring the whole to the reach asked for.
    vertices[:, 0] = (vertices[:, 0] + start) * reach / np.ptp(vertices[:, 0]) - start
    shape.add("spout", (vertices, faces), (-start, 0, low), "body")


def measure_handle(handle, held, body, middle, width, height):
    """How far the handle reaches, over the width, and its faults as log distances."""
    tall, top = np.ptp(handle[:, 2]), handle[:, 2].max() - body[:, 2].min()
    if held == "bail":
        span = np.ptp(handle[:, :2], axis=0).max() / width
        return tall / width, [0.8 * outside(span, 0.75, 1.15), 0.6 * outside(tall / width, 0.05, 1.5)]
    reach, root = grip(handle, middle, width)
    faults = [0.8 * outside(root, 0.08, 0.56), 0.6 * outside(top / np.ptp(body[:, 2]), 0.3, 1.7)]
    if held == "ear":
        faults += [0.8 * outside(tall / height, 0.12, 1.05), 0.8 * outside(reach, 0.02, 0.75)]
        faults += [0.5 * outside(reach * width / tall, 0.15, 2.2)]
    elif held == "ears":
        faults += [0.8 * outside(reach, 0.02, 0.5), 0.8 * outside(tall / height, 0.01, 1.05)]
    else:
        faults += [0.8 * outside(tall / width, 0.02, 0.6)]
    return reach, faults
