# SPDX-License-Identifier: MIT OR Apache-2.0
"""Zips dropped into Blender's window, as a mouse drags them from elsewhere; runs inside the chroot.

    python3 screen_install.py FOLDER ARTIFACTS SUITE ZIP NEWER_ZIP

FOLDER holds chair.blend; the extension is not installed. Prints "pass" or "FAIL" lines for run_install.py to
count, and keeps a screenshot of each step.
"""

import subprocess
import sys
import time
from pathlib import Path

from screen_drive import HEIGHT, WIDTH, Screen
from screen_steps import OBJECT, PROMPT, report

PACKAGE = "bl_ext.user_default.boxmorph"
MIDDLE = (WIDTH // 3, HEIGHT // 2)


def drop(screen, zip_path):
    """Drop a file on the viewport."""
    screen.move(*MIDDLE)
    command = [sys.executable, Path(__file__).with_name("screen_drop.py"), zip_path, *map(str, MIDDLE)]
    run = subprocess.run(command, env=screen.environment, text=True, capture_output=True)
    report(run.returncode == 0, "Blender takes the dropped zip", run.stderr)
    time.sleep(2.0)


def version(screen):
    """Return the version of the enabled extension, or None."""
    return screen.ask(
        f"import tomllib, sys, os\nmodule = sys.modules.get('{PACKAGE}')\nvalue = None\n"
        f"if '{PACKAGE}' in bpy.context.preferences.addons:\n"
        "    path = os.path.join(os.path.dirname(module.__file__), 'blender_manifest.toml')\n"
        "    value = tomllib.load(open(path, 'rb'))['version']"
    )


def deform(screen, mode="EXEC_DEFAULT", preset="standard"):
    """Deform by the operator; return how it ends, or what it refuses."""
    return screen.ask(
        f"bpy.context.view_layer.objects.active = bpy.data.objects['{OBJECT}']\n"
        "for o in bpy.data.objects: o.select_set(o == bpy.context.view_layer.objects.active)\n"
        "w, a, r = view()\n"
        "try:\n"
        "    with bpy.context.temp_override(window=w, area=a, region=a.regions[-1]):\n"
        f"        value = list(bpy.ops.boxmorph.deform('{mode}', prompt='{PROMPT}', preset='{preset}'))\n"
        "except RuntimeError as error:\n"
        "    value = str(error)"
    )


def install(screen, zip_path, shots):
    """Drop the zip into a Blender that does not know the extension, confirm, and use it."""
    report(version(screen) is None, "the extension is not installed")
    drop(screen, zip_path)
    screen.shot(shots("1-dropped"))
    report(version(screen) is None, "and asks first")
    screen.key("Return")
    screen.wait(lambda: version(screen), 60, "the extension")
    report(True, "Return installs and enables it")
    time.sleep(1.0)
    screen.shot(shots("2-installed"))
    answer = deform(screen)
    key = screen.ask(f"keys('{OBJECT}')").get(PROMPT)
    report(key == 1.0, "without a restart, it deforms", answer)


def update(screen, zip_path, shots):
    """Drop a newer zip while a search runs."""
    old = version(screen)
    before = screen.ask(f"keys('{OBJECT}')")
    deform(screen, "INVOKE_DEFAULT", "paper")
    screen.wait(lambda: "BOXMORPH_OT_deform" in screen.ask("modal()"), 20, "the search")
    drop(screen, zip_path)
    screen.key("Return")
    screen.wait(lambda: version(screen) not in (None, old), 60, "the newer extension")
    report(True, "a newer zip is dropped while a search runs, and installed")
    screen.move(*MIDDLE)
    screen.wait(lambda: "BOXMORPH_OT_deform" not in screen.ask("modal()"), 30, "the end of the search")
    left = screen.ask(f"keys('{OBJECT}')")
    report(left == before, "the search ends and leaves nothing", left)
    answer = deform(screen)
    report("Restart Blender" in str(answer), "the newer extension asks for a restart", answer)
    time.sleep(1.0)
    screen.shot(shots("3-updated"))


def read(screen, shots):
    """What an artist can read about it: its entry in the preferences, where the viewport was."""
    screen.ask(
        "view()[1].type = 'PREFERENCES'\n"
        "bpy.context.preferences.active_section = 'EXTENSIONS'\n"
        "bpy.context.window_manager.extension_search = 'Boxmorph'\n"
        "repos = [repo.module for repo in bpy.context.preferences.extensions.repos]\n"
        "show = bpy.ops.extensions.package_show_set\n"
        "value = list(show(pkg_id='boxmorph', repo_index=repos.index('user_default')))"
    )
    time.sleep(3.0)
    screen.shot(shots("4-preferences"))


def main(folder, artifacts, suite, zip_path, newer):
    def shots(step):
        return f"{artifacts}/install-{suite}-{step}.png"

    first, second = Path(folder, "first"), Path(folder, "second")
    try:
        first.mkdir()
        with Screen(first, ["--factory-startup", f"{folder}/chair.blend"]) as screen:
            install(screen, zip_path, shots)
            update(screen, newer, shots)
            read(screen, shots)
            report(screen.quit() == 0, "quitting after it is clean")
        second.mkdir()
        arguments = ["--factory-startup", "--addons", PACKAGE, f"{folder}/chair.blend"]
        with Screen(second, arguments) as screen:
            answer = deform(screen)
            report(answer == ["FINISHED"], "after the restart, the newer one deforms", answer)
    except RuntimeError as error:
        report(False, "the session goes on", error)
        screen.shot(shots("failed"))
    for start in (first, second):
        log = (start / "blender.log").read_text(encoding="utf-8", errors="replace")
        errors = [line for line in log.splitlines() if "Traceback" in line or "Error" in line]
        refused = [line for line in errors if "Restart Blender" in line]
        report(errors == refused, "Blender printed no other error", log[-3000:])


if __name__ == "__main__":
    main(*sys.argv[1:])
