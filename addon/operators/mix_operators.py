# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on all outcomes of an object together: mix them, key the mix."""

import bpy
from bpy.props import FloatProperty

from ..core import mesh_io
from ..errors import tells_refusals
from ..outcomes import keyframes, mix
from .outcome_operators import has_outcome


class BOXMORPH_OT_mix_outcomes(bpy.types.Operator):
    """Mix the outcomes in the ratio of their sliders, evenly where all are at 0, and no farther than every
    part stays thick enough
    """

    bl_idname = "boxmorph.mix_outcomes"
    bl_label = "Mix Outcomes"
    bl_options = {"REGISTER", "UNDO"}

    amount: FloatProperty(
        name="Amount",
        description="What the sliders add up to: 1 mixes whole outcomes, less stays nearer to the object, "
        "more goes beyond them",
        default=1.0,
        min=0.0,
        max=10.0,
        soft_max=2.0,
    )

    @classmethod
    def poll(cls, context):
        return has_outcome(cls, context)

    @tells_refusals
    def execute(self, context):
        obj = mesh_io.deformable(context.active_object)
        for note in mix.mix(obj, self.amount):
            self.report({"INFO"}, note)
        return {"FINISHED"}


class BOXMORPH_OT_keyframe_mix(bpy.types.Operator):
    """Keyframe the sliders of all outcomes as they are at the current frame. Between two mixes, all values
    run along straight lines
    """

    bl_idname = "boxmorph.keyframe_mix"
    bl_label = "Keyframe Mix"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return has_outcome(cls, context)

    @tells_refusals
    def execute(self, context):
        obj = mesh_io.deformable(context.active_object)
        keyframes.keyframe_pose(mix.posed(obj), context.scene.frame_current)
        return {"FINISHED"}


classes = (BOXMORPH_OT_mix_outcomes, BOXMORPH_OT_keyframe_mix)
