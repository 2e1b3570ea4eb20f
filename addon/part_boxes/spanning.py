# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that span parts: which are too long to bend gently, and how far an outcome shears them.

Triangles are (m,3) vertex indices, positions (n,3), in coordinates of the search.
"""

import numpy as np

#: A triangle of two parts is coarse if a corner is farther from one of them than this share of half the
#: object's diagonal.
_COARSE = 0.1


def coarse_faces(vertices, triangles, graph):
    """Return the triangles, (k,3), of two parts that reach too far from one into the other to bend gently."""
    owners = graph.assignment[triangles]
    spanning = (owners != owners[:, :1]).any(axis=1)
    candidates, owners = triangles[spanning], owners[spanning]
    corners = vertices[candidates]
    farthest = np.zeros(len(corners), np.float32)
    for other in range(3):
        center, half = (box[owners[:, None, other]] for box in (graph.box_center, graph.box_half_size))
        away = np.linalg.norm(np.maximum(np.abs(corners - center) - half, 0.0), axis=2).max(axis=1)
        farthest = np.maximum(farthest, away)
    return candidates[farthest > _COARSE * reach(vertices)]


def worst_shear(rest, moved, triangles, graph, scales):
    """Return how far the worst of the triangles is sheared between two positions, in degrees; 0 for none.

    A part's own scaling, `scales` (P,3), shears nothing. What counts is by how much an edge turns from where
    the scaling of a part of its face would have it; of the parts of a face, the one that it follows best.
    """
    if len(triangles) == 0:
        return 0.0
    before, after = (_edges(positions[triangles].astype(np.float64)) for positions in (rest, moved))
    factors = np.asarray(scales)[graph.parameter_row_of_box[graph.assignment[triangles]]]
    turns = [_angles(before * factors[:, None, corner], after).max(axis=1) for corner in range(3)]
    return float(np.degrees(np.min(turns, axis=0).max()))


def clauses(count, degrees=None, say=str):
    """Return the count of coarse faces, and how far the worst is sheared if it is, as clauses; in English,
    unless `say` translates.
    """
    if count == 0:
        return []
    is_one = count == 1
    out = [(say("1 long face spans parts") if is_one else say("{} long faces span parts")).format(count)]
    if degrees:
        words = say("it is sheared by {:.0f}°") if is_one else say("the worst is sheared by {:.0f}°")
        out.append(words.format(degrees))
    return out


def reach(positions):
    """Return half the diagonal of the bounding box of positions (n,3)."""
    return float(np.linalg.norm(np.ptp(positions, axis=0))) / 2 if len(positions) else 0.0


def _edges(corners):
    return np.roll(corners, -1, axis=1) - corners


def _angles(a, b):
    """Return the angles between vectors (…,3) in radians; 0 where one has no length."""
    across = np.linalg.norm(np.cross(a, b), axis=-1)
    return np.arctan2(across, (a * b).sum(axis=-1))
