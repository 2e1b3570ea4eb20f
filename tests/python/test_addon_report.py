# SPDX-License-Identifier: MIT OR Apache-2.0
"""The report on what Boxmorph is doing: it holds what a bug report needs, and no user's name."""

import os
import platform

import addon_blender as blender
import pytest
from addon_blender import bpy

bug_report = blender.addon("bug_report")


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()
    blender.addon("errors").told.clear()
    yield
    prefs = blender.preferences()
    prefs.guide_folder = prefs.runtime_library = ""
    prefs.renderer = "auto"


def sections():
    """Return the report's sections by title."""
    text = bug_report.text(bpy.context)
    assert text.startswith("# Boxmorph report\n")
    return {part.split("\n", 1)[0]: part for part in text.split("\n## ")[1:]}


def test_versions_guide_and_preferences():
    boxmorph = blender.addon("engine").library()
    blender.preferences().threads = 1
    try:
        found = sections()
    finally:
        blender.preferences().threads = 0
    for words in (
        f"Boxmorph {boxmorph.__version__}",
        f"Blender {bpy.app.version_string}",
        f"Python {platform.python_version()}",
        platform.system(),
        f"{os.cpu_count()} processor threads",
        f"ONNX Runtime {boxmorph.runtime_version()}",
        "Graphics card: ",
    ):
        assert words in found["Versions"], words
    assert "“mini” knows 249 names" in found["Guide"] and "Encodes on cpu" in found["Guide"]
    assert "threads: 1" in found["Preferences"] and "provider: 'auto'" in found["Preferences"]


def test_no_object():
    found = sections()
    assert "none is active" in found["Object"]
    assert "no search" in found["Running"]
    assert "Outcome" not in found


def test_an_object_that_is_no_mesh():
    light = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "POINT"))
    bpy.context.scene.collection.objects.link(light)
    blender.activate(light)
    assert "“Lamp”, light" in sections()["Object"]


def test_object_parts_settings_and_outcome():
    obj = blender.chair(half=True)
    bpy.context.scene.boxmorph.keep_size = "height"
    bpy.ops.boxmorph.find_parts()
    obj.boxmorph.items[0].lock = (True, False, True)
    blender.deform("a bar stool")
    found = sections()
    vertices, faces = len(obj.data.vertices), len(obj.data.polygons)
    assert f"{vertices} vertices, {faces} faces, {2 * faces} triangles" in found["Object"]
    assert "MIRROR, SUBSURF" in found["Object"]
    assert "“a bar stool” 1" in found["Object"]
    assert f"{obj.boxmorph.items[0].name} (locked xz)" in found["Object"]
    assert "keep_size 'height'" in found["Settings"]
    assert '"score_after"' in found["Outcome"] and '"provider": "cpu"' in found["Outcome"]


def test_many_shape_keys_do_not_flood_it():
    obj = blender.chair()
    for number in range(200):
        obj.shape_key_add(name=f"Key {number}")
    found = sections()["Object"]
    assert "200: " in found and "and 180 more" in found


def test_a_running_search(monkeypatch):
    obj = blender.chair()
    search = blender.addon("search").Search(bpy.context, obj, "a bar stool", splits="2")
    running = blender.addon("running").running
    monkeypatch.setattr(running, "search", search)
    try:
        search.poll()
        phase = search.progress["phase"]
        assert phase.capitalize() in sections()["Running"]
    finally:
        search.cancel(wait=True)


def test_what_was_refused_is_in_it():
    obj = blender.chair()
    with pytest.raises(RuntimeError):
        bpy.ops.boxmorph.take_apart()
    blender.deform("a bar stool")
    with pytest.raises(RuntimeError, match="no outcome named"):
        bpy.ops.boxmorph.take_apart(key="nothing of this name")
    assert f"“{obj.name}” has no outcome named “nothing of this name”" in sections()["Told last"]


def test_the_last_ten_sentences_are_kept():
    errors = blender.addon("errors")
    for number in range(30):
        errors.remember(f"sentence {number}")
        errors.remember(f"sentence {number}")
    assert list(errors.told) == [f"sentence {number}" for number in range(20, 30)]


def test_a_broken_guide_folder(tmp_path):
    blender.preferences().guide_folder = str(tmp_path)
    assert "has no vision_model.onnx" in sections()["Guide"]
    blender.preferences().guide_folder = str(tmp_path / "nowhere")
    assert "nowhere does not exist" in sections()["Guide"]


def test_a_missing_library(tmp_path):
    blender.preferences().runtime_library = str(tmp_path / "libonnxruntime.so")
    found = sections()
    assert "libonnxruntime.so is missing" in found["Versions"]
    assert f"Blender {bpy.app.version_string}" in found["Versions"]


def test_a_renderer_that_was_ruled_out_is_not_asked(monkeypatch):
    boxmorph = blender.addon("engine").library()
    monkeypatch.setattr(boxmorph, "graphics_adapter", lambda: pytest.fail("the drivers were opened"))
    blender.preferences().renderer = "cpu"
    assert "Graphics card: not asked" in sections()["Versions"]


def test_no_users_name(tmp_path, monkeypatch):
    home = tmp_path / "jane.doe"
    (home / "guides").mkdir(parents=True)
    monkeypatch.setenv("HOME", str(home))
    blender.preferences().guide_folder = str(home / "guides")
    blender.addon("errors").remember(f"The file {home}/a.blend cannot be read")
    text = bug_report.text(bpy.context)
    assert "jane" not in text
    assert "~/guides" in text and "~/a.blend" in text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("in /home/jane/x", "in /home/…/x"),
        ("“/Users/jane doe/x”", "“/Users/…/x”"),
        ("of /home/jane", "of /home/…"),
        (r"C:\Users\jane\x", r"C:\Users\…\x"),
        ("C:/Users/jane/x", "C:/Users/…/x"),
        ("/media/jane/disk", "/media/…/disk"),
        ("/opt/homes", "/opt/homes"),
    ],
)
def test_users_names_in_other_paths(text, expected):
    assert bug_report.without_user(text) == expected


def test_it_becomes_a_text_only_on_request():
    with pytest.raises(RuntimeError, match="no clipboard in background"):
        bpy.ops.boxmorph.copy_report()
    assert not bpy.data.texts
    blender.addon("errors").told.clear()
    for _ in range(2):
        assert bpy.ops.boxmorph.copy_report(as_text=True) == {"FINISHED"}
    (block,) = bpy.data.texts
    assert block.as_string().strip() == bug_report.text(bpy.context).strip()


def test_it_fits_into_a_bug_report():
    blender.chair()
    bpy.ops.boxmorph.find_parts()
    blender.deform("a bar stool")
    assert len(bug_report.text(bpy.context)) < 8000
