# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies of guides in eight bits: smaller, faster on most processors, a little less exact.

The work runs on a thread of the Rust module. A timer looks at it, as with downloads.
"""

import os
import shutil
import time
from dataclasses import dataclass, field

import bpy

from ..errors import Refusal, remember
from ..redraw import redraw_preferences
from . import engine, guide_downloads, guides

#: What the name of a copy's folder ends in, and begins with until it is whole: such folders are no guides.
_ENDING = "-8bit"
_BEGINNING = ".copy-"

_TICK_SECONDS = 0.2


@dataclass
class _State:
    """The copy that is being made, or how the last one ended."""

    work: object = None
    folder: str = ""
    progress: dict = field(default_factory=dict)
    is_cancelled: bool = False
    figures: dict | None = None
    refusal: Refusal | None = None


state = _State()


def start(folder):
    """Start to write a copy of the guide in `folder` into the guides folder, which takes about a minute for a
    large one. None is the embedded guide. Raises Refusal.
    """
    if folder is None:
        raise Refusal("The embedded guide is fast as it is. Choose a large one first")
    if state.work is not None:
        raise Refusal("A copy is being made. Wait for it, or cancel it first")
    copy = os.path.join(guides.root(), guides.name(folder) + _ENDING)
    if os.path.exists(copy):
        raise Refusal("{folder} is there already. Choose that guide, or delete it first", folder=copy)
    boxmorph = engine.library()
    # Not three at once: they may be large.
    engine.close_guide()
    try:
        os.makedirs(guides.root(), exist_ok=True)
        # Blender may have ended in the middle of another.
        shutil.rmtree(_unfinished(copy), ignore_errors=True)
        work = boxmorph.EightBitCopy(folder, _unfinished(copy))
        work.start()
    except (RuntimeError, OSError) as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    state.work, state.folder, state.progress = work, copy, work.progress()
    state.is_cancelled, state.figures, state.refusal = False, None, None


def watch():
    """Let a timer look at the copy until it is there; it is then chosen."""
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=_TICK_SECONDS, persistent=True)


def wait():
    """Wait for the copy; return its folder and the figures of `boxmorph.Guide.quantize`. Raises Refusal."""
    while not _poll():
        time.sleep(_TICK_SECONDS)
    return _end()


def cancel():
    """Ask the work to stop; nothing of the copy is left then."""
    if state.work is not None:
        state.is_cancelled = True
        state.work.cancel()


def stop():
    """Stop the work and wait for it: the extension is disabled, or Blender quits."""
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)
    if state.work is not None:
        cancel()
        try:
            _end()
        except Refusal:
            pass
    state.figures = state.refusal = None


def summary(figures, say=str):
    """Return in a line what a copy is worth; in English, unless `say` translates."""
    said = say(
        "{bytes} instead of {exact_bytes}, {speed:.1f} times as fast. Its embeddings agree to a cosine of "
        "{cosine:.4f}, and it puts candidates into the same order to {order:.2f} of 1"
    )
    return said.format(
        bytes=guides.megabytes(figures["bytes"]),
        exact_bytes=guides.megabytes(figures["exact_bytes"]),
        speed=figures["images_per_second"] / figures["exact_images_per_second"],
        cosine=figures["cosine_mean"],
        order=figures["rank_mean"],
    )


def _unfinished(copy):
    """Return the folder in which a copy grows until it is whole."""
    root, name = os.path.split(copy)
    return os.path.join(root, _BEGINNING + name)


def _poll():
    """Look how far the copy is; return whether the work has ended."""
    state.progress = state.work.progress()
    return state.progress["finished"]


def _tick():
    """Called by the timer."""
    if state.work is None:
        return None
    ended = _poll()
    if ended:
        try:
            folder, _figures = _end()
            guide_downloads.choose(folder)
        except Refusal:
            pass
    redraw_preferences()
    return None if ended else _TICK_SECONDS


def _end():
    """Forget the work; return the copy's folder and its figures. Raises Refusal, kept to be shown."""
    boxmorph = engine.library()
    work, state.work = state.work, None
    try:
        work.join()
        figures = work.result()
        os.rename(_unfinished(state.folder), state.folder)
        state.figures = figures
        return state.folder, figures
    except boxmorph.Cancelled as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    except (boxmorph.GuideError, ValueError, RuntimeError, OSError) as error:
        state.refusal = Refusal(engine.capitalised(engine.sentence(error)))
        remember(str(state.refusal))
        raise state.refusal from error
