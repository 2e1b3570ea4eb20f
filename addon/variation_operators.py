# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on variations: search for more outcomes of a prompt, and step through what there is."""

import bpy
from bpy.props import IntProperty

from . import again, shape_key, variations
from .errors import refused, tells_refusals
from .outcome_operators import _OnOutcome


class BOXMORPH_OT_variations(_OnOutcome, bpy.types.Operator):
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


class BOXMORPH_OT_show_outcome(_OnOutcome, bpy.types.Operator):
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


classes = (BOXMORPH_OT_variations, BOXMORPH_OT_show_outcome)
