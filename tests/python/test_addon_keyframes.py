# SPDX-License-Identifier: MIT OR Apache-2.0
"""Keyframe Spectrum, in the animation systems of all supported Blenders."""

import addon_blender as blender
import pytest
from addon_blender import bpy


@pytest.fixture
def key():
    """A shape key as an outcome would be, with limits −1 to 2."""
    blender.empty_scene()
    obj = blender.add("Square", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
    trial = blender.addon("shape_key").Trial(obj, 'it\'s a "stool"')
    name = trial.keep(obj, [(0, 0, 0), (1, 0, 1), (1, 1, 1), (0, 1, 0)], -1.0, 2.0, {"prompt": "a stool"})
    return obj.data.shape_keys.key_blocks[name]


def values(key, *frames):
    out = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        out.append(round(key.value, 4))
    return out


def test_values_run_linearly(key):
    assert bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=61, alpha_from=-1.0, alpha_to=2.0) == {
        "FINISHED"
    }
    assert values(key, 1, 16, 31, 46, 61) == [-1.0, -0.25, 0.5, 1.25, 2.0]


def test_backwards_too(key):
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=20, frame_to=10, alpha_from=0.0, alpha_to=1.0)
    assert values(key, 10, 15, 20) == [1.0, 0.5, 0.0]


def test_keyframes_between_are_replaced_and_others_stay(key):
    for frame, value in ((5, 0.9), (15, 0.1), (40, 0.7)):
        key.value = value
        key.keyframe_insert("value", frame=frame)
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=10, frame_to=30, alpha_from=0.0, alpha_to=1.0)
    assert values(key, 5, 10, 20, 30, 40) == [0.9, 0.0, 0.5, 1.0, 0.7]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"frame_from": 7, "frame_to": 7}, "two different frames"),
        ({"alpha_to": 3.0}, "outside"),
        ({"key": "Basis"}, "no outcome named"),
    ],
)
def test_refusals(key, options, words):
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.boxmorph.keyframe_spectrum(**options)
    assert key.id_data.animation_data is None
    assert key.value == 1.0


def test_removing_an_outcome_removes_its_animation(key):
    keys = key.id_data
    bpy.ops.boxmorph.keyframe_spectrum()
    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert [block.name for block in keys.key_blocks] == ["Basis"]
    assert blender.addon("keyframes")._curve(keys, 'key_blocks["it\'s a \\"stool\\""].value') is None
    assert "boxmorph" not in keys
