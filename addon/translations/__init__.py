# SPDX-License-Identifier: GPL-3.0-or-later
"""The languages of the interface: messages as they are in the code, and what they are elsewhere.

Blender takes the messages of "de" for every locale that begins so, such as "de_DE". Its own translation of a
message, where it has one, comes first; `sidebar.CONTEXT` is for words that it means otherwise.
"""

import bpy

from . import de

#: By locale, from (context, message) to the message in that language.
LANGUAGES = {"de": de.MESSAGES}

_OWNER = __package__.rpartition(".")[0]


def register():
    """Let Blender find the messages."""
    bpy.app.translations.register(_OWNER, LANGUAGES)


def unregister():
    """Let Blender forget them again."""
    bpy.app.translations.unregister(_OWNER)
