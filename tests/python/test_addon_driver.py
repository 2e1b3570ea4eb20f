# SPDX-License-Identifier: MIT OR Apache-2.0
"""Outcomes under drivers, through renaming and new searches; Add Driver Control."""

import json

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A file with a chair and its outcome."""
    path = tmp_path_factory.mktemp("driver") / "chair.blend"
    blender.empty_scene()
    blender.chair()
    blender.deform(PROMPT)
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return str(path)


@pytest.fixture
def obj(file):
    bpy.ops.wm.open_mainfile(filepath=file)
    return bpy.context.active_object


def key_of(obj, name=PROMPT):
    return obj.data.shape_keys.key_blocks[name]


def records(obj):
    return blender.addon("shape_key").records(obj.data)


def shown(obj, name=PROMPT):
    """The value at which an outcome is shown, from where the vertices are."""
    obj.update_tag()
    rest = blender.positions(obj.data.shape_keys.reference_key)
    change = blender.positions(key_of(obj, name)) - rest
    return float(((blender.evaluated_positions(obj) - rest) * change).sum() / (change**2).sum())


def drive(key, target, path):
    """Drive an outcome by a property."""
    driver = key.driver_add("value").driver
    driver.type = "SUM"
    variable = driver.variables.new()
    variable.targets[0].id = target
    variable.targets[0].data_path = path
    return variable


def armature():
    """Add an armature of one bone and return it."""
    rig = bpy.data.objects.new("Rig", bpy.data.armatures.new("Rig"))
    bpy.context.scene.collection.objects.link(rig)
    chair = bpy.context.active_object
    blender.activate(rig)
    bpy.ops.object.mode_set(mode="EDIT")
    bone = rig.data.edit_bones.new("Lever")
    bone.tail = (0.0, 0.0, 1.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    blender.activate(chair)
    return rig


def test_a_custom_property_drives_an_outcome(obj):
    obj["stool"] = 0.25
    drive(key_of(obj), obj, '["stool"]')
    for value in (0.25, 1.0, -0.2):
        obj["stool"] = value
        assert shown(obj) == pytest.approx(value, abs=1e-4)


def test_a_bone_drives_an_outcome(obj):
    rig = armature()
    variable = drive(key_of(obj), None, "")
    variable.type = "TRANSFORMS"
    target = variable.targets[0]
    target.id, target.bone_target = rig, "Lever"
    target.transform_type, target.transform_space = "LOC_Y", "LOCAL_SPACE"
    for value in (0.0, 0.4, 1.0):
        rig.pose.bones["Lever"].location.y = value
        rig.update_tag()
        assert shown(obj) == pytest.approx(value, abs=1e-4)


def test_drivers_and_keyframes_stay_through_a_new_search(obj):
    key = key_of(obj)
    obj["stool"] = 0.5
    drive(key, obj, '["stool"]')
    before = blender.positions(key)
    blender.deform(PROMPT, seed=5)
    assert not np.array_equal(blender.positions(key_of(obj)), before)
    assert shown(obj) == pytest.approx(0.5, abs=1e-4)

    key_of(obj).driver_remove("value")
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=11)
    blender.deform(PROMPT, seed=6)
    bpy.context.scene.frame_set(4)
    assert shown(obj) == pytest.approx(0.3, abs=1e-4)


@pytest.fixture
def renamed(obj):
    """The chair, its outcome animated and then renamed in Blender's own list."""
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=11)
    key_of(obj).name = 'Küche "hoch"'
    return obj


NEW = 'Küche "hoch"'


def test_a_renamed_outcome_is_still_one(renamed, tmp_path):
    assert [key.name for key in blender.addon("shape_key").outcomes(renamed.data)] == [NEW]
    assert records(renamed)[NEW]["prompt"] == PROMPT
    bpy.context.scene.frame_set(6)
    assert shown(renamed, NEW) == pytest.approx(0.5, abs=1e-4)
    assert bpy.ops.boxmorph.measure_scores(key=NEW) == {"FINISHED"}
    assert "score_curve" in records(renamed)[NEW]
    assert bpy.ops.boxmorph.keyframe_spectrum(key=NEW, frame_from=1, frame_to=21) == {"FINISHED"}
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "renamed.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "renamed.blend"))
    obj = bpy.context.active_object
    key_of(obj, NEW).name = "Again"
    assert list(records(obj)) == ["Again"]
    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert obj.data.shape_keys is None and not bpy.data.actions


def test_a_renamed_outcome_is_not_replaced(renamed):
    before = blender.positions(key_of(renamed, NEW))
    blender.deform(PROMPT, seed=3)
    stored = records(renamed)
    assert {name: report["seed"] for name, report in stored.items()} == {NEW: 0, PROMPT: 3}
    assert np.array_equal(blender.positions(key_of(renamed, NEW)), before)


def test_a_key_of_the_artist_is_never_taken_for_a_renamed_outcome(obj):
    own = obj.shape_key_add(name="Own", from_mix=False)
    own.points[0].co.x += 0.1
    obj.active_shape_key_index = 1
    bpy.ops.object.shape_key_remove()
    assert [key.name for key in obj.data.shape_keys.key_blocks] == ["Basis", "Own"]
    assert records(obj) == {}
    blender.deform(PROMPT)
    assert list(records(obj)) == [PROMPT]


def test_of_several_outcomes_each_record_follows_its_key(obj):
    blender.deform("a sofa")
    blender.deform("a throne")
    seats = key_of(obj, "a sofa"), key_of(obj, "a throne")
    seats[1].name = "Second"
    seats[0].name = "First"
    assert {name: report["prompt"] for name, report in records(obj).items()} == {
        PROMPT: PROMPT,
        "First": "a sofa",
        "Second": "a throne",
    }


def test_a_key_renamed_to_the_name_of_a_deleted_one_keeps_its_own_record(obj):
    blender.deform("a sofa")
    obj.active_shape_key_index = 1
    bpy.ops.object.shape_key_remove()
    key_of(obj, "a sofa").name = PROMPT
    assert {name: report["prompt"] for name, report in records(obj).items()} == {PROMPT: "a sofa"}


def control():
    assert bpy.ops.boxmorph.add_control() == {"FINISHED"}


def test_a_control_drives_its_outcome(obj, tmp_path):
    key = key_of(obj)
    key.value = 0.5
    control()
    assert obj[PROMPT] == pytest.approx(0.5) and shown(obj) == pytest.approx(0.5, abs=1e-4)
    limits = obj.id_properties_ui(PROMPT).as_dict()
    assert (limits["min"], limits["max"]) == pytest.approx((key.slider_min, key.slider_max))
    assert PROMPT in limits["description"]
    for frame, value in ((1, 0.0), (11, 1.0)):
        obj[PROMPT] = value
        obj.keyframe_insert(f'["{PROMPT}"]', frame=frame)
    key.name = "Renamed"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "control.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "control.blend"))
    obj = bpy.context.active_object
    bpy.context.scene.frame_set(1)
    assert shown(obj, "Renamed") == pytest.approx(0.0, abs=1e-4)
    bpy.context.scene.frame_set(11)
    assert shown(obj, "Renamed") == pytest.approx(1.0, abs=1e-4)

    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert PROMPT not in obj
    assert not blender.addon("animation_curves").curves(obj)
    assert obj.data.shape_keys is None


def test_a_control_keeps_to_the_slider_of_a_new_search(obj):
    control()
    blender.deform(PROMPT, seed=7)
    limits, key = obj.id_properties_ui(PROMPT).as_dict(), key_of(obj)
    assert (limits["min"], limits["max"]) == pytest.approx((key.slider_min, key.slider_max))
    obj[PROMPT] = 0.3
    assert shown(obj) == pytest.approx(0.3, abs=1e-4)


def test_properties_and_drivers_of_the_artist_stay(obj):
    obj[PROMPT] = "mine"
    control()
    assert obj[PROMPT] == "mine" and obj[f"{PROMPT}.001"] == 1.0
    bpy.ops.boxmorph.remove_outcome()
    assert dict(obj.items()).get(PROMPT) == "mine" and f"{PROMPT}.001" not in obj

    blender.deform(PROMPT)
    drive(key_of(obj), obj, '["own"]')
    obj["own"] = 0.5
    bpy.ops.boxmorph.remove_outcome()
    assert obj["own"] == 0.5


def test_no_control_where_something_else_sets_the_value(obj):
    control()
    with pytest.raises(RuntimeError, match="is driven already"):
        bpy.ops.boxmorph.add_control()
    bpy.ops.boxmorph.remove_outcome()
    blender.deform(PROMPT)
    bpy.ops.boxmorph.keyframe_spectrum()
    with pytest.raises(RuntimeError, match="has keyframes, which a driver would hide"):
        bpy.ops.boxmorph.add_control()
    assert PROMPT not in obj and not obj.data.shape_keys.animation_data.drivers


@pytest.mark.parametrize("asked", [{}, {"shift_parts": True, "keep_size": "height", "symmetry": "none"}])
def test_again_takes_another_seed_and_all_else_as_it_was(obj, asked):
    scene = bpy.context.scene.boxmorph
    blender.deform(PROMPT, seed=4, **asked)
    before = blender.positions(key_of(obj))
    scene.prompt, scene.splits, scene.least_scale = "a sofa", "5", 0.9
    scene.shift_parts, scene.seed = not asked, 99
    assert bpy.ops.boxmorph.search_again() == {"FINISHED"}
    again = blender.positions(key_of(obj))
    assert list(records(obj)) == [PROMPT]
    assert records(obj)[PROMPT]["seed"] == 5 and not np.array_equal(again, before)
    blender.deform(PROMPT, seed=5, **({"shift_parts": False} | asked), least_scale=0.3)
    assert np.array_equal(blender.positions(key_of(obj)), again)


def test_settings_of_a_record_without_what_was_asked(obj):
    settings_of = blender.addon("again").settings_of
    report = records(obj)[PROMPT]
    asked = report.pop("asked")
    assert asked["splits"] == "2" and asked["symmetry"] == "auto"
    settings = settings_of(report)
    assert settings.keys() == asked.keys() == settings_of(report | {"asked": asked}).keys()
    same = ("prompt", "preset", "seed", "splits", "shift_parts", "keep_size")
    assert {name: settings[name] for name in same} == {name: asked[name] for name in same}
    assert settings["least_scale"] == pytest.approx(0.3)
    assert blender.addon("again").next_seed(2**31 - 1) == 0


def test_again_refuses_as_a_search_does(obj):
    stored = json.loads(obj.data.shape_keys["boxmorph"])
    stored[PROMPT]["asked"]["prompt"] = "zzgribble xqwvk"
    obj.data.shape_keys["boxmorph"] = json.dumps(stored)
    with pytest.raises(RuntimeError) as failure:
        bpy.ops.boxmorph.search_again()
    assert str(failure.value).count("Error") == 1 and "knows no word" in str(failure.value)
