# SPDX-License-Identifier: MIT OR Apache-2.0
"""Copies of guides in eight bits, by button and on the command line."""

import pathlib
import time

import addon_blender as blender
import pytest
from addon_blender import bpy

pytest.importorskip("onnx", reason="the module onnx, which makes the toy guide, is not installed here")
from toy_guides import TinyViT

engine = blender.addon("engine")
copies = blender.addon("guide_copies")
guides = blender.addon("guides")
progress = blender.addon("guide_copy_progress")


@pytest.fixture
def prefs(tmp_path):
    """The preferences, with a guides folder that holds a toy of a large guide."""
    prefs = blender.preferences()
    TinyViT().write(tmp_path / "guides" / "large")
    prefs.guides_folder = str(tmp_path / "guides")
    prefs.guide_folder = str(tmp_path / "guides" / "large")
    yield prefs
    copies.stop()
    prefs.guide_folder = prefs.guides_folder = ""


def test_the_button_makes_a_copy_measures_and_chooses_it(prefs):
    assert bpy.ops.boxmorph.quantize_guide() == {"FINISHED"}
    assert prefs.guide_folder.endswith("large-8bit")
    guide = engine.open_guide()
    assert (guide.name, guide.precision) == ("large-8bit", "int8")


def test_a_copy_says_what_it_is_worth(prefs):
    copies.start(engine.guide_folder())
    folder, figures = copies.wait()
    assert pathlib.Path(folder).is_dir()
    said = copies.summary(figures)
    assert " MB instead of " in said and "times as fast" in said and "a cosine of 0.9" in said


def test_the_timer_follows_the_copy_and_chooses_it(prefs):
    # As if Blender had ended in the middle of one.
    (pathlib.Path(prefs.guides_folder) / ".copy-large-8bit" / "rest").mkdir(parents=True)
    copies.start(engine.guide_folder())
    copies.watch()
    assert bpy.app.timers.is_registered(copies._tick)
    assert [pathlib.Path(folder).name for folder in guides.found()] == ["large"], "it is offered too early"
    assert not bpy.ops.boxmorph.quantize_guide.poll() and bpy.ops.boxmorph.cancel_guide_copy.poll()
    said, fractions = set(), []
    while copies._tick() is not None:
        said.add(progress.progress_text())
        fractions.append(copies.state.progress["fraction"])
        time.sleep(0.001)
    bpy.app.timers.unregister(copies._tick)
    assert fractions == sorted(fractions) and fractions[-1] > 0.1
    assert any("Comparing them" in text or "Opening both" in text for text in said), said
    assert prefs.guide == "FOUND:large-8bit" and copies.state.work is None
    assert copies.state.folder == engine.guide_folder() and copies.state.figures["cosine_mean"] > 0.9
    prefs.guide_folder = ""


def test_a_cancelled_copy_leaves_nothing_and_the_guide_as_it_was(prefs):
    before = prefs.guide_folder
    copies.start(engine.guide_folder())
    copies.watch()
    assert bpy.ops.boxmorph.cancel_guide_copy() == {"FINISHED"}
    assert "Cancelling" in progress.progress_text()
    while copies._tick() is not None:
        time.sleep(0.001)
    bpy.app.timers.unregister(copies._tick)
    assert prefs.guide_folder == before and copies.state.refusal is None
    assert [path.name for path in pathlib.Path(prefs.guides_folder).iterdir()] == ["large"]


def test_disabling_the_extension_ends_a_copy(prefs):
    copies.start(engine.guide_folder())
    copies.watch()
    copies.stop()
    assert copies.state.work is None and not bpy.app.timers.is_registered(copies._tick)
    assert [path.name for path in pathlib.Path(prefs.guides_folder).iterdir()] == ["large"]


def test_no_copy_is_made_twice_or_of_the_embedded_guide(prefs):
    bpy.ops.boxmorph.quantize_guide()
    prefs.guide_folder = prefs.guide_folder.removesuffix("-8bit")
    with pytest.raises(RuntimeError, match="is there already"):
        bpy.ops.boxmorph.quantize_guide()
    prefs.guide_folder = ""
    with pytest.raises(RuntimeError, match="The embedded guide is fast as it is"):
        bpy.ops.boxmorph.quantize_guide()


def test_a_damaged_guide_leaves_nothing_behind(prefs):
    root = pathlib.Path(prefs.guides_folder)
    (root / "large" / "text_model.onnx").write_bytes(b"no network")
    with pytest.raises(RuntimeError, match=r"text_model\.onnx is not a network"):
        bpy.ops.boxmorph.quantize_guide()
    assert [path.name for path in root.iterdir()] == ["large"]


def test_the_command_line_makes_one_and_says_so(prefs, capsys):
    before = prefs.guide_folder
    assert blender.addon("guide_copy").make(before) == 0
    said = capsys.readouterr().out
    assert "large-8bit: " in said and "times as fast" in said
    assert prefs.guide_folder == before
