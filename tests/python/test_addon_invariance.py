# SPDX-License-Identifier: MIT OR Apache-2.0
"""What Boxmorph adds is a shape key and nothing else: of every example and of odd objects, all of the file
stays byte for byte what it was, also where a search fails or is cancelled.
"""

import re
import time

import addon_blender as blender
import pytest
from addon_blender import bpy
from addon_objects import OBJECTS, animated_object, modifiers, only_basis, shape_keys
from addon_snapshot import differences, snapshot

PROMPT = "a bar stool"

#: What an outcome changes of the object itself.
_POINTED_AT = r"objects\[.*\]\.active_shape_key(_index)?"


@pytest.fixture(params=OBJECTS.values(), ids=OBJECTS)
def obj(request):
    blender.empty_scene()
    obj = blender.activate(request.param())
    bpy.context.scene.frame_set(bpy.context.scene.frame_current)
    return obj


@pytest.mark.parametrize(
    "change",
    [
        lambda obj: setattr(obj.data.vertices[3].co, "x", 1e-7),
        lambda obj: setattr(obj.data.polygons[2], "use_smooth", not obj.data.polygons[2].use_smooth),
        lambda obj: setattr(
            obj.data.polygons[2], "material_index", 0 if obj.data.polygons[2].material_index else 1
        ),
        lambda obj: setattr(obj.data.edges[7], "use_seam", not obj.data.edges[7].use_seam),
        lambda obj: setattr(obj.data.uv_layers[0].data[5].uv, "x", 0.123),
        lambda obj: obj.data.color_attributes[0].data[1].color.__setitem__(3, 0.5),
        lambda obj: obj.data.flip_normals(),
        lambda obj: obj.data.normals_split_custom_set([(0, 0.6, 0.8)] * len(obj.data.loops)),
        lambda obj: obj.vertex_groups[0].add([2], 0.5, "REPLACE"),
        lambda obj: setattr(obj.data.shape_keys.key_blocks["Wide"].points[4].co, "z", 1e-7),
        lambda obj: setattr(obj.data.shape_keys.key_blocks["Wide"], "vertex_group", ""),
        lambda obj: setattr(obj.data.shape_keys.animation_data.drivers[0].driver, "expression", "1"),
        lambda obj: setattr(blender.addon("animation_curves").curves(obj.data.shape_keys)[0], "lock", True),
        lambda obj: setattr(
            blender.addon("animation_curves").curves(obj.data.shape_keys)[0].keyframe_points[1].co, "y", 0.5
        ),
        lambda obj: setattr(obj.modifiers[0], "width", 0.5),
        lambda obj: obj.__setitem__("amount", 0.31),
        lambda obj: bpy.data.images.new("New", 1, 1),
        lambda obj: bpy.app.handlers.undo_pre.append(print),
    ],
)
def test_a_snapshot_sees_small_changes(change):
    blender.empty_scene()
    obj = shape_keys()
    obj.modifiers.new("Bevel", "BEVEL")
    bpy.context.scene.frame_set(1)
    before = snapshot()
    assert not differences(before, snapshot())
    change(obj)
    assert differences(before, snapshot())
    if print in bpy.app.handlers.undo_pre:
        bpy.app.handlers.undo_pre.remove(print)


def assert_as_it_was(before):
    assert not differences(before, snapshot())


def assert_only_the_outcome_is_new(obj, before, name):
    keys = re.escape(f"shape_keys[{obj.data.shape_keys.name_full}]")
    allowed = [_POINTED_AT]
    if not any(re.match(keys, path) for path in before):
        allowed += [rf"{keys}.*", re.escape(f"meshes[{obj.data.name_full}].shape_keys")]
    else:
        allowed += [
            rf"{keys}\.key_blocks(\.count|\[{re.escape(name)}\].*)",
            rf"{keys}\['boxmorph'\]",
        ]
    changed = differences(before, snapshot())
    assert any(f"[{name}].points" in path for path in changed)
    assert not [path for path in changed if not any(re.fullmatch(rule, path) for rule in allowed)]


def test_an_outcome_adds_a_key_and_leaves_no_trace_when_it_goes(obj):
    before = snapshot()
    stood = [(key.name, key.value) for key in obj.data.shape_keys.key_blocks] if obj.data.shape_keys else []
    blender.deform(PROMPT, splits="1", seed=2)
    name = obj.active_shape_key.name
    assert name not in dict(stood)
    assert_only_the_outcome_is_new(obj, before, name)
    outcome = snapshot()
    bpy.ops.boxmorph.take_apart(key=name)
    assert differences(outcome, snapshot())
    bpy.ops.boxmorph.put_together(key=name)
    assert_as_it_was(outcome)
    bpy.ops.boxmorph.measure_scores(key=name)
    # Off and at the frame that it was, a keyframed outcome changes nothing but itself.
    frame = bpy.context.scene.frame_current
    bpy.ops.boxmorph.keyframe_spectrum(key=name, frame_from=frame, frame_to=frame + 10)
    bpy.ops.boxmorph.remove_outcome(key=name)
    if before_active := before.get(f"objects[{obj.name_full}].active_shape_key_index"):
        obj.active_shape_key_index = int(before_active)
    assert_as_it_was(before)


@pytest.mark.parametrize("make", [animated_object, shape_keys], ids=lambda make: make.__name__)
def test_a_control_goes_with_its_outcome(make):
    blender.empty_scene()
    obj = make()
    bpy.context.scene.frame_set(1)
    before = snapshot()
    blender.deform(PROMPT, splits="1")
    name = obj.active_shape_key.name
    assert bpy.ops.boxmorph.add_control(key=name) == {"FINISHED"}
    obj.keyframe_insert(f'["{name}"]', frame=1)
    bpy.ops.boxmorph.remove_outcome(key=name)
    if before_active := before.get(f"objects[{obj.name_full}].active_shape_key_index"):
        obj.active_shape_key_index = int(before_active)
    assert_as_it_was(before)


def test_nothing_is_left_of_a_search_that_was_refused_failed_or_cancelled(obj):
    before = snapshot()
    with pytest.raises(RuntimeError):
        bpy.ops.boxmorph.deform(prompt="zzgribble xqwv")
    assert_as_it_was(before)
    search = blender.addon("search").Search(bpy.context, obj, PROMPT, "paper", splits="1")
    until = time.monotonic() + 120
    while search._shown_score is None:
        search.poll()
        search.preview(obj)
        assert time.monotonic() < until, "no preview within two minutes"
        time.sleep(0.002)
    assert differences(before, snapshot())
    search.cancel(wait=True)
    with pytest.raises(blender.addon("errors").Refusal):
        search.keep(obj, bpy.context)
    assert search.take_back(search.find_object())
    assert_as_it_was(before)


@pytest.mark.parametrize("make", [shape_keys, modifiers, only_basis], ids=lambda make: make.__name__)
def test_nothing_is_left_of_a_search_that_fails_on_its_way(make, monkeypatch):
    blender.empty_scene()
    make()
    bpy.context.scene.frame_set(1)
    before = snapshot()
    monkeypatch.setattr(blender.addon("search").Search, "run", lambda search: search.cancel(wait=True))
    with pytest.raises(RuntimeError, match="ancelled"):
        bpy.ops.boxmorph.deform(prompt=PROMPT, splits="1")
    assert_as_it_was(before)
