# SPDX-License-Identifier: MIT OR Apache-2.0
"""The command `evaluate` on a folder, in real Blender, which opens one file after another for it."""

import csv
import json
from pathlib import Path


def check_evaluate(bench, boxmorph, counts):
    """A folder of two files that Blender saved with an outcome, and of one that it cannot read."""
    folder, inside = Path(f"{bench.outside}/judged"), f"{bench.inside}/judged"
    folder.mkdir()
    for name, more in (("stool", ()), ("sofa", ("--negative", "a bench", "--from", "a chair"))):
        run = boxmorph(
            *("deform", "--object", "Plain Chair", "--prompt", f"a {name}", "--splits", "2", *more),
            *("--output", f"{inside}/{name}.blend"),
        )
        counts.check(run.returncode == 0, f"a file with {name} is saved", run.stdout + run.stderr)
    out = [f"--{kind}={bench.inside}/judged.{kind}" for kind in ("json", "csv")]
    run = boxmorph("evaluate", inside, *out, f"--sheet={bench.inside}/judged.png", file=None)
    told = f"{run.returncode}\n{run.stdout}{run.stderr}"
    if counts.check(run.returncode == 0, "evaluate on a folder ends with exit code 0", told):
        found = json.loads(Path(f"{bench.outside}/judged.json").read_text(encoding="utf-8"))
        with open(f"{bench.outside}/judged.csv", encoding="utf-8", newline="") as file:
            rows = [(row["file"], row["outcome"]) for row in csv.DictReader(file)]
        wanted = [("sofa.blend", "a sofa"), ("stool.blend", "a stool")]
        counts.check(
            rows == wanted and found["average"]["outcomes"] == 2 and "average of 2 outcomes" in run.stdout,
            "evaluate judges every outcome of every file",
            told,
        )
        rises = [o["score_after"] > o["score_before"] for o in found["outcomes"]]
        counts.check(all(rises), "it judges by what each was searched for", found["outcomes"])
    (folder / "broken.blend").write_bytes(b"BLENDER, but no file")
    run = boxmorph("evaluate", inside, file=None)
    counts.check(
        run.returncode == 1 and "broken.blend" in run.stderr and "average of 2 outcomes" in run.stdout,
        "a file that cannot be read is told, the others are judged",
        f"{run.returncode}\n{run.stdout}{run.stderr}",
    )
