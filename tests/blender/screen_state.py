# SPDX-License-Identifier: MIT OR Apache-2.0
"""Runs inside Blender on the virtual screen: evaluates what the driver asks, and prepares the window.

The driver writes {"id", "code"} to $BOXMORPH_CHANNEL/ask.json; the answer goes to answer.json as
{"id", "value"} or {"id", "error"}. `code` is an expression, or statements that set `value`.
"""

import json
import os
import time  # noqa: F401 (for what is asked)
import traceback

import bpy

CHANNEL = os.environ["BOXMORPH_CHANNEL"]
_last = -1
_redraws = [0]
_handles = []


def view():
    """Return (window, area, its sidebar region) of the 3D viewport."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    return window, area, next(region for region in area.regions if region.type == "UI")


def areas():
    """Return the kinds of editors in all windows."""
    return [area.type for window in bpy.context.window_manager.windows for area in window.screen.areas]


def modal():
    """Return the identifiers of the running modal operators."""
    return [operator.bl_idname for operator in bpy.context.window_manager.windows[0].modal_operators]


def keys(name):
    """Return the shape keys of an object as {name: value}."""
    blocks = bpy.data.objects[name].data.shape_keys
    return {} if blocks is None else {key.name: key.value for key in blocks.key_blocks}


def moved(name):
    """Return how far the farthest vertex of any key is from the Basis."""
    blocks = bpy.data.objects[name].data.shape_keys
    if blocks is None:
        return 0.0
    basis = [point.co.copy() for point in blocks.reference_key.points]
    return max((key.points[i].co - co).length for key in blocks.key_blocks for i, co in enumerate(basis))


def handlers():
    """Return the names of the extension's handlers, which are there while a search runs."""
    lists = [getattr(bpy.app.handlers, name) for name in ("undo_pre", "redo_pre", "save_pre")]
    return [
        handler.__name__ for handlers in lists for handler in handlers if "boxmorph" in handler.__module__
    ]


def draws():
    """Return how often the 3D viewport was drawn while `redraw_always` was on."""
    return _redraws[0]


def redraw_always(on):
    """Ask for a redraw of the 3D viewport whenever Blender has time, and count them; or stop."""
    if on:
        _handles.append(bpy.types.SpaceView3D.draw_handler_add(_count_redraw, (), "WINDOW", "POST_PIXEL"))
        bpy.app.timers.register(_ask_for_redraw)
    else:
        bpy.app.timers.unregister(_ask_for_redraw)
        bpy.types.SpaceView3D.draw_handler_remove(_handles.pop(), "WINDOW")


def _count_redraw():
    _redraws[0] += 1


def _ask_for_redraw():
    view()[1].tag_redraw()
    return 0.0


def _answer():
    global _last
    try:
        with open(os.path.join(CHANNEL, "ask.json"), encoding="utf-8") as file:
            ask = json.load(file)
    except (OSError, ValueError):
        return 0.05
    if ask["id"] == _last:
        return 0.05
    _last = ask["id"]
    answer = {"id": ask["id"]}
    try:
        try:
            answer["value"] = eval(ask["code"], globals())
        except SyntaxError:
            scope = {}
            exec(ask["code"], globals(), scope)
            answer["value"] = scope.get("value")
    except Exception:
        answer["error"] = traceback.format_exc()
    path = os.path.join(CHANNEL, "answer.json")
    with open(path + ".new", "w", encoding="utf-8") as file:
        json.dump(answer, file, default=str)
    os.replace(path + ".new", path)
    return 0.05


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(_answer, persistent=True)
