# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that search again what an outcome was searched for: with another seed, or for variations; and to
step through what there is.
"""

import bpy
from bpy.props import IntProperty

from ..errors import refused, tells_refusals
from ..outcomes import again, shape_key, variations
from .outcome_operators import OnOutcome


class _SearchesAgain(OnOutcome):
    """Shared by operators that search again: beside the user's work where they were clicked. The search makes
    its own undo step when it ends.
    """

    bl_options = {"INTERNAL"}

    _how = "EXEC_DEFAULT"

    def invoke(self, context, _event):
        self._how = "INVOKE_DEFAULT"
        return self.execute(context)

    def asked(self, context):
        """Return what the outcome that is meant was searched with."""
        obj, key = self.outcome(context)
        return again.settings_of(shape_key.records(obj.data)[key.name])

    def search(self, **settings):
        """Search, and return what the operator is to return. Raises Refusal."""
        try:
            done = bpy.ops.boxmorph.deform(self._how, **settings)
        except RuntimeError as error:
            # A refusal comes as the error report of the search.
            raise refused(error) from error
        return {"CANCELLED"} if done == {"CANCELLED"} else {"FINISHED"}


class BOXMORPH_OT_search_again(_SearchesAgain, bpy.types.Operator):
    """Search again with the outcome's own prompt and settings and the next seed. What is found takes its
    place
    """

    bl_idname = "boxmorph.search_again"
    bl_label = "Again with Another Seed"

    @tells_refusals
    def execute(self, context):
        asked = self.asked(context)
        return self.search(**asked | {"seed": again.next_seed(asked["seed"])})


class BOXMORPH_OT_variations(_SearchesAgain, bpy.types.Operator):
    """Search again for the prompt of this outcome, and add others that are nearly as good and look different,
    each as a shape key. They take the place of its earlier variations
    """

    bl_idname = "boxmorph.variations"
    bl_label = "Variations"

    count: IntProperty(
        name="Count", description="Outcomes in all, with the one there is", min=2, max=8, default=4
    )

    @tells_refusals
    def execute(self, context):
        return self.search(**self.asked(context) | {"variations": self.count})


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
