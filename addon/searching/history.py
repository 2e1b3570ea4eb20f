# SPDX-License-Identifier: GPL-3.0-or-later
"""The prompts of this user's last searches, newest first, kept in the extension's user folder."""

import functools
import json
import os
from contextlib import suppress

import bpy

from ..preferences import PACKAGE
from ..redraw import redraw_panels

_KEPT = 12


@functools.cache
def _prompts():
    """Return the list, read once and then changed in place."""
    try:
        with open(_path(), encoding="utf-8") as file:
            stored = json.load(file)
    except (OSError, ValueError):
        stored = []
    return [prompt for prompt in stored if isinstance(prompt, str)] if isinstance(stored, list) else []


def recent():
    """Return the last prompts, newest first."""
    return tuple(_prompts())


def remember(prompt):
    """Put a prompt in front of the list, which lasts a session where its folder cannot be written."""
    prompt = " ".join(prompt.split())
    known = _prompts()
    if known[:1] == [prompt]:
        return
    known[:] = [prompt, *(other for other in known if other != prompt)][:_KEPT]
    with suppress(OSError):
        path = _path(create=True)
        with open(path + ".new", "w", encoding="utf-8") as file:
            json.dump(known, file, ensure_ascii=False)
        os.replace(path + ".new", path)


def _path(create=False):
    return os.path.join(bpy.utils.extension_path_user(PACKAGE, create=create), "prompts.json")


class BOXMORPH_OT_use_prompt(bpy.types.Operator):
    """Type this prompt again"""

    bl_idname = "boxmorph.use_prompt"
    bl_label = "Use Prompt"
    bl_options = {"INTERNAL", "UNDO"}

    prompt: bpy.props.StringProperty()

    def execute(self, context):
        context.scene.boxmorph.prompt = self.prompt
        redraw_panels()
        return {"FINISHED"}


class BOXMORPH_MT_prompts(bpy.types.Menu):
    """Prompts of the last searches"""

    bl_label = "Last Prompts"

    def draw(self, _context):
        for prompt in recent():
            self.layout.operator("boxmorph.use_prompt", text=prompt, translate=False).prompt = prompt


classes = (BOXMORPH_OT_use_prompt, BOXMORPH_MT_prompts)
