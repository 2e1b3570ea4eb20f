# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the parts of the active object, and their list in the panel."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.props import IntProperty

from ..core import mesh_io
from ..errors import tells_refusals
from ..part_boxes import parts, refine
from ..redraw import redraw_viewports


class BOXMORPH_OT_find_parts(bpy.types.Operator):
    """Split the active object into parts, to see them and to lock what must not change"""

    bl_idname = "boxmorph.find_parts"
    bl_label = "Find Parts"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        settings = context.scene.boxmorph
        parts.find(
            context.active_object, context, settings.splits, settings.symmetry, settings.parts_collection
        )
        settings.show_parts = True
        return {"FINISHED"}


class BOXMORPH_OT_forget_parts(bpy.types.Operator):
    """Forget the parts of the active object and their locks, so that the search splits it as it likes"""

    bl_idname = "boxmorph.forget_parts"
    bl_label = "Forget Parts"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        parts.forget(mesh_io.own_mesh(context.active_object))
        redraw_viewports()
        return {"FINISHED"}


class BOXMORPH_OT_lock_part(bpy.types.Operator):
    """Keep the part's size on all axes in searches from now on, or unlock it again"""

    bl_idname = "boxmorph.lock_part"
    bl_label = "Lock Part"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(options={"HIDDEN"})

    @tells_refusals
    def execute(self, context):
        part = mesh_io.own_mesh(context.active_object).boxmorph.items[self.index]
        part.lock = (not all(part.lock),) * 3
        return {"FINISHED"}


class BOXMORPH_OT_refine(bpy.types.Operator):
    """Cut the faces of the active object that span two parts, close to the boundary on either side, so that
    they need not shear. UVs, materials and shape keys stay
    """

    bl_idname = "boxmorph.refine"
    bl_label = "Refine at Part Boundaries"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj = context.active_object
        settings = context.scene.boxmorph
        added = refine.refine(obj)
        parts.find(obj, context, settings.splits, settings.symmetry, settings.parts_collection)
        done = rpt_("{} faces added" if added else "No face spans a boundary; nothing was cut")
        self.report({"INFO"}, done.format(added))
        return {"FINISHED"}


class BOXMORPH_UL_parts(bpy.types.UIList):
    """One line a part: color, name, locks of its axes, lock of the whole."""

    def draw_item(self, _context, layout, _data, item, _icon, _active_data, _property, index=0):
        row = layout.row(align=True)
        color = row.row()
        color.scale_x = 0.35
        color.prop(item, "color", text="")
        row.prop(item, "name", text="", emboss=False)
        axes = row.row(align=True)
        axes.scale_x = 0.3
        for axis in range(3):
            axes.prop(item, "lock", index=axis, text="XYZ"[axis], toggle=True)
        icon = "LOCKED" if all(item.lock) else "UNLOCKED"
        row.operator("boxmorph.lock_part", text="", icon=icon, emboss=False).index = index


classes = (
    BOXMORPH_OT_find_parts,
    BOXMORPH_OT_forget_parts,
    BOXMORPH_OT_lock_part,
    BOXMORPH_OT_refine,
)
if not parts.OLD_MODULE:
    classes = (*classes, BOXMORPH_UL_parts)
