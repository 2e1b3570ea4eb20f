# SPDX-License-Identifier: MIT OR Apache-2.0
"""Parts in Blender: found, named, locked, and kept with the object."""

import json

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy
from mathutils import Matrix

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


@pytest.fixture
def chair():
    obj = blender.chair()
    bpy.ops.boxmorph.find_parts()
    return obj


def names(obj):
    return [part.name for part in obj.boxmorph.items]


def record(obj):
    return json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]


def test_parts_are_named_for_where_they_are(chair):
    assert len(names(chair)) > 2 and len(set(names(chair))) == len(names(chair))
    assert any(name.startswith("Top") and "Back" in name for name in names(chair)), names(chair)
    assert any(name.startswith("Bottom") and "Sides" in name for name in names(chair)), names(chair)


def test_boxes_lie_around_the_object_and_hang_together(chair):
    geometry = blender.addon("parts").geometry(chair)
    rest = blender.evaluated_positions(chair)
    centers, halves = (np.array([box[i] for box in geometry["boxes"]]) for i in (0, 1))
    assert np.allclose((centers - halves).min(0), rest.min(0), atol=1e-4)
    assert np.allclose((centers + halves).max(0), rest.max(0), atol=1e-4)
    assert len(geometry["tree"]) == len(geometry["boxes"]) - 1


def test_four_legs_are_one_part():
    corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    sides = np.array([(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
    legs = [((x, y, 0.35), (0.06, 0.06, 0.7)) for x in (-0.7, 0.7) for y in (-0.3, 0.3)]
    boxes = [((0, 0, 0.73), (1.6, 0.8, 0.06)), *legs]
    vertices = np.concatenate([np.array(center) + corners * size for center, size in boxes])
    obj = blender.add("Table", vertices, np.concatenate([sides + 8 * i for i in range(len(boxes))]))
    bpy.ops.boxmorph.find_parts()
    assert sorted(names(obj)) == ["Corners", "Top"]
    blender.deform("a bar table")
    assert json.loads(obj.data.shape_keys["boxmorph"])["a bar table"]["symmetry"] == "xy"


def test_a_locked_part_keeps_its_scale(chair):
    chair.boxmorph.items[1].lock = (True, True, True)
    blender.deform(PROMPT)
    report = record(chair)
    assert report["locked"][1] == [True] * 3 and report["scales"][1] == [1.0] * 3
    assert report["gauge_scale"] == 1.0
    assert np.ptp(report["scales"]) > 0.1


def test_parts_without_locks_leave_the_search_free(chair):
    blender.deform(PROMPT)
    with_parts = blender.positions(chair.data.shape_keys.key_blocks[PROMPT])
    blender.empty_scene()
    other = blender.chair()
    blender.deform(PROMPT)
    assert np.array_equal(with_parts, blender.positions(other.data.shape_keys.key_blocks[PROMPT]))


@pytest.mark.skipif(bpy.app.version < (4, 3, 0), reason="Blender 4.2 as a module bears no callbacks of ours")
def test_parts_follow_the_settings(chair):
    count = len(names(chair))
    bpy.context.scene.boxmorph.splits = "1"
    assert len(names(chair)) < count
    bpy.context.scene.boxmorph.symmetry = "none"
    assert chair.boxmorph.symmetry == "none"


def test_locks_are_kept_when_the_same_parts_are_found_again(chair):
    chair.boxmorph.items[0].lock = (False, True, False)
    bpy.ops.boxmorph.find_parts()
    assert tuple(chair.boxmorph.items[0].lock) == (False, True, False)


def test_locks_of_a_changed_object_are_refused_in_a_sentence(chair):
    bpy.ops.boxmorph.lock_part(index=0)
    assert tuple(chair.boxmorph.items[0].lock) == (True, True, True)
    for vertex in chair.data.vertices:
        vertex.co.z *= 2.0
    with pytest.raises(RuntimeError, match="has changed since its parts were found"):
        blender.deform(PROMPT)
    assert chair.data.shape_keys is None
    bpy.ops.boxmorph.find_parts()
    blender.deform(PROMPT)


def test_everything_locked_is_refused_in_a_sentence(chair):
    for part in chair.boxmorph.items:
        part.lock = (True, True, True)
    with pytest.raises(RuntimeError, match="every axis of every part is locked"):
        blender.deform(PROMPT)


def test_forgotten_parts_lock_nothing(chair):
    bpy.ops.boxmorph.lock_part(index=0)
    bpy.ops.boxmorph.forget_parts()
    blender.deform(PROMPT)
    assert record(chair)["locked"] is None


def test_parts_and_locks_survive_saving(chair, tmp_path):
    bpy.ops.boxmorph.lock_part(index=1)
    expected = names(chair)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "chair.blend"))
    obj = bpy.context.active_object
    assert names(obj) == expected and tuple(obj.boxmorph.items[1].lock) == (True, True, True)


def cube(collection, low, high):
    low, high = np.array(low), np.array(high)
    corners = [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    box = blender.add("Box", corners, [(0, 1, 3, 2), (4, 5, 7, 6)])
    for user in box.users_collection:
        user.objects.unlink(box)
    collection.objects.link(box)


def test_boxes_of_ones_own_are_the_parts():
    obj = blender.chair()
    rest = blender.evaluated_positions(obj)
    low, high = rest.min(0), rest.max(0)
    collection = bpy.data.collections.new("Boxes")
    bpy.context.scene.collection.children.link(collection)
    settings = bpy.context.scene.boxmorph
    settings.parts_collection = collection
    with pytest.raises(RuntimeError, match="holds no boxes"):
        bpy.ops.boxmorph.find_parts()
    middle = (low[2] + high[2]) / 2
    cube(collection, low, [high[0], high[1], middle])
    cube(collection, [low[0], low[1], middle], high)
    bpy.context.view_layer.update()
    blender.activate(obj)
    bpy.ops.boxmorph.find_parts()
    assert names(obj) == ["Bottom", "Top"]
    blender.deform(PROMPT)
    assert record(obj)["boxes"] == 2 and record(obj)["locked"] is None
    bpy.ops.boxmorph.lock_part(index=0)
    blender.deform(PROMPT)
    assert record(obj)["scales"][0] == [1.0] * 3 and record(obj)["boxes"] == 2


def test_an_object_that_lies_askew_is_split_along_its_own_axes(chair):
    straight = blender.addon("parts").geometry(chair)
    blender.empty_scene()
    obj = blender.chair()
    turn = Matrix.Rotation(np.radians(30.0), 4, "Z")
    obj.data.transform(turn)
    bpy.ops.boxmorph.find_parts()
    askew = blender.addon("parts").geometry(obj)
    assert len(askew["boxes"]) == len(straight["boxes"])
    assert np.allclose(np.array(askew["place"]) @ np.array(turn)[:3, :3], np.eye(3), atol=1e-4)
    for ours, theirs in zip(askew["boxes"], straight["boxes"], strict=True):
        assert np.allclose(ours[0], theirs[0], atol=1e-3) and np.allclose(ours[1], theirs[1], atol=1e-3)
    # What is found lies along the turned axes, in the object's own coordinates.
    rest = blender.evaluated_positions(obj)
    bpy.ops.boxmorph.lock_part(index=0)
    blender.deform(PROMPT)
    along = np.array(turn)[:3, :3]
    moved = (blender.positions(obj.data.shape_keys.key_blocks[PROMPT]) - rest) @ along
    rest = rest @ along
    left, right = rest[:, 0] < -1e-3, rest[:, 0] > 1e-3
    assert np.isclose(np.abs(moved[left, 0]).max(), np.abs(moved[right, 0]).max(), atol=1e-3)


def test_scales_stay_in_the_range_of_the_panel():
    obj = blender.chair()
    settings = bpy.context.scene.boxmorph
    settings.least_scale, settings.greatest_scale, settings.keep_size = 0.9, 1.2, "height"
    rest = np.ptp(blender.evaluated_positions(obj)[:, 2])
    blender.deform(PROMPT)
    scales = np.array(record(obj)["scales"])
    assert scales.min() >= 0.9 - 1e-6 and scales.max() <= 1.2 + 1e-6
    key = blender.positions(obj.data.shape_keys.key_blocks[PROMPT])
    assert np.isclose(np.ptp(key[:, 2]), rest, rtol=1e-4)


def shown(obj):
    """Return low and high of the boxes as they are drawn, and of the vertices of each, (b,2,3)."""
    geometry = blender.addon("parts").geometry(obj)
    bpy.context.view_layer.update()
    boxes = blender.addon("parts_shown").shown_boxes(obj, geometry, bpy.context.evaluated_depsgraph_get())
    return np.array([(center - half, center + half) for center, half in boxes])


@pytest.mark.parametrize("value", [1.0, 0.5, -0.25])
def test_boxes_are_drawn_around_the_outcome_that_is_shown(chair, value):
    rest = blender.evaluated_positions(chair)
    before = shown(chair)
    blender.deform(PROMPT)
    key = chair.data.shape_keys.key_blocks[PROMPT]
    key.value = value
    now = blender.evaluated_positions(chair)
    after = shown(chair)
    assert np.abs(after - before).max() > 0.02
    # Each island of the chair lies in the box that it lay in.
    for island in range(len(rest) // 8):
        own = slice(8 * island, 8 * island + 8)
        for was, box in zip(before, after, strict=True):
            inside = (rest[own] >= was[0] - 1e-3).all() and (rest[own] <= was[1] + 1e-3).all()
            if inside:
                assert (now[own] >= box[0] - 0.02).all() and (now[own] <= box[1] + 0.02).all()
    assert np.allclose((after[:, 0].min(0), after[:, 1].max(0)), (now.min(0), now.max(0)), atol=0.02)
    key.value = 0.0
    assert np.allclose(shown(chair), before, atol=1e-6)


def test_boxes_follow_under_modifiers_and_stay_where_vertices_are_others():
    obj = blender.chair(half=True)
    bpy.ops.boxmorph.find_parts()
    before = shown(obj)
    blender.deform(PROMPT)
    now = blender.evaluated_positions(obj)
    after = shown(obj)
    assert np.abs(after - before).max() > 0.02
    assert np.allclose((after[:, 0].min(0), after[:, 1].max(0)), (now.min(0), now.max(0)), atol=0.02)
    obj.modifiers["Subdivision"].levels = 2
    assert np.allclose(shown(obj), before, atol=1e-6)
