# SPDX-License-Identifier: GPL-3.0-or-later
"""Guides from the hub: which there are, how much of them is here, and the one download that runs.

The work runs on a thread of the Rust module. A timer looks at it, not a modal operator: that would end with
the window of the preferences.
"""

import functools
import os
import time
from dataclasses import dataclass, field

import bpy

from ..errors import Refusal, remember
from ..preferences import preferences
from ..redraw import redraw_preferences
from . import engine, guides

#: The precisions: how they are called, and what they are for.
PRECISIONS = {
    "fp32": ("Full (fp32)", "As it was made. The fastest but int8 on a processor"),
    "fp16": ("Half (fp16)", "Half the size, practically the same scores; for graphics cards"),
    "int8": ("Small (int8)", "A quarter of the size, and the fastest on a processor; scores are coarser"),
}

_TICK_SECONDS = 0.2

#: What is on the disk is looked up so often at most: the interface asks whenever it is drawn.
_KNOWN_SECONDS = 1.0


@dataclass
class _State:
    """The download that runs, or how the last one ended."""

    download: object = None
    guide: str = ""
    precision: str = ""
    progress: dict = field(default_factory=dict)
    refusal: Refusal | None = None


state = _State()
_presences = {}


@functools.cache
def entries():
    """Return the guides that can be downloaded, as dicts: see `boxmorph.guides.registry`. Raises Refusal."""
    return engine.library().guides.registry()


def entry(guide):
    """Return the entry of this name. Raises Refusal."""
    for known in entries():
        if known["id"] == guide:
            return known
    names = ", ".join(known["id"] for known in entries())
    raise Refusal("There is no guide “{name}” to download. Choose {known}", name=guide, known=names)


def presence(guide, precision):
    """Return how much of a guide is on this machine, as a dict: see `boxmorph.guides.presence`."""
    key = guide, precision, guides.root()
    seen, known = _presences.get(key, (0.0, None))
    if known is None or time.monotonic() - seen > _KNOWN_SECONDS:
        known = engine.library().guides.presence(*key)
        _presences[key] = time.monotonic(), known
    return known


def is_running(guide, precision):
    """Whether this is what is being downloaded."""
    return state.download is not None and (state.guide, state.precision) == (guide, precision)


def bytes_here(guide, precision):
    """Return the bytes of a guide, or of a part of it, in the guides folder."""
    there = presence(guide, precision)
    return there["bytes"] if there["path"] is None else guides.size(there["path"])


def online_refusal():
    """Return the Refusal that says why Blender allows no download, or None where it does."""
    if bpy.app.online_access:
        return None
    if bpy.app.online_access_override:
        return Refusal("Blender was started offline. Start it with --online-mode to download guides")
    if bpy.app.background:
        return Refusal("Blender does not allow online access. Start it with --online-mode")
    return Refusal("Online access is off. Allow it in the preferences, under System, to download guides")


def start(guide, precision, endpoint=None):
    """Start to download a guide, or go on. Raises Refusal."""
    refusal = online_refusal()
    if refusal is not None:
        raise refusal
    if state.download is not None:
        raise Refusal("A guide is being downloaded. Wait for it, or cancel it first")
    endpoint = endpoint or preferences().hub_endpoint.strip() or None
    entry(guide)
    boxmorph = engine.library()
    try:
        download = boxmorph.guides.Download(guide, precision, guides.root(), endpoint=endpoint)
        download.start()
    except (ValueError, RuntimeError) as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    state.download, state.guide, state.precision = download, guide, precision
    state.progress, state.refusal = download.progress(), None


def watch():
    """Let a timer look at the download until it ends."""
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=_TICK_SECONDS, persistent=True)


def wait(on_progress=None):
    """Wait for the end of the download; return the guide's folder. Raises Refusal."""
    while not poll():
        if on_progress is not None:
            on_progress(state.progress)
        time.sleep(_TICK_SECONDS)
    return _end()


def poll():
    """Look how far the download is; return whether it has ended."""
    state.progress = state.download.progress()
    return state.progress["finished"]


def cancel():
    """Ask the download to stop; what has come is kept."""
    if state.download is not None:
        state.download.cancel()


def stop():
    """Stop the download and wait for it: the extension is disabled, or Blender quits."""
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)
    if state.download is not None:
        state.download.cancel()
        try:
            _end()
        except Refusal:
            pass
    state.refusal = None


def choose(folder, precision="auto"):
    """Make the guide in a folder the one that judges, and open it: in this precision, as the hub's cache may
    hold others beside it.
    """
    prefs = preferences()
    prefs.guide_precision = f"{precision} {folder}"
    prefs.guide_elsewhere = False
    # Opened by the update of this property, which also tells what is wrong.
    prefs.guide_folder = str(folder)
    bpy.context.preferences.is_dirty = True


def remove(guide, precision):
    """Delete a guide that was downloaded, or what an unfinished download has left. Raises Refusal."""
    boxmorph = engine.library()
    folder = os.path.join(guides.root(), entry(guide)["precisions"][precision]["folder_name"])
    try:
        boxmorph.guides.remove(guide, precision, guides.root())
    except boxmorph.GuideError as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    finally:
        _presences.clear()
    state.refusal = None
    if engine.guide_folder() == folder and not os.path.isdir(folder):
        preferences().guide_folder = ""
        bpy.context.preferences.is_dirty = True


def _tick():
    """Called by the timer."""
    if state.download is None:
        return None
    ended = poll()
    if ended:
        try:
            choose(_end(), state.precision)
        except Refusal:
            pass
    redraw_preferences()
    return None if ended else _TICK_SECONDS


def _end():
    """Forget the download; return the guide's folder. Raises Refusal, which is kept to be shown."""
    boxmorph = engine.library()
    download, state.download = state.download, None
    _presences.clear()
    try:
        download.join()
        return download.result()
    except boxmorph.Cancelled as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    except (boxmorph.GuideError, ValueError, RuntimeError) as error:
        state.refusal = Refusal(engine.capitalised(engine.sentence(error)))
        remember(str(state.refusal))
        raise state.refusal from error
