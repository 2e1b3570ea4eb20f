# SPDX-License-Identifier: MIT OR Apache-2.0
"""What else can happen while a search runs: none of it may leave a trace or end Blender."""

import time

from screen_drive import HEIGHT
from screen_steps import OBJECT, find, open_sidebar, report, select, start_search, wait_for_end


def queue(screen, shots):
    """Let a second object wait for the first, by the same button, and undo them one by one."""
    rectangle = open_sidebar(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    screen.ask("setattr(bpy.context.scene.boxmorph, 'preset', 'standard')")
    start_search(screen, button)
    screen.ask("setattr(bpy.context.view_layer.objects, 'active', bpy.data.objects['Chair'])")
    screen.ask("setattr(bpy.context.scene.boxmorph, 'prompt', 'a sofa')")
    time.sleep(0.5)
    screen.click(*button)
    screen.shot(shots("9-queue"))
    screen.wait(lambda: screen.ask(f"keys('{OBJECT}')").get("a bar stool") == 1.0, 60, "the first outcome")
    wait_for_end(screen)
    found = screen.ask("keys('Chair')")
    report(found.get("a sofa") == 1.0, "the second object was searched after the first", found)
    screen.move(rectangle[0] // 2, HEIGHT // 2)
    screen.key("ctrl+z")
    screen.wait(lambda: screen.ask("keys('Chair')") == {}, 20, "undo of the second")
    first = screen.ask(f"keys('{OBJECT}')").get("a bar stool")
    report(first == 1.0, "one undo takes back the second outcome alone", first)
    history = "__import__('bl_ext.user_default.boxmorph.searching.history', fromlist=['recent']).recent()"
    prompts = screen.ask(f"list({history})")
    report(prompts[:1] == ["a bar stool"], "the prompt is among the last prompts", prompts)


def interruptions(screen, _shots):
    """Interrupt a search in every way."""
    rectangle = open_sidebar(screen)
    button = find(screen, rectangle, "bpy.ops.boxmorph.deform(")
    middle = (rectangle[0] // 2, HEIGHT // 2)
    nothing = screen.ask(f"keys('{OBJECT}')")

    def searching():
        start_search(screen, button)
        screen.wait(lambda: screen.ask(f"moved('{OBJECT}')") > 1e-4, 120, "a preview")

    def ended(what):
        wait_for_end(screen, what, 60)
        left = screen.ask(f"keys('{OBJECT}')")
        report(left == nothing, f"{what} ends the search and leaves nothing", left)

    searching()
    screen.move(*middle)
    screen.key("ctrl+z")
    ended("Ctrl+Z")

    searching()
    cancel = find(
        screen, rectangle, "bpy.ops.boxmorph.cancel(", start=button[1] - rectangle[1] + 50, from_right=54
    )
    screen.click(*cancel)
    ended("the button Cancel")

    searching()
    screen.move(*middle)
    screen.key("ctrl+s")
    screen.wait(lambda: not screen.ask("bpy.data.is_dirty"), 20, "saving")
    screen.wait(lambda: screen.ask(f"moved('{OBJECT}')") > 1e-4, 20, "the preview after saving")
    report("BOXMORPH_OT_deform" in screen.ask("modal()"), "the search goes on after saving")
    screen.key("Escape")
    ended("Esc")
    screen.ask("bpy.ops.wm.revert_mainfile()")
    report(screen.ask(f"keys('{OBJECT}')") == {}, "what was saved is the object without the preview")
    select(screen)
    open_sidebar(screen)

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
    wait_for_end(screen, "deleting", 60)
    report(screen.ask(f"'{OBJECT}' not in bpy.context.scene.objects"), "deleting the object ends the search")
    screen.key("ctrl+z")
    screen.wait(lambda: screen.ask(f"'{OBJECT}' in bpy.context.scene.objects"), 20, "undo of deleting")
    left = screen.ask(f"keys('{OBJECT}')")
    report(left == nothing, "undo brings the object back without a preview", left)

    screen.ask("bpy.ops.wm.revert_mainfile()")
    select(screen)
    searching()
    screen.ask("bpy.ops.wm.revert_mainfile()")
    wait_for_end(screen, "loading", 60)
    report(screen.ask(f"keys('{OBJECT}')") == {}, "loading a file ends the search")

    select(screen)
    searching()
    screen.ask("bpy.ops.preferences.addon_disable(module='bl_ext.user_default.boxmorph')")
    left = screen.ask(f"[keys('{OBJECT}'), handlers()]")
    report(left == [{}, []], "disabling the extension ends the search and leaves nothing", left)
    # The operator goes when Blender has let go of it.
    screen.move(*middle)
    gone = "not hasattr(bpy.types, 'BOXMORPH_OT_deform')"
    report(bool(screen.wait(lambda: screen.ask(gone), 20, "the operator's end")), "and then no operator")
    screen.ask("bpy.ops.preferences.addon_enable(module='bl_ext.user_default.boxmorph')")

    select(screen)
    searching()
    code = screen.quit()
    report(code == 0, "quitting during a search is clean", code)
