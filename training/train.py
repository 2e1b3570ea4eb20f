# SPDX-License-Identifier: MIT OR Apache-2.0
"""Make the embedded guide from nothing: shapes, trained pairs of encoders, ONNX files, figures.

`python training/train.py` in an environment with this project's wheel and `training/requirements.txt`.
The same seed gives the same shapes and, on the same machine, the same weights. A last network, trained with
another seed and never searched against, is left in the output folder as a judge for `steer.py`.
"""

import argparse
import json
import subprocess
import sys
import time
from pathlib import Path

from evaluate import GuideFiles, held_out, name_meshes
from export import export
from generate import generate
from mine import mine

HERE = Path(__file__).parent
# Each round: batches trained, highest learning rate, searches mined with the guide it leaves.
ROUNDS = ((9000, 5e-3, 700), (8000, 4e-3, 700), (8000, 4e-3, 700), (12000, 4e-3, 0))
JUDGE = (9000, 5e-3)


def finish(jobs):
    """Wait for all; stop with a sentence if one failed."""
    if any([job.wait() for job in jobs]):
        sys.exit("training: a step failed; see the message above")


def fit(out, folders, steps, rate, seed, resume=None):
    """A network's training in a process of its own, on one core."""
    options = ["--steps", steps, "--rate", rate, "--seed", seed, *(["--resume", resume] if resume else [])]
    return subprocess.Popen([sys.executable, *map(str, [HERE / "fit.py", out, *folders, *options])])


def main():
    """Shapes, then rounds of fitting and mining, then the judge and the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--out",
        type=Path,
        default=HERE / "out",
        help="folder for shapes and weights; a run cut off goes on after its last step",
    )
    parser.add_argument(
        "--guide", type=Path, default=HERE.parent / "guides" / "mini", help="folder to write the guide to"
    )
    parser.add_argument("--count", type=int, default=80_000, help="shapes drawn before any search")
    parser.add_argument("--nets", type=int, default=2)
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--short", type=int, default=1, help="divide all counts by this, to try the pipeline")
    parser.add_argument("--meshes", type=Path, help="folder of unseen .obj files to name")
    a = parser.parse_args()
    done = a.out / "rounds.json"
    record = json.loads(done.read_text()) if done.is_file() else []
    start = time.time() - 60 * (record[-1]["minutes"] if record else 0)
    base = a.out / "base"
    if not (base / "usual.npz").is_file():
        generate(base, max(a.count // a.short, 4000), a.seed)
    folders = [base]
    for number, (steps, rate, searches) in enumerate(ROUNDS):
        if number < len(record):
            folders.append(a.out / f"mined{number}")
            continue
        steps, seed = max(steps // a.short, 20), a.seed + 10 * number
        weights = [a.out / f"net{n}-{number}.pt" for n in range(a.nets)]
        before = [a.out / f"net{n}-{number - 1}.pt" if number else None for n in range(a.nets)]
        finish([fit(w, folders, steps, rate, seed + n, before[n]) for n, w in enumerate(weights)])
        export(weights, a.guide)
        figures = {"round": number, "held out": held_out(GuideFiles(a.guide), base)}
        if searches:
            folders.append(a.out / f"mined{number}")
            figures["mined"] = mine(a.guide, folders[-1], max(searches // a.short, 20), a.seed + number)
        figures["minutes"] = round((time.time() - start) / 60, 1)
        record.append(figures)
        done.write_text(json.dumps(record, indent=2) + "\n")
        print(json.dumps(figures), flush=True)
    steps, rate = JUDGE
    finish([fit(a.out / "judge.pt", folders, max(steps // a.short, 20), rate, a.seed + 100)])
    export([a.out / "judge.pt"], a.out / "judge")
    if a.meshes:
        print(json.dumps(name_meshes(GuideFiles(a.guide), a.meshes), indent=2))


if __name__ == "__main__":
    main()
