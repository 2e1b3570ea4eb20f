# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators that search: deform to a prompt, and cancel."""

import bpy
from bpy.app.handlers import persistent

from .errors import Refusal
from .progress import progress_text
from .properties import SearchProperties
from .redraw import redraw_panels
from .search import Search

_TICK_SECONDS = 0.1

#: Events that push no undo step.
_NAVIGATION = frozenset(("MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "WHEELINMOUSE", "WHEELOUTMOUSE"))


class _Running:
    """The one modal search of this Blender, as the panel and the handlers see it."""

    search = None
    stop = False
    undone = False
    #: Whether the user did something meanwhile, so that there may be undo steps that hold the preview.
    touched = False
    #: The prompt that the last undo step of ours holds.
    prompt = None
    timer = None
    workspace = ""


def running_progress():
    """Return the progress of the running search, or None."""
    return None if _Running.search is None else _Running.search.progress


def register_operators():
    """Register the operators."""
    for cls in classes:
        bpy.utils.register_class(cls)


def unregister_operators():
    """Unregister the operators, and end a running search.

    The operator of a running search stays until Blender has let go of it: Blender 4.3 crashes when the class
    of a running operator goes and the same event starts another, as an update of extensions does.
    """
    ran = _stop_running()
    for cls in reversed(classes):
        if not (ran and cls is BOXMORPH_OT_deform):
            bpy.utils.unregister_class(cls)
    if ran:
        bpy.app.timers.register(_unregister_when_ended, first_interval=_TICK_SECONDS)


def _stop_running():
    """End a running search, wait for it and take its preview back; return whether there was one."""
    search = _Running.search
    if search is None:
        return False
    search.cancel(wait=True)
    obj = search.find_object()
    if obj is not None:
        search.take_back(obj)
    _clear()
    return True


def _unregister_when_ended():
    """Called by a timer: unregister the operator, unless it runs or a newer one has taken its place."""
    windows = bpy.context.window_manager.windows
    if any(o.bl_idname == "BOXMORPH_OT_deform" for window in windows for o in window.modal_operators):
        return _TICK_SECONDS
    if BOXMORPH_OT_deform.is_registered:
        bpy.utils.unregister_class(BOXMORPH_OT_deform)
    return None


class BOXMORPH_OT_deform(SearchProperties, bpy.types.Operator):
    """Search a deformation of the active object that looks like the prompt, and add it as a shape key"""

    bl_idname = "boxmorph.deform"
    bl_label = "Deform to Prompt"
    # Not REGISTER: "Adjust Last Operation" would search again at each change of a number.
    bl_options = {"UNDO"}

    def execute(self, context):
        """Search and wait for the end: the way of scripts and of `blender --background`."""
        try:
            search = self._begin(context)
            search.run()
            search.keep(context.active_object, context)
        except Refusal as refusal:
            return self._refuse(refusal)
        self._report(search, context.active_object)
        return {"FINISHED"}

    def invoke(self, context, _event):
        """Search beside the user's work: polled by a timer, with the best so far shown on the object."""
        try:
            _Running.search = self._begin(context)
        except Refusal as refusal:
            return self._refuse(refusal)
        _Running.stop = _Running.undone = _Running.touched = False
        _remember_prompt(context.scene.boxmorph.prompt)
        wm = context.window_manager
        _Running.timer = wm.event_timer_add(_TICK_SECONDS, window=context.window)
        _Running.workspace = context.workspace.name
        for handlers in _undo_handlers():
            handlers.append(_before_undo)
        wm.modal_handler_add(self)
        _show_status()
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        search = _Running.search
        if search is None:
            _clear()
            return {"CANCELLED"}
        if event.value == "PRESS" and (
            event.type == "ESC" or (event.type == "Z" and (event.ctrl or event.oskey))
        ):
            return self._give_up("Cancelled; the object is as it was")
        if event.type != "TIMER":
            if event.value == "PRESS" and event.type not in _NAVIGATION:
                _Running.touched = True
            return {"PASS_THROUGH"}
        if _Running.undone:
            return self._give_up("Cancelled by undo")
        if _Running.stop:
            return self._give_up("Cancelled; the object is as it was")
        return self._tick(search, context)

    def cancel(self, _context):
        """Blender ends the operator itself: another file is loaded, or it quits."""
        search = _Running.search
        if search is not None:
            search.cancel(wait=True)
        _clear()

    def _tick(self, search, context):
        ended = search.poll()
        _show_status()
        obj = search.find_object()
        if obj is None:
            name = search.object_name
            return self._give_up(f"Cancelled: “{name}” was deleted or its mesh was changed")
        if obj.mode != "OBJECT":
            return {"PASS_THROUGH"}
        if not ended:
            search.preview(obj)
            return {"PASS_THROUGH"}
        try:
            search.keep(obj, context)
        except Refusal as refusal:
            search.take_back(obj)
            _clear()
            return self._refuse(refusal)
        _clear()
        self._report(search, obj)
        return {"FINISHED"}

    def _begin(self, context):
        # No poll() for this: Blender would keep the button under the mouse grey after the search.
        if _Running.search is not None:
            raise Refusal("A search is running. Wait for it, or cancel it with Esc")
        settings = context.scene.boxmorph
        chosen = {
            name: getattr(self if self.properties.is_property_set(name) else settings, name)
            for name in SearchProperties.__annotations__
        }
        search = Search(context, context.active_object, **chosen)
        for note in search.notes():
            self.report({"WARNING"}, note)
        return search

    def _give_up(self, message):
        search = _Running.search
        search.cancel()
        obj = search.find_object()
        if obj is not None and obj.mode != "OBJECT":
            # The edits of this mode are the user's: the preview goes when they leave it.
            _Running.stop = True
            return {"PASS_THROUGH"}
        if obj is not None and search.take_back(obj) and _Running.touched:
            # Undo of what comes next would else lead to a step that holds the preview.
            bpy.ops.ed.undo_push(message="Cancel Deform to Prompt")
        _clear()
        self.report({"INFO"}, message)
        return {"CANCELLED"}

    def _report(self, search, obj):
        for note in search.departures(obj):
            self.report({"WARNING"}, note)
        for note in search.shear():
            self.report({"INFO"}, note)
        self.report({"INFO"}, search.summary())

    def _refuse(self, refusal):
        self.report({"ERROR"}, str(refusal))
        return {"CANCELLED"}


def _remember_prompt(prompt):
    """Make an undo step of a new prompt: fields with suggestions make none, and undoing the outcome would
    take the prompt along.
    """
    if prompt != _Running.prompt:
        bpy.ops.ed.undo_push(message="Prompt")
        _Running.prompt = prompt


def _show_status():
    _set_status(f"Boxmorph: {progress_text(_Running.search.progress)}   Esc: Cancel")


def _set_status(text):
    workspace = bpy.data.workspaces.get(_Running.workspace)
    if workspace is not None:
        workspace.status_text_set(text)
    redraw_panels()


def _clear():
    """Forget the search: its timer, its handlers, its text in the status bar."""
    _Running.search = None
    if _Running.timer is not None:
        if bpy.context.window_manager is not None:
            bpy.context.window_manager.event_timer_remove(_Running.timer)
        _Running.timer = None
    for handlers in _undo_handlers():
        if _before_undo in handlers:
            handlers.remove(_before_undo)
    _set_status(None)


class BOXMORPH_OT_cancel(bpy.types.Operator):
    """Stop the search and leave the object as it was"""

    bl_idname = "boxmorph.cancel"
    bl_label = "Cancel"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        return _Running.search is not None

    def execute(self, _context):
        _Running.stop = True
        return {"FINISHED"}


def _undo_handlers():
    return bpy.app.handlers.undo_pre, bpy.app.handlers.redo_pre


@persistent
def _before_undo(*_):
    # Undo keeps a mesh that no undo step changed, and frees a Key that no step knows: the preview must go
    # first, or the mesh would point to freed memory. Entering Edit Mode has made a step that knows the Key.
    search = _Running.search
    if search is None:
        return
    _Running.undone = True
    search.cancel()
    obj = search.find_object()
    if obj is not None and obj.mode == "OBJECT":
        search.take_back(obj)


classes = (BOXMORPH_OT_deform, BOXMORPH_OT_cancel)
