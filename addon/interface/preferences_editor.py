# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension's page in Blender's preferences: which guide judges, what it runs on, where guides lie."""

import os
import sys
from contextlib import suppress

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.app.translations import pgettext_tip as tip_
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty

from ..core import engine, guides
from ..errors import Refusal, tells_refusals
from ..preferences import PACKAGE, RENDERERS, preferences
from ..sidebar import CONTEXT
from . import guide_copy_progress, guide_download
from .lines import draw_lines

#: Numbers of the choices of `guide` that are always there; the guides found are counted on from the last.
_EMBEDDED, _FOLDER, _FIRST_FOUND = range(3)

#: Blender keeps no reference to the texts of a list that is made while it asks.
_listed = []

#: Room for a letter beside the page's margins, in pixels.
LETTER = 8

_MAC, _WINDOWS = sys.platform == "darwin", sys.platform == "win32"

#: Execution providers of ONNX Runtime: name, title, what it runs on, number in files, whether it exists here.
_PROVIDERS = (
    ("cuda", "CUDA", "NVIDIA graphics cards", 2, not _MAC),
    ("directml", "DirectML", "Any graphics card under Windows", 3, _WINDOWS),
    ("coreml", "Core ML", "Apple's processors", 4, _MAC),
    ("migraphx", "MIGraphX", "AMD graphics cards", 5, not _MAC and not _WINDOWS),
    ("openvino", "OpenVINO", "Intel's graphics and processors", 6, not _MAC),
)
PROVIDERS = (
    (
        "auto",
        "Automatic",
        "The processor, so that results are the same everywhere; a large guide runs on the graphics card "
        "where an ONNX Runtime library of your own has one",
        0,
    ),
    ("cpu", "Processor", "The processor, by ONNX Runtime itself", 1),
    *(
        (*provider[:2], f"{provider[2]}, if the ONNX Runtime library has it", provider[3])
        for provider in _PROVIDERS
        if provider[4]
    ),
)


def _guide_items(_prefs, _context):
    _listed[:] = [
        ("EMBEDDED", "Embedded", "The small guide inside the extension: 249 names, offline, fast", _EMBEDDED),
        ("FOLDER", "Folder…", "A guide anywhere else on the disk", _FOLDER),
    ]
    for number, folder in enumerate(guides.found(), _FIRST_FOUND):
        name = os.path.basename(folder)
        _listed.append((f"FOUND:{name}", name, tip_("The guide in {}").format(folder), number))
    return _listed


def _get_guide(prefs):
    folder = engine.guide_folder()
    if prefs.guide_elsewhere:
        return _FOLDER
    if folder is None:
        return _EMBEDDED
    found = guides.found()
    return _FIRST_FOUND + found.index(folder) if folder in found else _FOLDER


def _set_guide(prefs, number):
    prefs.guide_elsewhere = number == _FOLDER
    if number == _EMBEDDED:
        prefs.guide_folder = ""
    elif number >= _FIRST_FOUND:
        prefs.guide_folder = guides.found()[number - _FIRST_FOUND]


def _check(_prefs, _context):
    """Open the guide that has just been chosen, so that what is wrong with it is said at once."""
    with suppress(Refusal):
        engine.open_guide()


class BoxmorphPreferences(bpy.types.AddonPreferences):
    """Preferences of the extension, kept per user."""

    bl_idname = PACKAGE

    # A view of `guide_folder`, which alone is kept: a number would mean another guide when one is gone.
    guide: EnumProperty(
        name="Guide",
        description="The text–image model that judges. Change it for what the embedded one does not know",
        items=_guide_items,
        get=_get_guide,
        set=_set_guide,
        translation_context=CONTEXT,
    )
    guide_elsewhere: BoolProperty(options={"HIDDEN"})
    guide_folder: StringProperty(
        name="Guide Folder",
        description="Folder of a guide (ONNX files, tokenizer and configuration). Empty: the embedded guide",
        subtype="DIR_PATH",
        update=_check,
    )
    guide_precision: StringProperty(options={"HIDDEN"})
    guides_folder: StringProperty(
        name="Guides Folder",
        description="Folder whose sub-folders are offered as guides. Empty: one beside Blender's settings. "
        "Name another to keep large guides on another disk",
        subtype="DIR_PATH",
    )
    show_downloads: BoolProperty(
        name="Get a Guide",
        description="Show the guides that can be downloaded, for prompts that the embedded one does not know",
        default=False,
    )
    hub_endpoint: StringProperty(
        name="Hub Address",
        description="Where guides are downloaded from: the address of a mirror of the Hugging Face hub. "
        "Empty: the hub itself, or what the variable HF_ENDPOINT names",
    )
    runtime_library: StringProperty(
        name="ONNX Runtime",
        description="A library of ONNX Runtime of your own, for a graphics card. Empty: the one inside the "
        "extension. Read when Blender first uses a guide",
        subtype="FILE_PATH",
    )
    provider: EnumProperty(
        name="Provider",
        description="What the guide encodes images on. Change it where a large guide is slow and your ONNX "
        "Runtime library has something faster. Scores then differ in the last digits",
        items=PROVIDERS,
        default="auto",
        update=_check,
    )
    renderer: EnumProperty(
        name="Renderer",
        description="What renders the views that the guide sees. Change it where a driver makes trouble",
        items=RENDERERS,
        default="auto",
    )
    threads: IntProperty(
        name="Threads",
        description="Processor threads that a search may use; 0 means all. Lower it to work on meanwhile. "
        "Read when Blender first searches",
        min=0,
        max=256,
        default=0,
    )

    def draw(self, context):
        layout = self.layout
        letters = max(40, int(context.region.width / (LETTER * context.preferences.system.ui_scale)))
        layout.use_property_split = True
        layout.use_property_decorate = False
        self._draw_guide(layout.box(), letters)
        self._draw_runtime(layout.box(), letters)
        box = layout.box()
        box.label(text="Something Is Wrong?", icon="QUESTION")
        row = box.row()
        row.operator("boxmorph.copy_report", icon="COPYDOWN")
        row.operator("boxmorph.copy_report", text="Report as Text", icon="TEXT").as_text = True

    def _draw_guide(self, box, letters):
        box.label(text="Guide", text_ctxt=CONTEXT, icon="VIEWZOOM")
        box.prop(self, "guide")
        if self.guide == "FOLDER":
            box.prop(self, "guide_folder")
        # Above the lines, which come and go.
        guide_copy_progress.draw(box)
        draw_lines(box, guide_lines(iface_) + guide_copy_progress.lines(iface_), letters)
        box.separator()
        box.prop(self, "guides_folder")
        found = guides.found()
        count = iface_("1 folder" if len(found) == 1 else "{} folders").format(len(found))
        total = guides.megabytes(sum(map(guides.size, found)))
        kept = iface_("{count} in it, {size}. Else only your last prompts are kept")
        row = box.row()
        row.label(text=kept.format(count=count, size=total))
        row.operator("boxmorph.open_guides_folder", icon="FOLDER_REDIRECT")
        guide_download.draw(box, self, letters)

    def _draw_runtime(self, box, letters):
        box.label(text="What It Runs On", icon="MEMORY")
        box.prop(self, "runtime_library")
        box.prop(self, "provider")
        draw_lines(box, runtime_lines(iface_), letters)
        box.prop(self, "threads")
        box.prop(self, "renderer")


def guide_lines(say=str):
    """Return lines with icons on the chosen guide: what it is, or why it does not open; in English, unless
    `say` translates.
    """
    guide, why = engine.known_guide()
    if why is not None:
        return [(why.said(say), "ERROR")]
    if guide is None:
        return [(say("Not opened yet"), "INFO")]
    known = say("{} names").format(len(guide.classes)) if guide.classes else say("any words")
    folder = engine.guide_folder()
    size = say("inside the extension") if folder is None else guides.megabytes(guides.size(folder))
    what = say("“{name}” knows {known}, sees images of {pixels} pixels")
    return [
        (what.format(name=guide.name, known=known, pixels=guide.image_size), "CHECKMARK"),
        (f"{size}, {guide.precision}, sha256 {guide.sha256[:12]}", "BLANK1"),
    ]


def runtime_lines(say=str):
    """Return lines with icons on ONNX Runtime, as far as a guide has opened it: version, what it offers, and
    why what was asked for is not used; in English, unless `say` translates.
    """
    guide, _why = engine.known_guide()
    if guide is None:
        return []
    boxmorph = engine.library()
    titles = {item[0]: say(item[1]) for item in PROVIDERS}
    offered = ", ".join(titles.get(name, name) for name in boxmorph.execution_providers())
    used = titles.get(guide.provider, guide.provider)
    what = say("ONNX Runtime {version} offers: {offered}. In use: {used}")
    lines = [(what.format(version=boxmorph.runtime_version(), offered=offered, used=used), "INFO")]
    named = preferences().runtime_library.strip()
    if named and guides.absolute(named) != str(boxmorph.runtime_library()):
        lines.append((say("The library named above is used once Blender starts again"), "INFO"))
    if guide.provider_note is not None:
        lines.append((engine.capitalised(guide.provider_note), "ERROR"))
    return lines


class BOXMORPH_OT_check_guide(bpy.types.Operator):
    """Open the chosen guide again, and say what it is or why it cannot be used"""

    bl_idname = "boxmorph.check_guide"
    bl_label = "Check Guide"
    bl_options = {"INTERNAL"}

    @tells_refusals
    def execute(self, _context):
        engine.open_guide(again=True)
        self.report({"INFO"}, ". ".join(line for line, _icon in guide_lines(rpt_)))
        return {"FINISHED"}


class BOXMORPH_OT_open_guides_folder(bpy.types.Operator):
    """Show the guides folder in the file manager, to put guides into it or delete them. Guides and
    your last prompts are all that Boxmorph keeps on the disk; it caches nothing
    """

    bl_idname = "boxmorph.open_guides_folder"
    bl_label = "Open Guides Folder"
    bl_options = {"INTERNAL"}

    @tells_refusals
    def execute(self, _context):
        folder = guides.root()
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise Refusal(
                "The folder {folder} cannot be made ({reason}). Name another",
                folder=folder,
                reason=error.strerror,
            ) from error
        return bpy.ops.wm.path_open(filepath=folder)


classes = (BoxmorphPreferences, BOXMORPH_OT_check_guide, BOXMORPH_OT_open_guides_folder)
