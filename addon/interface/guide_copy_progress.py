# SPDX-License-Identifier: GPL-3.0-or-later
"""In the preferences: the button that makes a copy of a guide, how far the copy is, and what it is worth."""

from bpy.app.translations import pgettext_iface as iface_

from ..core import engine, guide_copies


def draw(layout):
    """Draw a row: the button, or how far the copy is."""
    state = guide_copies.state
    if state.work is not None:
        row = layout.row()
        row.progress(factor=state.progress["fraction"], type="BAR", text=progress_text(iface_))
        row.operator("boxmorph.cancel_guide_copy", text="", icon="X")
        return
    row = layout.row(align=True)
    row.operator("boxmorph.check_guide", icon="FILE_REFRESH")
    row.operator("boxmorph.quantize_guide", icon="MOD_DECIM")


def lines(say=str):
    """Return lines with icons on how the last copy ended; in English, unless `say` translates."""
    state = guide_copies.state
    if state.refusal is not None:
        return [(state.refusal.said(say), "ERROR")]
    if state.figures is not None and state.folder == engine.guide_folder():
        return [(guide_copies.summary(state.figures, say), "INFO")]
    return []


def progress_text(say=str):
    """Return in a line how far the copy is; in English, unless `say` translates."""
    state = guide_copies.state
    phase = say("Cancelling") if state.is_cancelled else say(state.progress["phase"])
    words = say("8-bit copy: {phase}, {percent} %")
    return words.format(phase=phase, percent=int(100 * state.progress["fraction"]))
