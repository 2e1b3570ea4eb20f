# SPDX-License-Identifier: GPL-3.0-or-later
"""The searches of the interface: the one that runs and those that wait for it, as the panel, the operators
and the handlers see them.
"""

from dataclasses import dataclass, field

import bpy
from bpy.app.handlers import persistent
from bpy.app.translations import pgettext_iface as iface_

from ..core import mesh_io
from ..redraw import redraw_panels
from .progress import Progress, progress_text

_TICK_SECONDS = 0.1


@dataclass
class Request:
    """An object that is to be searched, and with what. Holds no Blender pointer, so that it survives undo."""

    uid: int
    name: str
    settings: dict

    def find_object(self):
        """Return the object, or None if it was deleted."""
        return mesh_io.object_by_uid(self.uid, self.name)


@dataclass
class _Running:
    """The one modal search of this Blender, and what comes after it."""

    search: object = None
    waiting: list = field(default_factory=list)
    stop: bool = False
    undone: bool = False
    #: Whether the user did something meanwhile, so that there may be undo steps that hold the preview.
    touched: bool = False
    progress: Progress | None = None
    timer: object = None
    workspace: str = ""
    #: The file, and the prompt that the last undo step of ours in it holds.
    pushed: tuple = ()


running = _Running()


def is_asked_for(obj):
    """Whether `obj`, or another user of its mesh, is searched or waits for it."""
    requests = [running.search, *running.waiting] if running.search is not None else []
    objects = [request.find_object() for request in requests]
    return any(other is not None and other.data == obj.data for other in objects)


def begin(context, requests):
    """Make ready for these searches: timer and handlers."""
    running.waiting = list(requests)
    running.stop = running.undone = running.touched = False
    wm = context.window_manager
    running.timer = wm.event_timer_add(_TICK_SECONDS, window=context.window)
    running.workspace = context.workspace.name
    for handlers, handler in _handlers():
        handlers.append(handler)


def push_prompt(prompt):
    """Make an undo step of a new prompt.

    Fields with suggestions make none, and undoing the outcome would take the prompt along.
    """
    if running.pushed != (bpy.data.filepath, prompt):
        bpy.ops.ed.undo_push(message="Prompt")
        running.pushed = (bpy.data.filepath, prompt)


def start(search):
    """Make this the search that runs."""
    _forget_progress()
    running.search = search
    running.progress = Progress()
    show_status()


def show_status():
    """Show how far the search is, in the status bar and the panel."""
    running.progress.follow(running.search)
    text = iface_("Boxmorph: {}   Esc: Cancel")
    _set_status(text.format(progress_text(running.search.progress, iface_)))


def end():
    """Forget the search and those that wait: timer, handlers, pictures, the text in the status bar."""
    running.search = None
    running.waiting = []
    _forget_progress()
    if running.timer is not None:
        if bpy.context.window_manager is not None:
            bpy.context.window_manager.event_timer_remove(running.timer)
        running.timer = None
    for handlers, handler in _handlers():
        if handler in handlers:
            handlers.remove(handler)
    _set_status(None)


def stop_running():
    """End a running search, wait for it and take its preview back; return whether there was one."""
    search = running.search
    if search is None:
        return False
    search.cancel(wait=True)
    obj = search.find_object()
    if obj is not None:
        search.take_back(obj)
    end()
    return True


def _forget_progress():
    if running.progress is not None:
        running.progress.close()
        running.progress = None


def _set_status(text):
    workspace = bpy.data.workspaces.get(running.workspace)
    if workspace is not None:
        workspace.status_text_set(text)
    redraw_panels()


def _handlers():
    handlers = bpy.app.handlers
    return (
        (handlers.undo_pre, _before_undo),
        (handlers.redo_pre, _before_undo),
        (handlers.save_pre, _before_save),
    )


@persistent
def _before_undo(*_):
    # Undo keeps a mesh that no undo step changed, and frees a Key that no step knows: the preview must go
    # first, or the mesh would point to freed memory. Entering Edit Mode has made a step that knows the Key.
    search = running.search
    if search is None:
        return
    running.undone = True
    search.cancel()
    obj = search.find_object()
    if obj is not None and obj.mode == "OBJECT":
        search.take_back(obj)


@persistent
def _before_save(*_):
    # A file holds the object as it is, not a shape that may never be kept. The next tick shows it again.
    search = running.search
    obj = None if search is None else search.find_object()
    if obj is not None and obj.mode == "OBJECT":
        search.hide(obj)
