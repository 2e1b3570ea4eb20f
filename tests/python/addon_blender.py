# SPDX-License-Identifier: MIT OR Apache-2.0
"""Blender as a Python module with the built extension installed, for the tests named test_addon_*.

Import it before `bpy`: it gives Blender a user folder of its own, so that a developer's settings neither
matter nor change. `BOXMORPH_ZIP` names the zip (default: the one in dist/).
"""

import atexit
import importlib
import os
import pathlib
import shutil
import tempfile

import numpy as np
import pytest

PACKAGE = "bl_ext.user_default.boxmorph"

_ROOT = pathlib.Path(__file__).resolve().parents[2]
_USER = tempfile.mkdtemp(prefix="boxmorph-user-")
atexit.register(shutil.rmtree, _USER, ignore_errors=True)
os.environ["BLENDER_USER_RESOURCES"] = _USER

bpy = pytest.importorskip("bpy", reason="the module bpy is not installed in this environment")


def _install():
    named = os.environ.get("BOXMORPH_ZIP")
    found = [pathlib.Path(named)] if named else sorted((_ROOT / "dist").glob("boxmorph-*-linux_x64.zip"))
    if not found:
        pytest.skip("dist/ holds no built extension; run `make extension`", allow_module_level=True)
    bpy.ops.extensions.package_install_files(
        repo="user_default", filepath=str(found[-1]), enable_on_install=True
    )


_install()


def addon(name):
    """Return a module of the installed extension by its bare name, which no two share."""
    root = pathlib.Path(importlib.import_module(PACKAGE).__file__).parent
    source = next(root.rglob(f"{name}.py"), root / name)
    return importlib.import_module(".".join((PACKAGE, *source.relative_to(root).with_suffix("").parts)))


def preferences():
    """Return the extension's preferences."""
    return bpy.context.preferences.addons[PACKAGE].preferences


def empty_scene():
    """Start from an empty file."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def add(name, vertices, faces, edges=()):
    """Add a mesh object and make it the active one."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(
        [tuple(map(float, v)) for v in vertices], list(edges), [tuple(map(int, f)) for f in faces]
    )
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return activate(obj)


def activate(obj):
    """Make an object the active and only selected one."""
    for other in bpy.context.scene.objects:
        other.select_set(False)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    return obj


def chair(half=False):
    """Add a small chair of separate boxes with UVs, materials, a colour, a vertex group, seams and creases.

    With `half` its left side is missing, and Mirror and Subdivision modifiers make it whole.
    """
    parts = [((0.12, 0, 0.45), (0.24, 0.48, 0.06)), ((0.12, 0.21, 0.75), (0.24, 0.05, 0.54))]
    parts += [((0.21, y, 0.21), (0.05, 0.05, 0.42)) for y in (-0.21, 0.21)]
    if not half:
        parts += [((-c[0], c[1], c[2]), s) for c, s in parts]
    corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    sides = np.array([(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
    vertices = np.concatenate([np.array(centre) + corners * size for centre, size in parts])
    faces = np.concatenate([sides + 8 * i for i in range(len(parts))])
    obj = add("Chair", vertices, faces)
    mesh = obj.data
    for i, item in enumerate(mesh.uv_layers.new(name="UVMap").data):
        item.uv = (i % 7 / 7, i % 5 / 5)
    for i, item in enumerate(mesh.color_attributes.new("Dirt", "FLOAT_COLOR", "POINT").data):
        item.color = (i % 3 / 3, 0.5, 0.25, 1.0)
    for label in ("Wood", "Fabric"):
        mesh.materials.append(bpy.data.materials.new(label))
    for polygon in mesh.polygons:
        polygon.material_index = polygon.index % 2
        polygon.use_smooth = polygon.index % 3 == 0
    mesh.edges[3].use_seam = True
    mesh.attributes.new("crease_edge", "FLOAT", "EDGE").data[5].value = 0.5
    obj.vertex_groups.new(name="Seat").add(range(8), 0.75, "REPLACE")
    if half:
        obj.modifiers.new("Mirror", "MIRROR")
        subdivision = obj.modifiers.new("Subdivision", "SUBSURF")
        subdivision.subdivision_type, subdivision.levels = "SIMPLE", 1
    return obj


def mushroom():
    """Add a slab on a block, of one coarse piece."""
    outline = [
        (-0.2, 0.0),
        (-0.2, 1.0),
        (-1.0, 1.0),
        (-1.0, 1.2),
        (1.0, 1.2),
        (1.0, 1.0),
        (0.2, 1.0),
        (0.2, 0.0),
    ]
    n = len(outline)
    vertices = [(x, y, z) for y in (-0.5, 0.5) for x, z in outline]
    caps = [(0, 1, 6, 7), (1, 2, 3, 4, 5, 6)]
    faces = [tuple(reversed(cap)) for cap in caps] + [tuple(i + n for i in cap) for cap in caps]
    faces += [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)]
    return add("Mushroom", vertices, faces)


def fingerprint(obj):
    """Return all of an object that a deformation must not touch, as comparable Python data."""
    mesh = obj.data
    field = {"FLOAT_VECTOR": "vector", "FLOAT2": "vector", "FLOAT_COLOR": "color", "BYTE_COLOR": "color"}
    attributes = {}
    for attribute in mesh.attributes:
        name = field.get(attribute.data_type, "value")
        attributes[attribute.name] = [
            repr(tuple(value) if hasattr(value, "__len__") else value)
            for value in (getattr(item, name) for item in attribute.data)
        ]
    return {
        "attributes": attributes,
        "polygons": [(p.loop_start, p.loop_total, p.material_index, p.use_smooth) for p in mesh.polygons],
        "materials": [material.name for material in mesh.materials],
        "groups": [group.name for group in obj.vertex_groups],
        "weights": [[(g.group, g.weight) for g in v.groups] for v in mesh.vertices],
        "modifiers": [(m.name, m.type, m.show_viewport, m.show_render) for m in obj.modifiers],
        "matrix": [tuple(row) for row in obj.matrix_world],
        "hidden": (obj.hide_viewport, obj.hide_render, obj.mode),
    }


def key_state(obj):
    """Return all about the shape keys of an object, as comparable Python data; None without keys."""
    keys = obj.data.shape_keys
    pin = (obj.show_only_shape_key, obj.active_shape_key_index)
    if keys is None:
        return pin
    blocks = [
        (k.name, k.value, k.slider_min, k.slider_max, k.mute, k.relative_key.name, positions(k).tobytes())
        for k in keys.key_blocks
    ]
    return pin, blocks, dict(keys.items())


def positions(key):
    """Return the positions of a shape key, (n,3) float32."""
    out = np.empty(len(key.points) * 3, np.float32)
    key.points.foreach_get("co", out)
    return out.reshape(-1, 3)


def evaluated_positions(obj):
    """Return the positions of the evaluated mesh, (n,3) float32."""
    bpy.context.view_layer.update()
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    out = np.array([tuple(v.co) for v in mesh.vertices], np.float32)
    evaluated.to_mesh_clear()
    return out


def deform(prompt="a bar stool", **options):
    """Deform the active object; raises RuntimeError with the report's text where that is refused."""
    options.setdefault("splits", "2")
    assert bpy.ops.boxmorph.deform(prompt=prompt, **options) == {"FINISHED"}
