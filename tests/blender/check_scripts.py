# SPDX-License-Identifier: MIT OR Apache-2.0
"""The scripts of the documents, run as they are printed there."""

import re

from chroots import ROOT
from look import look

#: Put before a script: counts how often a guide is loaded.
_COUNT_GUIDES = """
import atexit, boxmorph
guide, opened = boxmorph.Guide, []
class Counted:
    @staticmethod
    def open(*arguments, **options):
        opened.append(1)
        return guide.open(*arguments, **options)
boxmorph.Guide = Counted
atexit.register(lambda: print("GUIDES", len(opened), flush=True))
"""

#: What the script of the README makes of the objects that make_ten.py saves.
_TEN = {
    "Chair": "a bar stool",
    "Chair.001": "a bar stool",
    "Chair.002": "a bar stool",
    "Table": "a coffee table",
    "Table.001": "a coffee table",
    "Table.002": "a coffee table",
    "Lamp": "a floor lamp",
    "Lamp.001": "a floor lamp",
    "Aeroplane": "a glider",
    "Aeroplane.001": "a glider",
}


def printed_script(page):
    """Return the first Python script of a page that uses Blender."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return next(
        script for script in re.findall(r"^```python\n(.*?)^```", text, re.M | re.S) if "import bpy" in script
    )


def run_script(bench, file, script):
    """Run a script on a file; return the CompletedProcess, and what is in the file that it saved."""
    (bench.outside / "script.py").write_text(script, encoding="utf-8")
    (bench.outside / "count.py").write_text(_COUNT_GUIDES, encoding="utf-8")
    script = f"{bench.inside}/script.py"
    run = bench.run(
        # Both, as in a shell: Blender goes by PWD.
        *("env", "--chdir", bench.inside, f"PWD={bench.inside}"),
        *("blender", "-b", file, "--python-exit-code", "1"),
        *("--python", f"{bench.inside}/count.py", "--python", script),
    )
    return run, look(bench, f"{bench.inside}/deformed.blend")


def check_script(bench, counts):
    """The script of docs/headless.md, with the objects of this file."""
    wanted = {"Chair": "a bar stool", "Plain Chair": "a sofa"}
    script = printed_script("docs/headless.md")
    script, replaced = re.subn(r"^prompts = .*$", f"prompts = {wanted}", script, flags=re.MULTILINE)
    run, made = run_script(bench, bench.chair, script)
    keys = {name: made.get(name, {}).get("keys", {}) for name in wanted}
    counts.check(
        replaced == 1 and run.returncode == 0 and all(keys[name].get(key) for name, key in wanted.items()),
        "the script of the documents deforms several objects",
        f"{keys}\n{run.stdout}{run.stderr}",
    )


def check_ten_objects(bench, counts):
    """The script of README.md, as it is printed there, on a file of ten objects."""
    script = printed_script("README.md")
    lines = [line for line in script.splitlines() if line.strip()]
    counts.check(len(lines) <= 10, "the script of the README has ten lines", script)
    file = f"{bench.inside}/ten.blend"
    run = bench.run(
        *("blender", "-b", "--factory-startup", "--python-exit-code", "9"),
        *("--python", "/repo/tests/blender/make_ten.py", "--", file),
    )
    counts.check(run.returncode == 0, "ten objects are made", run.stdout + run.stderr)
    run, made = run_script(bench, file, script)
    told = run.stdout + run.stderr
    counts.check(run.returncode == 0, "the script of the README ends with exit code 0", told)
    for name, prompt in _TEN.items():
        seen = made.get(name, {})
        key = seen.get("keys", {}).get(prompt)
        counts.check(
            key is not None and key[0] == 1 and key[1] < 0 and seen["moved"] > 1e-3,
            f"it makes {prompt} of {name}",
            f"{seen}\n{told}",
        )
    counts.check(set(made) == set(_TEN), "nothing else is in the file", list(made))
    counts.check("GUIDES 1" in run.stdout, "the guide is loaded once", run.stdout)
