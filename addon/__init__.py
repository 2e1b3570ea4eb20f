# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxmorph: deform a manufactured object toward a text prompt, as a shape key.

The work is done by the Rust module `boxmorph`, which is imported at first use and not when Blender starts.
"""

import bpy

from . import translations
from .command_line import command
from .core import guide_copies, guide_downloads
from .interface import bug_report, outcome_panel, panels, preferences_editor, setting_presets
from .operators import (
    evaluation_operators,
    guide_copy_operators,
    guide_operators,
    mix_operators,
    outcome_operators,
    parts_operators,
    properties,
    search_operators,
    variation_operators,
)
from .part_boxes import parts, parts_view
from .searching import history

_classes = (
    preferences_editor.classes
    + parts.classes
    + properties.classes
    + history.classes
    + outcome_operators.classes
    + guide_copy_operators.classes
    + evaluation_operators.classes
    + mix_operators.classes
    + variation_operators.classes
    + parts_operators.classes
    + guide_operators.classes
    + setting_presets.classes
    + bug_report.classes
    + panels.main_classes
    + outcome_panel.classes
    + panels.classes
)
_commands = []


def register():
    translations.register()
    for cls in _classes + search_operators.classes:
        _set_tooltip(cls)
    for cls in _classes:
        bpy.utils.register_class(cls)
    search_operators.register_operators()
    parts.register_object()
    properties.register_scene()
    parts_view.register_view()
    setting_presets.register_presets()
    _commands.append(bpy.utils.register_cli_command("boxmorph", command.main))


def unregister():
    guide_copies.stop()
    guide_downloads.stop()
    search_operators.unregister_operators()
    while _commands:
        bpy.utils.unregister_cli_command(_commands.pop())
    setting_presets.unregister_presets()
    parts_view.unregister_view()
    properties.unregister_scene()
    parts.unregister_object()
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
    translations.unregister()


def _set_tooltip(cls):
    """Make the docstring of an operator, menu or panel its tooltip, in one line: Blender would show, and look
    for translations of, a docstring with its line breaks and indents.
    """
    if cls.__doc__ and issubclass(cls, (bpy.types.Operator, bpy.types.Menu, bpy.types.Panel)):
        cls.bl_description = " ".join(cls.__doc__.split())
