# SPDX-License-Identifier: MIT OR Apache-2.0
"""Refine at Part Boundaries: coarse meshes of one piece are cut, and keep all that they carry."""

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


@pytest.fixture
def mushroom():
    """A slab on a block of one coarse piece, with UVs, two materials, a group, a shape key and normals."""
    obj = blender.mushroom()
    mesh = obj.data
    for name in ("Cap", "Stem"):
        mesh.materials.append(bpy.data.materials.new(name))
    uv = mesh.uv_layers.new(name="UVMap")
    for loop in mesh.loops:
        co = mesh.vertices[loop.vertex_index].co
        uv.data[loop.index].uv = (co.x, co.z)
    for polygon in mesh.polygons:
        polygon.material_index = int(polygon.center.z < 1.0)
    group = obj.vertex_groups.new(name="High")
    for vertex in mesh.vertices:
        group.add([vertex.index], vertex.co.z / 1.2, "REPLACE")
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Lean")
    key.value = 0.0  # Blender 5 makes new keys at 1
    for point in key.points:
        point.co.x += point.co.z
    bpy.ops.boxmorph.find_parts()
    return obj


def test_coarse_faces_are_counted_and_gone_afterwards(mushroom):
    assert mushroom.boxmorph.coarse > 0
    faces = len(mushroom.data.polygons)
    assert bpy.ops.boxmorph.refine() == {"FINISHED"}
    assert len(mushroom.data.polygons) > faces
    assert mushroom.boxmorph.coarse == 0


def test_shape_and_all_that_it_carries_are_the_same(mushroom):
    def area():
        return sum(polygon.area for polygon in mushroom.data.polygons)

    before = (
        area(),
        blender.evaluated_positions(mushroom).min(0),
        blender.evaluated_positions(mushroom).max(0),
    )
    bpy.ops.boxmorph.refine()
    mesh = mushroom.data
    assert np.isclose(area(), before[0])
    basis, lean = mesh.shape_keys.key_blocks
    assert (basis.name, lean.name) == ("Basis", "Lean")
    rest, leant = blender.positions(basis), blender.positions(lean)
    assert np.allclose(rest.min(0), before[1]) and np.allclose(rest.max(0), before[2])
    assert np.allclose(leant, rest + rest[:, [2, 0, 0]] * [1, 0, 0], atol=1e-5)
    uv = mesh.uv_layers["UVMap"].data
    for loop in mesh.loops:
        co = rest[loop.vertex_index]
        assert np.allclose(uv[loop.index].uv, (co[0], co[2]), atol=1e-5)
    for polygon in mesh.polygons:
        assert polygon.material_index == int(rest[list(polygon.vertices)].mean(0)[2] < 1.0)
    for vertex in mesh.vertices:
        weight = vertex.groups[0].weight if vertex.groups else 0.0
        assert weight == pytest.approx(rest[vertex.index][2] / 1.2, abs=1e-5)


def test_custom_normals_stay(mushroom):
    mesh = mushroom.data
    slanted = np.array([(0.6, 0.0, 0.8)] * len(mesh.loops))
    mesh.normals_split_custom_set(slanted)
    bpy.ops.boxmorph.refine()
    mesh = mushroom.data
    assert mesh.has_custom_normals
    normals = np.array([normal.vector for normal in mesh.corner_normals])
    assert np.allclose(normals, (0.6, 0.0, 0.8), atol=1e-2)
    assert "boxmorph normals" not in mesh.attributes


def test_a_refined_stem_keeps_its_sides_straight(mushroom):
    """Without the cuts the whole stem would be a wedge where it is made thicker."""
    bpy.ops.boxmorph.refine()
    bpy.ops.boxmorph.find_parts()
    graph = blender.addon("parts").Found(_library_mesh(mushroom), "auto", "auto").graph
    rows = graph.parameter_row_of_box
    stem = rows[graph.assignment[np.argmin(blender.positions(_basis(mushroom))[:, 2])]]
    scales = np.ones((graph.parameter_rows, 3), np.float32)
    scales[stem, 0] = 2.0
    rest, moved = blender.positions(_basis(mushroom)), graph.deform(scales)
    own = (np.abs(rest[:, 0]) < 0.21) & (rest[:, 2] < 0.97)
    assert own.sum() >= 8
    assert np.allclose(moved[own, 0] / rest[own, 0], 2.0, atol=0.25)


def test_unknown_parts_and_fine_meshes(mushroom):
    bpy.ops.boxmorph.forget_parts()
    with pytest.raises(RuntimeError, match="Find them first"):
        bpy.ops.boxmorph.refine()
    bpy.ops.boxmorph.find_parts()
    bpy.ops.boxmorph.refine()
    faces = len(mushroom.data.polygons)
    bpy.ops.boxmorph.refine()
    assert len(mushroom.data.polygons) == faces


def _basis(obj):
    return obj.data.shape_keys.reference_key


def _library_mesh(obj):
    mesh_io = blender.addon("mesh_io")
    return (
        blender.addon("engine")
        .library()
        .Mesh(mesh_io.basis_positions(obj.data), mesh_io.mesh_triangles(obj.data))
    )
