# SPDX-License-Identifier: MIT OR Apache-2.0
"""Saves a small chair as an artist would leave it: parts, a Mirror and a Bevel, UVs, materials, a group.

    blender -b --factory-startup --python make_chair.py -- FILE.blend

The objects: "Chair" (modifiers), "Plain Chair" (none), "Camera" (no mesh), "Points" (no faces).
"""

import sys

import bpy


def boxes(name, parts):
    """Return a mesh of separate boxes, each (centre, size), with UVs and two materials."""
    corners = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    vertices, faces = [], []
    for centre, size in parts:
        start = len(vertices)
        for corner in corners:
            vertices.append(tuple(c + k * s for c, k, s in zip(centre, corner, size, strict=True)))
        faces += [tuple(start + i for i in side) for side in sides]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    layer = mesh.uv_layers.new(name="UVMap")
    for i, item in enumerate(layer.data):
        item.uv = ((i % 4 in (1, 2)) * 0.9 + 0.05, (i % 4 in (2, 3)) * 0.9 + 0.05)
    for label, colour in (("Wood", (0.4, 0.2, 0.1, 1)), ("Fabric", (0.1, 0.3, 0.5, 1))):
        material = bpy.data.materials.new(label)
        material.diffuse_color = colour
        mesh.materials.append(material)
    for polygon in mesh.polygons:
        polygon.material_index = int(polygon.index < 6)
    return mesh


def chair(name, half):
    """Return a chair object; with `half`, its right side comes from a Mirror modifier."""
    parts = [((0.12, 0, 0.45), (0.24, 0.48, 0.06)), ((0.12, 0.21, 0.75), (0.24, 0.05, 0.54))]
    parts += [((0.21, y, 0.21), (0.05, 0.05, 0.42)) for y in (-0.21, 0.21)]
    if not half:
        parts = [((0, c[1], c[2]), (2 * s[0], s[1], s[2])) for c, s in parts[:2]] + parts[2:]
        parts += [((-c[0], c[1], c[2]), s) for c, s in parts[2:]]
    obj = bpy.data.objects.new(name, boxes(name, parts))
    bpy.context.scene.collection.objects.link(obj)
    obj.vertex_groups.new(name="Seat").add(range(8), 0.75, "REPLACE")
    if half:
        obj.modifiers.new("Mirror", "MIRROR")
    bevel = obj.modifiers.new("Bevel", "BEVEL")
    bevel.width, bevel.segments = 0.008, 2
    if not half:
        obj.modifiers.remove(bevel)
    return obj


def main(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    first = chair("Chair", half=True)
    plain = chair("Plain Chair", half=False)
    plain.location.x = 1.0
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    points = bpy.data.objects.new("Points", bpy.data.meshes.new("Points"))
    points.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [])
    for obj in (camera, points):
        bpy.context.scene.collection.objects.link(obj)
        obj.location.y = 3.0
    bpy.context.view_layer.objects.active = first
    first.select_set(True)
    bpy.ops.wm.save_as_mainfile(filepath=path)


main(sys.argv[sys.argv.index("--") + 1])
