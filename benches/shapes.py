# SPDX-License-Identifier: MIT OR Apache-2.0
"""Shapes of any number of vertices, z up: vertices (n, 3) float32, triangles (m, 3) int32."""

import numpy as np


def grid_chair(vertices_wanted):
    """A chair of six islands with about that many vertices; edges and corners are doubled."""
    legs = [((x - 0.03, y - 0.03, 0), (x + 0.03, y + 0.03, 0.45)) for x in (-0.2, 0.2) for y in (-0.2, 0.2)]
    boxes = [*legs, ((-0.24, -0.24, 0.44), (0.24, 0.24, 0.5)), ((-0.23, 0.19, 0.49), (0.23, 0.23, 1.0))]
    side = max(2, round((vertices_wanted / (6 * len(boxes))) ** 0.5))
    u, v = (c.ravel() for c in np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side)))
    cell = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    quad = np.stack([cell, cell + 1, cell + side + 1, cell + side], 1)
    face = np.concatenate([quad[:, [0, 1, 2]], quad[:, [0, 2, 3]]])
    vertices, triangles = [], []
    for low, high in boxes:
        for axis in range(3):
            for end in (0.0, 1.0):
                unit = np.insert(np.stack([u, v], 1), axis, end, axis=1)
                triangles.append(face + sum(map(len, vertices)))
                vertices.append(np.array(low) + unit * (np.array(high) - np.array(low)))
    return np.concatenate(vertices).astype(np.float32), np.ascontiguousarray(
        np.concatenate(triangles), np.int32
    )


def lamp(vertices_wanted):
    """A foot, a pole and a shade of one piece, with about that many vertices."""
    outline = [(0, 0), (0.3, 0), (0.3, 0.04), (0.04, 0.08), (0.03, 1), (0.28, 1), (0.16, 1.4), (0, 1.42)]
    radius, height = np.array(outline, float).T
    around = max(8, round((vertices_wanted / 2) ** 0.5))
    rings = max(8, vertices_wanted // around)
    length = np.concatenate([[0], np.cumsum(np.hypot(np.diff(radius), np.diff(height)))])
    along = np.linspace(0, length[-1], rings)
    r, z = (np.interp(along, length, values)[:, None] for values in (radius, height))
    turn = np.arange(around) * 2 * np.pi / around
    vertices = np.stack(np.broadcast_arrays(r * np.cos(turn), r * np.sin(turn), z), -1).reshape(-1, 3)
    ring = np.arange(rings - 1)[:, None] * around
    here, there = np.arange(around), (np.arange(around) + 1) % around
    quad = np.stack(
        np.broadcast_arrays(ring + here, ring + there, ring + around + there, ring + around + here), -1
    )
    quad = quad.reshape(-1, 4)
    triangles = np.concatenate([quad[:, [0, 1, 2]], quad[:, [0, 2, 3]]])
    return vertices.astype(np.float32), np.ascontiguousarray(triangles, np.int32)
