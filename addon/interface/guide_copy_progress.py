# SPDX-License-Identifier: GPL-3.0-or-later
"""In the preferences: the button that makes a copy of a guide, how far the copy is, and what it is worth."""

from bpy.app.translations import pgettext_iface as iface_

from ..core import engine, guide_copies
from .lines import draw_lines


def draw(layout, letters):
    """Draw a row, the button's or the progress's, and how the last copy ended; `letters` go into a line."""
    state = guide_copies.state
    if state.work is not None:
        row = layout.row()
        row.progress(factor=state.progress["fraction"], type="BAR", text=progress_text(iface_))
        row.operator("boxmorph.cancel_guide_copy", text="", icon="X")
        return
    row = layout.row(align=True)
    row.operator("boxmorph.check_guide", icon="FILE_REFRESH")
    row.operator("boxmorph.quantize_guide", icon="MOD_DECIM")
    if state.refusal is not None:
        draw_lines(layout, [(state.refusal.said(iface_), "ERROR")], letters)
    elif state.figures is not None and state.folder == engine.guide_folder():
        draw_lines(layout, [(guide_copies.summary(state.figures, iface_), "INFO")], letters)


def progress_text(say=str):
    """Return in a line how far the copy is; in English, unless `say` translates."""
    state = guide_copies.state
    phase = say("Cancelling") if state.is_cancelled else say(state.progress["phase"])
    words = say("8-bit copy: {phase}, {percent} %")
    return words.format(phase=phase, percent=int(100 * state.progress["fraction"]))
