# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on what a search has left: keyframe an outcome, give it a control, measure its scores, take
it apart, make it an object, remove it, show the views of the object.
"""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.app.translations import pgettext_tip as tip_
from bpy.props import FloatProperty, IntProperty, StringProperty

from ..core import engine, images, mesh_io
from ..errors import Refusal, tells_refusals
from ..outcomes import control, keyframes, new_object, score_curve, shape_key, take_apart
from ..preferences import preferences
from ..redraw import redraw_panels
from .properties import timing


def has_outcome(operator, context):
    """Whether the active object has an outcome; if not, `operator`, a class, tells so where it is offered."""
    obj = context.active_object
    if obj is None or obj.type != "MESH" or not shape_key.records(obj.data):
        operator.poll_message_set(tip_("The active object has no outcome yet. Deform it to a prompt first"))
        return False
    return True


class OnOutcome:
    """Shared by operators on one outcome of the active object, named by `key`, else the active shape key."""

    key: StringProperty(
        name="Shape Key", description="Name of the outcome; empty: the active one", options={"HIDDEN"}
    )

    @classmethod
    def poll(cls, context):
        return has_outcome(cls, context)

    def outcome(self, context):
        """Return the active object, checked, and the key that is meant."""
        obj = mesh_io.deformable(context.active_object)
        if self.key and self.key not in shape_key.records(obj.data):
            raise Refusal(
                "“{name}” has no outcome named “{outcome}”",
                name=obj.name,
                outcome=self.key,
            )
        name = self.key or shape_key.meant_outcome(obj)[0]
        return obj, obj.data.shape_keys.key_blocks[name]

    def take_settings(self, context, *names):
        """Take properties that were not given from the panel's settings."""
        for name in names:
            if not self.properties.is_property_set(name):
                setattr(self, name, getattr(context.scene.boxmorph, name))


class BOXMORPH_OT_keyframe_spectrum(OnOutcome, bpy.types.Operator):
    """Animate the outcome: keyframe its value from one frame to another, as set above the button"""

    bl_idname = "boxmorph.keyframe_spectrum"
    bl_label = "Keyframe Spectrum"
    bl_options = {"REGISTER", "UNDO"}

    frame_from: IntProperty(name="From Frame", description="Frame of the first keyframe", default=1)
    frame_to: IntProperty(name="To Frame", description="Frame of the last keyframe", default=60)
    alpha_from: FloatProperty(name="From Value", description="Value at the first frame", default=0.0)
    alpha_to: FloatProperty(name="To Value", description="Value at the last frame", default=1.0)
    timing: timing()

    def invoke(self, context, _event):
        self.take_settings(context, "frame_from", "frame_to", "alpha_from", "alpha_to", "timing")
        return self.execute(context)

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        keyframes.keyframe_spectrum(
            obj,
            context,
            key,
            self.frame_from,
            self.frame_to,
            self.alpha_from,
            self.alpha_to,
            self.timing,
        )
        context.scene.frame_set(context.scene.frame_current)
        return {"FINISHED"}


class BOXMORPH_OT_measure_scores(OnOutcome, bpy.types.Operator):
    """Measure how much the outcome looks like its prompt from one value to another, and draw the curve: it
    shows where on the slider it turns into the prompt
    """

    bl_idname = "boxmorph.measure_scores"
    bl_label = "Measure Scores"
    bl_options = {"REGISTER", "UNDO"}

    alpha_from: FloatProperty(name="From Value", description="Value where the curve begins", default=0.0)
    alpha_to: FloatProperty(name="To Value", description="Value where the curve ends", default=1.0)

    def invoke(self, context, _event):
        self.take_settings(context, "alpha_from", "alpha_to")
        return self.execute(context)

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        curve = score_curve.measure(obj, context, key, self.alpha_from, self.alpha_to)
        score_curve.keep(obj, key, curve)
        redraw_panels()
        return {"FINISHED"}


class BOXMORPH_OT_add_control(OnOutcome, bpy.types.Operator):
    """Make a custom property of the object that drives the outcome: a slider that can be keyed, driven by
    bones, or read by other drivers
    """

    bl_idname = "boxmorph.add_control"
    bl_label = "Add Driver Control"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        name = control.add(obj, key)
        done = rpt_("“{outcome}” follows the custom property “{control}” of “{name}”")
        self.report({"INFO"}, done.format(outcome=key.name, control=name, name=obj.name))
        return {"FINISHED"}


class BOXMORPH_OT_remove_outcome(OnOutcome, bpy.types.Operator):
    """Delete the outcome: its shape key, those it was taken apart into, its record, its control and its
    animation
    """

    bl_idname = "boxmorph.remove_outcome"
    bl_label = "Remove Outcome"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        control.remove(key)
        shape_key.remove_outcome(obj, key.name)
        return {"FINISHED"}


class BOXMORPH_OT_take_apart(OnOutcome, bpy.types.Operator):
    """Make a shape key of each part's width, depth and height, to be tuned by hand. Together they equal the
    outcome, which is set to 0 and stays
    """

    bl_idname = "boxmorph.take_apart"
    bl_label = "Take Apart"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        made = take_apart.take_apart(obj, context, key.name)
        self.report({"INFO"}, rpt_("“{}” is now {} shape keys").format(key.name, len(made)))
        return {"FINISHED"}


class BOXMORPH_OT_put_together(OnOutcome, bpy.types.Operator):
    """Delete the shape keys that the outcome was taken apart into, and show the outcome again as it was. What
    was tuned by hand on them is lost
    """

    bl_idname = "boxmorph.put_together"
    bl_label = "Put Together"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        missing = take_apart.put_together(obj, key.name)
        if missing:
            left = rpt_("{} of its shape keys, deleted or renamed, were left as they are")
            self.report({"WARNING"}, left.format(missing))
        return {"FINISHED"}


class BOXMORPH_OT_apply_as_new(OnOutcome, bpy.types.Operator):
    """Make a new object, in the same place, whose mesh is the outcome as it is shown now, without shape keys.
    UVs, materials, groups and modifiers stay
    """

    bl_idname = "boxmorph.apply_as_new"
    bl_label = "Apply as New Object"
    bl_options = {"REGISTER", "UNDO"}

    @tells_refusals
    def execute(self, context):
        obj, key = self.outcome(context)
        new = new_object.apply_as_new(obj, key.name)
        context.view_layer.update()
        if new.name in context.view_layer.objects:
            for other in context.view_layer.objects:
                other.select_set(False)
            new.select_set(True)
            context.view_layer.objects.active = new
        return {"FINISHED"}


class BOXMORPH_OT_show_views(bpy.types.Operator):
    """Render the four views that the guide sees of the active object as it is now, as the image Boxmorph
    Views. To see what is judged where a score surprises
    """

    bl_idname = "boxmorph.show_views"
    bl_label = "Show Views"
    bl_options = {"REGISTER"}

    @tells_refusals
    def execute(self, context):
        obj = context.active_object
        if obj is None or obj.type != "MESH":
            raise Refusal("There is no active mesh object to view. Select one")
        boxmorph = engine.library()
        vertices, triangles = mesh_io.shown_arrays(obj, context)
        try:
            row = images.render_row(boxmorph, vertices, triangles, renderer=preferences().renderer)
        except (boxmorph.RenderError, ValueError) as error:
            raise Refusal(engine.sentence(error)) from error
        half = row.shape[1] // 2
        image = images.show(images.stack([row[:, :half], row[:, half:]]))
        for window in context.window_manager.windows:
            for area in window.screen.areas:
                if area.type == "IMAGE_EDITOR" and area.spaces.active.mode == "VIEW":
                    area.spaces.active.image = image
        redraw_panels()
        return {"FINISHED"}


classes = (
    BOXMORPH_OT_keyframe_spectrum,
    BOXMORPH_OT_measure_scores,
    BOXMORPH_OT_add_control,
    BOXMORPH_OT_remove_outcome,
    BOXMORPH_OT_take_apart,
    BOXMORPH_OT_put_together,
    BOXMORPH_OT_apply_as_new,
    BOXMORPH_OT_show_views,
)
