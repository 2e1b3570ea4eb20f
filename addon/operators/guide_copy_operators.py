# SPDX-License-Identifier: GPL-3.0-or-later
"""The operator that makes a smaller copy of a guide."""

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
        return True

    def invoke(self, context, event):
        return context.window_manager.invoke_confirm(
            self,
            event,
            title=iface_("Make 8-Bit Copy", "Operator"),
            message=iface_("Blender waits for it, about a minute for a large guide"),
            confirm_text=iface_("Make Copy"),
        )

    @tells_refusals
    def execute(self, context):
        if context.window is not None:
            context.window.cursor_set("WAIT")
        try:
            folder, figures = guide_copies.eight_bit_copy(engine.guide_folder())
        finally:
            if context.window is not None:
                context.window.cursor_set("DEFAULT")
        preferences().guide_folder = folder
        self.report({"INFO"}, guide_copies.summary(figures, rpt_))
        return {"FINISHED"}


classes = (BOXMORPH_OT_quantize_guide,)
