# SPDX-License-Identifier: GPL-3.0-or-later
"""Preferences: where guides and ONNX Runtime lie, and how views are rendered."""

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

RENDERERS = (
    ("auto", "Automatic", "The graphics card where there is a real one, else the processor"),
    ("cpu", "Processor", "Render the guide's views on the processor"),
    ("gpu", "Graphics Card", "Render the guide's views on the graphics card"),
)


class BoxmorphPreferences(bpy.types.AddonPreferences):
    """Preferences of the extension, kept per user."""

    bl_idname = __package__

    guide_folder: StringProperty(
        name="Guide Folder",
        description="Folder of a guide (ONNX files, tokenizer and configuration). Empty: the embedded guide",
        subtype="DIR_PATH",
    )
    runtime_library: StringProperty(
        name="ONNX Runtime",
        description="A library of ONNX Runtime of your own, for one graphics card or another. "
        "Empty: the one inside the extension. Read when Blender first uses a guide",
        subtype="FILE_PATH",
    )
    renderer: EnumProperty(
        name="Renderer",
        description="What renders the views that the guide sees",
        items=RENDERERS,
        default="auto",
    )
    threads: IntProperty(
        name="Threads",
        description="Processor threads that a search may use; 0 means all. Read when Blender first searches",
        min=0,
        max=256,
        default=0,
    )

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "guide_folder")
        layout.prop(self, "runtime_library")
        layout.prop(self, "renderer")
        layout.prop(self, "threads")


def preferences():
    """Return this extension's preferences, or their defaults while the extension is not enabled."""
    addon = bpy.context.preferences.addons.get(__package__)
    if addon is None or addon.preferences is None:
        return _Defaults
    return addon.preferences


class _Defaults:
    guide_folder = ""
    runtime_library = ""
    renderer = "auto"
    threads = 0


classes = (BoxmorphPreferences,)
