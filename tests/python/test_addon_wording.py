# SPDX-License-Identifier: MIT OR Apache-2.0
"""What is asked for besides the prompt, in Blender: settings, record, searching again, command line."""

import json

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a sofa:1, a throne:0.3"
MORE = {"negative": "a bench", "source": "a chair", "templates": "on"}


@pytest.fixture
def chair():
    blender.empty_scene()
    return blender.chair()


def record(obj, name=PROMPT):
    return json.loads(obj.data.shape_keys["boxmorph"])[name]


def test_the_record_and_all_that_follows_hold_what_was_asked(chair):
    blender.deform(PROMPT, **MORE)
    report = record(chair)
    assert (report["negative"], report["source"], report["templates"]) == ("a bench", "a chair", True)
    assert {name: report["asked"][name] for name in MORE} == MORE
    assert bpy.ops.boxmorph.evaluate() == {"FINISHED"}
    assert bpy.ops.boxmorph.measure_scores() == {"FINISHED"}
    evaluated, curve = record(chair)["evaluation"], record(chair)["score_curve"]
    for name, end in (("score_before", 0), ("score_after", -1)):
        assert evaluated[name] == pytest.approx(report[name], abs=1e-5)
        assert curve["scores"][end] == pytest.approx(report[name], abs=1e-5)


def test_searched_again_it_is_the_same(chair):
    blender.deform(PROMPT, **MORE)
    before = blender.positions(chair.data.shape_keys.key_blocks[PROMPT])
    again = blender.addon("again").settings_of(record(chair))
    blender.empty_scene()
    other = blender.chair()
    assert bpy.ops.boxmorph.deform(**again) == {"FINISHED"}
    assert np.array_equal(blender.positions(other.data.shape_keys.key_blocks[PROMPT]), before)


def test_the_panel_says_what_is_asked_unless_the_outcome_does(chair):
    settings = bpy.context.scene.boxmorph
    blender.deform("a sofa")
    alone = blender.positions(chair.data.shape_keys.key_blocks["a sofa"])
    # A record from before there was more than a prompt.
    stored = json.loads(chair.data.shape_keys["boxmorph"])
    for name in MORE:
        del stored["a sofa"]["asked"][name]
        del stored["a sofa"][name]
    chair.data.shape_keys["boxmorph"] = json.dumps(stored)
    settings.negative, settings.source = MORE["negative"], MORE["source"]
    asked = blender.addon("again").settings_of(record(chair, "a sofa"))
    assert bpy.ops.boxmorph.deform(**asked) == {"FINISHED"}
    assert np.array_equal(blender.positions(chair.data.shape_keys.key_blocks["a sofa"]), alone)
    blender.deform("a sofa")
    assert record(chair, "a sofa")["negative"] == "a bench"


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"prompt": "a sofa, a bed:1"}, "has no weight"),
        ({"prompt": "a sofa", "negative": "zzgribble"}, "knows no word"),
        ({"prompt": "a sofa", "source": "a sofa"}, "nearly the same"),
    ],
)
def test_refused_in_a_sentence_and_unchanged(chair, settings, words):
    before = blender.key_state(chair)
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.boxmorph.deform(**settings)
    assert blender.key_state(chair) == before


def test_the_command_line(chair, tmp_path, capfd):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    main = blender.addon("command").main
    output, report = tmp_path / "out.blend", tmp_path / "report.json"
    options = ["deform", "--prompt", f" {PROMPT} ", "--negative", "a zzgribble bench", "--from", "a chair"]
    options += ["--templates", "on", "--splits", "2", "--output", str(output), "--report", str(report)]
    assert main(options) == 0
    assert "does not know “zzgribble”" in capfd.readouterr().err
    found = json.loads(report.read_text(encoding="utf-8"))
    assert (found["prompt"], found["source"], found["templates"]) == (PROMPT, "a chair", True)
    assert main(["deform", "--prompt", "a sofa, a bed:1"]) == 1
    assert "“" not in (told := capfd.readouterr().err) and "has no weight" in told


def test_behind_a_weight_another_name_is_suggested():
    complete = blender.addon("suggestions").completions
    names = ["a throne", "a thick table", "a bar stool"]
    assert complete("a sofa:1, a thr", names) == ["a sofa:1, a throne"]
    assert complete("a sofa:1,a thr", names) == ["a sofa:1,a throne"]
    assert complete("a sofa:1, ", names) == [f"a sofa:1, {name}" for name in names]
    assert complete("a tall, bar st", names) == ["a tall, bar stool"]
