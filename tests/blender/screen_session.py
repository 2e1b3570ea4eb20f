# SPDX-License-Identifier: MIT OR Apache-2.0
"""One sitting of an artist in front of Blender, by mouse and keyboard; runs inside the chroot.

    python3 screen_session.py FOLDER ARTIFACTS SUITE

FOLDER holds chair.blend and user/, where the extension is installed.

Prints "pass" or "FAIL" lines for run_screen.py to count, and keeps a screenshot of each step.
"""

import sys
import time
from pathlib import Path

from screen_drive import HEIGHT, Screen

PROMPT = "a bar stool"
OBJECT = "Plain Chair"


def report(holds, what, detail=""):
    why = "" if holds or not detail else " (" + " | ".join(str(detail).splitlines()) + ")"
    print(f"{'pass' if holds else 'FAIL'}  {what}{why}", flush=True)


def open_sidebar(screen):
    """Show the sidebar with our tab in front; return its rectangle (x, top, width, height), y downwards."""
    screen.ask("setattr(view()[1].spaces.active, 'show_region_ui', True)")

    def choose():
        screen.ask("setattr(view()[2], 'active_panel_category', 'Boxmorph')")
        return screen.ask("view()[2].active_panel_category") == "Boxmorph"

    screen.wait(choose, 30, "the sidebar tab")
    # A wide sidebar and the object in the middle, as an artist would have them.
    screen.ask(
        "w, a, r = view()\n"
        "with bpy.context.temp_override(window=w, area=a, region=a.regions[-1]):\n"
        "    bpy.ops.view3d.view_selected()\n"
        "value = True"
    )
    screen.ask("view()[1].tag_redraw()")
    time.sleep(2.0)
    x, y, width, height = screen.ask("[getattr(view()[2], n) for n in ('x', 'y', 'width', 'height')]")
    return x, HEIGHT - (y + height), width, height


def find(screen, rectangle, call, start=10, from_right=None):
    """Return the centre of the first button that makes `call`, scanning the sidebar downwards: its middle, or
    so many pixels from its right edge.
    """
    x, top, width, height = rectangle
    x += width // 2 - 25 if from_right is None else width - from_right
    hits = []
    for y in range(top + start, top + height - 10, 7):
        if screen.under(x, y).startswith(call):
            hits.append(y)
        elif hits:
            break
    if not hits:
        raise RuntimeError(f"no button makes {call}")
    return x, (hits[0] + hits[-1]) // 2


def start_search(screen, button):
    """Click until the search runs; a click can be lost while Blender redraws."""
    for _ in range(4):
        screen.click(*button)
        try:
            return screen.wait(lambda: "BOXMORPH_OT_deform" in screen.ask("modal()"), 6, "the search")
        except RuntimeError:
            continue
    return False


def session(screen, shots):
    screen.ask(
        f"bpy.context.view_layer.objects.active = bpy.data.objects['{OBJECT}']\n"
        "for o in bpy.data.objects: o.select_set(o == bpy.context.view_layer.objects.active)\n"
        "bpy.ops.ed.undo_push(message='Start')"
    )
    rectangle = open_sidebar(screen)
    middle = (rectangle[0] // 2, HEIGHT // 2)
    screen.shot(shots("1-panel"))
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    report(True, "the button is in the sidebar")

    screen.type_into(button[0], button[1] - 28, PROMPT[:-2], "Down", shot=shots("1-suggestions"))
    completed = screen.ask("bpy.context.scene.boxmorph.prompt")
    report(completed == PROMPT, "a suggestion completes the prompt", completed)
    screen.type_into(button[0], button[1] - 28, PROMPT)
    typed = screen.ask("bpy.context.scene.boxmorph.prompt")
    report(typed == PROMPT, "the prompt is typed", typed)
    # The long search, so that it is still running when Esc is pressed.
    screen.ask("setattr(bpy.context.scene.boxmorph, 'preset', 'paper')")

    report(bool(start_search(screen, button)), "a click starts the search")
    screen.wait(lambda: screen.ask(f"moved('{OBJECT}')") > 1e-4, 120, "a preview")
    report(True, "the object moves to the best so far")
    screen.shot(shots("2-searching"))
    screen.move(*middle)
    screen.key("Escape")
    screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), 20, "the end of the search")
    left = screen.ask(f"keys('{OBJECT}')")
    report(left == {}, "Esc leaves no shape key", left)
    records = screen.ask("[len(bpy.data.shape_keys), len(bpy.data.images), len(bpy.app.handlers.undo_pre)]")
    report(records[0] == 0 and records[2] == 0, "Esc leaves no data and no handler", records)
    screen.shot(shots("3-cancelled"))

    screen.ask("setattr(bpy.context.scene.boxmorph, 'preset', 'standard')")
    report(bool(start_search(screen, button)), "it starts again")
    screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), 300, "the end of the search")
    found = screen.ask(f"keys('{OBJECT}')")
    report(found.get(PROMPT) == 1.0, "the outcome is a shape key at 1", found)
    screen.shot(shots("4-outcome"))

    screen.move(*middle)
    screen.key("ctrl+z")
    undone = screen.wait(lambda: screen.ask(f"keys('{OBJECT}')") == {}, 20, "undo")
    report(bool(undone), "one undo takes it all back")
    selected = screen.ask("bpy.context.scene.boxmorph.prompt")
    report(selected == PROMPT, "and takes back nothing else", selected)
    screen.key("ctrl+shift+z")
    screen.wait(lambda: screen.ask(f"keys('{OBJECT}')").get(PROMPT) == 1.0, 20, "redo")
    report(True, "redo brings it again")

    take_apart(screen, rectangle, button, shots)
    keyframe = find(
        screen, rectangle, "bpy.ops.boxmorph.keyframe_spectrum()", start=button[1] - rectangle[1] + 100
    )
    screen.click(*keyframe)
    animated = "bool(bpy.data.shape_keys[0].animation_data and bpy.data.shape_keys[0].animation_data.action)"
    screen.wait(lambda: screen.ask(animated), 20, "keyframes")
    report(True, "a click keyframes the spectrum")
    screen.ask("bpy.context.scene.frame_set(30)")
    value = screen.ask(f"keys('{OBJECT}')")[PROMPT]
    report(0.4 < value < 0.6, "half-way, the slider is half-way", value)
    screen.shot(shots("5-keyframed"))

    below = keyframe[1] - rectangle[1] - 50
    scores = find(screen, rectangle, "bpy.ops.boxmorph.measure_scores(", start=below, from_right=42)
    screen.click(*scores)
    curve = "'score_curve' in bpy.data.shape_keys[0]['boxmorph']"
    screen.wait(lambda: screen.ask(curve), 30, "the curve of scores")
    report(True, "a click draws the scores along the slider")
    screen.move(*middle)
    time.sleep(1.0)
    screen.shot(shots("5-scores"))
    # The curve takes a row of its own.
    keyframe = find(screen, rectangle, "bpy.ops.boxmorph.keyframe_spectrum()", start=below)

    parts_header, views_header = keyframe[1] + 30, keyframe[1] + 57
    screen.click(keyframe[0], parts_header)
    parts = find(screen, rectangle, "bpy.ops.boxmorph.find_parts(", start=parts_header - rectangle[1])
    screen.click(*parts)
    count = f"len(bpy.data.objects['{OBJECT}'].boxmorph.items)"
    report(screen.wait(lambda: screen.ask(count), 30, "the parts") > 1, "a click finds the parts")
    screen.ask(f"setattr(bpy.data.objects['{OBJECT}'].boxmorph.items[0], 'lock', (True, True, True))")
    screen.move(*middle)
    time.sleep(1.0)
    screen.shot(shots("6-parts"))
    screen.click(keyframe[0], parts_header)

    screen.click(keyframe[0], views_header)
    views = find(screen, rectangle, "bpy.ops.boxmorph.show_views(", start=views_header - rectangle[1])
    screen.click(*views)
    screen.wait(lambda: screen.ask("'Boxmorph Views' in bpy.data.images"), 30, "the views")
    report(True, "a click shows the views")
    screen.move(*middle)
    time.sleep(1.0)
    screen.shot(shots("7-views"))


def take_apart(screen, rectangle, button, shots):
    """Take the outcome apart by its menu, look, and undo it."""
    middle = (rectangle[0] // 2, HEIGHT // 2)
    below = button[1] - rectangle[1] + 50
    remove = find(screen, rectangle, "bpy.ops.boxmorph.remove_outcome(", start=below, from_right=62)
    screen.click(remove[0] + 20, remove[1])
    time.sleep(1.0)
    screen.shot(shots("4-menu"))
    screen.key("Down")
    screen.key("Return")
    pieces = f"[name for name in keys('{OBJECT}') if name.startswith('{PROMPT}: ')]"
    screen.wait(lambda: len(screen.ask(pieces)) > 2, 20, "the pieces")
    report(True, "the outcome's menu takes it apart")
    screen.move(*middle)
    time.sleep(1.0)
    screen.shot(shots("4-taken-apart"))
    screen.key("ctrl+z")
    screen.wait(lambda: screen.ask(pieces) == [], 20, "undo of taking apart")
    value = screen.ask(f"keys('{OBJECT}')").get(PROMPT)
    report(value == 1.0, "one undo puts it together again", value)


def interruptions(screen):
    """What else can happen while a search runs: none of it may leave a trace or end Blender."""
    rectangle = open_sidebar(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    middle = (rectangle[0] // 2, HEIGHT // 2)
    nothing = screen.ask(f"keys('{OBJECT}')")

    def searching():
        start_search(screen, button)
        screen.wait(lambda: screen.ask(f"moved('{OBJECT}')") > 1e-4, 120, "a preview")

    def ended(what):
        screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), 60, f"the end after {what}")
        left = screen.ask(f"keys('{OBJECT}')")
        report(left == nothing, f"{what} ends the search and leaves nothing", left)

    searching()
    screen.move(*middle)
    screen.key("ctrl+z")
    ended("Ctrl+Z")

    searching()
    screen.click(*find(screen, rectangle, "bpy.ops.boxmorph.cancel(", start=button[1] - rectangle[1] + 50))
    ended("the button Cancel")

    searching()
    # As the menus do it, past our modal operator; a menu's place depends on how fast the screen is.
    screen.ask("w, a, r = view()\nwith bpy.context.temp_override(window=w, area=a):\n    bpy.ops.ed.undo()")
    ended("undo by its operator")

    select(screen)
    searching()
    screen.move(*middle)
    screen.key("Tab")
    screen.wait(lambda: screen.ask(f"bpy.data.objects['{OBJECT}'].mode") == "EDIT", 20, "Edit Mode")
    screen.key("Escape")
    time.sleep(1.5)
    report(screen.ask(f"bpy.data.objects['{OBJECT}'].mode") == "EDIT", "Esc in Edit Mode stays in Edit Mode")
    screen.key("Tab")
    ended("Esc in Edit Mode")

    searching()
    screen.move(*middle)
    screen.key("Delete")
    screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), 60, "the end after deleting")
    report(screen.ask(f"'{OBJECT}' not in bpy.context.scene.objects"), "deleting the object ends the search")
    screen.key("ctrl+z")
    screen.wait(lambda: screen.ask(f"'{OBJECT}' in bpy.context.scene.objects"), 20, "undo of deleting")
    left = screen.ask(f"keys('{OBJECT}')")
    report(left == nothing, "undo brings the object back without a preview", left)

    screen.ask("bpy.ops.wm.revert_mainfile()")
    select(screen)
    searching()
    screen.ask("bpy.ops.wm.revert_mainfile()")
    screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), 60, "the end after loading")
    report(screen.ask(f"keys('{OBJECT}')") == {}, "loading a file ends the search")

    select(screen)
    searching()
    screen.ask("bpy.ops.preferences.addon_disable(module='bl_ext.user_default.boxmorph')")
    left = screen.ask(f"[keys('{OBJECT}'), len(bpy.app.handlers.undo_pre)]")
    report(left == [{}, 0], "disabling the extension ends the search and leaves nothing", left)
    # The operator goes when Blender has let go of it.
    screen.move(*middle)
    gone = "not hasattr(bpy.types, 'BOXMORPH_OT_deform')"
    report(bool(screen.wait(lambda: screen.ask(gone), 20, "the operator's end")), "and then no operator")
    screen.ask("bpy.ops.preferences.addon_enable(module='bl_ext.user_default.boxmorph')")

    select(screen)
    searching()
    code = screen.quit()
    report(code == 0, "quitting during a search is clean", code)


def select(screen):
    """Make OBJECT the active and only selected one, as the state that undo returns to; open our tab."""
    screen.ask(
        f"bpy.context.view_layer.objects.active = bpy.data.objects['{OBJECT}']\n"
        "for o in bpy.data.objects: o.select_set(o == bpy.context.view_layer.objects.active)\n"
        f"bpy.context.scene.boxmorph.prompt = '{PROMPT}'\n"
        "bpy.context.scene.boxmorph.preset = 'paper'\n"
        "bpy.ops.ed.undo_push(message='Start')"
    )
    open_sidebar(screen)


def main(folder, artifacts, suite):
    arguments = ["--factory-startup", "--addons", "bl_ext.user_default.boxmorph", f"{folder}/chair.blend"]
    with Screen(folder, arguments) as screen:
        try:
            session(screen, lambda step: f"{artifacts}/screen-{suite}-{step}.png")
            screen.ask("bpy.ops.wm.revert_mainfile()")
            select(screen)
            interruptions(screen)
        except RuntimeError as error:
            report(False, "the session goes on", error)
            screen.shot(f"{artifacts}/screen-{suite}-failed.png")
    log = Path(folder, "blender.log").read_text(encoding="utf-8", errors="replace")
    report("Traceback" not in log and "Error" not in log, "Blender printed no error", log[-3000:])


if __name__ == "__main__":
    main(*sys.argv[1:])
