# SPDX-License-Identifier: MIT OR Apache-2.0
"""A search of so many seconds, and the evaluation of all outcomes: by mouse and keyboard."""

import time
from pathlib import Path

from screen_drive import HEIGHT, WIDTH
from screen_steps import OBJECT, PROMPT, find, open_sidebar, report, start_search, wait_for_end

RECORDS = (
    "list(__import__('sys').modules['bl_ext.user_default.boxmorph.outcomes.shape_key']"
    f".records(bpy.data.objects['{OBJECT}'].data).values())"
)


def seconds(screen, shots):
    """Choose the preset Time, type how long, and search."""
    rectangle = open_sidebar(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    # Below the button; T is the letter that is underlined in "Time".
    screen.click(rectangle[0] + 60, button[1] + 30)
    time.sleep(1.0)
    screen.shot(shots("10-presets"))
    screen.key("t")
    chosen = screen.ask("bpy.context.scene.boxmorph.preset")
    report(chosen == "time", "the preset Time is chosen", chosen)
    screen.move(rectangle[0] // 2, HEIGHT // 2)
    time.sleep(1.0)
    screen.shot(shots("10-seconds"))
    screen.type_into(button[0], button[1] + 56, "3")
    typed = screen.ask("bpy.context.scene.boxmorph.seconds")
    report(typed == 3.0, "the seconds are typed", typed)
    begin = time.monotonic()
    start_search(screen, button)
    wait_for_end(screen)
    took = time.monotonic() - begin
    record = screen.ask(f"{RECORDS}[0]")
    report(
        record["seconds_budget"] == 3.0 and 1.0 < record["seconds"] < 6.0,
        f"the search takes the seconds: {record['seconds']:.1f} s, {took:.1f} s with clicks",
        record,
    )
    time.sleep(1.0)
    screen.shot(shots("10-time"))


def evaluate_all(screen, shots):
    """Judge all outcomes by the menu, and name the files in the file browser."""
    # A window of its own would lie anywhere: nothing manages windows here.
    screen.ask("setattr(bpy.context.preferences.view, 'filebrowser_display_type', 'SCREEN')")
    screen.ask("setattr(bpy.context.scene.boxmorph, 'preset', 'draft')")
    rectangle = open_sidebar(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    start_search(screen, button)
    wait_for_end(screen)
    slider = find(screen, rectangle, "1.0", start=button[1] - rectangle[1] + 60)
    screen.click(rectangle[0] + rectangle[2] - 49, slider[1])
    time.sleep(1.0)
    screen.shot(shots("11-menu"))
    # The letter that is underlined in "Evaluate All…".
    screen.key("l")
    screen.wait(lambda: screen.ask("'FILE_BROWSER' in areas()"), 20, "the file browser")
    time.sleep(2.0)
    screen.shot(shots("11-files"))
    table = Path(screen.ask("bpy.data.filepath")).with_suffix("")
    files = [Path(f"{table}-evaluation{ending}") for ending in (".csv", ".png")]
    screen.move(WIDTH // 2, HEIGHT // 2)
    screen.key("Return")
    least = 10_000
    screen.wait(lambda: files[1].is_file() and files[1].stat().st_size > least, 60, "the contact sheet")
    report(True, "a contact sheet of all outcomes is written")
    lines = files[0].read_text(encoding="utf-8").splitlines()
    report(len(lines) == 2 and PROMPT in lines[1], "and a table", lines)
    time.sleep(1.0)
    screen.shot(shots("11-evaluated"))
