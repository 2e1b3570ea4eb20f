# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panel asks for, kept in the scene: prompt, preset, seed, search and keyframe settings."""

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from .suggestions import suggest

PRESETS = (
    ("standard", "Standard", "The result of the full search at a fraction of its cost"),
    ("paper", "Paper", "The published protocol, step by step. Much slower"),
)
SPLITS = (
    ("auto", "Automatic", "Try several and keep the best"),
    *((str(n), str(n), f"Split the object into parts {n} time{'s' if n > 1 else ''}") for n in range(1, 9)),
)
SYMMETRY = (
    ("auto", "Automatic", "Use the mirror symmetry found in the object, if there is one"),
    ("none", "None", "Let the two sides change separately"),
    ("x", "X", "Keep left and right alike"),
    ("y", "Y", "Keep front and back alike"),
    ("z", "Z", "Keep top and bottom alike"),
)


class SearchProperties:
    """The properties that the panel and the operator share (a mixin for registered classes)."""

    prompt: StringProperty(
        name="Prompt",
        description="What the object should become, in a few words, such as: a bar stool",
        search=suggest,
        search_options={"SUGGESTION"},
    )
    preset: EnumProperty(
        name="Preset", description="How thoroughly to search", items=PRESETS, default="standard"
    )
    seed: IntProperty(
        name="Seed",
        description="Another seed gives another result; the same seed gives the same one again",
        min=0,
        default=0,
    )
    splits: EnumProperty(
        name="Splits", description="How finely to split the object into parts", items=SPLITS, default="auto"
    )
    symmetry: EnumProperty(
        name="Symmetry", description="Which mirror symmetry to keep", items=SYMMETRY, default="auto"
    )


class BoxmorphSettings(SearchProperties, bpy.types.PropertyGroup):
    """Settings of the panel; one set in each scene."""

    frame_from: IntProperty(name="From Frame", description="Frame of the first keyframe", default=1)
    frame_to: IntProperty(name="To Frame", description="Frame of the second keyframe", default=60)
    alpha_from: FloatProperty(
        name="From Value",
        description="Slider value at the first frame: 0 is the object as it was, 1 the prompt, "
        "below 0 away from it",
        soft_min=-1.0,
        soft_max=2.0,
        default=0.0,
    )
    alpha_to: FloatProperty(
        name="To Value",
        description="Slider value at the second frame: 1 is the prompt, above 1 beyond it",
        soft_min=-1.0,
        soft_max=2.0,
        default=1.0,
    )


classes = (BoxmorphSettings,)


def register_scene():
    """Attach the settings to every scene."""
    bpy.types.Scene.boxmorph = PointerProperty(type=BoxmorphSettings)


def unregister_scene():
    """Take the settings off the scenes again."""
    del bpy.types.Scene.boxmorph
