# SPDX-License-Identifier: MIT OR Apache-2.0
"""Solids that buildings are put together from: many boxes as one, stacks of rectangles."""

import numpy as np

from .solids import loft

CORNERS = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]], float)


def merge(solids):
    """Several solids as one."""
    vertices, faces, count = [], [], 0
    for v, f in solids:
        vertices.append(v)
        faces.append(f + count)
        count += len(v)
    return np.concatenate(vertices), np.concatenate(faces)


def boxes(centers, half):
    """Many boxes of one half size (3,) about centers (n, 3), as one solid."""
    corner = np.array([[x, y, z] for z in (-1, 1) for x, y in CORNERS]) * half
    sides = [(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)]
    quads = np.array([*sides, (3, 2, 1, 0), (4, 5, 6, 7)])
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    centers = np.asarray(centers, float)
    vertices = (centers[:, None] + corner).reshape(-1, 3)
    return vertices, (faces + 8 * np.arange(len(centers))[:, None, None]).reshape(-1, 3)


def stack(levels):
    """A loft of rectangles, each (z, half_x, half_y) or (z, half_x, half_y, shift in y)."""
    rings = []
    for z, x, y, *shift in levels:
        ring = CORNERS * (x, y) + (0, shift[0] if shift else 0.0)
        rings.append(np.column_stack([ring, np.full(4, z)]))
    return loft(rings)


def moved(solid, x, y):
    """The solid moved along x and y."""
    return solid[0] + (x, y, 0), solid[1]
