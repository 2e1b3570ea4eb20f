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
from screen_interruptions import interruptions, queue
from screen_more import evaluate_all, seconds
from screen_steps import (
    OBJECT,
    PROMPT,
    find,
    open_sidebar,
    redraw_rate,
    report,
    select,
    start_search,
    wait_for_end,
)


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
    searching = redraw_rate(screen)
    screen.shot(shots("2-searching"))
    screen.move(*middle)
    screen.key("Escape")
    wait_for_end(screen)
    left = screen.ask(f"keys('{OBJECT}')")
    report(left == {}, "Esc leaves no shape key", left)
    left = screen.ask("[*bpy.data.shape_keys, *handlers()]")
    report(left == [], "Esc leaves no data and no handler", left)
    screen.shot(shots("3-cancelled"))
    idle = redraw_rate(screen)
    rates = f"{searching:.1f} redraws a second while searching, {idle:.1f} without"
    report(searching >= 0.5 * idle, rates)

    screen.ask("setattr(bpy.context.scene.boxmorph, 'preset', 'standard')")
    report(bool(start_search(screen, button)), "it starts again")
    wait_for_end(screen)
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

    drag_slider(screen, rectangle, button, shots)
    vary(screen, rectangle, button, shots)
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

    # Below it is the header of "More to the Prompt", then these.
    parts_header, search_header, guide_header, views_header = (keyframe[1] + y for y in (57, 83, 110, 136))
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

    for name, header in (("search", search_header), ("guide", guide_header)):
        screen.click(keyframe[0], header)
        screen.move(*middle)
        time.sleep(1.0)
        screen.shot(shots(f"6-{name}"))
        screen.click(keyframe[0], header)

    screen.click(keyframe[0], views_header)
    views = find(screen, rectangle, "bpy.ops.boxmorph.show_views(", start=views_header - rectangle[1])
    screen.click(*views)
    screen.wait(lambda: screen.ask("'Boxmorph Views' in bpy.data.images"), 30, "the views")
    report(True, "a click shows the views")
    screen.move(*middle)
    time.sleep(1.0)
    screen.shot(shots("7-views"))
    save_and_reopen(screen, middle, shots)


def save_and_reopen(screen, middle, shots):
    """Save by the keyboard, load the file again: outcome, animation and prompt are there."""
    screen.ask("bpy.context.scene.frame_set(60)")
    screen.key("ctrl+s")
    screen.wait(lambda: not screen.ask("bpy.data.is_dirty"), 20, "saving")
    screen.ask("bpy.ops.wm.revert_mainfile()")
    value = screen.ask(f"keys('{OBJECT}')").get(PROMPT)
    prompt = screen.ask("bpy.context.scene.boxmorph.prompt")
    report(value == 1.0 and prompt == PROMPT, "saved and loaded again, all is there", (value, prompt))
    open_sidebar(screen)
    screen.shot(shots("8-reopened"))


def slider_of(screen, rectangle, button):
    """Return the centre of the outcome's slider, which stands at 1."""
    return find(screen, rectangle, "1.0", start=button[1] - rectangle[1] + 60)


def drag_slider(screen, rectangle, button, shots):
    """Drag the slider of the outcome to the left, look, and undo it."""
    slider = slider_of(screen, rectangle, button)
    screen.drag(*slider, 60)
    value = screen.ask(f"keys('{OBJECT}')")[PROMPT]
    report(value < 0.9, "the slider is dragged", value)
    screen.shot(shots("4-dragged"))
    screen.move(rectangle[0] // 2, HEIGHT // 2)
    screen.key("ctrl+z")
    back = screen.wait(lambda: screen.ask(f"keys('{OBJECT}')")[PROMPT] == 1.0, 20, "undo of dragging")
    report(bool(back), "one undo takes back the dragging")


def open_menu(screen, rectangle, button):
    """Open the menu beside the outcome's slider."""
    slider = slider_of(screen, rectangle, button)
    screen.click(rectangle[0] + rectangle[2] - 49, slider[1])
    time.sleep(1.0)


def vary(screen, rectangle, button, shots):
    """Search variations by the menu, look, and undo them."""
    open_menu(screen, rectangle, button)
    # The letter that is underlined in "Variations".
    screen.key("v")
    screen.wait(lambda: "BOXMORPH_OT_deform" in screen.ask("modal()"), 20, "the search for variations")
    wait_for_end(screen, "variations")
    others = f"[name for name in keys('{OBJECT}') if name not in ('Basis', '{PROMPT}')]"
    found = screen.ask(others)
    report(len(found) > 0, "the outcome's menu finds variations", found)
    screen.move(rectangle[0] // 2, HEIGHT // 2)
    time.sleep(1.0)
    screen.shot(shots("4-variations"))
    screen.key("ctrl+z")
    screen.wait(lambda: screen.ask(others) == [], 20, "undo of variations")
    report(True, "one undo takes them back")


def take_apart(screen, rectangle, button, shots):
    """Take the outcome apart by its menu, look, and undo it."""
    middle = (rectangle[0] // 2, HEIGHT // 2)
    open_menu(screen, rectangle, button)
    screen.shot(shots("4-menu"))
    # The letter that is underlined in "Take Apart".
    screen.key("t")
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


def main(folder, artifacts, suite):
    chair = Path(folder, "chair.blend")
    as_made = chair.read_bytes()
    arguments = ["--factory-startup", "--addons", "bl_ext.user_default.boxmorph", str(chair)]

    def shots(step):
        return f"{artifacts}/screen-{suite}-{step}.png"

    with Screen(folder, arguments) as screen:
        try:
            session(screen, shots)
            for sitting in (queue, seconds, evaluate_all, interruptions):
                chair.write_bytes(as_made)
                screen.ask(f"bpy.ops.wm.open_mainfile(filepath='{chair}')")
                select(screen)
                sitting(screen, shots)
        except RuntimeError as error:
            report(False, "the session goes on", error)
            screen.shot(f"{artifacts}/screen-{suite}-failed.png")
    log = Path(folder, "blender.log").read_text(encoding="utf-8", errors="replace")
    report("Traceback" not in log and "Error" not in log, "Blender printed no error", log[-3000:])


if __name__ == "__main__":
    main(*sys.argv[1:])
