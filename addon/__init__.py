# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxmorph: deform a manufactured object toward a text prompt, as a shape key.

The work is done by the Rust module `boxmorph`, which is imported at first use and not when Blender starts.
"""

import bpy

from . import (
    command,
    outcome_operators,
    panels,
    parts,
    parts_operators,
    parts_view,
    preferences,
    properties,
    search_operators,
    variation_operators,
)

_classes = (
    preferences.classes
    + parts.classes
    + properties.classes
    + search_operators.classes
    + outcome_operators.classes
    + variation_operators.classes
    + parts_operators.classes
    + panels.classes
)
_commands = []


def register():
    for cls in _classes:
        bpy.utils.register_class(cls)
    parts.register_object()
    properties.register_scene()
    parts_view.register_view()
    _commands.append(bpy.utils.register_cli_command("boxmorph", command.main))


def unregister():
    search_operators.stop_running()
    while _commands:
        bpy.utils.unregister_cli_command(_commands.pop())
    parts_view.unregister_view()
    properties.unregister_scene()
    parts.unregister_object()
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
