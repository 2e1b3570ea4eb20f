# SPDX-License-Identifier: MIT OR Apache-2.0
"""Deforming objects in Blender: what comes out, and what stays as it was."""

import json

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def record(obj):
    return json.loads(obj.data.shape_keys["boxmorph"])


def test_outcome_is_a_shape_key():
    """That all else stays is seen in test_addon_invariance.py, that it survives in test_addon_assets.py."""
    obj = blender.chair()
    blender.deform(PROMPT, seed=3)
    basis, key = obj.data.shape_keys.key_blocks
    assert (basis.name, key.name, key.value) == ("Basis", PROMPT, 1.0)
    assert np.array_equal(blender.positions(basis), [tuple(v.co) for v in obj.data.vertices])
    moved = np.abs(blender.positions(key) - blender.positions(basis)).max()
    assert moved > 0.01
    assert -1.0 <= key.slider_min < 0.0 and 1.0 <= key.slider_max <= 2.0
    report = record(obj)[PROMPT]
    assert report["score_after"] > report["score_before"]
    assert report["seed"] == 3


def test_spectrum_is_linear_and_keeps_its_place():
    obj = blender.chair()
    rest = blender.evaluated_positions(obj)
    blender.deform(PROMPT)
    key = obj.data.shape_keys.key_blocks[PROMPT]
    full = blender.positions(key)
    for alpha in (key.slider_min, 0.0, 0.37, 1.0, key.slider_max):
        key.value = alpha
        assert np.allclose(blender.evaluated_positions(obj), rest + alpha * (full - rest), atol=1e-5)
    # The gauge: the chair stays on its floor and in its place, and keeps its size.
    for shape in (rest, full):
        centre = (shape.min(0) + shape.max(0)) / 2
        assert np.allclose([centre[0], centre[1], shape[:, 2].min()], [0, 0, 0], atol=2e-3)
    assert np.isclose(np.linalg.norm(np.ptp(full, axis=0)), np.linalg.norm(np.ptp(rest, axis=0)), rtol=1e-3)


def test_same_seed_gives_the_same_key_and_replaces_it():
    obj = blender.chair()
    blender.deform(PROMPT, seed=1)
    first = blender.positions(obj.data.shape_keys.key_blocks[PROMPT])
    blender.deform(PROMPT, seed=1)
    assert [key.name for key in obj.data.shape_keys.key_blocks] == ["Basis", PROMPT]
    assert np.array_equal(blender.positions(obj.data.shape_keys.key_blocks[PROMPT]), first)


def test_another_prompt_gets_a_key_of_its_own():
    obj = blender.chair()
    blender.deform(PROMPT)
    first = blender.positions(obj.data.shape_keys.key_blocks[PROMPT])
    blender.deform("a sofa")
    keys = obj.data.shape_keys.key_blocks
    assert [(key.name, key.value) for key in keys[1:]] == [(PROMPT, 0.0), ("a sofa", 1.0)]
    assert np.array_equal(blender.positions(keys[PROMPT]), first)
    assert list(record(obj)) == [PROMPT, "a sofa"]

    bpy.ops.boxmorph.remove_outcome(key=PROMPT)
    assert [key.name for key in keys[1:]] == ["a sofa"]
    assert list(record(obj)) == ["a sofa"]


def test_keys_of_the_artist_stay_and_do_not_change_the_result():
    obj = blender.chair()
    blender.deform(PROMPT)
    expected = blender.positions(obj.data.shape_keys.key_blocks[PROMPT])

    blender.empty_scene()
    obj = blender.chair()
    obj.shape_key_add(name="Basis")
    own = obj.shape_key_add(name=PROMPT)
    for point in own.points:
        point.co.x *= 3.0
    own.value = 0.8
    kept = blender.positions(own)
    blender.deform(PROMPT)
    keys = obj.data.shape_keys.key_blocks
    assert [key.name for key in keys] == ["Basis", PROMPT, PROMPT + ".001"]
    assert np.array_equal(blender.positions(keys[PROMPT]), kept)
    assert keys[PROMPT].value == pytest.approx(0.8)
    assert np.array_equal(blender.positions(keys[PROMPT + ".001"]), expected)


def test_modifiers_are_seen_and_never_applied():
    obj = blender.chair(half=True)
    before = blender.fingerprint(obj)
    whole = blender.evaluated_positions(obj)
    blender.deform(PROMPT)
    assert blender.fingerprint(obj) == before
    key = obj.data.shape_keys.key_blocks[PROMPT]
    assert len(key.points) == len(obj.data.vertices) < len(whole)
    deformed = blender.evaluated_positions(obj)
    assert np.abs(deformed - whole).max() > 0.01
    # The mirror holds: no gap opens at its plane, since what lay on x = 0 still does.
    on_plane = np.abs([v.co.x for v in obj.data.vertices]) < 1e-6
    assert np.abs(blender.positions(key)[on_plane, 0]).max() < 1e-3


def test_objects_are_searched_as_their_scale_shows_them():
    obj = blender.chair()
    for vertex in obj.data.vertices:
        vertex.co.z /= 4.0
    obj.scale.z = 4.0
    bpy.context.view_layer.update()
    blender.deform(PROMPT)
    scaled = blender.positions(obj.data.shape_keys.key_blocks[PROMPT]) * (1.0, 1.0, 4.0)

    blender.empty_scene()
    obj = blender.chair()
    blender.deform(PROMPT)
    assert np.allclose(scaled, blender.positions(obj.data.shape_keys.key_blocks[PROMPT]), atol=1e-3)


def test_posed_objects_are_deformed_at_rest():
    obj = blender.chair()
    blender.deform(PROMPT)
    expected = blender.positions(obj.data.shape_keys.key_blocks[PROMPT])

    blender.empty_scene()
    obj = blender.chair()
    bend = obj.modifiers.new("Bend", "SIMPLE_DEFORM")
    bend.deform_method, bend.angle = "BEND", 1.0
    blender.deform(PROMPT)
    assert bend.show_viewport
    assert np.array_equal(blender.positions(obj.data.shape_keys.key_blocks[PROMPT]), expected)


def test_users_of_one_mesh_share_the_key():
    obj = blender.chair()
    twin = bpy.data.objects.new("Twin", obj.data)
    bpy.context.scene.collection.objects.link(twin)
    blender.deform(PROMPT)
    assert twin.data.shape_keys.key_blocks[PROMPT].value == 1.0
    assert obj.data is twin.data or obj.data == twin.data


def test_long_prompts_name_keys_within_blenders_limit():
    name = blender.addon("shape_key").key_name("ein hoher Küchenstuhl mit ä" + "ö" * 60)
    assert len(name.encode()) <= 60 and name.startswith("ein hoher Küchenstuhl")


def test_views_are_an_image_on_request():
    blender.chair()
    assert not bpy.data.images
    assert bpy.ops.boxmorph.show_views() == {"FINISHED"}
    image = bpy.data.images["Boxmorph Views"]
    assert not image.is_dirty, "Blender would ask to save it with each saving of the file"
    pixels = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(pixels)
    height, width = image.size[1], image.size[0]
    grey = pixels.reshape(height, width, 4)[..., :3]
    # Each of the four views shows the object on white.
    for part in (grey[: height // 2, : width // 2], grey[height // 2 :, width // 2 :]):
        assert part.min() < 0.8 and part.max() == 1.0
    assert bpy.ops.boxmorph.show_views() == {"FINISHED"}
    assert len(bpy.data.images) == 1
