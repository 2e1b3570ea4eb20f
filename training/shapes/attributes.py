# SPDX-License-Identifier: MIT OR Apache-2.0
"""Quantities that every shape has, read off its vertices: what adjectives grade."""

import numpy as np

QUANTITIES = ("tall", "wide", "long", "bulk", "top", "boxy")


def attributes(shape):
    """The quantities of `QUANTITIES` as numbers on axes where equal steps look equally large.

    tall, wide, long: log of an extent (z, x, y) over the geometric mean of the other two; bulk: log of the
    share of the bounding box that the parts fill; top: height of the middle of the surface, 0 floor to 1;
    boxy: share of the surface that looks along an axis.
    """
    points = np.concatenate([p.vertices for p in shape.parts])
    low = points.min(0)
    size = np.log(np.maximum(np.ptp(points, 0), 1e-6))
    middle = size.mean()
    area = top = flat = volume = 0.0
    for part in shape.parts:
        a, b, c = (part.vertices[part.faces[:, i]] for i in range(3))
        normal = np.cross(b - a, c - a)
        each = np.linalg.norm(normal, axis=1)
        area += each.sum()
        top += (each * (a + b + c)[:, 2]).sum() / 3
        flat += each[np.abs(normal).max(1) > 0.995 * each].sum()
        center = part.vertices.mean(0)
        volume += abs(np.einsum("ij,ij->", a - center, np.cross(b - center, c - center))) / 6
    area = max(area, 1e-12)
    return {
        "tall": 1.5 * (size[2] - middle),
        "wide": 1.5 * (size[0] - middle),
        "long": 1.5 * (size[1] - middle),
        "bulk": np.log(max(volume, 1e-9)) - size.sum(),
        "top": (top / area - low[2]) / np.exp(size[2]),
        "boxy": flat / area,
    }
