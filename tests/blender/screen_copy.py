# SPDX-License-Identifier: MIT OR Apache-2.0
"""A copy of a guide in eight bits, by mouse, in the preferences; runs inside the chroot.

    python3 screen_copy.py FOLDER ARTIFACTS SUITE

FOLDER holds chair.blend, user/, where the extension is installed, and guides/large, a guide to be copied.
Prints "pass" or "FAIL" lines for run_download.py to count, and keeps a screenshot of each step.
"""

import sys
import time
from pathlib import Path

from screen_download import AWAY, PACKAGE, PREFS, open_preferences, sit
from screen_steps import find, report

STATE = f"__import__('sys').modules['{PACKAGE}.core.guide_copies'].state"

#: Seconds for which Blender may not answer while a copy is made.
PATIENCE = 1.0


def begin(screen, rectangle, shot=None):
    """Press the button, and Return in the dialog; return once the copy is being made."""
    button = find(screen, rectangle, "bpy.ops.boxmorph.quantize_guide(", from_right=150)
    screen.click(*button)
    time.sleep(1.0)
    if shot:
        screen.shot(shot)
    screen.key("Return")
    screen.wait(lambda: screen.ask(f"{STATE}.work is not None"), 20, "the copy to begin")
    screen.move(*AWAY)
    return button


def longest_pause(screen, until):
    """Ask Blender whether `until` holds, until it does; return the longest wait for an answer, in s."""
    longest = 0.0
    while True:
        start = time.monotonic()
        holds = screen.ask(until)
        longest = max(longest, time.monotonic() - start)
        if holds:
            return longest


def copy(screen, folder, shots):
    """Cancel one copy, then let one be made."""
    root = Path(folder, "guides")
    screen.ask(f"setattr({PREFS}, 'guides_folder', '{root}')")
    screen.ask(f"setattr({PREFS}, 'guide_folder', '{root}/large')")
    rectangle = open_preferences(screen)
    _x, y = begin(screen, rectangle, shots("1-dialog"))
    screen.click(rectangle[0] + rectangle[2] - 39, y)
    screen.wait(lambda: screen.ask(f"{STATE}.work is None"), 60, "the end of the cancelled copy")
    left = [path.name for path in root.iterdir()]
    report(left == ["large"], "a click cancels a copy, and nothing of it is left", left)

    begin(screen, rectangle)
    screen.wait(lambda: screen.ask(f"{STATE}.progress['fraction']") > 0.3, 120, "the comparison")
    screen.shot(shots("2-progress"))
    pause = longest_pause(screen, f"{STATE}.work is None")
    report(pause < PATIENCE, f"Blender answers within {pause:.2f} s while a copy is made")
    chosen = screen.ask(f"{PREFS}.guide")
    report(chosen == "FOUND:large-8bit", "the copy is there, and is chosen", chosen)
    figures = screen.ask(f"{STATE}.figures['images']")
    report(figures == 96, "what it is worth was measured", figures)
    screen.move(*AWAY)
    time.sleep(1.0)
    screen.shot(shots("3-copied"))


def main(folder, artifacts, suite):
    def shots(step):
        return f"{artifacts}/copy-{suite}-{step}.png"

    sit(folder, lambda screen: copy(screen, folder, shots), "copy", shots)


if __name__ == "__main__":
    main(*sys.argv[1:])
