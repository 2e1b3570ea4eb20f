# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators that make a smaller copy of a guide."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.app.translations import pgettext_tip as tip_

from ..core import engine, guide_copies
from ..errors import tells_refusals
from ..preferences import preferences


class BOXMORPH_OT_quantize_guide(bpy.types.Operator):
    """Make a copy of the chosen guide whose image network calculates in eight bits, measure how far it agrees
    with the exact one, and choose it. Good for drafts; the exact guide stays
    """

    bl_idname = "boxmorph.quantize_guide"
    bl_label = "Make 8-Bit Copy"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        if engine.guide_folder() is None:
            cls.poll_message_set(tip_("The embedded guide is fast as it is. Choose a large one first"))
            return False
        if guide_copies.state.work is not None:
            cls.poll_message_set(tip_("A copy is being made. Wait for it, or cancel it first"))
            return False
        return True

    def invoke(self, context, event):
        return context.window_manager.invoke_confirm(
            self,
            event,
            title=iface_("Make 8-Bit Copy", "Operator"),
            message=iface_("It takes about a minute for a large guide; you can work on meanwhile"),
            confirm_text=iface_("Make Copy"),
        )

    @tells_refusals
    def execute(self, _context):
        guide_copies.start(engine.guide_folder())
        if bpy.app.background:
            folder, figures = guide_copies.wait()
            preferences().guide_folder = folder
            self.report({"INFO"}, guide_copies.summary(figures, rpt_))
        else:
            guide_copies.watch()
        return {"FINISHED"}


class BOXMORPH_OT_cancel_guide_copy(bpy.types.Operator):
    """Stop making the copy. Nothing of it is left"""

    bl_idname = "boxmorph.cancel_guide_copy"
    bl_label = "Cancel Copy"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        return guide_copies.state.work is not None

    def execute(self, _context):
        guide_copies.cancel()
        return {"FINISHED"}


classes = (BOXMORPH_OT_quantize_guide, BOXMORPH_OT_cancel_guide_copy)
