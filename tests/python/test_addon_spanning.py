# SPDX-License-Identifier: MIT OR Apache-2.0
"""Faces that span parts: how many, how far an outcome shears them, and where that is said."""

import json
from types import SimpleNamespace

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def two_parts():
    """A square of two triangles, its lower edge in one part and its upper edge in another."""
    square = np.array([(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)], np.float32)
    graph = SimpleNamespace(
        assignment=np.array([0, 0, 1, 1]),
        parameter_row_of_box=np.array([0, 1]),
        box_center=np.array([(0.5, 0, 0), (0.5, 0, 1)]),
        box_half_size=np.array([(0.5, 0.1, 0.1)] * 2),
    )
    return square, np.array([(0, 1, 2), (0, 2, 3)]), graph


@pytest.mark.parametrize("degrees", [0, 10, 34, 60])
def test_shear_is_how_far_edges_lean(degrees):
    spanning = blender.addon("spanning")
    square, triangles, graph = two_parts()
    moved = square.copy()
    moved[2:, 0] += np.tan(np.radians(degrees))
    shear = spanning.worst_shear(square, moved, triangles, graph, np.ones((2, 3)))
    assert shear == pytest.approx(degrees, abs=0.01)


def test_the_scaling_of_a_part_is_no_shear():
    spanning = blender.addon("spanning")
    square, triangles, graph = two_parts()
    scales = np.array([(3.0, 1.0, 0.5)] * 2)
    assert spanning.worst_shear(square, square * scales[0], triangles, graph, scales) < 1e-3
    assert spanning.worst_shear(square, square, triangles[:0], graph, scales) == 0.0
    # The upper part twice as wide about the left edge: the right edge leans by 45°.
    moved = square.copy()
    moved[2, 0] = 2.0
    scales = np.array([(1.0, 1.0, 1.0), (2.0, 1.0, 1.0)])
    assert 40.0 < spanning.worst_shear(square, moved, triangles, graph, scales) <= 45.01


def test_only_long_faces_count():
    spanning = blender.addon("spanning")
    square, triangles, graph = two_parts()
    assert spanning.coarse_faces(square, triangles, graph).tolist() == triangles.tolist()
    graph.box_half_size = graph.box_half_size * (1, 1, 9.9)
    assert len(spanning.coarse_faces(square, triangles, graph)) == 0


def test_clauses_count_and_measure():
    clauses = blender.addon("spanning").clauses
    assert clauses(0) == clauses(0, 0.0) == []
    assert clauses(1, 20.0) == ["1 long face spans parts", "it is sheared by 20°"]
    assert clauses(12, 33.7) == ["12 long faces span parts", "the worst is sheared by 34°"]
    assert clauses(2) == clauses(2, 0.0) == ["2 long faces span parts"]


def test_shear_is_said_and_recorded_and_gone_after_refining(capfd):
    obj = blender.mushroom()
    blender.deform(PROMPT)
    said = "".join(capfd.readouterr())
    record = json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]
    count, degrees = record["coarse_faces"], record["worst_shear"]
    assert count > 0 and 1.0 < degrees <= 180.0
    assert f"{count} long faces span parts; the worst is sheared by {degrees:.0f}°" in said
    bpy.ops.boxmorph.remove_outcome(key=PROMPT)
    bpy.context.scene.boxmorph.splits = "2"
    bpy.ops.boxmorph.find_parts()
    assert obj.boxmorph.coarse == count
    bpy.ops.boxmorph.refine()
    blender.deform(PROMPT)
    assert json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]["coarse_faces"] == 0
    assert "sheared" not in "".join(capfd.readouterr())


def test_separate_boxes_are_not_sheared():
    obj = blender.chair()
    blender.deform(PROMPT)
    record = json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]
    assert (record["coarse_faces"], record["worst_shear"]) == (0, 0.0)
