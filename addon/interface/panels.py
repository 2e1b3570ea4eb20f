# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar tab "Boxmorph": prompt, button and progress; folded, the parts, the views, the settings of the
search. Its outcomes are in `outcome_panel`.
"""

import bpy
from bpy.app.translations import pgettext_iface as iface_

from ..core import engine
from ..core.images import VIEWS_IMAGE
from ..outcomes import shape_key, wordings
from ..part_boxes import spanning
from ..preferences import PACKAGE, preferences
from ..searching import history, running
from ..searching.progress import progress_parts
from ..sidebar import Sidebar
from . import preferences_editor, setting_presets


class BOXMORPH_PT_main(Sidebar, bpy.types.Panel):
    bl_label = "Boxmorph"

    def draw(self, context):
        layout = self.layout
        settings = context.scene.boxmorph
        row = layout.row(align=True)
        row.prop(settings, "prompt", text="", placeholder="a bar stool")
        if history.recent():
            row.menu("BOXMORPH_MT_prompts", text="", icon="RECOVER_LAST")
        _draw_button(layout, context)
        row = layout.row(align=True)
        row.prop(settings, "preset", text="")
        row.prop(settings, "seed")
        if settings.preset == "time":
            layout.prop(settings, "seconds")
        if running.running.search is not None:
            _draw_progress(layout.box())


def _draw_button(layout, context):
    """Draw the button that searches the active object or all selected ones, now or after what runs."""
    selected = {obj.data for obj in context.selected_objects if obj.type == "MESH"}
    row = layout.row()
    row.scale_y = 1.4
    text, icon = iface_("Deform to Prompt", "Operator"), "MOD_SIMPLEDEFORM"
    if running.running.search is not None:
        text, icon = iface_("Add to Queue", "Operator"), "ADD"
        obj = context.active_object
        row.enabled = obj is not None and not running.is_asked_for(obj)
    elif len(selected) > 1:
        text = iface_("Deform {} Objects to Prompt", "Operator").format(len(selected))
    elif context.active_object is None or context.active_object.type != "MESH":
        row.enabled = False
        text, icon = iface_("Select a Mesh Object", "Operator"), "INFO"
    row.operator("boxmorph.deform", text=text, icon=icon).all_selected = len(selected) > 1


def _draw_progress(layout):
    """Draw the running search: what, how far, the best so far, the course of the score, what waits."""
    search, progress = running.running.search, running.running.progress
    phase, generation, scores, left = progress_parts(search.progress, iface_)
    layout.label(text=f"{search.object_name}: {search.prompt}", translate=False)
    row = layout.row()
    row.progress(factor=min(max(search.progress["fraction"], 0.0), 1.0), type="BAR", text=phase)
    row.operator("boxmorph.cancel", text="", icon="X")
    icons = progress.pictures.icons()
    if icons:
        row = layout.row()
        for icon in icons:
            row.template_icon(icon_value=icon, scale=4.5)
    column = layout.column(align=True)
    row = column.row()
    row.label(text=generation)
    row = row.row()
    row.alignment = "RIGHT"
    row.label(text=left)
    column.label(text=scores)
    for index, request in enumerate(running.running.waiting):
        row = layout.row()
        row.label(text=f"{request.name}: {request.settings['prompt']}", icon="TIME", translate=False)
        row.operator("boxmorph.unqueue", text="", icon="X", emboss=False).index = index


class BOXMORPH_PT_wording(Sidebar, bpy.types.Panel):
    bl_label = "More to the Prompt"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header_preset(self, context):
        # Folded, it shall not be forgotten.
        if any(getattr(context.scene.boxmorph, name) != usual for name, usual in wordings.DEFAULTS.items()):
            self.layout.label(text="", icon="DOT")

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in wordings.DEFAULTS:
            layout.prop(context.scene.boxmorph, name)


class BOXMORPH_PT_parts(Sidebar, bpy.types.Panel):
    bl_label = "Parts"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        obj = context.active_object
        return running.running.search is None and obj is not None and obj.type == "MESH"

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
            for clause in spanning.clauses(kept.coarse, report.get("worst_shear"), iface_):
                column.label(text=engine.capitalised(clause), icon="INFO", translate=False)
            layout.operator("boxmorph.refine", icon="MOD_BEVEL")


class BOXMORPH_PT_search(Sidebar, bpy.types.Panel):
    bl_label = "Search"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header_preset(self, _context):
        setting_presets.BOXMORPH_PT_search_presets.draw_panel_header(self.layout)

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
        prefs = preferences()
        if isinstance(prefs, bpy.types.AddonPreferences):
            layout.prop(prefs, "renderer")


class BOXMORPH_PT_guide(Sidebar, bpy.types.Panel):
    bl_label = "Guide"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        letter = preferences_editor.LETTER * context.preferences.system.ui_scale
        letters = max(20, int(context.region.width / letter) - 6)
        preferences_editor.draw_lines(layout, preferences_editor.guide_lines(iface_), letters)
        layout.operator("preferences.addon_show", text="Preferences", icon="PREFERENCES").module = PACKAGE
        layout.operator("boxmorph.copy_report", icon="COPYDOWN")


class BOXMORPH_PT_views(Sidebar, bpy.types.Panel):
    bl_label = "Views"
    bl_parent_id = "BOXMORPH_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, _context):
        layout = self.layout
        layout.operator("boxmorph.show_views", icon="RENDER_RESULT")
        image = bpy.data.images.get(VIEWS_IMAGE)
        if image is not None and image.preview is not None:
            layout.template_icon(icon_value=image.preview.icon_id, scale=9.0)


main_classes = (BOXMORPH_PT_main,)
classes = (
    BOXMORPH_PT_wording,
    BOXMORPH_PT_parts,
    BOXMORPH_PT_search,
    BOXMORPH_PT_guide,
    BOXMORPH_PT_views,
)
