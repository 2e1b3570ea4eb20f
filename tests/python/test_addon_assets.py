# SPDX-License-Identifier: MIT OR Apache-2.0
"""An outcome from file to file: saved, copied, appended, linked, overridden, kept as an asset."""

import json

import addon_blender as blender
import addon_finished as finished
import pytest
from addon_blender import bpy


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """A file with the finished chair, the names of its outcomes, and its state."""
    obj, names = finished.build()
    path = str(tmp_path_factory.mktemp("kept") / "chair.blend")
    expected = finished.state(obj)
    obj.asset_mark()
    bpy.ops.wm.save_as_mainfile(filepath=path)
    return path, names, expected


@pytest.fixture
def chair(kept):
    """The finished chair, loaded and active."""
    bpy.ops.wm.open_mainfile(filepath=kept[0])
    return blender.activate(bpy.data.objects["Chair"])


def loaded(path, link=False):
    """Append or link the chair of a file into an empty one, and activate it."""
    blender.empty_scene()
    with bpy.data.libraries.load(path, link=link) as (_, wanted):
        wanted.objects = ["Chair"]
    bpy.context.scene.collection.objects.link(wanted.objects[0])
    return blender.activate(wanted.objects[0])


def usable(obj, names):
    """Whether the operators on outcomes know the outcomes of an object, and do what they do."""
    blender.activate(obj)
    stool, sofa, table = names
    assert list(blender.addon("shape_key").records(obj.data)) == [sofa, table, stool]
    assert bpy.ops.boxmorph.put_together(key=table) == {"FINISHED"}
    assert bpy.ops.boxmorph.take_apart(key=table) == {"FINISHED"}
    assert bpy.ops.boxmorph.keyframe_spectrum(key=stool, frame_from=3, frame_to=9) == {"FINISHED"}
    for name in names:
        assert bpy.ops.boxmorph.remove_outcome(key=name) == {"FINISHED"}
    assert obj.data.shape_keys is None


def test_the_chair_has_all_that_is_to_be_kept(kept):
    _path, (stool, *_), expected = kept
    assert len(finished.STOOL.encode()) > 60 >= len(stool.encode()) > 50 and '"' in stool and "椅" in stool
    assert len(expected["curves"]) == 2 and len(expected["drivers"]) == 1
    assert sorted(json.loads(expected["record"]["boxmorph"])) == sorted((stool, "a sofa", "a low table"))
    of_stool = [row[[key[0] for key in expected["keys"]].index(stool) - 1] for row in expected["values"]]
    assert of_stool[1] == pytest.approx(-0.25) and of_stool[11] == pytest.approx(1.05)


@pytest.mark.parametrize("compress", [False, True])
def test_saved_and_opened(chair, kept, tmp_path, compress):
    path = str(tmp_path / "again.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, compress=compress)
    bpy.ops.wm.open_mainfile(filepath=path)
    obj = bpy.data.objects["Chair"]
    assert finished.state(obj) == kept[2]
    usable(obj, kept[1])


def test_appended(kept):
    obj = loaded(kept[0])
    assert obj.library is None and obj.data.shape_keys.library is None
    assert finished.state(obj) == kept[2]
    usable(obj, kept[1])


def test_appended_by_the_operator_as_an_asset_is(kept):
    blender.empty_scene()
    bpy.ops.wm.append(directory=f"{kept[0]}/Object/", filename="Chair", clear_asset_data=True)
    obj = bpy.data.objects["Chair"]
    assert obj.asset_data is None
    assert finished.state(obj) == kept[2]


def test_asset_mark_is_kept_with_the_outcomes(chair, kept):
    assert chair.asset_data is not None
    assert finished.state(chair) == kept[2]


def test_copied_and_pasted(chair, kept):
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        assert bpy.ops.view3d.copybuffer() == {"FINISHED"}
    blender.empty_scene()
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        assert bpy.ops.view3d.pastebuffer() == {"FINISHED"}
    obj = bpy.data.objects["Chair"]
    assert finished.state(obj) == kept[2]
    usable(obj, kept[1])


def test_duplicated(chair, kept):
    assert bpy.ops.object.duplicate(linked=False) == {"FINISHED"}
    copy = bpy.context.active_object
    assert copy != chair and copy.data != chair.data and copy.data.shape_keys != chair.data.shape_keys
    expected, state = kept[2], finished.state(copy)
    # The copy is driven by its own property.
    assert [targets for *_, targets in state.pop("drivers")] == [[("Chair.001", '["sofa"]')]]
    assert state == {field: value for field, value in expected.items() if field != "drivers"}
    usable(copy, kept[1])
    assert finished.state(chair) == expected


def test_duplicated_with_the_same_mesh(chair, kept):
    assert bpy.ops.object.duplicate(linked=True) == {"FINISHED"}
    copy = bpy.context.active_object
    assert copy != chair and copy.data == chair.data
    assert finished.state(chair) == kept[2]
    usable(copy, kept[1])


OPERATORS = {
    "keyframe_spectrum": {},
    "keyframe_mix": {},
    "mix_outcomes": {},
    "measure_scores": {},
    "evaluate": {},
    "search_again": {},
    "add_control": {"key": "a low table"},
    "remove_outcome": {},
    "take_apart": {},
    "put_together": {},
    "apply_as_new": {},
    "deform": {"prompt": "a bar stool"},
    "find_parts": {},
    "forget_parts": {},
    "lock_part": {"index": 0},
    "refine": {},
}


def refuse_all(obj):
    """All operators refuse an object of another file in a sentence, and change nothing."""
    blender.activate(obj)
    before = finished.state(obj), len(bpy.data.objects), len(bpy.data.meshes), obj.boxmorph.geometry
    for name, options in OPERATORS.items():
        with pytest.raises(RuntimeError, match="is linked from another file"):
            getattr(bpy.ops.boxmorph, name)(**options)
        after = finished.state(obj), len(bpy.data.objects), len(bpy.data.meshes), obj.boxmorph.geometry
        assert after == before, name


def test_linked(kept):
    obj = loaded(kept[0], link=True)
    assert obj.library is not None
    assert finished.state(obj) == kept[2]
    refuse_all(obj)


def test_library_override(kept, tmp_path):
    obj = loaded(kept[0], link=True)
    override = obj.override_create(remap_local_usages=True)
    assert finished.state(override) == kept[2]
    refuse_all(override)
    # Where the mesh is overridden too, values of its keys are kept; keys and records cannot be added.
    assert override.data.override_create(remap_local_usages=True) is not None
    assert finished.state(override) == kept[2]
    refuse_all(override)
    blender.addon("shape_key").pieces(override.data, "a low table")[-1].value = 0.875
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "shot.blend"))
    override = next(obj for obj in bpy.data.objects if obj.override_library)
    assert blender.addon("shape_key").pieces(override.data, "a low table")[-1].value == 0.875
    assert finished.curves(override.data.shape_keys) == kept[2]["curves"]


@pytest.mark.parametrize("override", [False, True])
def test_made_local(kept, override):
    obj = loaded(kept[0], link=True)
    if override:
        obj = blender.activate(obj.override_create(remap_local_usages=True))
    bpy.ops.object.make_local(type="ALL")
    obj = bpy.context.active_object
    assert obj.library is None and obj.override_library is None and obj.data.library is None
    state = finished.state(obj)
    if override:
        # What was overridden becomes another local object, and the driver keeps to it.
        assert state["drivers"] == [(*kept[2]["drivers"][0][:2], [("Chair.001", '["sofa"]')])]
        state["drivers"] = kept[2]["drivers"]
    assert state == kept[2]
    usable(obj, kept[1])


def test_linked_keyframes_of_a_local_object_are_left_alone(kept):
    obj = loaded(kept[0], link=True)
    bpy.ops.object.make_local(type="SELECT_OBDATA")
    obj = bpy.context.active_object
    assert obj.data.shape_keys.library is None and obj.data.shape_keys.animation_data.action.library
    before = finished.state(obj)
    with pytest.raises(RuntimeError, match=r"keyframes of .* are linked from another file"):
        bpy.ops.boxmorph.keyframe_spectrum(key=kept[1][0])
    assert finished.state(obj) == before
    bpy.ops.object.make_local(type="ALL")
    usable(obj, kept[1])
