# SPDX-License-Identifier: MIT OR Apache-2.0
"""Mix Outcomes and Keyframe Mix: a pose of several outcomes in which every part stays thick enough."""

import json
from itertools import pairwise

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPTS = ("a bar stool", "a sofa", "a throne")


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A file with a chair of three outcomes, searched with the same parts."""
    path = tmp_path_factory.mktemp("mix") / "chair.blend"
    blender.empty_scene()
    obj = blender.chair()
    for prompt in PROMPTS:
        blender.deform(prompt)
    for key in outcomes(obj):
        key.value = 0.0
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return str(path)


@pytest.fixture
def obj(file):
    bpy.ops.wm.open_mainfile(filepath=file)
    return bpy.context.active_object


def outcomes(obj):
    return [obj.data.shape_keys.key_blocks[prompt] for prompt in PROMPTS]


def records(obj):
    return json.loads(obj.data.shape_keys["boxmorph"])


def rewrite(obj, change):
    """Let `change(records)` change the records of an object."""
    stored = records(obj)
    change(stored)
    obj.data.shape_keys["boxmorph"] = json.dumps(stored)


def set_values(obj, *values):
    for key, value in zip(outcomes(obj), values, strict=True):
        key.value = value


def values(obj):
    return [key.value for key in outcomes(obj)]


def factors(obj):
    """The scale factors of the parts (P,3) as the outcomes stand."""
    together = 1.0
    for key in outcomes(obj):
        report = records(obj)[key.name]
        together = together + key.value * (report["gauge_scale"] * np.array(report["scales"]) - 1.0)
    return together


def room(obj):
    return blender.addon("mix").room(obj)


def test_outcomes_are_mixed_evenly_and_in_the_ratio_of_their_sliders(obj):
    assert bpy.ops.boxmorph.mix_outcomes() == {"FINISHED"}
    np.testing.assert_allclose(values(obj), [1 / 3] * 3, atol=1e-6)
    set_values(obj, 1.0, 1.0, 1.0)
    bpy.ops.boxmorph.mix_outcomes()
    np.testing.assert_allclose(values(obj), [1 / 3] * 3, atol=1e-6)
    set_values(obj, 0.2, 0.6, 0.0)
    bpy.ops.boxmorph.mix_outcomes()
    np.testing.assert_allclose(values(obj), [0.25, 0.75, 0.0], atol=1e-6)
    bpy.ops.boxmorph.mix_outcomes(amount=0.5)
    np.testing.assert_allclose(values(obj), [0.125, 0.375, 0.0], atol=1e-6)
    # Away from one of them, where its slider has room for that.
    set_values(obj, 0.9, -0.1, 0.0)
    bpy.ops.boxmorph.mix_outcomes()
    np.testing.assert_allclose(values(obj), [0.9, -0.1, 0.0], atol=1e-6)


@pytest.mark.parametrize("weights", [(1, 1, 1), (0.3, 0.6, 0.1), (1, -0.4, 0.2)])
def test_a_mix_is_what_the_field_makes_of_the_mixed_factors(obj, weights):
    import boxmorph

    set_values(obj, *weights)
    bpy.ops.boxmorph.mix_outcomes()
    arrays, mesh = blender.addon("engine").searched(obj, bpy.context)
    stored = records(obj)
    first = stored[PROMPTS[0]]
    graph = boxmorph.BoxDefGraph.build(
        mesh, **{name: first[name] for name in ("splits", "symmetry", "boundary")}
    )
    gauge = 1.0 + sum(key.value * (stored[key.name]["gauge_scale"] - 1.0) for key in outcomes(obj))
    shift = sum(key.value * np.array(stored[key.name]["gauge_shift"]) for key in outcomes(obj))
    assert np.ptp(factors(obj)) > 0.05, "the test needs parts that scale apart"
    expected = gauge * graph.deform((factors(obj) / gauge).astype(np.float32)) + shift
    size = np.linalg.norm(np.ptp(arrays.vertices, axis=0))
    seen = blender.evaluated_positions(obj)
    assert np.abs(seen - expected).max() <= 1e-5 * size
    assert np.abs(seen - arrays.vertices).max() > 1e-2 * size


def thin(stored):
    """Let all outcomes make one and the same part thin."""
    for name in PROMPTS:
        stored[name]["gauge_scale"] = 1.0
        stored[name]["scales"] = np.ones_like(stored[name]["scales"]).tolist()
        stored[name]["scales"][0][0] = 0.4


def test_what_takes_too_much_together_is_said_and_brought_into_range(obj):
    rewrite(obj, thin)
    set_values(obj, 1.0, 0.0, 0.0)
    assert room(obj) is None
    set_values(obj, 0.7, 0.8, 0.0)
    assert factors(obj).min() == pytest.approx(0.1) and room(obj) is None
    set_values(obj, 0.8, 0.9, 0.0)
    assert "thinner than a twentieth" in room(obj)
    bpy.ops.boxmorph.mix_outcomes(amount=3.0)
    assert values(obj)[0] / values(obj)[1] == pytest.approx(8 / 9)
    assert factors(obj).min() == pytest.approx(0.05, abs=1e-6)
    assert room(obj) is None
    # Those that are muted do nothing, and are left out.
    outcomes(obj)[1].mute = True
    set_values(obj, 0.8, 0.9, 0.2)
    assert room(obj) is None
    bpy.ops.boxmorph.mix_outcomes()
    np.testing.assert_allclose(values(obj), [0.8, 0.9, 0.2], atol=1e-6)


def test_outcomes_that_make_up_for_each_other_have_more_room(obj):
    def opposite(stored):
        for name, scale in zip(PROMPTS, (0.4, 1.6, 1.0), strict=True):
            stored[name]["gauge_scale"] = 1.0
            stored[name]["scales"] = np.full_like(stored[name]["scales"], scale).tolist()

    rewrite(obj, opposite)
    for key in outcomes(obj):
        key.slider_max = 4.0
    set_values(obj, 3.0, 2.0, 0.0)
    assert factors(obj).min() == pytest.approx(0.4)
    assert room(obj) is None
    # Parts that differ need not make up for each other: what is taken away counts alone.
    rewrite(obj, lambda stored: stored[PROMPTS[1]].update(parts_id="other"))
    assert room(obj) is not None
    set_values(obj, 1.5, 4.0, 0.0)
    assert room(obj) is None


@pytest.mark.parametrize("ends", [("max", "min"), ("min", "max"), ("max", "max")])
@pytest.mark.parametrize("same", [True, False])
def test_opposite_extremes_end_at_the_limit(obj, ends, same):
    if not same:
        rewrite(obj, lambda stored: stored[PROMPTS[1]].update(parts_id="other"))
    for key, end in zip(outcomes(obj), ends, strict=False):
        key.value = getattr(key, f"slider_{end}")
    wanted = values(obj)
    bpy.ops.boxmorph.mix_outcomes(amount=10.0)
    reached = values(obj)
    np.testing.assert_allclose(
        np.array(reached) / np.abs(reached).sum(), np.array(wanted) / np.abs(wanted).sum(), atol=1e-5
    )
    assert room(obj) is None and factors(obj).min() >= 0.05 - 1e-5
    at_an_end = [
        value == pytest.approx(getattr(key, f"slider_{end}"), abs=1e-5)
        for key, value, end in zip(outcomes(obj), reached, ends, strict=False)
    ]
    if not any(at_an_end):
        for key in outcomes(obj):
            key.slider_min, key.slider_max = -10.0, 10.0
            key.value *= 1.001
        assert room(obj) is not None


def test_same_parts_are_known_and_other_parts_too(obj):
    stored = records(obj)
    assert len({stored[name]["parts_id"] for name in PROMPTS}) == 1
    blender.deform("a sofa", splits="3")
    assert records(obj)["a sofa"]["parts_id"] != stored["a sofa"]["parts_id"]


def refused(words):
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.boxmorph.mix_outcomes()


def test_one_alone_keeps_its_value(obj, capfd):
    set_values(obj, 0.7, 0.0, 0.0)
    assert bpy.ops.boxmorph.mix_outcomes() == {"FINISHED"}
    assert values(obj) == pytest.approx([0.7, 0.0, 0.0])
    assert "Only “a bar stool” has a value" in "".join(capfd.readouterr())


def test_what_is_not_mixed(obj):
    driver = outcomes(obj)[2].driver_add("value").driver
    driver.type = "SUM"
    set_values(obj, 0.7, 0.7, 0.0)
    refused("“a throne” is driven")
    outcomes(obj)[2].mute = True
    bpy.ops.boxmorph.mix_outcomes()
    assert values(obj)[:2] == pytest.approx([0.5, 0.5])
    outcomes(obj)[1].mute = True
    refused("fewer than two outcomes")
    assert values(obj)[:2] == pytest.approx([0.5, 0.5])


def test_a_pose_goes_to_the_next_along_straight_lines(obj):
    for frame, pose in ((1, (1, 0, 0)), (21, (0.5, 0.5, 0.2)), (41, (0, 0.2, 1))):
        bpy.context.scene.frame_set(frame)
        set_values(obj, *pose)
        bpy.ops.boxmorph.mix_outcomes()
        assert bpy.ops.boxmorph.keyframe_mix() == {"FINISHED"}
    poses = []
    for frame in (1, 11, 21, 31, 41):
        bpy.context.scene.frame_set(frame)
        poses.append(values(obj))
    for before, between, after in ((0, 1, 2), (2, 3, 4)):
        np.testing.assert_allclose(poses[between], (np.array(poses[before]) + poses[after]) / 2, atol=1e-5)
    assert all(not np.allclose(a, b) for a, b in pairwise(poses))
    np.testing.assert_allclose(np.sum(poses, axis=1), 1.0, atol=1e-5)


def test_a_driven_pose_is_not_keyed(obj):
    driver = outcomes(obj)[1].driver_add("value").driver
    driver.type = "SUM"
    with pytest.raises(RuntimeError, match="“a sofa” is driven"):
        bpy.ops.boxmorph.keyframe_mix()
    assert obj.data.shape_keys.animation_data.action is None


def test_outcomes_without_a_record_of_their_parts_keep_to_their_sliders(obj):
    rewrite(obj, lambda stored: [stored[name].pop("scales") for name in PROMPTS])
    set_values(obj, 1.0, 1.0, 1.0)
    assert room(obj) is None
    bpy.ops.boxmorph.mix_outcomes(amount=10.0)
    assert values(obj) == pytest.approx([min(key.slider_max for key in outcomes(obj))] * 3)


def test_pieces_stay_and_count(obj):
    set_values(obj, 1.0, 0.0, 0.0)
    bpy.ops.boxmorph.take_apart(key="a bar stool")
    pieces = blender.addon("shape_key").pieces(obj.data, "a bar stool")
    rewrite(obj, thin)

    def set_pieces(*of_pieces):
        for piece, value in zip(pieces, of_pieces * len(pieces), strict=False):
            piece.slider_max, piece.value = 4.0, value

    # Pieces that are all at one value are the outcome at that value.
    set_pieces(0.7)
    set_values(obj, 0.0, 0.8, 0.0)
    assert room(obj) is None
    set_pieces(0.8)
    set_values(obj, 0.0, 0.9, 0.0)
    assert room(obj) is not None
    # Of those at several values, the one that takes most away.
    set_pieces(0.1, 0.8)
    assert room(obj) is not None

    set_values(obj, 0.0, 1.0, 1.0)
    before = [piece.value for piece in pieces]
    bpy.ops.boxmorph.mix_outcomes()
    assert [piece.value for piece in pieces] == before
    assert values(obj) == pytest.approx([0.0, 0.47 / 1.2, 0.47 / 1.2])
    assert room(obj) is None
    bpy.ops.boxmorph.keyframe_mix()
    paths = {curve.data_path for curve in blender.addon("animation_curves").curves(obj.data.shape_keys)}
    assert {key.path_from_id("value") for key in (*pieces, *outcomes(obj))} == paths

    set_pieces(1.6)
    refused("pieces of “a bar stool” already make a part thinner")
    assert values(obj) == pytest.approx([0.0, 0.47 / 1.2, 0.47 / 1.2])
