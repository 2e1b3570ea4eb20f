#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, headless: the built zip installed into real Blender, used by its command line.

tests/blender/run_headless.py [CHROOT ...]
"""

import json
import shutil
import sys
from pathlib import Path

from check_evaluate import check_evaluate
from check_exchange import check_exchange
from check_german import check_german
from check_guides import check_guides
from check_scripts import check_script, check_ten_objects
from check_undo import check_undo
from chroots import ARTIFACTS, run_everywhere
from look import look


def check_suite(bench, counts):
    """Install into the Blender of one chroot and try everything that its command line promises."""
    version = bench.run("blender", "-b", "--version").stdout.splitlines()[0]
    print(f"{bench.suite}: {version}", flush=True)
    run = bench.run("blender", "--command", "extension", "validate", bench.zip)
    counts.check(run.returncode == 0, "the zip is valid", run.stdout + run.stderr)
    run = bench.install()
    if not counts.check(run.returncode == 0, "the zip installs", run.stdout + run.stderr):
        return
    counts.check("Traceback" not in run.stdout + run.stderr, "installing is silent", run.stdout + run.stderr)
    run = bench.make_chair()
    counts.check(run.returncode == 0, "the chair is made", run.stdout + run.stderr)
    before = (bench.outside / "chair.blend").read_bytes()

    def boxmorph(*arguments, file=bench.chair):
        opened = ["-b", file] if file else ["-b"]
        return bench.run("blender", *opened, "--command", "boxmorph", *arguments)

    check_done(bench, boxmorph, counts)
    check_evaluate(bench, boxmorph, counts)
    check_script(bench, counts)
    check_ten_objects(bench, counts)
    check_exchange(bench, counts)
    check_undo(bench, counts)
    check_german(bench, counts)
    check_guides(bench, counts)
    check_failed(bench.inside, boxmorph, counts)
    check_usage(boxmorph, counts)
    after = (bench.outside / "chair.blend").read_bytes()
    counts.check(after == before, "the input file is never written to")


def check_done(bench, boxmorph, counts):
    """What works: exit code 0, and files as promised."""
    inside, outside = bench.inside, bench.outside
    run = boxmorph(
        *("deform", "--object", "Chair", "--prompt", "a bar stool", "--seed", "3", "--splits", "3"),
        *("--symmetry", "x", "--keyframes", "1:60", "--output", f"{inside}/out.blend"),
        *("--report", f"{inside}/report.json", "--sheet", f"{inside}/sheet.png"),
        *("--spectrum", f"{inside}/spectrum.png"),
    )
    text = run.stdout + run.stderr
    if not counts.check(run.returncode == 0, "deform ends with exit code 0", f"{run.returncode}\n{text}"):
        return
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    report = json.loads(Path(f"{outside}/report.json").read_text(encoding="utf-8"))
    counts.check(
        report["score_after"] > report["score_before"] and report["shape_key"] == "a bar stool",
        "the report tells of a higher score",
        report,
    )
    for name in ("sheet.png", "spectrum.png"):
        check_picture(bench, name, counts)
    seen = look(bench, f"{inside}/out.blend").get("Chair", {})
    key = seen.get("keys", {}).get("a bar stool")
    counts.check(
        key is not None and key[1] < 0 and key[2] > 1 and seen["moved"] > 0.01,
        "the saved object has the shape key, with its limits",
        seen,
    )
    counts.check(
        seen.get("vertices") == 32
        and seen["modifiers"] == ["Mirror", "Bevel"]
        and seen["materials"] == ["Wood", "Fabric"],
        "mesh, modifiers and materials are as they were",
        seen,
    )
    counts.check(seen.get("curves") == [[[1, 0], [60, 1]]], "the spectrum is keyframed", seen)

    run = boxmorph("parts", "--object", "Chair", "--splits", "3", "--sheet", f"{inside}/parts.png")
    listed = [line.partition(":")[0] for line in run.stdout.splitlines() if " × " in line]
    counts.check(run.returncode == 0 and len(listed) > 1, "parts are listed by name", run.stdout + run.stderr)
    check_picture(bench, "parts.png", counts)
    run = boxmorph(
        *("deform", "--object", "Chair", "--prompt", "a bar stool", "--splits", "3", "--lock", listed[0]),
        *("--output", f"{inside}/locked.blend", "--report", f"{inside}/locked.json", "--scales", "0.5:2"),
    )
    if counts.check(run.returncode == 0, "a listed part can be locked", run.stdout + run.stderr):
        report = json.loads(Path(f"{outside}/locked.json").read_text(encoding="utf-8"))
        counts.check(
            report["scales"][0] == [1.0] * 3 and max(map(max, report["scales"])) <= 2.0,
            "a locked part keeps its size, the others their range",
            report,
        )

    run = boxmorph("deform", "--prompt", "a low zzgribble table", "--object", "Plain Chair")
    expected = Path(f"{outside}/chair-a-low-zzgribble-table.blend")
    counts.check(
        run.returncode == 0 and expected.is_file(), "without --output, saved beside the input", run.stderr
    )
    counts.check(
        "zzgribble" in run.stderr and "does not know" in run.stderr, "an unknown word is named", run.stderr
    )


def check_picture(bench, name, counts):
    """A picture was written; keep it to be looked at."""
    picture = Path(f"{bench.outside}/{name}")
    good = picture.is_file() and picture.read_bytes()[:4] == b"\x89PNG" and picture.stat().st_size > 2000
    counts.check(good, f"{name} is a picture")
    if good:
        shutil.copy(picture, ARTIFACTS / f"headless-{bench.suite}-{name}")


def check_failed(inside, boxmorph, counts):
    """What cannot work: exit code 1 and a sentence on stderr."""
    good = ("--prompt", "a bar stool", "--object", "Chair", "--output", f"{inside}/no.blend")
    cases = [
        ("no such object", (*good, "--object", "Bench"), "no object named “Bench”"),
        ("not a mesh", (*good, "--object", "Camera"), "not a mesh"),
        ("no faces", (*good, "--object", "Points"), "no faces"),
        ("an empty prompt", (*good, "--prompt", "  "), "prompt is empty"),
        ("unknown words only", (*good, "--prompt", "zzgribble xqwv"), "knows no word"),
        ("10,000 characters", (*good, "--prompt", "chair " * 1700), "characters"),
        ("an output in no folder", (*good, "--output", f"{inside}/none/o.blend"), "cannot be written"),
        ("an output that is a folder", (*good, "--output", inside), "cannot be written"),
        ("no such part", (*good, "--lock", "Wing"), "has no part named “Wing”"),
        ("no such collection", (*good, "--boxes", "None"), "no collection named “None”"),
        ("an impossible range", (*good, "--scales", "2:3"), "the range of scale factors is 2 to 3"),
        ("a report in no folder", (*good, "--report", f"{inside}/none/r.json"), "cannot be written"),
    ]
    for what, arguments, expected in cases:
        run = boxmorph("deform", *arguments)
        counts.check(
            run.returncode == 1 and expected in run.stderr and "Traceback" not in run.stderr,
            f"{what}: exit code 1 and a sentence",
            f"{run.returncode}\n{run.stderr}",
        )
    run = boxmorph("deform", *good, file=f"{inside}/missing.blend")
    counts.check(
        run.returncode == 1 and "could not open" in run.stderr,
        "a missing file: exit code 1, not the startup file",
        f"{run.returncode}\n{run.stderr}",
    )


def check_usage(boxmorph, counts):
    """Wrong usage: exit code 2."""
    for arguments in (
        (),
        ("bend",),
        ("deform",),
        ("deform", "--prompt", "a stool", "--splits", "9"),
        ("deform", "--prompt", "a stool", "--keyframes", "60"),
        ("deform", "--prompt", "a stool", "--seed", "-1"),
        ("deform", "--prompt", "a stool", "--scales", "3"),
    ):
        run = boxmorph(*arguments)
        counts.check(run.returncode == 2, f"usage “{' '.join(arguments)}”: exit code 2", run.stderr)
    run = boxmorph("deform", "--prompt", "a bar stool", file=None)
    counts.check(run.returncode == 2 and "name a file" in run.stderr, "no file: exit code 2", run.stderr)
    run = boxmorph("deform", "--help")
    counts.check(run.returncode == 0 and "--keyframes" in run.stdout, "--help: exit code 0", run.stdout)


if __name__ == "__main__":
    sys.exit(run_everywhere("headless", check_suite))
