# SPDX-License-Identifier: GPL-3.0-or-later
"""Redraws of what does not change with Blender's own data."""

import bpy


def redraw_panels():
    """Ask for a redraw of the 3D viewports' sidebars in all windows."""
    for area in _viewports():
        for region in area.regions:
            if region.type == "UI":
                region.tag_redraw()


def redraw_preferences():
    """Ask for a redraw of the preferences in all windows."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "PREFERENCES":
                area.tag_redraw()


def redraw_viewports():
    """Ask for a redraw of the 3D viewports in all windows, with their sidebars."""
    for area in _viewports():
        area.tag_redraw()


def _viewports():
    for window in bpy.context.window_manager.windows:
        yield from (area for area in window.screen.areas if area.type == "VIEW_3D")
