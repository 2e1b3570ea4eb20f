# SPDX-License-Identifier: MIT OR Apache-2.0
"""Variations in Blender: keys beside an outcome, each with its own record; replaced, cancelled, shown."""

import json
import time

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def records(obj):
    return json.loads(obj.data.shape_keys["boxmorph"])


def keys(obj):
    return obj.data.shape_keys.key_blocks


def names(obj):
    return [key.name for key in keys(obj)]


def test_variations_are_keys_beside_the_outcome():
    obj = blender.chair()
    before = blender.fingerprint(obj)
    blender.deform(PROMPT)
    alone = blender.positions(keys(obj)[PROMPT])
    blender.deform(PROMPT, variations=3)
    assert names(obj) == ["Basis", PROMPT, f"{PROMPT} 2", f"{PROMPT} 3"]
    assert [key.value for key in keys(obj)][1:] == [1, 0, 0]
    assert obj.active_shape_key.name == PROMPT
    np.testing.assert_array_equal(blender.positions(keys(obj)[PROMPT]), alone)
    shapes = [blender.positions(key) for key in keys(obj)]
    size = np.linalg.norm(np.ptp(shapes[0], axis=0))
    for i, one in enumerate(shapes):
        for other in shapes[:i]:
            assert np.abs(one - other).max() > 0.03 * size
    reports = records(obj)
    assert list(reports) == names(obj)[1:]
    for number, (name, report) in enumerate(reports.items()):
        assert (report["prompt"], report["variation"], report["variations_asked"]) == (PROMPT, number, 3)
        assert report["score_after"] > report["score_before"]
        key = keys(obj)[name]
        assert key.slider_min == pytest.approx(min(report["slider_min"], 0), abs=1e-6)
        assert key.slider_max == pytest.approx(max(report["slider_max"], 1), abs=1e-6)
        assert not key.mute and key.relative_key.name == "Basis"
    assert len({json.dumps(report["scales"]) for report in reports.values()}) == 3
    assert blender.fingerprint(obj) == before


def test_they_are_written_under_modifiers_as_they_were_scored():
    obj = blender.chair(half=True)
    obj.modifiers.remove(obj.modifiers["Subdivision"])
    blender.deform(PROMPT, variations=3)
    shown = []
    for key in list(keys(obj))[1:]:
        for other in keys(obj):
            other.value = 1.0 if other.name == key.name else 0.0
        shown.append(blender.evaluated_positions(obj))
    assert len(shown) > 1
    low = [positions[:, 2].min() for positions in shown]
    np.testing.assert_allclose(low, low[0], atol=1e-3)
    size = [np.linalg.norm(np.ptp(positions, axis=0)) for positions in shown]
    np.testing.assert_allclose(size, size[0], rtol=1e-3)
    assert all(report["modifiers_depart"] < 1e-3 for report in records(obj).values())


def test_searching_the_prompt_again_replaces_its_variations():
    obj = blender.chair()
    blender.deform("a sofa", variations=2)
    blender.deform(PROMPT, variations=3)
    keys(obj)[f"{PROMPT} 2"].value = 0.5
    second = blender.positions(keys(obj)[f"{PROMPT} 2"])
    blender.deform(PROMPT, variations=3, seed=5)
    assert {name for name in names(obj) if name.startswith(PROMPT)} <= {PROMPT, f"{PROMPT} 2", f"{PROMPT} 3"}
    assert not any(name.endswith(".001") for name in names(obj))
    assert not np.array_equal(blender.positions(keys(obj)[f"{PROMPT} 2"]), second)
    assert keys(obj)[f"{PROMPT} 2"].value == 0
    blender.deform(PROMPT)
    assert [name for name in names(obj) if name.startswith(PROMPT)] == [PROMPT]
    assert [name for name in records(obj) if name.startswith("a sofa")] == ["a sofa", "a sofa 2"]
    assert keys(obj)[PROMPT].value == 1 and keys(obj)["a sofa"].value == 0


def test_a_key_of_the_artists_own_stays():
    obj = blender.chair()
    obj.shape_key_add(name="Basis", from_mix=False)
    obj.shape_key_add(name=f"{PROMPT} 2", from_mix=False)
    own = blender.positions(keys(obj)[f"{PROMPT} 2"])
    blender.deform(PROMPT, variations=2)
    np.testing.assert_array_equal(blender.positions(keys(obj)[f"{PROMPT} 2"]), own)
    assert f"{PROMPT} 2.001" in records(obj)
    blender.deform(PROMPT, variations=2)
    assert sum(name.startswith(PROMPT) for name in names(obj)) == 3


def test_a_variation_that_was_taken_apart_is_replaced_whole():
    obj = blender.chair()
    blender.deform(PROMPT, variations=2)
    count = len(names(obj))
    assert bpy.ops.boxmorph.take_apart(key=f"{PROMPT} 2") == {"FINISHED"}
    assert len(names(obj)) > count
    blender.deform(PROMPT, variations=2)
    assert len(names(obj)) == count
    assert "pieces" not in records(obj)[f"{PROMPT} 2"]


def test_cancel_restores_the_variations_that_were_there():
    obj = blender.chair()
    blender.deform(PROMPT, variations=3)
    keys(obj)[PROMPT].value, keys(obj)[f"{PROMPT} 2"].value = 0.25, 0.75
    before = blender.key_state(obj)
    search = blender.addon("search").Search(bpy.context, obj, PROMPT, seed=9, splits="2", variations=8)
    until = time.monotonic() + 120
    while "variations" not in search.progress["phase"]:
        search.poll()
        search.preview(obj)
        assert time.monotonic() < until, "no variation within two minutes"
        time.sleep(0.01)
    assert blender.key_state(obj) != before
    search.cancel(wait=True)
    assert search.take_back(search.find_object())
    assert blender.key_state(obj) == before


def test_the_operator_searches_again_as_the_record_says():
    obj = blender.chair()
    blender.deform(PROMPT, seed=3, keep_size="height", least_scale=0.5)
    first = blender.positions(keys(obj)[PROMPT])
    assert bpy.ops.boxmorph.variations(key=PROMPT, count=3) == {"FINISHED"}
    np.testing.assert_array_equal(blender.positions(keys(obj)[PROMPT]), first)
    added = [name for name in names(obj) if name.startswith(f"{PROMPT} ")]
    assert added and all(records(obj)[name]["variation_of"] == PROMPT for name in added)
    # From a variation too, and the same again.
    shapes = [blender.positions(key) for key in keys(obj)]
    assert bpy.ops.boxmorph.variations(key=added[0], count=3) == {"FINISHED"}
    for key, shape in zip(keys(obj), shapes, strict=True):
        np.testing.assert_array_equal(blender.positions(key), shape)


def test_the_operator_needs_an_outcome():
    obj = blender.chair()
    with pytest.raises(RuntimeError, match="poll"):
        bpy.ops.boxmorph.variations()
    blender.deform(PROMPT)
    with pytest.raises(RuntimeError, match="has no outcome named “a sofa”"):
        bpy.ops.boxmorph.variations(key="a sofa")
    obj.data.vertices.add(0)
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError) as refused:
        bpy.ops.boxmorph.variations(key=PROMPT)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert str(refused.value).count("Error") == 1


def test_one_outcome_is_shown_alone():
    obj = blender.chair()
    blender.deform("a sofa")
    blender.deform(PROMPT, variations=2)
    own = obj.shape_key_add(name="Mine", from_mix=False)
    own.value = 0.5
    assert bpy.ops.boxmorph.show_outcome(key=f"{PROMPT} 2") == {"FINISHED"}
    values = {key.name: key.value for key in keys(obj)}
    assert (values["a sofa"], values[PROMPT], values[f"{PROMPT} 2"], values["Mine"]) == (0, 0, 1, 0.5)
    assert obj.active_shape_key.name == f"{PROMPT} 2"
    bpy.ops.boxmorph.take_apart(key=f"{PROMPT} 2")
    shown = blender.evaluated_positions(obj)
    bpy.ops.boxmorph.show_outcome(key=PROMPT)
    assert [key.value for key in keys(obj) if key.name.startswith(f"{PROMPT} 2")] == pytest.approx(
        [0.0] * sum(key.name.startswith(f"{PROMPT} 2") for key in keys(obj))
    )
    bpy.ops.boxmorph.show_outcome(key=f"{PROMPT} 2")
    np.testing.assert_allclose(blender.evaluated_positions(obj), shown, atol=1e-6)


def test_the_summary_says_how_many_there_are():
    obj = blender.chair()
    search = blender.addon("search").Search(bpy.context, obj, PROMPT, splits="2", variations=2)
    search.run()
    search.keep(obj, bpy.context)
    assert search.summary().endswith(", with 1 variation")
    assert [report["shape_key"] for report in search.reports] == [PROMPT, f"{PROMPT} 2"]
    search.report["variations_asked"] = 4
    assert search.summary().endswith(", with 1 variation of 3; no others are as good and look different")


def test_the_command_writes_them_all(tmp_path, capfd):
    blender.chair()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    output, report, sheet = tmp_path / "out.blend", tmp_path / "report.json", tmp_path / "sheet.png"
    spectrum = tmp_path / "spectrum.png"
    arguments = ["deform", "--prompt", PROMPT, "--splits", "2", "--variations", "3", "--output", output]
    arguments += ["--report", report, "--sheet", sheet, "--spectrum", spectrum]
    assert blender.addon("command").main([str(argument) for argument in arguments]) == 0
    assert "variation" in capfd.readouterr().out
    bpy.ops.wm.open_mainfile(filepath=str(output))
    obj = bpy.data.objects["Chair"]
    written = json.loads(report.read_text())
    outcomes = [written["shape_key"], *(other["shape_key"] for other in written["variations"])]
    assert outcomes == names(obj)[1:] and len(outcomes) > 1
    for path, rows in ((sheet, 1 + len(outcomes)), (spectrum, len(outcomes))):
        image = bpy.data.images.load(str(path))
        assert image.size[1] == rows * 224 + (rows - 1) * 4
        bpy.data.images.remove(image)


@pytest.mark.parametrize("count", ["0", "9", "many"])
def test_the_command_refuses_other_numbers(tmp_path, capfd, count):
    blender.chair()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    with pytest.raises(SystemExit, match="2"):
        blender.addon("command").main(["deform", "--prompt", PROMPT, "--variations", count])
    assert "argument --variations" in capfd.readouterr().err
