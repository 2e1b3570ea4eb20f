# SPDX-License-Identifier: GPL-3.0-or-later
"""Where our panels are."""

#: Translation context of words that Blender translates in another meaning: Search, Guide, Paper.
CONTEXT = "Boxmorph"


class Sidebar:
    """A panel in our tab of the 3D viewport's sidebar (a mixin)."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Boxmorph"
    bl_translation_context = CONTEXT
