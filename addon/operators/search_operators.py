# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators that search: deform to a prompt, cancel, take an object out of the queue."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.props import BoolProperty, IntProperty

from ..core import mesh_io
from ..errors import Refusal, remember, tell, tells_refusals
from ..searching import history, running
from ..searching.running import Request
from ..searching.search import Search
from .properties import SearchProperties

#: Events that push no undo step.
_NAVIGATION = frozenset(("MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "WHEELINMOUSE", "WHEELOUTMOUSE"))

_LET_GO_SECONDS = 0.1


class BOXMORPH_OT_deform(SearchProperties, bpy.types.Operator):
    """Search a deformation of the active object that looks like the prompt, and add it as a shape key. While
    a search runs, the object waits for its end
    """

    bl_idname = "boxmorph.deform"
    bl_label = "Deform to Prompt"
    # Not REGISTER: "Adjust Last Operation" would search again at each change of a number.
    bl_options = {"UNDO"}

    all_selected: BoolProperty(
        name="All Selected",
        description="Deform all selected mesh objects, one after another, not only the active one",
        default=False,
        options={"SKIP_SAVE"},
    )

    @tells_refusals
    def execute(self, context):
        """Search and wait for the end: the way of scripts and of `blender --background`."""
        requests = self._requests(context)
        kept = 0
        for request in requests:
            try:
                search = self._search(context, request)
                search.run()
                search.keep(request.find_object(), context)
            except Refusal as refusal:
                if len(requests) == 1:
                    raise
                remember(str(refusal))
                self.report({"WARNING"}, refusal.said(rpt_))
            else:
                kept += 1
                self._tell(search, request.find_object())
        return {"FINISHED"} if kept else {"CANCELLED"}

    def invoke(self, context, _event):
        """Search beside the user's work: polled by a timer, with the best so far shown on the object."""
        try:
            requests = self._requests(context)
            if running.running.search is not None:
                return self._queue(requests)
        except Refusal as refusal:
            return tell(self, refusal)
        running.begin(context, requests)
        if not self._start_next(context):
            return {"CANCELLED"}
        history.remember(requests[0].settings["prompt"])
        running.push_prompt(context.scene.boxmorph.prompt)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        state = running.running
        if state.search is None:
            running.end()
            return {"CANCELLED"}
        if event.value == "PRESS" and (
            event.type == "ESC" or (event.type == "Z" and (event.ctrl or event.oskey))
        ):
            return self._give_up(rpt_("Cancelled; the object is as it was"))
        if event.type != "TIMER":
            if event.value == "PRESS" and event.type not in _NAVIGATION:
                state.touched = True
            return {"PASS_THROUGH"}
        if state.undone:
            return self._give_up(rpt_("Cancelled by undo"))
        if state.stop:
            return self._give_up(rpt_("Cancelled; the object is as it was"))
        return self._tick(state.search, context)

    def cancel(self, _context):
        """Blender ends the operator itself: another file is loaded, or it quits."""
        if running.running.search is not None:
            running.running.search.cancel(wait=True)
        running.end()

    def _tick(self, search, context):
        ended = search.poll()
        running.show_status()
        obj = search.find_object()
        if obj is None:
            name = search.object_name
            search.cancel()
            gone = rpt_("Cancelled: “{}” was deleted or its mesh was changed")
            self.report({"WARNING"}, gone.format(name))
            return {"PASS_THROUGH"} if self._start_next(context) else {"CANCELLED"}
        if obj.mode != "OBJECT":
            return {"PASS_THROUGH"}
        if not ended:
            search.preview(obj)
            return {"PASS_THROUGH"}
        try:
            search.keep(obj, context)
        except Refusal as refusal:
            search.take_back(obj)
            done = tell(self, refusal)
        else:
            done = {"FINISHED"}
            self._tell(search, obj)
            if running.running.waiting:
                bpy.ops.ed.undo_push(message=self.bl_label)
        return {"PASS_THROUGH"} if self._start_next(context) else done

    def _requests(self, context):
        """Return what is to be searched: the active object or all selected ones, each mesh once."""
        settings = context.scene.boxmorph
        chosen = {
            name: getattr(self if self.properties.is_property_set(name) else settings, name)
            for name in SearchProperties.__annotations__
        }
        objects = [context.active_object]
        if self.all_selected:
            selected = {obj.data: obj for obj in reversed(context.selected_objects) if obj.type == "MESH"}
            objects = sorted(selected.values(), key=lambda obj: (obj != context.active_object, obj.name))
        if not objects or objects[0] is None:
            mesh_io.deformable(None)
        return [Request(obj.session_uid, obj.name, chosen) for obj in objects]

    def _search(self, context, request):
        search = Search(context, request.find_object(), **request.settings)
        for note in search.notes(rpt_):
            self.report({"WARNING"}, note)
        return search

    def _queue(self, requests):
        """Let objects wait for the search that runs. Not FINISHED: an undo step would hold the preview."""
        new = [request for request in requests if not running.is_asked_for(request.find_object())]
        if not new:
            raise Refusal(
                "“{name}” is searched or waits already. Cancel the search with Esc to begin anew",
                name=requests[0].name,
            )
        running.running.waiting += new
        names = ", ".join(rpt_("“{}”").format(request.name) for request in new)
        is_one = len(new) == 1
        waits = rpt_("{} waits for the search that runs" if is_one else "{} wait for the search that runs")
        self.report({"INFO"}, waits.format(names))
        return {"CANCELLED"}

    def _start_next(self, context):
        """Start the next search that can be; return whether there is one. Without any, all is forgotten."""
        waiting = running.running.waiting
        while waiting:
            request = waiting.pop(0)
            try:
                if request.find_object() is None:
                    raise Refusal("“{name}” was deleted before its search began", name=request.name)
                running.start(self._search(context, request))
            except Refusal as refusal:
                remember(str(refusal))
                self.report({"WARNING" if waiting else "ERROR"}, refusal.said(rpt_))
            else:
                return True
        running.end()
        return False

    def _give_up(self, message):
        state = running.running
        search = state.search
        search.cancel()
        obj = search.find_object()
        if obj is not None and obj.mode != "OBJECT":
            # The edits of this mode are the user's: the preview goes when they leave it.
            state.stop = True
            return {"PASS_THROUGH"}
        if obj is not None and search.take_back(obj) and state.touched:
            # Undo of what comes next would else lead to a step that holds the preview.
            bpy.ops.ed.undo_push(message="Cancel Deform to Prompt")
        running.end()
        self.report({"INFO"}, message)
        return {"CANCELLED"}

    def _tell(self, search, obj):
        for note in search.departures(obj, rpt_):
            self.report({"WARNING"}, note)
        for note in search.shear(rpt_):
            self.report({"INFO"}, note)
        self.report({"INFO"}, search.summary(rpt_))


class BOXMORPH_OT_cancel(bpy.types.Operator):
    """Stop the search and leave the object as it was; objects that wait are not searched"""

    bl_idname = "boxmorph.cancel"
    bl_label = "Cancel"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context):
        return running.running.search is not None

    def execute(self, _context):
        running.running.stop = True
        return {"FINISHED"}


class BOXMORPH_OT_unqueue(bpy.types.Operator):
    """Do not search this object"""

    bl_idname = "boxmorph.unqueue"
    bl_label = "Remove from Queue"
    bl_options = {"INTERNAL"}

    index: IntProperty(min=0)

    def execute(self, _context):
        waiting = running.running.waiting
        if self.index >= len(waiting):
            return {"CANCELLED"}
        del waiting[self.index]
        return {"FINISHED"}


def register_operators():
    """Register the operators."""
    for cls in classes:
        bpy.utils.register_class(cls)


def unregister_operators():
    """Unregister the operators, and end a running search.

    The operator of a running search stays until Blender has let go of it: Blender 4.3 crashes when the class
    of a running operator goes and the same event starts another, as an update of extensions does.
    """
    ran = running.stop_running()
    for cls in reversed(classes):
        if not (ran and cls is BOXMORPH_OT_deform):
            bpy.utils.unregister_class(cls)
    if ran:
        bpy.app.timers.register(_unregister_when_ended, first_interval=_LET_GO_SECONDS)


def _unregister_when_ended():
    """Called by a timer: unregister the operator, unless it runs or a newer one has taken its place."""
    windows = bpy.context.window_manager.windows
    if any(o.bl_idname == "BOXMORPH_OT_deform" for window in windows for o in window.modal_operators):
        return _LET_GO_SECONDS
    if BOXMORPH_OT_deform.is_registered:
        bpy.utils.unregister_class(BOXMORPH_OT_deform)
    return None


classes = (BOXMORPH_OT_deform, BOXMORPH_OT_cancel, BOXMORPH_OT_unqueue)
