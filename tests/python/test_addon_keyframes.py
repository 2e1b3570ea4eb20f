# SPDX-License-Identifier: MIT OR Apache-2.0
"""Keyframe Spectrum, in the animation systems of all supported Blenders."""

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy


@pytest.fixture
def key():
    """A shape key as an outcome would be, with limits −1 to 2."""
    blender.empty_scene()
    obj = blender.add("Square", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
    trial = blender.addon("trial").Trial(obj, 'it\'s a "stool"')
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


def test_eased_values_start_and_end_slowly(key):
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=61, timing="eased")
    seen = values(key, *range(1, 62, 6))
    assert seen[0] == 0.0 and seen[5] == 0.5 and seen[-1] == 1.0
    steps = np.diff(seen)
    assert (np.diff(steps[:5]) > 0).all() and (np.diff(steps[5:]) < 0).all()
    assert steps[0] < 0.03


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


def driven(key):
    """A driver that gives the key the object's custom property."""
    obj = bpy.context.active_object
    obj["stool"] = 0.25
    driver = key.driver_add("value").driver
    driver.type = "SUM"
    variable = driver.variables.new()
    variable.targets[0].id = obj
    variable.targets[0].data_path = '["stool"]'
    return obj


def test_a_driver_can_drive_an_outcome(key):
    obj = driven(key)
    for value in (0.25, 1.5, -1.0):
        obj["stool"] = value
        obj.update_tag()
        heights = blender.evaluated_positions(obj)[:, 2]
        np.testing.assert_allclose(heights, [0, value, value, 0], atol=1e-6)


@pytest.mark.parametrize("timing", ["linear", "eased", "semantic"])
def test_a_driven_value_is_not_keyframed(key, timing):
    obj = driven(key)
    with pytest.raises(RuntimeError, match='“it\'s a "stool"” is driven, and a driven value cannot be'):
        bpy.ops.boxmorph.keyframe_spectrum(timing=timing)
    assert key.id_data.animation_data.action is None
    assert blender.evaluated_positions(obj)[:, 2].max() == pytest.approx(0.25)


@pytest.mark.parametrize("locked", ["curve", "group"])
def test_locked_keyframes_are_left_alone(key, locked):
    key.keyframe_insert("value", frame=1, group="Shapes")
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=11)
    curve = blender.addon("animation_curves").curve(key.id_data, key.path_from_id("value"))
    (curve.group if locked == "group" else curve).lock = True
    with pytest.raises(RuntimeError, match="is locked"):
        bpy.ops.boxmorph.keyframe_spectrum(frame_from=3, frame_to=7, alpha_from=2.0, alpha_to=-1.0)
    assert values(key, 1, 6, 11) == [0.0, 0.5, 1.0]


def test_removing_an_outcome_removes_its_animation_and_no_other(key):
    keys = key.id_data
    own = bpy.context.active_object.shape_key_add(name="Own")
    own.keyframe_insert("value", frame=1)
    bpy.ops.boxmorph.keyframe_spectrum()
    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert [block.name for block in keys.key_blocks] == ["Basis", "Own"]
    assert [curve.data_path for curve in blender.addon("animation_curves").curves(keys)] == [
        'key_blocks["Own"].value'
    ]
    assert "boxmorph" not in keys


def test_with_the_last_outcome_goes_what_was_made_for_it(key):
    bpy.ops.boxmorph.keyframe_spectrum()
    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert bpy.context.active_object.data.shape_keys is None
    assert not bpy.data.shape_keys and not bpy.data.actions


def test_an_action_that_others_use_stays(key):
    bpy.ops.boxmorph.keyframe_spectrum()
    bpy.data.actions[0].use_fake_user = True
    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert len(bpy.data.actions) == 1


def test_even_alphas_invert_the_curve():
    even_alphas = blender.addon("semantic_timing").even_alphas
    alphas, shares = np.linspace(0, 1, 33), np.linspace(0, 1, 11)
    found = even_alphas(alphas, alphas**2, shares)
    assert found[0] == 0.0 and found[-1] == 1.0
    np.testing.assert_allclose(found**2, shares, atol=1e-3)
    # Also where the score is below 0 and the values are not from 0 to 1.
    found = even_alphas(2 * alphas - 1, np.tanh(6 * alphas - 3) - 5, shares)
    reached = np.tanh(3 * found)
    np.testing.assert_allclose(np.diff(reached), np.diff(reached).mean(), atol=0.01)


@pytest.mark.parametrize(
    "scores",
    [
        [0.1, 0.2, 0.2, 0.2, 0.3],  # a flat stretch, at a level that a key asks for
        [0.1, 0.3, 0.15, 0.2, 0.4],  # a dent
        [0.2, 0.1, 0.0, 0.3, 0.4],  # falls first
        [0.1, 0.4, 0.9, 0.8, 0.5],  # is above its end before it
        [0.1, 0.1, 0.1, 0.1, 0.9],
        [0.1, 0.9, 0.9, 0.9, 0.9],
    ],
)
def test_even_alphas_increase_and_lie_on_the_curve(scores):
    alphas = np.linspace(-1, 2, 5)
    shares = np.linspace(0, 1, 11)
    found = blender.addon("semantic_timing").even_alphas(alphas, scores, shares)
    assert found[0] == -1.0 and found[-1] == 2.0
    assert (np.diff(found) > 1e-3).all()
    levels = scores[0] + (scores[-1] - scores[0]) * shares
    np.testing.assert_allclose(np.interp(found, alphas, scores), levels, atol=1e-9)


@pytest.mark.parametrize("scores", [[0.3, 0.9, 0.3], [0.5, 0.4, 0.2], [0.3, 0.3, 0.3004]])
def test_a_score_that_does_not_rise_places_no_keys(scores):
    refusal = blender.addon("errors").Refusal
    with pytest.raises(refusal, match=r"does not rise from value 0 \(0\.[35]00\) to 1"):
        blender.addon("semantic_timing").even_alphas([0, 0.5, 1], scores, [0, 0.5, 1])


@pytest.fixture
def stool():
    """The outcome of a search on the chair."""
    blender.empty_scene()
    obj = blender.chair()
    blender.deform()
    return obj.data.shape_keys.key_blocks["a bar stool"]


def record(key):
    return blender.addon("shape_key").records(bpy.context.active_object.data)[key.name]


def scores_at(key, alphas):
    """The scores of an outcome at these values, measured anew."""
    curves, (low, high) = blender.addon("score_curve"), (min(alphas), max(alphas))
    obj = bpy.context.active_object
    curve = curves.measure(obj, bpy.context, key, low, high)
    return np.interp(alphas, curve["alphas"], curve["scores"])


@pytest.mark.parametrize("frames", [(1, 61), (61, 1), (10, 14)])
@pytest.mark.parametrize("ends", [(0.0, 1.0), (1.0, 0.0)])
def test_the_score_rises_evenly_in_semantic_timing(stool, frames, ends):
    bpy.ops.boxmorph.keyframe_spectrum(
        frame_from=frames[0], frame_to=frames[1], alpha_from=ends[0], alpha_to=ends[1], timing="semantic"
    )
    assert values(stool, *frames) == list(ends)
    seen = np.array(values(stool, *np.linspace(*frames, min(11, abs(frames[1] - frames[0]) + 1)).astype(int)))
    assert (np.diff(seen) * (ends[1] - ends[0]) > 0).all()
    scores = scores_at(stool, seen)
    steps = np.diff(scores) / (scores[-1] - scores[0])
    np.testing.assert_allclose(steps, 1 / len(steps), atol=0.01)
    linear = scores_at(stool, np.linspace(*ends, len(seen)))
    assert np.diff(linear).std() > 2 * np.diff(scores).std()


def test_the_curve_is_kept_with_the_outcome_and_drawn(stool, tmp_path):
    curves = blender.addon("score_curve")
    assert curves.text(record(stool)) is None
    bpy.ops.boxmorph.keyframe_spectrum(timing="semantic")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "stool.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "stool.blend"))
    report = record(bpy.context.active_object.data.shape_keys.key_blocks["a bar stool"])
    assert report["score_curve"]["alphas"][0] == 0.0 and report["score_curve"]["alphas"][-1] == 1.0
    drawn = curves.text(report).split()
    assert drawn[0] == f"{report['score_before']:.2f}" and drawn[2] == f"{report['score_after']:.2f}"
    assert drawn[1][0] == "▁" and drawn[1][-1] == "█" and len(drawn[1]) == 11


def test_scores_are_measured_on_request(stool):
    assert bpy.ops.boxmorph.measure_scores(alpha_from=1.0, alpha_to=-0.5) == {"FINISHED"}
    report = record(stool)
    alphas, scores = report["score_curve"]["alphas"], report["score_curve"]["scores"]
    assert (alphas[0], alphas[-1]) == (-0.5, 1.0)
    assert np.interp(0.0, alphas, scores) == pytest.approx(report["score_before"], abs=2e-3)
    assert scores[-1] == pytest.approx(report["score_after"], abs=1e-5)
    assert stool.id_data.animation_data is None


@pytest.mark.parametrize("half", [False, True])
def test_scores_are_those_of_the_search_whatever_the_place_and_the_modifiers(half):
    blender.empty_scene()
    obj = blender.chair(half)
    obj.scale, obj.rotation_euler[2] = (1.3, 1.0, 0.8), 0.4
    bpy.context.view_layer.update()
    blender.deform()
    key = obj.data.shape_keys.key_blocks["a bar stool"]
    key.value = 0.3
    report = record(key)
    np.testing.assert_allclose(
        scores_at(key, [0.0, 1.0]), [report["score_before"], report["score_after"]], atol=2e-3
    )


def test_what_does_not_rise_keeps_what_was_there(stool):
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=61)
    report = record(stool)
    with pytest.raises(RuntimeError, match=r"does not rise from value 0\.5 .* Choose other values"):
        bpy.ops.boxmorph.keyframe_spectrum(alpha_from=0.5, alpha_to=0.5, timing="semantic")
    blender.preferences().guide_folder = "/none/such"
    try:
        with pytest.raises(RuntimeError, match="guide folder"):
            bpy.ops.boxmorph.keyframe_spectrum(timing="semantic")
    finally:
        blender.preferences().guide_folder = ""
    assert values(stool, 1, 31, 61) == [0.0, 0.5, 1.0]
    assert record(stool) == report


def test_the_command_line_takes_a_timing(tmp_path):
    blender.empty_scene()
    blender.chair()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    output = tmp_path / "out.blend"
    arguments = ["deform", "--prompt", "a bar stool", "--splits", "2", "--output", str(output)]
    arguments += ["--keyframes", "1:61", "--timing", "semantic"]
    assert blender.addon("command").main(arguments) == 0
    bpy.ops.wm.open_mainfile(filepath=str(output))
    keys = bpy.context.active_object.data.shape_keys
    curve = blender.addon("animation_curves").curve(keys, 'key_blocks["a bar stool"].value')
    assert [point.co.x for point in curve.keyframe_points] == list(range(1, 62, 6))
    assert record(keys.key_blocks["a bar stool"])["score_curve"]["alphas"][-1] == 1.0
