# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that judge outcomes by numbers: one in a few lines, or all of the selected objects in files."""

import os

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.props import BoolProperty, StringProperty

from ..core import engine, images, mesh_io
from ..errors import Refusal, remember, tells_refusals
from ..outcomes import evaluation, evaluation_sheet, evaluations
from ..redraw import redraw_panels
from .outcome_operators import OnOutcome, has_outcome


class BOXMORPH_OT_evaluate(OnOutcome, bpy.types.Operator):
    """Judge the outcome by numbers: how alike it is to its prompt, how many faces cross others, how far
    curvature and shading changed
    """

    bl_idname = "boxmorph.evaluate"
    bl_label = "Evaluate"
    bl_options = {"REGISTER", "UNDO"}

    def invoke(self, context, _event):
        done = self.execute(context)
        if done == {"FINISHED"} and not bpy.app.background:
            _obj, key = self.outcome(context)
            lines = evaluation.lines(self.evaluated, iface_)
            context.window_manager.popup_menu(
                lambda menu, _context: [menu.layout.label(text=line) for line in lines],
                title=key.name,
                icon="INFO",
            )
        return done

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        self.evaluated = evaluation.evaluate(obj, context, key)
        evaluation.keep(obj, key, self.evaluated)
        self.report({"INFO"}, f"“{key.name}”: {'; '.join(evaluation.lines(self.evaluated, rpt_))}")
        redraw_panels()
        return {"FINISHED"}


class BOXMORPH_OT_evaluate_all(bpy.types.Operator):
    """Judge all outcomes of the selected objects by numbers, and write them to files: a table, and a contact
    sheet with every object before and after
    """

    bl_idname = "boxmorph.evaluate_all"
    bl_label = "Evaluate All…"
    bl_options = {"UNDO"}

    filepath: StringProperty(subtype="FILE_PATH", options={"HIDDEN", "SKIP_SAVE"})
    filter_glob: StringProperty(default="*.csv;*.json;*.png", options={"HIDDEN"})
    table: BoolProperty(
        name="Table", description="Write a .csv file, a line for each outcome, for spreadsheets", default=True
    )
    details: BoolProperty(
        name="Details",
        description="Write a .json file of the same name, with the averages of each prompt, for scripts",
        default=False,
    )
    pictures: BoolProperty(
        name="Contact Sheet",
        description="Write a .png file of the same name: each outcome before and after, with its numbers",
        default=True,
    )

    @classmethod
    def poll(cls, context):
        return has_outcome(cls, context)

    def invoke(self, context, _event):
        self.filepath = f"{os.path.splitext(bpy.data.filepath)[0] or 'outcomes'}-evaluation.csv"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @tells_refusals
    def execute(self, context):
        paths = self._paths()
        engine.open_guide()
        objects = {context.active_object, *context.selected_objects}
        objects = [mesh_io.deformable(obj) for obj in evaluations.with_outcomes(objects)]
        file, found = bpy.path.basename(bpy.data.filepath), []
        for evaluated in evaluations.evaluate_all(objects, context, file, pictures=self.pictures):
            found.append(evaluated)
            if evaluated.refusal is None:
                obj = bpy.data.objects[evaluated.object]
                key = obj.data.shape_keys.key_blocks[evaluated.outcome]
                evaluation.keep(obj, key, evaluated.evaluation)
            else:
                remember(str(evaluated.refusal))
                self.report({"WARNING"}, evaluated.refusal.said(rpt_))
        self._write(found, paths)
        redraw_panels()
        names = ", ".join(os.path.basename(path) for path in paths.values())
        if len(found) == 1:
            done = rpt_("1 outcome evaluated, written to {names}")
        else:
            done = rpt_("{count} outcomes evaluated, written to {names}")
        self.report({"INFO"}, done.format(count=len(found), names=names))
        return {"FINISHED"}

    def _paths(self):
        """Return the files that are to be written, by their kinds."""
        kinds = {".csv": self.table, ".json": self.details, ".png": self.pictures}
        stem, ending = os.path.splitext(os.path.abspath(bpy.path.abspath(self.filepath)))
        if ending.lower() not in kinds:
            stem += ending
        paths = {kind: stem + kind for kind, is_wanted in kinds.items() if is_wanted}
        if not paths:
            raise Refusal("Nothing is to be written. Turn on Table, Details or Contact Sheet")
        return paths

    def _write(self, found, paths):
        writers = {
            ".csv": evaluations.write_csv,
            ".json": evaluations.write_json,
            ".png": lambda found, path: images.save_png(evaluation_sheet.sheet(found, iface_), path),
        }
        for kind, path in paths.items():
            try:
                writers[kind](found, path)
            except OSError as error:
                raise Refusal("{path} cannot be written. Choose another place", path=path) from error


classes = (BOXMORPH_OT_evaluate, BOXMORPH_OT_evaluate_all)
