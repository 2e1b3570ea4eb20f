# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that search again what an outcome was searched for: with another seed, or for variations; and to
step through what there is.
"""

import bpy
from bpy.props import IntProperty

from ..errors import refused, tells_refusals
from ..outcomes import again, shape_key, variations
from .outcome_operators import OnOutcome


class BOXMORPH_OT_search_again(OnOutcome, bpy.types.Operator):
    """Search again with the outcome's own prompt and settings and the next seed. What is found takes its
    place
    """

    bl_idname = "boxmorph.search_again"
    bl_label = "Again with Another Seed"
    # The search makes its own undo step when it ends.
    bl_options = set()

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        settings = again.settings_of(shape_key.records(obj.data)[key.name])
        settings["seed"] = again.next_seed(settings["seed"])
        try:
            done = bpy.ops.boxmorph.deform("INVOKE_DEFAULT", **settings)
        except RuntimeError as error:
            raise refused(error) from error
        # A search that goes on beside the user's work is an operator of its own by now.
        return {"FINISHED"} if "RUNNING_MODAL" in done else done


class BOXMORPH_OT_variations(OnOutcome, bpy.types.Operator):
    """Search again for the prompt of this outcome, and add others that are nearly as good and look different,
    each as a shape key. They take the place of its earlier variations
    """

    bl_idname = "boxmorph.variations"
    bl_label = "Variations"
    # The search pushes its own undo step.
    bl_options = {"INTERNAL"}

    count: IntProperty(
        name="Count", description="Outcomes in all, with the one there is", min=2, max=8, default=4
    )

    #: How the search is called: beside the user's work where this was clicked.
    _how = "EXEC_DEFAULT"

    def invoke(self, context, _event):
        self._how = "INVOKE_DEFAULT"
        return self.execute(context)

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        report = shape_key.records(obj.data)[key.name]
        try:
            settings = again.settings_of(report) | {"variations": self.count}
            done = bpy.ops.boxmorph.deform(self._how, **settings)
        except RuntimeError as error:
            # A refusal comes as the error report of the search.
            raise refused(error) from error
        return {"CANCELLED"} if done == {"CANCELLED"} else {"FINISHED"}


class BOXMORPH_OT_show_outcome(OnOutcome, bpy.types.Operator):
    """Set this outcome to 1 and all others of the object to 0"""

    bl_idname = "boxmorph.show_outcome"
    bl_label = "Show Only This"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        variations.show_only(obj, key.name)
        obj.data.update()
        return {"FINISHED"}


classes = (BOXMORPH_OT_search_again, BOXMORPH_OT_variations, BOXMORPH_OT_show_outcome)
