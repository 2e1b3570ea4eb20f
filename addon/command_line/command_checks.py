# SPDX-License-Identifier: GPL-3.0-or-later
"""What every sub-command checks before it begins: the file, the object, the paths that it is to write.

Exit codes: 0 done, 1 failed, 2 wrong usage.
"""

import os
import sys
import tempfile

import bpy

from ..errors import Refusal

DONE, FAILED, USAGE = 0, 1, 2


def opened_file():
    """Return the path of the open file. Raises Refusal where Blender opened its startup file instead."""
    if bpy.data.filepath:
        return bpy.data.filepath
    before = sys.argv[
        : next((i for i, word in enumerate(sys.argv) if word in ("-c", "--command")), len(sys.argv))
    ]
    named = [word for word in before[1:] if word.endswith(".blend")]
    if named:
        raise Refusal(f"Blender could not open {named[-1]}; nothing was done")
    print(
        "boxmorph: name a file before --command: blender -b FILE.blend --command boxmorph …", file=sys.stderr
    )
    raise SystemExit(USAGE)


def named_object(name):
    """Return the object of this name, the active one for None. Raises Refusal where there is none."""
    if name is None:
        if bpy.context.active_object is None:
            raise Refusal("The file has no active object. Name one with --object")
        return bpy.context.active_object
    obj = bpy.data.objects.get(name)
    if obj is None:
        meshes = sorted(obj.name for obj in bpy.data.objects if obj.type == "MESH")
        known = ", ".join(meshes[:10]) if meshes else "none"
        raise Refusal(f"The file has no object named “{name}”. Its mesh objects: {known}")
    return obj


def named_collection(name):
    """Return the collection of this name; None for None. Raises Refusal where there is none."""
    if name is not None and name not in bpy.data.collections:
        raise Refusal(f"There is no collection named “{name}”")
    return name and bpy.data.collections[name]


def require_writable(path):
    """Raise Refusal unless a file at `path` could be written; checked by doing it, since permissions
    mislead.
    """
    folder = os.path.dirname(os.path.abspath(path))
    try:
        if os.path.isdir(path):
            raise IsADirectoryError(0, "it is a folder")
        if os.path.exists(path):
            with open(path, "r+b"):
                pass
        else:
            with tempfile.TemporaryFile(dir=folder):
                pass
    except OSError as error:
        raise Refusal(f"{path} cannot be written ({error.strerror}). Name another path") from error
