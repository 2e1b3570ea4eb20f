# SPDX-License-Identifier: GPL-3.0-or-later
"""In the preferences: the guides that can be downloaded, the one that comes, and those that are here."""

import bpy
from bpy.app.translations import pgettext_iface as iface_

from ..core import engine, guide_downloads, guides
from ..core.guide_downloads import PRECISIONS
from ..errors import Refusal
from .lines import draw_lines


def draw(layout, prefs, letters):
    """Draw the folded section; `letters` go into a line."""
    row = layout.row()
    row.use_property_split = False
    row.alignment = "LEFT"
    row.prop(
        prefs, "show_downloads", icon="DOWNARROW_HLT" if prefs.show_downloads else "RIGHTARROW", emboss=False
    )
    if not prefs.show_downloads:
        return
    body = layout.column()
    try:
        entries = guide_downloads.entries()
    except Refusal as refusal:
        draw_lines(body, [(refusal.said(iface_), "ERROR")], letters)
        return
    _draw_online(body, letters)
    if guide_downloads.state.download is not None:
        _draw_progress(body.box(), entries, letters)
    elif guide_downloads.state.refusal is not None:
        draw_lines(body, [(guide_downloads.state.refusal.said(iface_), "ERROR")], letters)
    for entry in entries:
        _draw_entry(body, entry)
    body.prop(prefs, "hub_endpoint", placeholder="https://huggingface.co")


def _draw_online(layout, letters):
    """Say why nothing can be downloaded, with the switch at hand where there is one."""
    refusal = guide_downloads.online_refusal()
    if refusal is None:
        return
    draw_lines(layout, [(refusal.said(iface_), "INTERNET_OFFLINE")], letters)
    if not bpy.app.online_access_override:
        system = bpy.context.preferences.system
        layout.prop(system, "use_online_access", text="Allow Online Access")


def _draw_entry(layout, entry):
    """Draw one guide: what it is, a button to get it, and what of it is here."""
    known = {name: guide_downloads.presence(entry["id"], name) for name in entry["precisions"]}
    sizes = sorted(details["bytes"] for details in entry["precisions"].values())
    column = layout.box().column(align=True)
    row = column.split(factor=0.75)
    what = iface_("{title}: {least} to {most}, {licence}").format(
        title=entry["title"],
        least=guides.megabytes(sizes[0]),
        most=guides.megabytes(sizes[-1]),
        licence=entry["licence"],
    )
    row.label(text=what, translate=False)
    absent = [name for name, there in known.items() if there["state"] == "absent"]
    button = row.row()
    button.enabled = bool(absent)
    operator = button.operator("boxmorph.download_guide", text="Download", icon="IMPORT")
    operator.guide = entry["id"]
    if absent:
        operator.precision = absent[0]
    column.label(text=iface_(entry["good_for"]), translate=False)
    for name, there in known.items():
        if there["state"] != "absent" and not guide_downloads.is_running(entry["id"], name):
            _draw_present(column, entry["id"], name, there)


def _draw_present(layout, guide, precision, there):
    """Draw what is here of one precision of a guide, and what can be done with it."""
    row = layout.split(factor=0.55)
    row.label(text=_said(precision, there), icon=_icon(there), translate=False)
    row = row.row(align=True)
    if there["state"] == "partial":
        percent = int(100 * there["bytes"] / max(there["total"], 1))
        text = iface_("Resume ({} % here)", "Operator").format(percent)
        operator = row.operator("boxmorph.download_guide", text=text, icon="IMPORT", translate=False)
        operator.resume = True
    else:
        is_used = str(there["path"]) == engine.guide_folder() and _is_chosen(precision)
        operator = row.operator("boxmorph.use_guide", text="In Use" if is_used else "Use", depress=is_used)
    operator.guide, operator.precision = guide, precision
    if there["state"] != "cached":
        operator = row.operator("boxmorph.remove_guide", text="", icon="TRASH")
        operator.guide, operator.precision = guide, precision


def _is_chosen(precision):
    """Whether the chosen guide is of this precision."""
    guide, _why = engine.known_guide()
    chosen = engine.guide_precision()
    return chosen == precision or (chosen == "auto" and (guide is None or guide.precision == precision))


def _said(precision, there):
    name = iface_(PRECISIONS[precision][0])
    if there["state"] == "partial":
        words = iface_("{name}: {here} of {total}")
        here, total = guides.megabytes(there["bytes"]), guides.megabytes(there["total"])
        return words.format(name=name, here=here, total=total)
    if there["state"] == "cached":
        return iface_("{name}: in the hub's cache").format(name=name)
    return iface_("{name}: downloaded").format(name=name)


def _icon(there):
    return "TIME" if there["state"] == "partial" else "CHECKMARK"


def _draw_progress(layout, entries, letters):
    """Draw the download that runs."""
    state = guide_downloads.state
    title = next(entry["title"] for entry in entries if entry["id"] == state.guide)
    layout.label(text=f"{title}, {state.precision}", translate=False)
    progress = state.progress
    row = layout.row()
    share = progress["bytes"] / progress["total"] if progress["total"] else 0.0
    row.progress(factor=min(share, 1.0), type="BAR", text=progress_text(progress, iface_))
    row.operator("boxmorph.cancel_guide", text="", icon="X")
    if progress["trouble"]:
        draw_lines(layout, [(iface_("Trying again: {}").format(progress["trouble"]), "ERROR")], letters)


def progress_text(progress, say=str):
    """Return the progress of a download in one line; in English, unless `say` translates."""
    if not progress["total"]:
        return say(progress["phase"])
    words = say("{here} of {total}")
    parts = [
        words.format(here=guides.megabytes(progress["bytes"]), total=guides.megabytes(progress["total"]))
    ]
    if progress["phase"] != "Downloading":
        parts.insert(0, say(progress["phase"]))
    elif progress["seconds_left"] is not None:
        seconds = progress["seconds_left"]
        is_short = seconds < 100
        left = say("{:.0f} s left") if is_short else say("{:.0f} min left")
        parts.append(left.format(seconds if is_short else seconds / 60))
    return ", ".join(parts)
