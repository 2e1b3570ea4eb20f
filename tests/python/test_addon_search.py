# SPDX-License-Identifier: MIT OR Apache-2.0
"""A search that is watched, cancelled or interrupted: the object afterwards is the object before."""

import json
import time

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def started(obj, preset="paper"):
    """Start a search, by default a long one, and wait for its first preview."""
    search = blender.addon("search").Search(bpy.context, obj, "a bar stool", preset, splits="2")
    until = time.monotonic() + 120
    while search._shown_score is None:
        search.poll()
        search.preview(obj)
        assert time.monotonic() < until, "no preview within two minutes"
        time.sleep(0.01)
    return search


def test_cancel_takes_back_the_preview():
    obj = blender.chair()
    before = blender.fingerprint(obj), blender.key_state(obj)
    search = started(obj)
    assert obj.data.shape_keys.key_blocks["a bar stool"].value == 1.0
    search.cancel(wait=True)
    assert search.take_back(search.find_object())
    assert not search.take_back(search.find_object())
    assert obj.data.shape_keys is None
    assert (blender.fingerprint(obj), blender.key_state(obj)) == before
    assert not bpy.data.shape_keys


def test_cancel_restores_the_keys_that_were_there():
    obj = blender.chair()
    blender.deform("a sofa")
    blender.deform("a bar stool")
    keys = obj.data.shape_keys
    keys.key_blocks["a sofa"].value = 0.25
    keys.key_blocks["a bar stool"].value = -0.5
    keys.key_blocks["a bar stool"].mute = True
    obj.active_shape_key_index = 1
    obj.show_only_shape_key = True
    before = blender.key_state(obj)
    search = started(obj)
    assert keys.key_blocks["a sofa"].value == 0.0
    search.cancel(wait=True)
    search.take_back(obj)
    assert blender.key_state(obj) == before


def test_cancelled_search_has_no_result():
    obj = blender.chair()
    search = started(obj)
    search.cancel(wait=True)
    assert search.poll()
    with pytest.raises(blender.addon("errors").Refusal):
        search.keep(obj, bpy.context)
    search.take_back(obj)
    assert obj.data.shape_keys is None


def test_deleted_or_edited_objects_are_noticed():
    obj = blender.chair()
    search = started(obj)
    obj.name = "Renamed"
    assert search.find_object() == obj
    obj.data.vertices.add(1)
    assert search.find_object() is None
    bpy.data.objects.remove(obj)
    assert search.find_object() is None
    search.cancel(wait=True)


def test_key_deleted_by_hand_during_the_search():
    obj = blender.chair()
    search = started(obj, preset="standard")
    obj.shape_key_clear()
    search.run()
    search.keep(obj, bpy.context)
    assert [key.name for key in obj.data.shape_keys.key_blocks] == ["Basis", "a bar stool"]


def test_parts_are_shifted_where_that_is_asked_for():
    obj = blender.chair()
    blender.deform("a bar stool", shift_parts=True)
    record = json.loads(obj.data.shape_keys["boxmorph"])["a bar stool"]
    assert np.abs(record["shifts"]).max() > 0
    blender.deform("a sofa")
    assert json.loads(obj.data.shape_keys["boxmorph"])["a sofa"]["shifts"] is None


def test_a_search_takes_the_seconds_that_it_is_given():
    obj = blender.chair()
    assert bpy.ops.boxmorph.deform(prompt="a bar stool", preset="time", seconds=2.0) == {"FINISHED"}
    record = blender.addon("shape_key").records(obj.data)["a bar stool"]
    assert record["seconds_budget"] == 2.0 and record["image_budget"] > 0
    asked = blender.addon("again").settings_of(record)
    assert (asked["preset"], asked["seconds"]) == ("time", 2.0)


def test_the_guide_is_opened_once_for_all_searches():
    engine = blender.addon("engine")
    engine.close_guide()
    opened = []
    for prompt in ("a bar stool", "a sofa"):
        blender.chair()
        blender.deform(prompt, preset="draft")
        opened.append(engine.known_guide()[0])
    assert opened[0] is not None and opened[0] is opened[1]
