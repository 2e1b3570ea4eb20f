# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a search as Blender presets: those that come with the extension, and the user's own."""

import os

import bpy
from bl_operators.presets import AddPresetBase
from bl_ui.utils import PresetPanel

#: Where presets lie, below Blender's folder of presets and below ours.
_FOLDER = "boxmorph/search"

#: What a preset holds: how to search, but neither for what nor with which seed.
SETTINGS = (
    "preset",
    "seconds",
    "splits",
    "symmetry",
    "keep_size",
    "least_scale",
    "greatest_scale",
    "shift_parts",
)


class BOXMORPH_PT_search_presets(PresetPanel, bpy.types.Panel):
    """Apply, save and delete settings of the search. Yours are kept with Blender's other presets"""

    bl_space_type = "VIEW_3D"
    bl_label = "Search Presets"
    preset_subdir = _FOLDER
    preset_operator = "script.execute_preset"
    preset_add_operator = "boxmorph.add_search_preset"


class BOXMORPH_OT_add_search_preset(AddPresetBase, bpy.types.Operator):
    """Save the settings of the search as a preset, or delete one"""

    bl_idname = "boxmorph.add_search_preset"
    bl_label = "Add Search Preset"
    preset_menu = "BOXMORPH_PT_search_presets"
    preset_subdir = _FOLDER
    preset_defines = ("settings = bpy.context.scene.boxmorph",)
    preset_values = tuple(f"settings.{name}" for name in SETTINGS)


classes = (BOXMORPH_PT_search_presets, BOXMORPH_OT_add_search_preset)


def register_presets():
    """Let Blender find the presets that come with the extension."""
    bpy.utils.register_preset_path(os.path.dirname(__file__))


def unregister_presets():
    """Let Blender forget them again."""
    bpy.utils.unregister_preset_path(os.path.dirname(__file__))
