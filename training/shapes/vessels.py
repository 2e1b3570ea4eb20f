# SPDX-License-Identifier: MIT OR Apache-2.0
"""What bottles and cups share: an inner wall, ears, a lip to pour from, and how these are measured."""

import numpy as np

from .solids import tube


def inside(outer, rng):
    """The inner wall of a body seen through its mouth, from the top down to the floor inside."""
    thick = rng.uniform(0.02, 0.05)
    low, high = outer[0][1], outer[-1][1]
    floor = low + min(thick, 0.3 * (high - low))
    return [(max(r - thick, 0.03), max(z, floor)) for r, z in outer[::-2]]


def ear(rng, inner, outer, low, high, size):
    """A handle in the half plane x > 0.

    It runs from (inner[0], low) out to x = `outer` and back to (inner[1], high).
    """
    t = np.linspace(-np.pi / 2, np.pi / 2, 11)
    power = 2 / rng.uniform(1.8, 4.5)
    share = (1 + np.sign(t) * np.abs(np.sin(t)) ** power) / 2
    droop = rng.uniform(-0.25, 0.35)
    line = inner[0] + (inner[1] - inner[0]) * share
    bulge = np.abs(np.cos(t)) ** power * (1 + droop * (2 * share - 1))
    # The size of the bulge that makes the outermost point land on `outer`.
    reach = ((outer - size - line) / np.maximum(bulge, 1e-6))[1:-1].min()
    x = line + bulge * max(reach, size)
    path = np.column_stack([x, 0 * x, low + (high - low) * share])
    vertices, faces = tube(path, size, 6)
    return vertices * (1, rng.uniform(0.8, 1.8), 1), faces


def pour(solid, low, high, reach):
    """The rim of a vessel drawn out towards -x into a lip for pouring."""
    vertices, faces = solid
    angle = np.arctan2(vertices[:, 1], -vertices[:, 0])
    share = np.clip((vertices[:, 2] - low) / (high - low), 0, 1) ** 2 * np.exp(-((angle / 0.45) ** 2))
    return vertices - share[:, None] * (reach, 0, 0), faces


def turn(shape, quarters):
    """The whole turned about z by quarters, in place."""
    c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarters]
    spin = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]], float)
    for part in shape.parts:
        part.vertices, part.attach = part.vertices @ spin, part.attach @ spin


def girth(points):
    """The mean of the extents along x and y."""
    return np.ptp(points[:, :2], axis=0).mean()


def grip(handle, center, width):
    """How far a handle reaches from its root outwards, over the width, and the radius of its root."""
    radius = np.linalg.norm(handle[:, :2] - center, axis=1)
    return np.ptp(radius) / width, radius.min() / width


def grip_width(shape):
    """The width across of the first handle: the smaller of its level extents."""
    first = next(part for part in shape.parts if part.label == "handle")
    return np.ptp(first.vertices[:, :2], axis=0).min()
