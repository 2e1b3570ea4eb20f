# SPDX-License-Identifier: MIT OR Apache-2.0
"""Saves ten objects in one file: the examples, some of them several times and stretched, each with a mesh of
its own.

    blender -b --factory-startup --python make_ten.py -- FILE.blend
"""

import importlib
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

#: Name, module, and how tall each is.
_KINDS = (
    ("Chair", "chair", (1.0, 1.2, 0.9)),
    ("Table", "table", (1.0, 0.8, 1.3)),
    ("Lamp", "desk_lamp", (1.0, 0.8)),
    ("Aeroplane", "aeroplane", (1.0, 1.1)),
)

bpy.ops.wm.read_factory_settings(use_empty=True)
for name, module, heights in _KINDS:
    first = importlib.import_module(f"examples.{module}").build()
    first.name = name
    for height in heights[1:]:
        other = first.copy()
        other.data = first.data.copy()
        bpy.context.scene.collection.objects.link(other)
        for vertex in other.data.vertices:
            vertex.co.z *= height
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[sys.argv.index("--") + 1])
