# SPDX-License-Identifier: MIT OR Apache-2.0
"""Make the embedded guide from nothing: shapes, two trained pairs of encoders, ONNX files, figures.

`python training/train.py` in an environment with this project's wheel and `training/requirements.txt`.
The same seed gives the same shapes and, on the same machine and thread count, the same weights.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

from evaluate import GuideFiles, held_out, name_meshes
from export import export
from generate import generate

HERE = Path(__file__).parent
# Each round: batches trained, highest learning rate, searches mined with the guide it leaves.
ROUNDS = ((1400, 2e-3, 350), (4000, 2e-3, 600), (4500, 1.5e-3, 600), (3600, 1.2e-3, 0))


def run(*command):
    """A step of the training in a process of its own."""
    return subprocess.Popen([sys.executable, *map(str, command)])


def finish(jobs):
    """Wait for all; stop with a sentence if one failed."""
    if any([job.wait() for job in jobs]):
        sys.exit("training: a step failed; see the message above")


def main():
    """Shapes, then rounds of fitting and mining, then the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=HERE / "out", help="folder for shapes and weights")
    parser.add_argument(
        "--guide", type=Path, default=HERE.parent / "guides" / "mini", help="folder to write the guide to"
    )
    parser.add_argument("--count", type=int, default=28_000, help="shapes drawn before any search")
    parser.add_argument("--nets", type=int, default=2)
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--short", type=int, default=1, help="divide all counts by this, to try the pipeline")
    parser.add_argument(
        "--meshes", type=Path, default=HERE.parent.parent / "shared" / "reference", help="unseen .obj files"
    )
    a = parser.parse_args()
    base = a.out / "base"
    generate(base, max(a.count // a.short, 3000), a.seed)
    folders, weights = [base], [a.out / f"net{n}.pt" for n in range(a.nets)]
    # The first round only makes something to search with: the second starts from scratch.
    for number, (steps, rate, searches) in enumerate(ROUNDS):
        jobs = []
        for n, path in enumerate(weights):
            resume = ["--resume", path] if number > 1 else []
            options = [
                "--steps",
                max(steps // a.short, 20),
                "--rate",
                rate,
                "--seed",
                a.seed + 10 * number + n,
            ]
            jobs.append(run(HERE / "fit.py", path, *folders, *options, *resume))
        finish(jobs)
        export(weights, a.guide)
        if searches:
            folders.append(a.out / f"mined{number}")
            count = ["--count", max(searches // a.short, 2), "--seed", a.seed + number]
            finish([run(HERE / "mine.py", a.guide, folders[-1], *count)])
    guide = GuideFiles(a.guide)
    print(json.dumps(held_out(guide, base), indent=2))
    if a.meshes.is_dir():
        print(json.dumps(name_meshes(guide, a.meshes), indent=2))


if __name__ == "__main__":
    main()
