# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of docs/meshes.md: odd meshes with the parts found in them, and what a prompt makes of them.

Every object is built, split and deformed by the installed extension. Leaves a strip for each kind in
docs/images/meshes/: before, in the colours of its parts, with their boxes, and after, in the same colours.
"""

import argparse
import importlib
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
import run
import sheets

ROOT = Path(__file__).resolve().parent.parent
OUT = ROOT / "docs" / "images" / "meshes"

#: What each of odd_objects.py is deformed to.
PROMPTS = {
    "open_shells": "a chest of drawers",
    "planes": "a coffee table",
    "intersecting_shells": "an armchair",
    "loose_parts": "a throne",
    "coarse": "a bar stool",
    "non_manifold": "a tv stand",
    "duplicate_vertices": "a mushroom lamp",
    "flipped_normals": "a glider plane",
    "ngons": "a ukulele",
    "turned": "a single bed",
    "symmetric_on_y": "a limousine",
    "symmetric_on_two": "a bar table",
    "symmetric_on_none": "a sideboard",
    "plain_box": "a mattress",
    "sphere": "an airship",
    "very_flat": "a glider plane",
    "very_long": "a floor lamp",
    "very_small": "a monster truck",
    "very_large": "a cartoon rocket",
}
SPLITS = "4"
TILE, SAMPLES = (240, 200), 32


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kind", choices=PROMPTS, action="append", help="only this one; may be repeated")
    parser.add_argument("--prompt", help="another prompt, to try it")
    options = parser.parse_args()
    say = run.speak_alone()
    extension = run.install()
    sys.path.insert(0, str(ROOT))
    OUT.mkdir(parents=True, exist_ok=True)
    for kind in options.kind or PROMPTS:
        path = OUT / f"{kind.replace('_', '-')}.png"
        prompt = options.prompt or PROMPTS[kind]
        tiles, words = _strip(extension, kind, prompt)
        sheets.save_png(sheets.grid([tiles]), path)
        say(f"{path.name}: {words}, {path.stat().st_size // 1024} kB")


def _strip(extension, kind, prompt):
    """Deform an object. Returns its two pictures, before and after, and what happened, in words."""
    import bpy

    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    obj = getattr(importlib.import_module("odd_objects"), kind)()
    bpy.context.scene.boxmorph.splits = SPLITS
    bpy.ops.boxmorph.find_parts()
    owners, boxes, colors = _parts(extension, obj)
    bpy.ops.boxmorph.deform(prompt=prompt, splits=SPLITS)
    report = json.loads(obj.data.shape_keys["boxmorph"])[prompt]
    faces = [tuple(face.vertices) for face in obj.data.polygons]
    keys = obj.data.shape_keys.key_blocks
    shapes = [importlib.import_module(f"{extension}.core.mesh_io").key_positions(key) for key in keys]
    shares = _shares(shapes[0], faces, owners, boxes)
    before = _picture(shapes[0], faces, shares, colors, boxes)
    after = _picture(shapes[1], faces, shares, colors)
    scores = f"{report['score_before']:.3f} to {report['score_after']:.3f}"
    return [before, after], f"{prompt}, {len(boxes)} boxes in {len(colors)} parts, {scores}"


def _parts(extension, obj):
    """The part of each vertex, (n,), the corners of the boxes with their parts, and the parts' colours."""
    import bpy

    engine, kept = (
        importlib.import_module(f"{extension}.{name}") for name in ("core.engine", "part_boxes.parts")
    )
    arrays, mesh = engine.searched(obj, bpy.context)
    graph = kept.kept_graph(obj, mesh)
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    corners = [
        arrays.to_object(center + signs * half)
        for center, half in zip(graph.box_center, graph.box_half_size, strict=True)
    ]
    rows = np.asarray(graph.parameter_row_of_box)
    colors = [tuple(part.color) for part in obj.boxmorph.items]
    return rows[graph.assignment], list(zip(corners, rows, strict=True)), colors


def _shares(vertices, faces, owners, boxes):
    """The part of each face: that of most of its corners, and of several that whose box is nearest."""
    centers = np.array([corners.mean(0) for corners, _part in boxes])
    halves = np.array([np.ptp(corners, axis=0) / 2 for corners, _part in boxes])
    shares = []
    for face in faces:
        votes = np.bincount(owners[list(face)], minlength=len(boxes)).astype(float)
        away = np.maximum(np.abs(vertices[list(face)].mean(0) - centers) - halves, 0)
        votes[boxes[np.linalg.norm(away, axis=1).argmin()][1]] += 0.5
        shares.append(int(votes.argmax()))
    return shares


def _picture(vertices, faces, shares, colors, boxes=()):
    """The object with each face in the colour of its part, with thin frames for `boxes`."""
    import bpy
    import portrait

    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    used = vertices[np.unique(np.concatenate([np.array(face) for face in faces]))]
    low, high = used.min(0), used.max(0)
    unit, foot = np.linalg.norm(high - low), [*(low + high)[:2] / 2, low[2]]

    def place(points):
        # To one size: Cycles is not made for millionths.
        return (points - foot) / unit

    mesh = bpy.data.meshes.new("Object")
    mesh.from_pydata(place(vertices).tolist(), [], faces)
    for color in colors:
        mesh.materials.append(_paint(color))
    mesh.polygons.foreach_set("material_index", shares)
    mesh.set_sharp_from_angle(angle=np.radians(35))
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("Object", mesh))
    for corners, part in boxes:
        _frame(place(corners), _paint(colors[part], 0.25))
    with tempfile.TemporaryDirectory() as folder:
        seen = np.concatenate([used, *(corners for corners, _part in boxes)])
        path = Path(folder) / "picture.png"
        return portrait.shoot(place(seen).astype(np.float32), path, TILE, SAMPLES)


def _paint(color, shade=1.0):
    """A dull paint, darker on the inner side of faces."""
    import bpy

    material = bpy.data.materials.new("Part")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    shader = nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = 0.6
    mix = nodes.new("ShaderNodeMix")
    mix.data_type = "RGBA"
    # Colours of the interface are sRGB, and bright; the shader's are linear.
    linear = (0.7 * np.array(color) + 0.2) ** 2.2 * shade
    mix.inputs["A"].default_value = (*linear, 1)
    mix.inputs["B"].default_value = (*(0.35 * linear), 1)
    links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], mix.inputs["Factor"])
    links.new(mix.outputs["Result"], shader.inputs["Base Color"])
    return material


def _frame(corners, material):
    """The twelve edges of a box, (8, 3) corners, as thin bars."""
    import bpy

    curve = bpy.data.curves.new("Box", "CURVE")
    curve.dimensions, curve.bevel_depth = "3D", 0.003
    curve.materials.append(material)
    for i in range(8):
        for bit in (1, 2, 4):
            if not i & bit:
                spline = curve.splines.new("POLY")
                spline.points.add(1)
                for point, corner in zip(spline.points, (corners[i], corners[i | bit]), strict=True):
                    point.co = (*corner, 1)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("Box", curve))


if __name__ == "__main__":
    main()
