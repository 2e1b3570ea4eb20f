# SPDX-License-Identifier: GPL-3.0-or-later
"""An outcome under its modifiers: held to what was scored, and how far it is from it all the same.

The mesh with its modifiers is scored, and the key is written on the mesh below them. Most modifiers carry it
up again as it was scored; some keep a length or an offset of their own, or round it off.
"""

import numpy as np
from mathutils.kdtree import KDTree

from . import mesh_io

#: How far the outcome under its modifiers may be from what was scored, as a share of its size.
DEPARTS = 0.01

#: How often the key is corrected by what is seen of it. The first time brings most.
_CORRECTIONS = 3

#: As near as need be, as a share of the size.
_NEAR = 1e-4

#: Modifiers that carry any deformation up as it is.
_FOLLOWING = frozenset("EDGE_SPLIT MIRROR NORMAL_EDIT TRIANGULATE UV_PROJECT UV_WARP WEIGHTED_NORMAL".split())


class Correction:
    """Brings the key of `obj` nearer to what was scored by what is seen of it under the modifiers.

    `rest` and `expected`, (n,3): the mesh under the modifiers, undeformed and as it should be. `positions`,
    (k,3), are the best for the key so far, and `away` is how far the mesh then is from `expected` where it is
    farthest, as a share of its size; infinite if it has other vertices.
    """

    def __init__(self, obj, context, key, rest, expected):
        self._obj, self._context, self._key = obj, context, key
        self._rest, self._expected = rest, expected
        self._size = np.linalg.norm(np.ptp(expected, axis=0))
        self._index = obj.data.shape_keys.key_blocks.find(key.name)
        self._missing = None
        self.positions, self.away = None, float("inf")

    def run(self, positions):
        """Begin with these positions of the key, and correct them for as long as that helps."""
        self.positions = positions
        if not self._try(positions):
            return
        self._repeat(self._of_first)
        if self.away > DEPARTS:
            self._repeat(self._of_nearest())

    def _repeat(self, pull):
        for _ in range(_CORRECTIONS):
            if self.away <= _NEAR or not self._try(self.positions + pull(self._missing)):
                return

    def _try(self, positions):
        """Whether these positions bring the mesh nearer than it was."""
        self._key.points.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
        self._obj.data.update()
        with mesh_io.as_modelled(self._obj, self._context, self._index) as mesh:
            seen = mesh_io.mesh_positions(mesh)
        if len(seen) != len(self._expected) or len(seen) < len(positions):
            return False
        missing = self._expected - seen
        away = float(np.linalg.norm(missing, axis=1).max() / self._size)
        if not away < self.away:
            return False
        self.positions, self.away, self._missing = positions, away, missing
        return True

    def _of_first(self, missing):
        """What each vertex of the key is off by where modifiers put the vertices they were given first, as
        Subdivision does.
        """
        return missing[: len(self.positions)]

    def _of_nearest(self):
        """Return what gives the mean of what the vertices around each vertex of the key are off by, for
        modifiers that put others in its place, as Bevel does, or beside it, as Solidify does.
        """
        base = mesh_io.basis_positions(self._obj.data)
        tree = KDTree(len(base))
        for index, position in enumerate(base.tolist()):
            tree.insert(position, index)
        tree.balance()
        owner = np.array([tree.find(position)[1] for position in self._rest.tolist()])
        count = np.maximum(np.bincount(owner, minlength=len(base)), 1)[:, None]

        def pull(missing):
            sums = [np.bincount(owner, along, minlength=len(base)) for along in missing.T]
            return np.stack(sums, axis=1) / count

        return pull


def departing(obj):
    """Return the names of the modifiers of `obj` under which an outcome may differ from what was scored."""
    shown = [m for m in obj.modifiers if m.show_viewport and m.type not in mesh_io.POSING]
    return [m.name for m in shown if m.type not in _FOLLOWING] or [m.name for m in shown]
