# SPDX-License-Identifier: MIT OR Apache-2.0
"""The example objects are as an artist would leave them: whole, on the floor, with UVs and modifiers."""

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs the module bpy")
from mathutils import kdtree  # noqa: E402

sys.path.insert(0, str(Path(__file__).parents[2]))

#: Module, modifier types, least number of materials, size in metres (x, y, z).
OBJECTS = [
    ("chair", ["MIRROR"], 2, (0.456, 0.526, 0.851)),
    ("table", [], 2, (1.4, 0.8, 0.75)),
    ("aeroplane", ["MIRROR"], 4, (35.4, 37.8, 10.2)),
    ("desk_lamp", ["SUBSURF"], 3, (0.18, 0.315, 0.43)),
]
NAMES = [name for name, *_ in OBJECTS]


def build(name):
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    return importlib.import_module(f"examples.{name}").build()


def shown(obj):
    """Positions (n, 3) and triangles (m, 3) of the evaluated mesh."""
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    mesh.calc_loop_triangles()
    positions = np.array([v.co for v in mesh.vertices])
    triangles = np.array([t.vertices for t in mesh.loop_triangles])
    evaluated.to_mesh_clear()
    return positions, triangles


def islands(count, triangles):
    """The number of the island of each vertex."""
    label = np.arange(count)
    while True:
        low = label[triangles].min(axis=1)
        new = label.copy()
        np.minimum.at(new, triangles.ravel(), np.repeat(low, 3))
        new = new[new]
        if np.array_equal(new, label):
            return label
        label = new


@pytest.mark.parametrize(("name", "modifiers", "materials", "size"), OBJECTS)
def test_is_what_it_promises(name, modifiers, materials, size):
    obj = build(name)
    assert bpy.context.active_object == obj and obj.select_get()
    assert [m.type for m in obj.modifiers] == modifiers
    assert all(m.use_clip for m in obj.modifiers if m.type == "MIRROR")
    assert len(obj.data.materials) >= materials
    used = {polygon.material_index for polygon in obj.data.polygons}
    assert used == set(range(len(obj.data.materials))), "a material that no face has"
    grouped = [v for v in obj.data.vertices if v.groups]
    assert len(obj.vertex_groups) >= 2 and len(grouped) == len(obj.data.vertices)
    positions, _ = shown(obj)
    assert 2000 <= len(positions) <= 30000
    assert np.ptp(positions, axis=0) == pytest.approx(size, rel=0.05)


@pytest.mark.parametrize("name", NAMES)
def test_stands_on_the_floor_at_the_origin(name):
    obj = build(name)
    positions, _ = shown(obj)
    assert tuple(obj.location) == (0, 0, 0) and tuple(obj.scale) == (1, 1, 1)
    assert positions[:, 2].min() == pytest.approx(0, abs=1e-3 * np.ptp(positions[:, 2]))
    assert np.abs(positions[:, 0].min() + positions[:, 0].max()) < 1e-4 * np.ptp(positions[:, 0])


@pytest.mark.parametrize("name", NAMES)
def test_parts_are_closed_and_face_outwards(name):
    positions, triangles = shown(build(name))
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, uses = np.unique(edges, axis=0, return_counts=True)
    assert (uses == 2).all(), f"{(uses != 2).sum()} edges do not have two faces"
    label = islands(len(positions), triangles)
    parts = np.unique(label)
    assert len(parts) >= 5
    for part in parts:
        own = positions[triangles[label[triangles[:, 0]] == part]]
        own = own - own.mean(axis=(0, 1))
        assert np.einsum("ij,ij->", own[:, 0], np.cross(own[:, 1], own[:, 2])) > 0


@pytest.mark.parametrize("name", ["chair", "aeroplane"])
def test_mirrored_objects_are_symmetric(name):
    obj = build(name)
    assert min(v.co.x for v in obj.data.vertices) >= 0, "the modelled half crosses the middle"
    positions, _ = shown(obj)
    tree = kdtree.KDTree(len(positions))
    for i, position in enumerate(positions):
        tree.insert(position, i)
    tree.balance()
    assert max(tree.find(position * (-1, 1, 1))[2] for position in positions) < 1e-5 * np.ptp(positions)


@pytest.mark.parametrize("name", NAMES)
def test_uvs_are_spread_and_finite(name):
    mesh = build(name).data
    uv = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers.active.data.foreach_get("uv", uv)
    uv = uv.reshape(-1, 2)
    assert np.isfinite(uv).all()
    flat = 0
    for polygon in mesh.polygons:
        corners = uv[list(polygon.loop_indices)]
        flat += not (np.ptp(corners, axis=0) > 0).all()
    assert flat < 0.01 * len(mesh.polygons)


@pytest.mark.parametrize("name", NAMES)
def test_builds_the_same_every_time(name):
    first, second = (shown(build(name)) for _ in range(2))
    assert np.array_equal(first[0], second[0]) and np.array_equal(first[1], second[1])
