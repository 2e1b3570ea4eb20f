# SPDX-License-Identifier: MIT OR Apache-2.0
"""Steps that sittings on the virtual screen share: what is selected, where a button is, a search begun."""

import time

from screen_drive import HEIGHT

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


def wait_for_end(screen, what="the search", seconds=300):
    """Wait until no search runs."""
    screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), seconds, f"the end after {what}")


def redraw_rate(screen, seconds=4.0):
    """Return how often the viewport is redrawn in a second if it is asked to all the time."""
    screen.ask("redraw_always(True)")
    time.sleep(1.0)
    first, begin = screen.ask("[draws(), time.monotonic()]")
    time.sleep(seconds)
    last, end = screen.ask("[draws(), time.monotonic()]")
    screen.ask("redraw_always(False)")
    return (last - first) / (end - begin)
