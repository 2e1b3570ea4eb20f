# SPDX-License-Identifier: MIT OR Apache-2.0
"""Presets of the search's settings: those that come along, and the user's own."""

import pathlib

import addon_blender as blender
import addon_utils
import pytest
from addon_blender import bpy

presets = blender.addon("setting_presets")
FOLDER = "boxmorph/search"
PANEL = "BOXMORPH_PT_search_presets"


@pytest.fixture
def settings():
    blender.empty_scene()
    return bpy.context.scene.boxmorph


def values(settings):
    return {
        name: pytest.approx(value) if isinstance(value := getattr(settings, name), float) else value
        for name in presets.SETTINGS
    }


def shipped():
    """Return the files of the presets that come with the extension, by name."""
    folder = pathlib.Path(presets.__file__).parent / "presets" / FOLDER
    return {bpy.path.display_name(path.name, title_case=False): path for path in folder.glob("*.py")}


def apply(name):
    path = bpy.utils.preset_find(name, FOLDER, display_name=True)
    assert path, f"there is no preset {name}"
    assert bpy.ops.script.execute_preset(filepath=path, menu_idname=PANEL) == {"FINISHED"}


def test_every_shipped_preset_sets_every_setting(settings):
    assert set(shipped()) == {"Defaults", "Quick Look", "Keep the Height", "Stay Near", "Bold"}
    for name, path in shipped().items():
        text = path.read_text(encoding="utf-8")
        assert all(f"settings.{setting} = " in text for setting in presets.SETTINGS), name
        apply(name)
        assert getattr(bpy.types, PANEL).bl_label == name


def test_defaults_are_the_settings_of_a_new_scene(settings):
    new = values(settings)
    apply("Bold")
    assert values(settings) != new
    apply("Defaults")
    assert values(settings) == new


def test_a_preset_leaves_prompt_and_seed(settings):
    settings.prompt, settings.seed = "a sofa", 7
    apply("Bold")
    assert settings.shift_parts and settings.greatest_scale > 3.1
    assert (settings.prompt, settings.seed) == ("a sofa", 7)


def test_the_height_is_kept(settings):
    obj = blender.chair()
    height = obj.dimensions.z
    apply("Keep the Height")
    blender.deform("a coffee table", keep_size=settings.keep_size)
    z = blender.evaluated_positions(obj)[:, 2]
    assert z.max() - z.min() == pytest.approx(height, rel=1e-3)


def test_save_apply_delete(settings):
    settings.splits, settings.keep_size, settings.greatest_scale = "3", "footprint", 2.5
    mine = values(settings)
    assert bpy.ops.boxmorph.add_search_preset(name="Chairs of oak") == {"FINISHED"}
    apply("Defaults")
    assert values(settings) != mine
    apply("Chairs of oak")
    assert values(settings) == mine
    assert bpy.ops.boxmorph.add_search_preset(name="Chairs of oak", remove_name=True) == {"FINISHED"}
    assert not bpy.utils.preset_find("Chairs of oak", FOLDER, display_name=True)


def test_a_shipped_preset_is_neither_replaced_nor_deleted(settings, capfd):
    before = {path: path.read_bytes() for path in shipped().values()}
    for options in ({}, {"remove_name": True}):
        assert bpy.ops.boxmorph.add_search_preset(name="Bold", **options) == {"CANCELLED"}
    assert {path: path.read_bytes() for path in shipped().values()} == before
    assert "already exists" in "".join(capfd.readouterr())


def test_disabling_takes_the_shipped_presets_away():
    assert bpy.utils.preset_find("Bold", FOLDER)
    addon_utils.disable(blender.PACKAGE)
    try:
        assert not bpy.utils.preset_find("Bold", FOLDER)
    finally:
        addon_utils.enable(blender.PACKAGE, default_set=True)
    assert bpy.utils.preset_find("Bold", FOLDER)
