# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators that bring guides to the disk and take them away again."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.app.translations import pgettext_tip as tip_
from bpy.props import BoolProperty, EnumProperty, StringProperty

from ..core import guide_downloads, guides
from ..core.guide_downloads import PRECISIONS
from ..errors import Refusal, tell, tells_refusals
from ..preferences import preferences

#: Blender keeps no reference to the texts of a list that is made while it asks.
_listed = []


def _precision_items(operator, _context):
    known = PRECISIONS
    try:
        if operator is not None:
            known = guide_downloads.entry(operator.guide)["precisions"]
    except Refusal:
        pass
    _listed[:] = [(name, *PRECISIONS[name], list(PRECISIONS).index(name)) for name in known]
    return _listed


class _OfGuide:
    """The guide and the precision that an operator is about (a mixin)."""

    guide: StringProperty(options={"HIDDEN", "SKIP_SAVE"})
    precision: EnumProperty(
        name="Precision",
        description="How exactly the guide's numbers are kept",
        items=_precision_items,
        options={"SKIP_SAVE"},
    )


class BOXMORPH_OT_download_guide(_OfGuide, bpy.types.Operator):
    """Download this guide from the hub, after a look at its size and licence. What has come stays if it is
    cancelled, and the next download goes on from there
    """

    bl_idname = "boxmorph.download_guide"
    bl_label = "Download Guide"
    bl_options = {"INTERNAL"}

    resume: BoolProperty(options={"HIDDEN", "SKIP_SAVE"})

    @classmethod
    def poll(cls, _context):
        refusal = guide_downloads.online_refusal()
        if refusal is not None:
            cls.poll_message_set(refusal.said(tip_))
        elif guide_downloads.state.download is not None:
            cls.poll_message_set(tip_("A guide is being downloaded. Wait for it, or cancel it first"))
        else:
            return True
        return False

    def invoke(self, context, _event):
        if self.resume:
            return self.execute(context)
        try:
            title = guide_downloads.entry(self.guide)["title"]
        except Refusal as refusal:
            return tell(self, refusal)
        return context.window_manager.invoke_props_dialog(
            self, width=420, title=title, confirm_text=iface_("Download")
        )

    def draw(self, _context):
        entry = guide_downloads.entry(self.guide)
        details = entry["precisions"][self.precision]
        hub = preferences().hub_endpoint.strip() or iface_("on the hub")
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.label(text=iface_(entry["good_for"]), translate=False)
        layout.prop(self, "precision")
        column = layout.column(align=True)
        column.label(text=iface_(PRECISIONS[self.precision][1]), icon="BLANK1", translate=False)
        lines = [
            (iface_("Size: about {}").format(guides.megabytes(details["bytes"])), "DISK_DRIVE"),
            (iface_("Licence of its weights: {}").format(entry["licence"]), "TEXT"),
            (iface_("From {repository}, {hub}").format(repository=entry["repository"], hub=hub), "URL"),
            (iface_("Into {}").format(guides.root()), "FILE_FOLDER"),
        ]
        if not details["verified"]:
            lines.append((iface_("Unverified: we could not check the names of its files"), "ERROR"))
        if details["note"]:
            lines.append((iface_(details["note"]), "ERROR"))
        for line, icon in lines:
            column.label(text=line, icon=icon, translate=False)

    @tells_refusals
    def execute(self, _context):
        guide_downloads.start(self.guide, self.precision)
        if bpy.app.background:
            guide_downloads.choose(guide_downloads.wait(), self.precision)
            self.report({"INFO"}, rpt_("Downloaded {}").format(self.guide))
        else:
            guide_downloads.watch()
        return {"FINISHED"}


class BOXMORPH_OT_cancel_guide(bpy.types.Operator):
    """Stop the download. What has come is kept, and the next download goes on from there"""

    bl_idname = "boxmorph.cancel_guide"
    bl_label = "Cancel Download"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        return guide_downloads.state.download is not None

    def execute(self, _context):
        guide_downloads.cancel()
        return {"FINISHED"}


class BOXMORPH_OT_use_guide(_OfGuide, bpy.types.Operator):
    """Let this guide judge from now on"""

    bl_idname = "boxmorph.use_guide"
    bl_label = "Use Guide"
    bl_options = {"INTERNAL"}

    @tells_refusals
    def execute(self, _context):
        path = guide_downloads.presence(self.guide, self.precision)["path"]
        if path is None:
            raise Refusal("The guide “{name}” is not here. Download it first", name=self.guide)
        guide_downloads.choose(path, self.precision)
        return {"FINISHED"}


class BOXMORPH_OT_remove_guide(_OfGuide, bpy.types.Operator):
    """Delete this guide from the disk, or what an unfinished download of it has left"""

    bl_idname = "boxmorph.remove_guide"
    bl_label = "Remove Guide"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        if guide_downloads.state.download is not None:
            cls.poll_message_set(tip_("A guide is being downloaded. Wait for it, or cancel it first"))
            return False
        return True

    def invoke(self, context, event):
        try:
            title = guide_downloads.entry(self.guide)["title"]
            here = guide_downloads.bytes_here(self.guide, self.precision)
        except Refusal as refusal:
            return tell(self, refusal)
        message = iface_("{title}, {precision}, {size}. It can be downloaded again")
        return context.window_manager.invoke_confirm(
            self,
            event,
            title=iface_("Remove Guide", "Operator"),
            message=message.format(title=title, precision=self.precision, size=guides.megabytes(here)),
            confirm_text=iface_("Remove"),
        )

    @tells_refusals
    def execute(self, _context):
        guide_downloads.remove(self.guide, self.precision)
        return {"FINISHED"}


classes = (
    BOXMORPH_OT_download_guide,
    BOXMORPH_OT_cancel_guide,
    BOXMORPH_OT_use_guide,
    BOXMORPH_OT_remove_guide,
)
