# SPDX-License-Identifier: MIT OR Apache-2.0
"""The preferences: which guide judges, what it runs on, and what is said of a guide that does not open."""

import os
import pathlib
import shutil

import addon_blender as blender
import pytest
from addon_blender import bpy

MINI = pathlib.Path(__file__).resolve().parents[2] / "guides" / "mini"
FILES = ("vision_model.onnx", "text_model.onnx", "tokenizer.json", "preprocessor_config.json", "config.json")

editor = blender.addon("preferences_editor")


@pytest.fixture
def prefs(tmp_path):
    """The preferences, with a guides folder that holds the guide `copy` and an empty folder."""
    prefs = blender.preferences()
    root = tmp_path / "guides"
    (root / "copy" / "onnx").mkdir(parents=True)
    (root / "broken").mkdir()
    for name in FILES:
        shutil.copy(MINI / name, root / "copy" / ("onnx" if name.endswith(".onnx") else "") / name)
    (root / "readme.txt").write_text("no guide")
    prefs.guides_folder = str(root)
    yield prefs
    prefs.runtime_library = prefs.guide_folder = prefs.guides_folder = ""
    prefs.guide_elsewhere = False
    prefs.provider, prefs.threads = "auto", 0


def said():
    """Return what the preferences say of the guide, after it was asked for."""
    editor._check(None, None)
    return " ".join(line for line, _icon in editor.guide_lines())


def choices(prefs):
    return [item[0] for item in editor._guide_items(prefs, bpy.context)]


def test_the_guides_of_the_folder_can_be_chosen(prefs):
    assert choices(prefs) == ["EMBEDDED", "FOLDER", "FOUND:broken", "FOUND:copy"]
    assert prefs.guide == "EMBEDDED"
    prefs.guide = "FOUND:copy"
    assert prefs.guide == "FOUND:copy"
    assert pathlib.Path(prefs.guide_folder).name == "copy"
    guide = blender.addon("engine").open_guide()
    assert (guide.name, guide.image_size) == ("copy", 64)
    prefs.guide = "EMBEDDED"
    assert prefs.guide_folder == ""
    assert blender.addon("engine").open_guide().name == "mini"


def test_a_choice_says_at_once_what_it_is(prefs):
    prefs.guide = "FOUND:copy"
    lines = " ".join(line for line, _icon in editor.guide_lines())
    size = sum((MINI / name).stat().st_size for name in FILES)
    assert "“copy” knows 249 names, sees images of 64 pixels" in lines
    assert f"{size / 1e6:.1f} MB" in lines
    assert blender.addon("engine").open_guide().sha256[:12] in lines


def test_a_choice_says_at_once_why_it_does_not_open(prefs):
    prefs.guide = "FOUND:broken"
    (line,) = editor.guide_lines()
    assert "has no vision_model.onnx; copy the whole folder" in line[0] and line[1] == "ERROR"


def test_a_guide_that_vanishes_stays_chosen_and_says_so(prefs):
    prefs.guide = "FOUND:copy"
    shutil.rmtree(prefs.guide_folder)
    assert choices(prefs) == ["EMBEDDED", "FOLDER", "FOUND:broken"]
    assert prefs.guide == "FOLDER"
    assert "copy does not exist" in said()
    with pytest.raises(RuntimeError, match="copy does not exist"):
        bpy.ops.boxmorph.check_guide()
    # Another guide that sorts before it is not taken for it.
    (pathlib.Path(prefs.guides_folder) / "another").mkdir()
    assert prefs.guide == "FOLDER"


def test_any_other_folder_can_be_named(prefs, tmp_path):
    prefs.guide = "FOLDER"
    assert prefs.guide == "FOLDER" and prefs.guide_folder == ""
    prefs.guide = "FOUND:copy"
    prefs.guide = "FOLDER"
    assert prefs.guide == "FOLDER" and prefs.guide_folder.endswith("copy")
    prefs.guide_folder = str(tmp_path / "nowhere")
    assert prefs.guide == "FOLDER"
    assert "nowhere does not exist" in editor.guide_lines()[0][0]


def test_a_missing_guides_folder_lists_nothing(prefs, tmp_path):
    prefs.guides_folder = str(tmp_path / "nowhere")
    assert blender.addon("guides").found() == []
    assert choices(prefs) == ["EMBEDDED", "FOLDER"]


def test_the_guides_folder_is_beside_blenders_settings_by_default(prefs):
    prefs.guides_folder = ""
    root = blender.addon("guides").root()
    assert root == bpy.utils.extension_path_user(blender.PACKAGE, path="guides")


def test_a_guides_folder_that_cannot_be_made_is_refused(prefs):
    prefs.guides_folder = str(pathlib.Path(prefs.guides_folder) / "readme.txt" / "guides")
    with pytest.raises(RuntimeError, match="guides cannot be made"):
        bpy.ops.boxmorph.open_guides_folder()


def test_files_that_have_changed_are_read_again_on_request(prefs):
    prefs.guide_folder = str(pathlib.Path(prefs.guides_folder) / "copy")
    assert "“copy”" in said()
    config = pathlib.Path(prefs.guide_folder) / "config.json"
    config.write_text(config.read_text().replace('"classes"', '"renamed"'))
    assert "knows 249 names" in said()
    assert bpy.ops.boxmorph.check_guide() == {"FINISHED"}
    assert "knows any words" in said()


def test_a_provider_that_the_library_lacks_is_replaced_and_said(prefs):
    engine = blender.addon("engine")
    boxmorph = engine.library()
    lacking = [name for name, *_ in editor.PROVIDERS[2:] if name not in boxmorph.execution_providers()]
    assert lacking
    prefs.provider = lacking[0]
    guide = engine.open_guide()
    assert guide.provider == "cpu"
    lines = [line for line, _icon in editor.runtime_lines()]
    assert "offers: Processor" in lines[0] and "In use: Processor" in lines[0]
    assert lines[-1] == engine.capitalised(guide.provider_note)


def test_the_provider_is_recorded_with_the_outcome(prefs):
    blender.empty_scene()
    obj = blender.chair()
    blender.deform()
    (report,) = blender.addon("shape_key").records(obj.data).values()
    assert report["guide"]["provider"] == "cpu"


def test_another_runtime_library_is_used_from_the_next_start(prefs, tmp_path):
    said()
    other = tmp_path / "libonnxruntime.so"
    other.write_bytes(b"")
    prefs.runtime_library = str(other)
    said()
    assert os.environ["ORT_DYLIB_PATH"] == str(other)
    assert any("once Blender starts again" in line for line, _icon in editor.runtime_lines())
    prefs.runtime_library = ""
    said()
    assert "ORT_DYLIB_PATH" not in os.environ
    assert not any("once Blender starts again" in line for line, _icon in editor.runtime_lines())


def test_without_a_guide_opened_nothing_is_claimed(prefs):
    blender.addon("engine")._guides.clear()
    assert editor.guide_lines() == [("Not opened yet", "INFO")]
    assert editor.runtime_lines() == []
