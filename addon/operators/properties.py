# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panel asks for, kept in the scene: prompt, preset, seed, search and keyframe settings."""

from contextlib import suppress

import bpy
from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from ..errors import Refusal
from ..outcomes.keyframes import TIMINGS
from ..part_boxes import parts
from ..searching.suggestions import suggest
from ..sidebar import CONTEXT

PRESETS = (
    ("draft", "Draft", "A first look, in a third of the time of Standard"),
    ("standard", "Standard", "A good outcome in seconds"),
    ("best", "Best", "Looks at more beginnings and goes on for longer, five times the time of Standard"),
    ("time", "Time", "The best that can be found in the seconds that you give it"),
    ("paper", "Paper", "The published protocol, step by step. Much slower, to compare with"),
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
    ("xy", "X and Y", "Keep left and right alike, and front and back"),
)
TEMPLATES = (
    ("auto", "Automatic", "As photo and as rendering for a guide that knows any words; as typed for others"),
    ("on", "On", "Read every text as a photo, a rendering and a grey 3D model of it, and take the mean"),
    ("off", "Off", "Read every text as it is typed"),
)
KEEP_SIZE = (
    ("auto", "Automatic", "Keep the diagonal of the bounding box; where parts are locked, keep their size"),
    ("diagonal", "Diagonal", "Keep the diagonal of the bounding box"),
    ("height", "Height", "Keep the height"),
    ("footprint", "Footprint", "Keep the diagonal of the rectangle on the floor"),
    ("off", "Off", "Leave the size as the search finds it"),
)


def _splits(**options):
    return EnumProperty(
        name="Splits",
        description="How finely to split the object into parts. Raise it where what should change is no part "
        "of its own, lower it where parts are slivers",
        items=SPLITS,
        default="auto",
        **options,
    )


def _symmetry(**options):
    return EnumProperty(
        name="Symmetry",
        description="Which mirror symmetry to keep. Choose None where the two sides may come to differ",
        items=SYMMETRY,
        default="auto",
        **options,
    )


def timing():
    """Return the property that chooses the timing of keyframes."""
    return EnumProperty(
        name="Timing",
        description="How the outcome comes about between the two frames. Choose another where it starts "
        "or ends too suddenly",
        items=TIMINGS,
        default="linear",
    )


def _find_again(settings, context):
    """Show the parts of new settings at once, if parts are shown."""
    obj = context.active_object
    if obj is None or not obj.boxmorph.items:
        return
    with suppress(Refusal):
        parts.find(obj, context, settings.splits, settings.symmetry, settings.parts_collection)


_LIVE = {} if parts.OLD_MODULE else {"update": _find_again}


class SearchProperties:
    """The properties that the panel and the operator share (a mixin for registered classes)."""

    prompt: StringProperty(
        name="Prompt",
        description="What the object should become, in a few words, such as: a bar stool. Names that the "
        "guide knows are suggested. Something between several: a bar stool:1, a throne:0.3",
        search=suggest,
        search_options={"SUGGESTION"},
    )
    negative: StringProperty(
        name="Not",
        description="What the object should not look like, such as: a bench. For results that could be "
        "taken for something else. Counts half as much as the prompt; as much as you say with: a bench:0.8",
        search=suggest,
        search_options={"SUGGESTION"},
    )
    source: StringProperty(
        name="From",
        description="What the object is now, such as: a chair. What it shares with the prompt then does not "
        "count, only the way from one to the other. For changes that are too mild",
        search=suggest,
        search_options={"SUGGESTION"},
    )
    templates: EnumProperty(
        name="Templates",
        description="How the guide reads the texts. CLIP and its kin judge best by captions of pictures, "
        "the embedded guide by bare names",
        items=TEMPLATES,
        default="auto",
    )
    preset: EnumProperty(
        name="Preset",
        description="How thoroughly to search. Draft to try prompts out, Best for what is to be kept",
        items=PRESETS,
        default="standard",
        translation_context=CONTEXT,
    )
    seconds: FloatProperty(
        name="Seconds",
        description="How long to search, with the preset Time. What is found depends on how fast this "
        "machine is; the record says what repeats it elsewhere",
        min=1.0,
        soft_max=60.0,
        max=3600.0,
        default=20.0,
        precision=0,
        step=100,
    )
    seed: IntProperty(
        name="Seed",
        description="Change it where a result does not please: another seed gives another result, "
        "the same seed the same one again",
        min=0,
        default=0,
    )
    splits: _splits()
    symmetry: _symmetry()
    keep_size: EnumProperty(
        name="Keep",
        description="Which size of the object the result keeps. Choose one where it must fit: Height for "
        "what stands under something, Footprint for what has its place on the floor",
        items=KEEP_SIZE,
        default="auto",
    )
    least_scale: FloatProperty(
        name="Least Scale",
        description="No part gets smaller than this share of its size, before the size of the whole is kept. "
        "Raise it where parts come out too thin",
        min=0.05,
        max=1.0,
        default=0.3,
    )
    greatest_scale: FloatProperty(
        name="Greatest",
        description="No part gets larger than this many times its size, before the size of the whole is "
        "kept. Lower it to stay near the object, raise it for what is far from it",
        min=1.0,
        max=10.0,
        default=3.1,
    )
    shift_parts: BoolProperty(
        name="Shift Parts",
        description="Let parts also slide over those they hang on: legs outwards, wings back. "
        "More can be reached, and the search is less sure to find it",
        default=False,
    )
    variations: IntProperty(
        name="Variations",
        description="How many outcomes to make: the best, and others that are nearly as good and look "
        "different. Each takes about a third as long again",
        min=1,
        max=8,
        default=1,
    )


class BoxmorphSettings(SearchProperties, bpy.types.PropertyGroup):
    """Settings of the panel; one set in each scene."""

    splits: _splits(**_LIVE)
    symmetry: _symmetry(**_LIVE)
    parts_collection: PointerProperty(
        name="Boxes",
        description="A collection of cubes that stand around the parts, to be used as they are; "
        "empty: the parts are found. For an object that is split otherwise than you would",
        type=bpy.types.Collection,
        **_LIVE,
    )
    show_parts: BoolProperty(
        name="Show Parts",
        description="Draw the parts of the active object as boxes, joined where they hang together",
        default=True,
    )

    frame_from: IntProperty(
        name="From Frame", description="Frame of the first keyframe: the animation starts here", default=1
    )
    frame_to: IntProperty(
        name="To Frame", description="Frame of the last keyframe: the animation ends here", default=60
    )
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
    timing: timing()


classes = (BoxmorphSettings,)


def register_scene():
    """Attach the settings to every scene."""
    bpy.types.Scene.boxmorph = PointerProperty(type=BoxmorphSettings)


def unregister_scene():
    """Take the settings off the scenes again."""
    del bpy.types.Scene.boxmorph
