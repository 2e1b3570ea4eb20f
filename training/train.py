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

HERE = Path(__file__).parent
STAGES = ("generate", "fit", "export", "evaluate")


def fit_all(data, weights, steps, seed):
    """One process and one thread for each net, side by side."""
    jobs = [
        subprocess.Popen([sys.executable, HERE / "fit.py", data, path, "--steps", str(steps), "--seed", str(seed + n)])
        for n, path in enumerate(weights)
    ]
    if any([job.wait() for job in jobs]):
        sys.exit("training: a net was not trained; see the message above")


def main():
    """Run the stages asked for, in order."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=HERE / "out" / "main", help="folder of shapes and weights")
    parser.add_argument("--guide", type=Path, default=HERE.parent / "guides" / "mini", help="folder to write the guide to")
    parser.add_argument("--count", type=int, default=60_000, help="shapes")
    parser.add_argument("--steps", type=int, default=8_000, help="batches of 64 shapes, 256 images")
    parser.add_argument("--nets", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--stages", nargs="+", choices=STAGES, default=STAGES)
    parser.add_argument("--meshes", type=Path, default=HERE.parent.parent / "shared" / "reference", help="unseen .obj files")
    a = parser.parse_args()
    weights = [a.out / f"net{n}.pt" for n in range(a.nets)]
    if "generate" in a.stages:
        from generate import generate

        generate(a.out, a.count, a.seed)
    if "fit" in a.stages:
        fit_all(a.out, weights, a.steps, a.seed)
    if "export" in a.stages:
        from export import export

        export(weights, a.guide)
    if "evaluate" in a.stages:
        from evaluate import GuideFiles, held_out, name_meshes

        guide = GuideFiles(a.guide)
        print(json.dumps(held_out(guide, a.out), indent=2))
        if a.meshes.is_dir():
            print(json.dumps(name_meshes(guide, a.meshes), indent=2))


if __name__ == "__main__":
    main()
