# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the boxes of the parts are on the shape that is shown: under outcomes, other shape keys, poses.

Each box is held by the six vertices of its part that lie outermost: reading these costs nothing, however
dense the mesh is. Positions are in coordinates of the search.
"""

import numpy as np

#: A part's vertices that span less than this share of its box along an axis move the box and leave its size.
_FLAT = 0.05


def holders(vertices, graph):
    """Return what holds each box, as plain lists: the indices of its lowest and highest vertices along x, y
    and z, [3][2], and where these are; None for a box without vertices.
    """
    held = []
    for box in range(len(graph.box_center)):
        own = np.flatnonzero(graph.assignment == box)
        if len(own) == 0:
            held.append(None)
            continue
        ends = own[np.stack([vertices[own].argmin(0), vertices[own].argmax(0)], axis=1)]
        held.append([ends.tolist(), vertices[ends, np.arange(3)[:, None]].tolist()])
    return held


def shown_boxes(obj, geometry, depsgraph):
    """Return center and half size, (3,) each, of the boxes in `geometry` on `obj` as it is evaluated.

    Where its vertices are not those of the search, such as in Edit Mode, the boxes are where they were found.
    """
    found = [(np.array(center), np.array(half)) for center, half, _row in geometry["boxes"]]
    mesh = obj.evaluated_get(depsgraph).data
    if obj.mode == "EDIT" or len(mesh.vertices) != geometry.get("vertices"):
        return found
    place = np.array(geometry["place"])
    return [
        box if held is None else _follow(*box, *held, mesh, place)
        for box, held in zip(found, geometry["held"], strict=True)
    ]


def _follow(center, half, ends, rest, mesh, place):
    """Return a box carried along with its vertices `ends`, [3][2], from `rest` to where they are now."""
    rest = np.array(rest)
    now = np.array([[place[axis] @ mesh.vertices[end].co for end in pair] for axis, pair in enumerate(ends)])
    span = np.ptp(rest, axis=1)
    factor = np.where(span > _FLAT * 2 * half, np.ptp(now, axis=1) / np.maximum(span, 1e-12), 1.0)
    return now.mean(axis=1) + factor * (center - rest.mean(axis=1)), factor * half
