# SPDX-License-Identifier: GPL-3.0-or-later
"""What Boxmorph is doing, as text to paste into a report on a bug: versions, preferences, the active object,
the settings, the running search, and what the user was told last.

Names of objects are in it; paths are without the user's name.
"""

import json
import os
import platform
import re

import bpy
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.props import BoolProperty

from ..core import engine, guides
from ..errors import Refusal, tells_refusals, told
from ..operators.properties import BoxmorphSettings, SearchProperties
from ..outcomes import shape_key
from ..preferences import preferences
from ..searching import running
from ..searching.progress import progress_text
from . import preferences_editor

#: Name of the text data-block that is made on request.
TEXT = "Boxmorph Report"

#: Shape keys, modifiers and parts that are named one by one.
_MOST = 20

#: A longer list in an outcome's record is left out.
_LONGEST = 24

#: Folders of all users, below which the next folder bears a user's name.
_USERS = re.compile(
    r"((?:/home|/Users|/media|/run/media|[A-Za-z]:[\\/]Users)[\\/])"
    # With blanks only where the path goes on.
    r"(?:[^\\/\n\"“”]+(?=[\\/])|[^\\/\s\"“”]+)"
)


def text(context):
    """Return the report as Markdown."""
    sections = [
        ("Versions", _versions()),
        ("Guide", _guide()),
        ("Preferences", _preferences()),
        ("Settings", _settings(context.scene.boxmorph)),
        ("Object", _object(context.active_object)),
        ("Running", [_running()]),
        ("Told last", list(told) or ["nothing"]),
    ]
    lines = ["# Boxmorph report"]
    for title, entries in sections:
        lines += ["", f"## {title}", *(f"- {entry}" for entry in entries)]
    record = _record(context.active_object)
    if record:
        lines += ["", "## Outcome", "```json", record, "```"]
    return without_user("\n".join(lines) + "\n")


def without_user(text):
    """Return `text` with the user's home folder as ~, and without users' names in other paths."""
    home = os.path.expanduser("~")
    for path in {home, os.path.realpath(home), home.replace("\\", "/")}:
        if len(path) > 1:
            text = re.sub(re.escape(path) + r"(?![\w.-])", "~", text, flags=re.IGNORECASE)
    return _USERS.sub(r"\1…", text)


def _versions():
    lines = [
        f"Blender {bpy.app.version_string} ({bpy.app.build_platform.decode(errors='replace')}, "
        f"{bpy.app.build_hash.decode(errors='replace')}){', in background' if bpy.app.background else ''}",
        f"Python {platform.python_version()}",
        f"{platform.platform()}, {platform.machine()}, {os.cpu_count()} processor threads",
    ]
    try:
        boxmorph = engine.library()
    except Refusal as refusal:
        return [f"Boxmorph: {refusal}", *lines]
    lines.insert(0, f"Boxmorph {boxmorph.__version__}")
    try:
        providers = ", ".join(boxmorph.execution_providers())
        lines.append(f"ONNX Runtime {boxmorph.runtime_version()}, {boxmorph.runtime_library()}: {providers}")
    except boxmorph.GuideError as error:
        lines.append(engine.sentence(error))
    if preferences().renderer == "cpu":
        # Asking opens the drivers, which may be what was to be avoided.
        lines.append("Graphics card: not asked, the renderer is the processor")
    else:
        lines.append(f"Graphics card: {boxmorph.graphics_adapter() or 'none for rendering'}")
    return lines


def _guide():
    try:
        guide = engine.open_guide()
    except Refusal as refusal:
        return [str(refusal)]
    lines = [line for line, _icon in preferences_editor.guide_lines()]
    lines.append(f"Encodes on {guide.provider}")
    if guide.provider_note is not None:
        lines.append(guide.provider_note)
    return lines


def _preferences():
    prefs = preferences()
    names = (
        "guide_folder",
        "guides_folder",
        "hub_endpoint",
        "runtime_library",
        "provider",
        "renderer",
        "threads",
    )
    lines = [f"{name}: {getattr(prefs, name)!r}" for name in names]
    return [
        *lines,
        f"guides: {', '.join(map(os.path.basename, guides.found())) or 'none'} in {guides.root()}",
    ]


def _settings(settings):
    names = dict.fromkeys([*SearchProperties.__annotations__, *BoxmorphSettings.__annotations__])
    return [", ".join(f"{name} {_value(getattr(settings, name))}" for name in names)]


def _value(value):
    """Return a setting in a few characters."""
    if isinstance(value, float):
        return f"{value:.6g}"
    return repr(value.name if isinstance(value, bpy.types.ID) else value)


def _object(obj):
    if obj is None:
        return ["none is active"]
    lines = [f"“{obj.name}”, {obj.type.lower()}, {obj.mode.lower().replace('_', ' ')} mode"]
    if obj.type != "MESH":
        return lines
    mesh = obj.data
    triangles = len(mesh.loops) - 2 * len(mesh.polygons)
    size = " × ".join(f"{side:.4g}" for side in obj.dimensions)
    linked = ", linked or overridden" if obj.library or mesh.library or obj.override_library else ""
    lines.append(
        f"{len(mesh.vertices)} vertices, {len(mesh.polygons)} faces, {triangles} triangles, {size}, "
        f"{mesh.users} users{linked}"
    )
    modifiers = [f"{m.type}{'' if m.show_viewport else ' (hidden)'}" for m in obj.modifiers]
    lines.append(f"modifiers: {_some(modifiers)}")
    keys = mesh.shape_keys
    blocks = [] if keys is None else [f"“{key.name}” {key.value:.3g}" for key in keys.key_blocks]
    lines.append(f"shape keys: {_some(blocks)}{'' if keys is None or keys.use_relative else ', absolute'}")
    lines.append(f"outcomes: {_some([f'“{name}”' for name in shape_key.records(mesh)])}")
    parts = [_part(part) for part in obj.boxmorph.items]
    lines.append(f"parts: {_some(parts)}")
    if parts:
        lines.append(f"{obj.boxmorph.coarse} faces span parts")
    return lines


def _part(part):
    locked = "".join(axis for axis, lock in zip("xyz", part.lock, strict=True) if lock)
    return part.name + (f" (locked {locked})" if locked else "")


def _some(names):
    """Return names in a line, the first of many."""
    if not names:
        return "none"
    more = f" and {len(names) - _MOST} more" if len(names) > _MOST else ""
    return f"{len(names)}: " + ", ".join(names[:_MOST]) + more


def _running():
    progress = None if running.running.search is None else running.running.search.progress
    return "no search" if progress is None else progress_text(progress)


def _record(obj):
    """Return the record of the outcome that is meant, as JSON; nothing where there is none."""
    if obj is None or obj.type != "MESH":
        return ""
    _name, report = shape_key.meant_outcome(obj)
    return json.dumps(_short(report), ensure_ascii=False) if report else ""


def _short(value):
    """Return a JSON value with numbers rounded and long lists left out."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, dict):
        return {name: _short(each) for name, each in value.items()}
    if isinstance(value, list):
        return [_short(each) for each in value] if len(value) <= _LONGEST else f"{len(value)} values"
    return value


class BOXMORPH_OT_copy_report(bpy.types.Operator):
    """Put a text on the clipboard that says what Boxmorph is doing: versions, settings, counts of the active
    object, what was refused last. For a report on a bug; it names no user, and nothing is sent
    """

    bl_idname = "boxmorph.copy_report"
    bl_label = "Copy Report"
    bl_options = {"REGISTER"}

    as_text: BoolProperty(
        name="As Text",
        description="Put it into the text “Boxmorph Report” of this file instead, to read it first",
        default=False,
        options={"SKIP_SAVE"},
    )

    @tells_refusals
    def execute(self, context):
        report = text(context)
        if not self.as_text:
            if bpy.app.background:
                raise Refusal("There is no clipboard in background. Ask for the report as text")
            context.window_manager.clipboard = report
            self.report({"INFO"}, rpt_("The report is on the clipboard. Paste it where you tell of the bug"))
            return {"FINISHED"}
        block = bpy.data.texts.get(TEXT) or bpy.data.texts.new(TEXT)
        block.from_string(report)
        self.report({"INFO"}, rpt_("The report is the text “{}”. Read it in a Text Editor").format(TEXT))
        return {"FINISHED"}


classes = (BOXMORPH_OT_copy_report,)
