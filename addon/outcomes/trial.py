# SPDX-License-Identifier: GPL-3.0-or-later
"""The shape key that a running search shows its best in, until it is kept or taken back."""

import numpy as np

from ..core.mesh_io import key_positions
from .shape_key import (
    OWN_BASIS,
    follow_renames,
    keep_record,
    key_name,
    outcomes,
    pieces,
    records,
    remove_pieces,
    set_limits,
)


class Trial:
    """A shape key on trial: shows the best so far, and is either kept or taken back without a trace.

    Holds names and copies only, never Blender pointers, so that it survives undo, rename and file loading.
    The object is handed in again at each call.
    """

    def __init__(self, obj, prompt):
        keys = obj.data.shape_keys
        self.had_keys = keys is not None
        self.active = obj.active_shape_key_index
        self.pinned = obj.show_only_shape_key
        self.vertex_count = len(obj.data.vertices)
        self.previous = None
        self.others = {}
        self.name = None
        self._shown = False
        self._made_basis = False
        self._wanted = key_name(prompt)
        if keys is None:
            return
        follow_renames(obj.data)
        for key in outcomes(obj.data):
            if key.name == self._wanted:
                self.previous = _KeyState(key)
            else:
                self.others[key.name] = key.value
            self.others |= {piece.name: piece.value for piece in pieces(obj.data, key.name)}

    def fits(self, obj):
        """Whether `obj` still has the vertices that the search was begun with."""
        return obj.type == "MESH" and len(obj.data.vertices) == self.vertex_count

    def write(self, obj, positions):
        """Put `positions`, (n,3) float32, into the key, making it if need be, and show it at value 1."""
        mesh = obj.data
        key = self.key(obj)
        if key is None or not self._shown:
            key = self._create(obj)
        key.points.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
        mesh.update()
        if key.value != 1.0:
            key.value = 1.0

    def keep(self, obj, positions, slider_min, slider_max, report):
        """Make the key an outcome with these slider limits and this record. Returns its name."""
        self.write(obj, positions)
        if self.name in records(obj.data):
            remove_pieces(obj, self.name)
        key = self.key(obj)
        set_limits(key, slider_min, slider_max)
        key.value = 1.0
        # Not before: Blender 4.3 does not free a property of keys that undo throws away with their object.
        if self._made_basis:
            obj.data.shape_keys[OWN_BASIS] = True
        keep_record(obj.data, self.name, report)
        return self.name

    def take_back(self, obj):
        """Restore the keys of `obj` as they were before the trial; return whether there was something to do.

        Calling it again takes back a key that undo has brought again; writing again shows it again.
        """
        keys = obj.data.shape_keys
        key = self.key(obj)
        if key is None or (self.previous is not None and not self._shown):
            return False
        self._shown = False
        if self.previous is not None:
            self.previous.restore(key)
        elif not self.had_keys and len(keys.key_blocks) == 2:
            obj.shape_key_clear()
        else:
            obj.shape_key_remove(key)
        if obj.data.shape_keys is not None:
            for name, value in self.others.items():
                other = obj.data.shape_keys.key_blocks.get(name)
                if other is not None:
                    other.value = value
        obj.active_shape_key_index = self.active
        obj.show_only_shape_key = self.pinned
        obj.data.update()
        return True

    def key(self, obj):
        """Return the key, or None where there is none yet or no longer."""
        keys = obj.data.shape_keys
        if keys is None or self.name is None:
            return None
        return keys.key_blocks.get(self.name)

    def _create(self, obj):
        """Make the key, or take the earlier outcome of the same prompt, and set the other outcomes to 0."""
        if obj.data.shape_keys is None:
            # Blender 5.0 gives new keys the value 1.
            obj.shape_key_add(name="Basis", from_mix=False).value = 0.0
            self._made_basis = True
        blocks = obj.data.shape_keys.key_blocks
        if self.previous is not None and self._wanted in blocks:
            key = blocks[self._wanted]
        else:
            key = obj.shape_key_add(name=self._wanted, from_mix=False)
        key.relative_key = obj.data.shape_keys.reference_key
        key.mute = False
        key.slider_min, key.slider_max = min(key.slider_min, 0.0), max(key.slider_max, 1.0)
        self.name = key.name
        self._shown = True
        # Outcomes are alternatives: one that stayed at 1 would add up with this one.
        for name in self.others:
            if name in blocks:
                blocks[name].value = 0.0
        obj.active_shape_key_index = blocks.find(self.name)
        return key


class _KeyState:
    """A copy of all that a trial changes in a shape key."""

    def __init__(self, key):
        self.positions = key_positions(key)
        self.relative = key.relative_key.name
        self.values = (key.slider_min, key.slider_max, key.value, key.mute)

    def restore(self, key):
        key.points.foreach_set("co", self.positions.ravel())
        relative = key.id_data.key_blocks.get(self.relative)
        if relative is not None:
            key.relative_key = relative
        key.slider_min, key.slider_max, key.value, key.mute = self.values
