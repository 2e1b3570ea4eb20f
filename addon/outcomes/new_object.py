# SPDX-License-Identifier: GPL-3.0-or-later
"""Apply as New Object: what is seen of an outcome as the mesh of an object of its own, without shape keys."""

import bpy
import numpy as np

from ..core import mesh_io
from ..errors import Refusal
from ..part_boxes import parts
from . import shape_key


def apply_as_new(obj, name):
    """Return a copy of `obj` whose mesh at rest is the outcome `name`, or its pieces, at their values now.

    UVs, materials, groups, attributes, custom normals and modifiers are kept; other shape keys do not count.
    """
    blocks = obj.data.shape_keys.key_blocks
    shown = [blocks[name], *shape_key.pieces(obj.data, name)]
    if all(key.mute or key.value == 0.0 for key in shown):
        raise Refusal(
            "“{name}” is off, so that nothing of it is seen. Give it a value first",
            name=name,
        )
    shown = {key.name for key in shown}
    new = obj.copy()
    new.data = obj.data.copy()
    new.name = new.data.name = f"{obj.name} {name}"
    keys = new.data.shape_keys
    for key in keys.key_blocks:
        if key.name not in shown:
            key.mute = True
    new.show_only_shape_key = False
    positions = mesh_io.key_positions(new.shape_key_add(name="Mix", from_mix=True))
    new.shape_key_clear()
    # Blender counts a user too many of copied keys, and would save them in the file for nobody.
    bpy.data.batch_remove([keys])
    new.data.attributes["position"].data.foreach_set("vector", np.ascontiguousarray(positions).ravel())
    new.data.update()
    parts.forget(new)
    for collection in obj.users_collection:
        collection.objects.link(new)
    return new
