# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts in the viewport: boxes in the colors of the list, joined by the edges of the tree.

The module `gpu` is imported where something is drawn: without a window it is of no use.
"""

import bpy
import numpy as np
from mathutils import Matrix

from . import parts, parts_shown

#: Corners of a box, by their signs, and the edges and triangles between them.
_SIGNS = np.array([(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], np.float32)
_EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if (a ^ b).bit_count() == 1]
_TRIANGLES = [
    triangle
    for a, b, c, d in ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
    for triangle in ((a, b, c), (a, c, d))
]

_handles = []


def register_view():
    """Draw in every 3D viewport from now on."""
    if not bpy.app.background:
        _handles.append(bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_VIEW"))


def unregister_view():
    """Stop drawing."""
    while _handles:
        bpy.types.SpaceView3D.draw_handler_remove(_handles.pop(), "WINDOW")


def _draw():
    import gpu

    context = bpy.context
    obj = context.active_object
    if not context.scene.boxmorph.show_parts or obj is None or not context.space_data.overlay.show_overlays:
        return
    geometry = parts.geometry(obj)
    if geometry is None or not obj.visible_get():
        return
    gpu.state.blend_set("ALPHA")
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(obj.matrix_world @ Matrix(geometry["place"]).inverted().to_4x4())
        boxes = parts_shown.shown_boxes(obj, geometry, context.evaluated_depsgraph_get())
        _draw_boxes(obj.boxmorph, boxes, [row for _center, _half, row in geometry["boxes"]])
        _draw_tree(boxes, geometry["tree"])
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def _draw_boxes(kept, boxes, rows):
    import gpu
    from gpu_extras.batch import batch_for_shader

    faces = gpu.shader.from_builtin("UNIFORM_COLOR")
    # A little out of the surface, which they would else flicker with.
    off = 0.003 * max(max(half) for _center, half in boxes)
    for (center, half), row in zip(boxes, rows, strict=True):
        part = kept.items[row]
        corners = (np.float32(center) + _SIGNS * (np.float32(half) + off)).tolist()
        active, color = row == kept.active, tuple(part.color)
        # Faces behind the object stay behind it; edges can be seen through it.
        gpu.state.depth_test_set("LESS_EQUAL")
        faces.bind()
        faces.uniform_float("color", (*color, 0.22 if active else 0.1))
        batch_for_shader(faces, "TRIS", {"pos": corners}, indices=_TRIANGLES).draw(faces)
        _lines([corners[i] for edge in _EDGES for i in edge], (*color, 1.0), 3.0 if active else 1.5)
        gpu.state.depth_test_set("NONE")
        _lines([corners[i] for edge in _EDGES for i in edge], (*color, 0.25), 1.0)


def _draw_tree(boxes, tree):
    import gpu

    ends = [boxes[i][0].tolist() for edge in tree for i in edge]
    if ends:
        gpu.state.depth_test_set("NONE")
        _lines(ends, (1.0, 1.0, 1.0, 0.8), 1.5)


def _lines(ends, color, width):
    import gpu
    from gpu_extras.batch import batch_for_shader

    shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", width)
    shader.uniform_float("color", color)
    batch_for_shader(shader, "LINES", {"pos": ends}).draw(shader)
