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
from screen_steps import OBJECT, PROMPT, find, open_sidebar, report, start_search, wait_for_end

sys.path.insert(0, "/repo/tests/python")
from hub_server import HubServer

PACKAGE = "bl_ext.user_default.boxmorph"
GUIDE = "clip-vit-base-patch32-fp32"
PREFS = f"bpy.context.preferences.addons['{PACKAGE}'].preferences"
STATE = f"__import__('sys').modules['{PACKAGE}.core.guide_downloads'].state"

#: Bytes after which the connection breaks off, of four million.
CUT = 1_500_000

#: Where the mouse is out of the way.
AWAY = (WIDTH - 20, 150)

_AREA = (
    "w = bpy.context.window_manager.windows[0]\n"
    "a = next(a for a in w.screen.areas if a.type == 'PREFERENCES')\n"
    "r = next(r for r in a.regions if r.type == 'WINDOW')\n"
)
_FULL = (
    f"{_AREA}with bpy.context.temp_override(window=w, area=a, region=r):\n"
    "    bpy.ops.screen.screen_full_area(use_hide_panels=True)"
)


def open_preferences(screen, folded=True):
    """Show the extension's preferences over the whole window; return their rectangle (x, top, width, height),
    y downwards. `folded` tells whether they are a line until they are opened.
    """
    screen.ask(
        "view()[1].type = 'PREFERENCES'\n"
        "bpy.context.preferences.active_section = 'ADDONS'\n"
        "bpy.context.window_manager.addon_search = 'Boxmorph'\n"
    )
    if folded:
        screen.ask(f"list(bpy.ops.preferences.addon_expand(module='{PACKAGE}'))")
    screen.ask(_FULL)
    time.sleep(2.0)
    x, y, width, height = screen.ask(f"{_AREA}value = [r.x, r.y, r.width, r.height]")
    return x, HEIGHT - (y + height), width, height


def close_preferences(screen):
    """Bring the viewport back."""
    screen.ask(_FULL)
    time.sleep(1.5)
    screen.ask(f"{_AREA}a.type = 'VIEW_3D'")
    time.sleep(1.5)


def allow(screen, rectangle, hub, shots):
    """Unfold the section; allow online access; name the server. Return the first guide's button."""
    screen.shot(shots("1-folded"))
    folder = find(screen, rectangle, "bpy.ops.boxmorph.open_guides_folder(", start=330, from_right=250)
    screen.click(85, folder[1] + 29)
    screen.wait(lambda: screen.ask(f"{PREFS}.show_downloads"), 10, "the section")
    screen.move(*AWAY)
    screen.shot(shots("2-offline"))
    can = "bpy.ops.boxmorph.download_guide.poll()"
    report(not screen.ask(can), "without online access nothing can be downloaded")
    screen.click(401, folder[1] + 81)
    report(screen.wait(lambda: screen.ask(can), 10, "online access"), "a click beside the reason allows it")
    scroll_down(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.download_guide(", from_right=130)
    screen.type_into(660, button[1] + 319, hub.url)
    typed = screen.ask(f"{PREFS}.hub_endpoint")
    report(typed == hub.url, "the address of a mirror is typed", typed)
    screen.shot(shots("3-list"))
    return button


def scroll_down(screen):
    """Show the end of the preferences."""
    screen.move(WIDTH // 2, HEIGHT // 2)
    for _ in range(25):
        screen.press(5)
    screen.move(*AWAY)
    time.sleep(1.0)


def download(screen, hub, button, shots):
    """Begin a download on a line that breaks off for good."""
    hub.rate, hub.cuts = 500_000, [CUT] + [0] * 20
    screen.click(*button)
    time.sleep(1.0)
    screen.shot(shots("4-dialog"))
    report(hub.log == [], "size and licence are shown before anything is asked of the server", hub.log)
    screen.key("Return")
    here = f"{STATE}.progress.get('bytes', 0)"
    screen.wait(lambda: screen.ask(here) > 600_000, 30, "the first bytes")
    screen.move(*AWAY)
    screen.shot(shots("5-downloading"))
    screen.wait(lambda: screen.ask(f"{STATE}.progress.get('trouble')"), 30, "the cut")
    screen.shot(shots("6-trying-again"))
    sentence = screen.wait(lambda: screen.ask(f"str({STATE}.refusal or '')"), 60, "the end of the tries")
    report("broke off" in sentence, "a line that stays cut is a sentence", sentence)
    screen.shot(shots("7-cut"))
    report(screen.ask(f"{PREFS}.guide") == "EMBEDDED", "what is half here is not offered as a guide")


def resume(screen, rectangle, hub, shots):
    """Go on after a restart of Blender; the guide is then chosen and open."""
    hub.rate, hub.cuts = None, []
    before = len(hub.log)
    scroll_down(screen)
    screen.shot(shots("8-restarted"))
    # Left of those that begin anew.
    button = find(screen, rectangle, "bpy.ops.boxmorph.download_guide(", from_right=360)
    screen.click(*button)
    screen.wait(lambda: screen.ask(f"{PREFS}.guide") == f"FOUND:{GUIDE}", 60, "the guide")
    report(True, "after a restart, a click goes on, and the guide is chosen")
    spans = {span for *_, span in hub.log[before:] if span}
    report(spans == {f"bytes={CUT}-"}, "nothing is fetched twice", spans)
    screen.move(*AWAY)
    time.sleep(1.0)
    screen.shot(shots("9-chosen"))


def deform(screen, shots):
    """Type a prompt and press the button, in the viewport's sidebar."""
    screen.ask(
        f"bpy.context.view_layer.objects.active = bpy.data.objects['{OBJECT}']\n"
        "for o in bpy.data.objects: o.select_set(o == bpy.context.view_layer.objects.active)"
    )
    rectangle = open_sidebar(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    screen.type_into(button[0], button[1] - 28, PROMPT)
    start_search(screen, button)
    wait_for_end(screen)
    key = screen.ask(f"keys('{OBJECT}')").get(PROMPT)
    report(key == 1.0, "it deforms the object", key)
    records = (
        f"list(__import__('sys').modules['{PACKAGE}.outcomes.shape_key']"
        f".records(bpy.data.objects['{OBJECT}'].data).values())"
    )
    judge = screen.ask(f"{records}[0]['guide']['name']")
    report(judge == GUIDE, "and is named in the outcome's record", judge)
    screen.shot(shots("10-deformed"))


def remove(screen, rectangle, shots):
    """Take the guide away again."""
    scroll_down(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.remove_guide(", from_right=39)
    screen.click(*button)
    time.sleep(1.0)
    screen.shot(shots("11-remove"))
    folder = f"__import__('os').path.isdir({PREFS}.guide_folder)"
    report(screen.ask(folder), "removing asks first")
    screen.key("Return")
    screen.wait(lambda: screen.ask(f"{PREFS}.guide") == "EMBEDDED", 20, "the removal")
    report(True, "then the embedded guide judges again")


def first(screen, hub, shots):
    """Begin, and be cut off."""
    rectangle = open_preferences(screen)
    button = allow(screen, rectangle, hub, shots)
    download(screen, hub, button, shots)


def second(screen, hub, shots):
    """Go on, deform, take the guide away."""
    rectangle = open_preferences(screen)
    resume(screen, rectangle, hub, shots)
    close_preferences(screen)
    deform(screen, shots)
    rectangle = open_preferences(screen, folded=False)
    remove(screen, rectangle, shots)


def sit(folder, sitting, name, shots):
    """One session of Blender: what `sitting` does with its screen. It goes on to its end, which is clean."""
    start = Path(folder, name)
    start.mkdir()
    with Screen(start, [f"{folder}/chair.blend"]) as screen:
        try:
            sitting(screen)
        except RuntimeError as error:
            report(False, "the session goes on", error)
            screen.shot(shots("failed"))
        report(screen.quit() == 0, "quitting after it is clean")
    log = (start / "blender.log").read_text(encoding="utf-8", errors="replace")
    # Blender tells where it may not ask for news of its own, and where it gets none: these are no faults.
    report("Traceback" not in log, "Blender printed no error", log[-3000:])


def main(folder, artifacts, suite):
    def shots(step):
        return f"{artifacts}/download-{suite}-{step}.png"

    with HubServer() as hub:
        for sitting in (first, second):
            sit(folder, lambda screen, sitting=sitting: sitting(screen, hub, shots), sitting.__name__, shots)


if __name__ == "__main__":
    main(*sys.argv[1:])
