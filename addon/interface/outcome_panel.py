# SPDX-License-Identifier: GPL-3.0-or-later
"""The outcomes of the active object in the sidebar: a list to choose from, the slider of the chosen one, what
else can be done with it, and its keyframes.
"""

import bpy
from bpy.app.translations import pgettext_iface as iface_

from ..outcomes import animation_curves, mix, score_curve, shape_key
from ..searching import running
from ..sidebar import Sidebar


class BOXMORPH_UL_outcomes(bpy.types.UIList):
    """The outcomes among the shape keys of an object"""

    def draw_item(self, _context, layout, _keys, key, _icon, _active, _property):
        report = shape_key.records(key.id_data.user).get(key.name, {})
        row = layout.row(align=True)
        row.prop(key, "name", text="", emboss=False)
        side = row.row(align=True)
        side.alignment = "RIGHT"
        side.active = key.value != 0.0 and not key.mute
        side.label(text=f"{report.get('score_after', 0.0):.2f}", translate=False)
        side.prop(key, "value", text="", emboss=False)

    def filter_items(self, _context, keys, _property):
        records = shape_key.records(keys.user)
        shown = [self.bitflag_filter_item if key.name in records else 0 for key in keys.key_blocks]
        return shown, []


class BOXMORPH_PT_outcomes(Sidebar, bpy.types.Panel):
    bl_label = "Outcomes"
    bl_parent_id = "BOXMORPH_PT_main"

    @classmethod
    def poll(cls, context):
        obj = context.active_object
        usable = running.running.search is None and obj is not None and obj.type == "MESH"
        return usable and bool(shape_key.records(obj.data))

    def draw(self, context):
        layout = self.layout
        obj = context.active_object
        records = shape_key.records(obj.data)
        name, report = shape_key.meant_outcome(obj)
        keys = obj.data.shape_keys
        key = keys.key_blocks[name]
        if len(records) > 1:
            rows = min(len(records), 6)
            layout.template_list(
                "BOXMORPH_UL_outcomes",
                *("", keys, "key_blocks", obj, "active_shape_key_index"),
                rows=rows,
                maxrows=rows,
                sort_lock=True,
            )
            _draw_mix(layout, obj)
        row = layout.row(align=True)
        row.prop(key, "value", text=name, translate=False, slider=True)
        row.prop_decorator(key, "value")
        row.context_pointer_set("boxmorph_outcome", key)
        row.menu("BOXMORPH_MT_outcome", text="", icon="DOWNARROW_HLT")
        _draw_ends(layout, key, report)
        _draw_pieces(layout, key)
        _draw_keyframes(layout, context.scene.boxmorph)


def _draw_mix(layout, obj):
    """Draw what is done with several outcomes, and whether they are too much together."""
    row = layout.row(align=True)
    row.operator("boxmorph.mix_outcomes", icon="ARROW_LEFTRIGHT")
    row.operator("boxmorph.keyframe_mix", text="", icon="KEYINGSET")
    if mix.room(obj) is not None:
        row = layout.row()
        row.alert = True
        row.label(text="Together, a part gets too thin", icon="ERROR")


def _draw_ends(layout, key, report):
    """Draw what lies at the ends of the slider, and the scores along it where they are known."""
    row = layout.row()
    row.active = False
    row.label(text=iface_("{:.1f} away").format(key.slider_min))
    middle = row.row()
    middle.alignment = "CENTER"
    middle.label(text=f"{report['score_before']:.2f} → {report['score_after']:.2f}", translate=False)
    end = row.row()
    end.alignment = "RIGHT"
    end.label(text=iface_("beyond {:.1f}").format(key.slider_max))
    curve = score_curve.text(report)
    if curve is not None:
        layout.label(text=curve, translate=False)


def _draw_pieces(layout, outcome):
    """Draw the sliders of what an outcome was taken apart into, if it was."""
    pieces = shape_key.pieces(outcome.id_data.user, outcome.name)
    if not pieces:
        return
    header, body = layout.panel(f"boxmorph_pieces_{outcome.name}")
    header.label(text=iface_("Taken apart: {} pieces").format(len(pieces)))
    if body is not None:
        column = body.column(align=True)
        for key in pieces:
            column.prop(key, "value", text=key.name.rpartition(": ")[2], translate=False, slider=True)


def _draw_keyframes(layout, settings):
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


class BOXMORPH_MT_outcome(bpy.types.Menu):
    """More to do with an outcome"""

    bl_label = "Outcome"

    def draw(self, context):
        layout = self.layout
        key = context.boxmorph_outcome
        layout.operator("boxmorph.show_outcome", icon="HIDE_OFF").key = key.name
        layout.separator()
        layout.operator("boxmorph.search_again", icon="FILE_REFRESH").key = key.name
        layout.operator("boxmorph.variations", icon="PRESET").key = key.name
        layout.separator()
        apart = shape_key.is_apart(key.id_data.user, key.name)
        kind = "put_together" if apart else "take_apart"
        layout.operator(f"boxmorph.{kind}", icon="MOD_BUILD").key = key.name
        row = layout.row()
        row.enabled = not animation_curves.is_animated(key)
        row.operator("boxmorph.add_control", icon="DRIVER").key = key.name
        layout.operator("boxmorph.apply_as_new", icon="DUPLICATE").key = key.name
        layout.operator("boxmorph.evaluate", icon="INFO").key = key.name
        layout.operator("boxmorph.evaluate_all", icon="SPREADSHEET")
        layout.separator()
        layout.operator("boxmorph.remove_outcome", icon="X").key = key.name


classes = (BOXMORPH_UL_outcomes, BOXMORPH_PT_outcomes, BOXMORPH_MT_outcome)
