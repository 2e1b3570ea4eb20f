# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension's preferences, as its other modules read them. `preferences_editor` shows them."""

import bpy

#: The name under which Blender knows the extension.
PACKAGE = __package__

RENDERERS = (
    ("auto", "Automatic", "The graphics card where there is a real one, else the processor"),
    ("cpu", "Processor", "Render the guide's views on the processor. Choose it where a driver makes trouble"),
    (
        "gpu",
        "Graphics Card",
        "Render the guide's views on the graphics card, even one that the processor plays",
    ),
)


def preferences():
    """Return this extension's preferences, or their defaults while the extension is not enabled."""
    addon = bpy.context.preferences.addons.get(PACKAGE)
    if addon is None or addon.preferences is None:
        return _Defaults
    return addon.preferences


class _Defaults:
    guide_folder = ""
    guide_precision = ""
    guides_folder = ""
    hub_endpoint = ""
    runtime_library = ""
    provider = "auto"
    renderer = "auto"
    threads = 0
