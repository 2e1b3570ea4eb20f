# SPDX-License-Identifier: MIT OR Apache-2.0
"""Several objects with one call, prompts that are remembered, and the pictures of a running search."""

import json
import types

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def two_chairs():
    first, second = blender.chair(), blender.chair()
    blender.activate(first)
    second.select_set(True)
    return first, second


def test_only_the_active_object_is_deformed_unless_all_are_asked_for():
    first, second = two_chairs()
    blender.deform("a bar stool", splits="1")
    assert first.data.shape_keys is not None and second.data.shape_keys is None


def test_all_selected_objects_are_deformed():
    first, second = two_chairs()
    blender.deform("a bar stool", splits="1", all_selected=True)
    for obj in (first, second):
        assert obj.data.shape_keys.key_blocks["a bar stool"].value == 1.0
    keys = [blender.positions(obj.data.shape_keys.key_blocks["a bar stool"]) for obj in (first, second)]
    assert np.array_equal(*keys), "two like objects become alike"


def test_a_mesh_that_two_selected_objects_share_is_deformed_once():
    first, second = two_chairs()
    second.data = first.data
    blender.deform("a bar stool", splits="1", all_selected=True)
    assert [key.name for key in first.data.shape_keys.key_blocks] == ["Basis", "a bar stool"]


def test_one_that_cannot_be_deformed_does_not_keep_the_others_from_it():
    first, second = two_chairs()
    second.data.clear_geometry()
    blender.deform("a bar stool", splits="1", all_selected=True)
    assert first.data.shape_keys is not None and second.data.shape_keys is None


def test_prompts_are_remembered_newest_first_and_over_sessions():
    history = blender.addon("history")
    for prompt in ("a sofa", "a  bar stool ", "a sofa", *(f"chair {n}" for n in range(20)), "a sofa"):
        history.remember(prompt)
    assert history.recent()[:2] == ("a sofa", "chair 19")
    assert len(history.recent()) == len(set(history.recent())) == 12
    kept = history.recent()
    history._prompts.cache_clear()
    assert history.recent() == kept
    bpy.ops.boxmorph.use_prompt(prompt="chair 19")
    assert bpy.context.scene.boxmorph.prompt == "chair 19"


@pytest.mark.parametrize("text", ["", "{", "3", json.dumps({"a": 1}), json.dumps(["a chair", 7, None])])
def test_a_damaged_list_of_prompts_is_borne(text):
    history = blender.addon("history")
    with open(history._path(create=True), "w", encoding="utf-8") as file:
        file.write(text)
    history._prompts.cache_clear()
    assert set(history.recent()) <= {"a chair"}
    history.remember("a sofa")
    assert history.recent()[0] == "a sofa"


def test_the_course_of_the_score_is_drawn_as_far_as_it_is_known():
    pictures = blender.addon("progress_pictures")
    half = pictures.drawn_course([(0.0, 0.1), (0.2, 0.3), (0.4, 0.6)], 0.5)
    blank = half[0, -1]
    drawn = (half != blank).any(-1)
    height = drawn.sum(0)
    middle = pictures.SIZE // 2
    assert height[middle:].max() == 0, "nothing is drawn of what is not done yet"
    assert (np.diff(height[:middle].astype(int)) >= -3).all() and height[middle - 1] > 3 * height[2]


def test_pictures_of_a_search_leave_nothing_behind():
    search_module, progress_module = blender.addon("search"), blender.addon("progress")
    search = search_module.Search(bpy.context, blender.chair(), "a bar stool", splits="1")
    progress = progress_module.Progress()
    search.run(lambda _: progress.follow(search))
    progress.follow(search)
    assert len(progress.pictures.icons()) == 2
    scores = [score for _, score in progress.course]
    assert scores == sorted(scores) and scores[0] < scores[-1]
    progress.close()
    assert not progress.pictures.icons() and not bpy.data.images


def test_a_preview_that_was_hidden_is_shown_again():
    obj = blender.chair()
    blender.deform("a bar stool", splits="1")
    obj.data.shape_keys.key_blocks["a bar stool"].value = 0.5
    before = blender.key_state(obj)
    search = blender.addon("search").Search(bpy.context, obj, "a bar stool", splits="1", seed=1)
    search.run(lambda _: search.preview(obj))
    search.preview(obj)
    shown = blender.key_state(obj)
    assert shown != before
    search.hide(obj)
    assert blender.key_state(obj) == before
    search.preview(obj)
    assert blender.key_state(obj) == shown
    search.take_back(obj)
    assert blender.key_state(obj) == before


def test_an_object_deleted_during_its_search_does_not_keep_the_others_from_theirs():
    running, operators = blender.addon("running"), blender.addon("search_operators")
    obj = blender.chair()
    search = blender.addon("search").Search(bpy.context, obj, "a bar stool", "paper")
    bpy.data.objects.remove(obj)
    started, said = [], []
    operator = types.SimpleNamespace(
        report=lambda kind, text: said.append((kind, text)),
        _start_next=lambda context: not started.append(context),
    )
    try:
        running.start(search)
        done = operators.BOXMORPH_OT_deform._tick(operator, search, bpy.context)
    finally:
        search.cancel(wait=True)
        running.end()
    assert done == {"PASS_THROUGH"} and len(started) == 1
    assert "was deleted" in said[0][1]
    assert search.poll(), "the search of the deleted object has ended"
