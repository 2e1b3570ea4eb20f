# SPDX-License-Identifier: GPL-3.0-or-later
"""Deforms each example object to two prompts, through the installed extension's own command line.

Leaves in demo/out/<object>-<prompt>/ a .blend with the keyed shape key, contact-sheet.png, spectrum.png and
report.json, and prints a table. With --readme it also renders docs/images/demo.png.
"""

import argparse
import atexit
import contextlib
import functools
import importlib
import io
import json
import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUT = ROOT / "demo" / "out"

PROMPTS = {
    "chair": ("a bar stool", "a sofa"),
    "table": ("a coffee table", "a nightstand"),
    "aeroplane": ("a glider plane", "an airship"),
    "desk_lamp": ("a floor lamp", "a table lamp"),
}
ALPHAS = (-1.0, -0.5, 0.0, 0.5, 1.0, 1.5)
_ROW = "{:<10} {:<15} {:>7} {:>7} {:>12} {:>8}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--object", choices=PROMPTS, action="append", help="only this one; may be repeated")
    parser.add_argument("--readme", action="store_true", help="also render docs/images/demo.png (minutes)")
    options = parser.parse_args()
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    say = speak_alone()
    extension = install()
    began = time.monotonic()
    rows = []
    for name in options.object or PROMPTS:
        source = _model(name)
        for prompt in PROMPTS[name]:
            say(f"{name.replace('_', ' ')} to {prompt} …")
            rows.append(_deform(extension, name, source, prompt))
    seconds = time.monotonic() - began
    say("\n" + _ROW.format("object", "prompt", "before", "after", "evaluations", "seconds"))
    for row in rows:
        say(_ROW.format(*row))
    say(f"\n{len(rows)} results in {seconds:.0f} s, in {OUT.relative_to(ROOT)}/")
    if options.readme:
        say(_readme(options.object or PROMPTS))


def speak_alone():
    """Send what Blender prints, in C and in Python, to nowhere. Returns a print() to the terminal."""
    terminal = os.fdopen(os.dup(1), "w", buffering=1)
    nowhere = open(os.devnull, "w")
    os.dup2(nowhere.fileno(), 1)
    sys.stdout = nowhere
    return functools.partial(print, file=terminal)


def install():
    """Install the built zip where no Blender of the user's sees it. Returns the extension's package name."""
    zips = sorted((ROOT / "dist").glob("boxmorph-*-*.zip"), key=os.path.getmtime)
    if not zips:
        sys.exit("There is no built extension in dist/. Run: make extension")
    resources = tempfile.mkdtemp(prefix="boxmorph-demo-")
    atexit.register(shutil.rmtree, resources, ignore_errors=True)
    os.environ["BLENDER_USER_RESOURCES"] = resources
    import bpy

    bpy.ops.extensions.package_install_files(
        repo="user_default", filepath=str(zips[-1]), enable_on_install=True
    )
    return "bl_ext.user_default.boxmorph"


def _model(name):
    """Build an example object and save it as demo/out/<object>.blend. Returns the path."""
    import bpy

    sys.path.insert(0, str(ROOT))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    importlib.import_module(f"examples.{name}").build()
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 60
    path = OUT / f"{name.replace('_', '-')}.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def _deform(extension, name, source, prompt):
    """Run the command on the saved object, leave the results in a folder. Returns a row of the table."""
    import bpy

    command = importlib.import_module(f"{extension}.command_line.command")
    folder = _folder(name, prompt)
    folder.mkdir()
    report_path = folder / "report.json"
    bpy.ops.wm.open_mainfile(filepath=str(source))
    arguments = ["deform", "--prompt", prompt, "--keyframes", "1:60"]
    arguments += ["--output", str(folder / f"{folder.name}.blend"), "--report", str(report_path)]
    with contextlib.redirect_stdout(io.StringIO()) as said:
        status = command.main(arguments)
    if status != 0:
        sys.exit(f"{prompt!r} failed with exit code {status}.\n{said.getvalue()}")
    report = json.loads(report_path.read_text(encoding="utf-8"))
    alphas = _pictures(extension, folder, report)
    report["spectrum_alphas"] = alphas
    report_path.write_text(json.dumps(report, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    scores = [f"{report[key]:.3f}" for key in ("score_before", "score_after")]
    return (source.stem, prompt, *scores, report["evaluations"], f"{report['seconds']:.1f}")


def _folder(name, prompt):
    return OUT / f"{name}-{prompt.split(' ', 1)[1]}".replace("_", "-").replace(" ", "-")


def _pictures(extension, folder, report):
    """Write the pictures of the object as Blender shows it, modifiers included.

    Returns the values of the strip: ALPHAS, held within the slider's limits.
    """
    import boxmorph
    import bpy
    import sheets

    mesh_io = importlib.import_module(f"{extension}.core.mesh_io")
    obj = bpy.data.objects[report["object"]]
    keys = obj.data.shape_keys
    keys.animation_data_clear()  # in memory only: the keyed file is saved
    key = keys.key_blocks[report["shape_key"]]

    def shown(alpha):
        key.value = alpha
        bpy.context.view_layer.update()
        return mesh_io.shown_arrays(obj, bpy.context)

    (before, triangles), (after, _) = shown(0.0), shown(1.0)
    sheets.save_png(sheets.contact_sheet(boxmorph, before, after, triangles), folder / "contact-sheet.png")
    alphas = [min(max(alpha, key.slider_min), key.slider_max) for alpha in ALPHAS]
    strip = sheets.spectrum(boxmorph, [shown(alpha)[0] for alpha in alphas], triangles)
    sheets.save_png(strip, folder / "spectrum.png")
    return alphas


def _readme(names):
    """Render each object and its outcomes from the saved files, as docs/images/demo.png.

    Returns what was written, in words.
    """
    import portrait
    import sheets

    rows = []
    for name in names:
        folders = [_folder(name, prompt) for prompt in PROMPTS[name]]
        row = [portrait.render(folders[0], 1)] + [portrait.render(folder, 60) for folder in folders]
        rows.append(row)
    path = ROOT / "docs" / "images" / "demo.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    sheets.save_png(sheets.grid(rows), path)
    return f"{path.relative_to(ROOT)}: {path.stat().st_size // 1024} kB"


if __name__ == "__main__":
    main()
