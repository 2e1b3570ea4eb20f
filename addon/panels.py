# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar tab "Boxmorph": prompt, button, progress, outcomes, keyframes, views, settings of the
search.
"""

import bpy

from . import engine, score_curve, shape_key, spanning
from .images import VIEWS_IMAGE
from .preferences import preferences
from .progress import progress_parts
from .search_operators import running_progress


class _Sidebar:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Boxmorph"


class BOXMORPH_PT_main(_Sidebar, bpy.types.Panel):
    bl_label = "Boxmorph"

    def draw(self, context):
        layout = self.layout
        settings = context.scene.boxmorph
        progress = running_progress()
        row = layout.row()
        row.enabled = progress is None
        row.prop(settings, "prompt", text="", placeholder="a bar stool")
        if progress is not None:
            _draw_progress(layout, progress)
            return
        row = layout.row()
        row.scale_y = 1.4
        row.operator("boxmorph.deform", icon="MOD_SIMPLEDEFORM")
        row = layout.row(align=True)
        row.prop(settings, "preset", text="")
        row.prop(settings, "seed")


def _draw_progress(layout, progress):
    phase, done, left = progress_parts(progress)
    row = layout.row()
    row.scale_y = 1.4
    row.progress(factor=min(max(progress["fraction"], 0.0), 1.0), type="BAR", text=phase)
    column = layout.column(align=True)
    column.label(text=done)
    column.label(text=left)
    layout.operator("boxmorph.cancel", icon="CANCEL")


def _outcomes(context):
    obj = context.active_object
    return [] if obj is None or obj.type != "MESH" else shape_key.outcomes(obj.data)


class BOXMORPH_PT_outcomes(_Sidebar, bpy.types.Panel):
    bl_label = "Outcomes"
    bl_parent_id = "BOXMORPH_PT_main"

    @classmethod
    def poll(cls, context):
        return running_progress() is None and bool(_outcomes(context))

    def draw(self, context):
        layout = self.layout
        settings = context.scene.boxmorph
        reports = shape_key.records(context.active_object.data)
        for key in _outcomes(context):
            row = layout.row(align=True)
            row.prop(key, "value", text=key.name, slider=True)
            row.operator("boxmorph.keyframe_spectrum", text="", icon="KEYINGSET").key = key.name
            row.operator("boxmorph.remove_outcome", text="", icon="X").key = key.name
            row.context_pointer_set("boxmorph_outcome", key)
            row.menu("BOXMORPH_MT_outcome", text="", icon="DOWNARROW_HLT")
            curve = score_curve.text(reports[key.name])
            if curve is not None:
                layout.label(text=curve)
            _draw_pieces(layout, key)
        column = layout.column(align=True)
        row = column.row(align=True)
        row.prop(settings, "frame_from", text="Frame")
        row.prop(settings, "frame_to", text="to")
        row = column.row(align=True)
        row.prop(settings, "alpha_from", text="Value")
        row.prop(settings, "alpha_to", text="to")
        row = column.row(align=True)
        row.prop(settings, "timing", text="")
        row.operator("boxmorph.measure_scores", text="", icon="GRAPH")
        layout.operator("boxmorph.keyframe_spectrum", icon="KEYINGSET")


def _draw_pieces(layout, outcome):
    """Draw the sliders of what an outcome was taken apart into, if it was."""
    pieces = shape_key.pieces(outcome.id_data.user, outcome.name)
    if not pieces:
        return
    header, body = layout.panel(f"boxmorph_pieces_{outcome.name}")
    header.label(text=f"Taken apart: {len(pieces)} pieces")
    if body is not None:
        column = body.column(align=True)
        for key in pieces:
            column.prop(key, "value", text=key.name.rpartition(": ")[2], slider=True)


class BOXMORPH_MT_outcome(bpy.types.Menu):
    """More to do with an outcome"""

    bl_label = "Outcome"

    def draw(self, context):
        layout = self.layout
        key = context.boxmorph_outcome
        apart = shape_key.is_apart(key.id_data.user, key.name)
        kind = "put_together" if apart else "take_apart"
        layout.operator(f"boxmorph.{kind}", icon="MOD_BUILD").key = key.name
        layout.operator("boxmorph.apply_as_new", icon="DUPLICATE").key = key.name


class BOXMORPH_PT_parts(_Sidebar, bpy.types.Panel):
    bl_label = "Parts"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        obj = context.active_object
        return running_progress() is None and obj is not None and obj.type == "MESH"

    def draw(self, context):
        layout = self.layout
        settings = context.scene.boxmorph
        kept = context.active_object.boxmorph
        layout.prop(settings, "parts_collection")
        row = layout.row(align=True)
        row.operator(
            "boxmorph.find_parts", icon="MESH_CUBE", text="Find Again" if kept.items else "Find Parts"
        )
        if not kept.items:
            return
        row.prop(settings, "show_parts", text="", icon="HIDE_OFF" if settings.show_parts else "HIDE_ON")
        row.operator("boxmorph.forget_parts", text="", icon="X")
        layout.template_list("BOXMORPH_UL_parts", "", kept, "items", kept, "active", rows=3)
        if kept.coarse:
            _name, report = shape_key.meant_outcome(context.active_object)
            column = layout.column(align=True)
            for clause in spanning.clauses(kept.coarse, report.get("worst_shear")):
                column.label(text=engine.capitalised(clause), icon="INFO")
            layout.operator("boxmorph.refine", icon="MOD_BEVEL")


class BOXMORPH_PT_views(_Sidebar, bpy.types.Panel):
    bl_label = "Views"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, _context):
        layout = self.layout
        layout.operator("boxmorph.show_views", icon="RENDER_RESULT")
        image = bpy.data.images.get(VIEWS_IMAGE)
        if image is not None and image.preview is not None:
            layout.template_icon(icon_value=image.preview.icon_id, scale=9.0)


class BOXMORPH_PT_search(_Sidebar, bpy.types.Panel):
    bl_label = "Search"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.boxmorph
        layout.prop(settings, "splits")
        layout.prop(settings, "symmetry")
        layout.prop(settings, "keep_size")
        column = layout.column(align=True)
        column.prop(settings, "least_scale")
        column.prop(settings, "greatest_scale")
        layout.prop(settings, "shift_parts")
        layout.prop(preferences(), "renderer")


classes = (
    BOXMORPH_PT_main,
    BOXMORPH_PT_outcomes,
    BOXMORPH_MT_outcome,
    BOXMORPH_PT_parts,
    BOXMORPH_PT_views,
    BOXMORPH_PT_search,
)
