# SPDX-License-Identifier: GPL-3.0-or-later
"""An outcome under its modifiers: held to what was scored, and how far it is from it all the same.

The mesh with its modifiers is scored, and the key is written on the mesh below them. Most modifiers carry it
up again as it was scored; some keep a length or an offset of their own, or round it off.
"""

import numpy as np

from . import mesh_io

#: How often the key is corrected by what is seen of it. More brings little (measured on Subdivision: the mean
#: difference falls to a quarter with the first, and then stays).
_CORRECTIONS = 3

#: As near as need be, as a share of the size.
_NEAR = 1e-4

#: Modifiers that carry any deformation up as it is.
_FOLLOWING = frozenset("EDGE_SPLIT MIRROR NORMAL_EDIT TRIANGULATE UV_PROJECT UV_WARP WEIGHTED_NORMAL".split())


def corrected(obj, context, key, positions, expected):
    """Return the positions for `key`, (k,3), with which `obj` comes nearest to `expected`, and how far it is.

    `positions`: the first ones to try; `expected`, (n,3): the mesh as it should be under the modifiers. The
    distance is the greatest of a vertex, as a share of the size; infinite if there are other vertices.
    """
    size = np.linalg.norm(np.ptp(expected, axis=0))
    index = obj.data.shape_keys.key_blocks.find(key.name)
    best, nearest = positions, float("inf")
    for _ in range(1 + _CORRECTIONS):
        key.points.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
        obj.data.update()
        with mesh_io.as_modelled(obj, context, index) as mesh:
            seen = mesh_io.mesh_positions(mesh)
        if len(seen) != len(expected):
            break
        away = float(np.linalg.norm(seen - expected, axis=1).max() / size)
        if away >= nearest:
            break
        best, nearest = positions, away
        if away <= _NEAR or len(seen) < len(positions):
            break
        # Modifiers that add vertices put those they were given first.
        positions = positions + (expected - seen)[: len(positions)]
    return best, nearest


def departing(obj):
    """Return the names of the modifiers of `obj` under which an outcome may differ from what was scored."""
    shown = [m for m in obj.modifiers if m.show_viewport and m.type not in mesh_io.POSING]
    return [m.name for m in shown if m.type not in _FOLLOWING] or [m.name for m in shown]
