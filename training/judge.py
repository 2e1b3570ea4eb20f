# SPDX-License-Identifier: MIT OR Apache-2.0
"""Make a judge for a guide that is there: a network of another seed that no search ever climbs.

`python training/judge.py GUIDE OUT` draws shapes of its own, mines the guide's searches once, fits one
network to both, and leaves OUT/judge for `steer.py`. `train.py` ends with the same, on the shapes of all its
rounds.
"""

import argparse
from pathlib import Path

from export import export
from generate import generate
from mine import mine
from train import JUDGE, finish, fit


def main():
    """Shapes, one round of mining, the fit."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("guide", type=Path)
    parser.add_argument("out", type=Path, help="what is there already is not made again")
    parser.add_argument("--count", type=int, default=80_000, help="shapes drawn before any search")
    parser.add_argument("--searches", type=int, default=2100)
    parser.add_argument("--seed", type=int, default=111)
    a = parser.parse_args()
    base, mined = a.out / "base", a.out / "mined"
    if not (base / "usual.npz").is_file():
        generate(base, a.count, a.seed)
    if not (mined / "images.npy").is_file():
        print(mine(a.guide, mined, a.searches, a.seed), flush=True)
    steps, rate = JUDGE
    finish([fit(a.out / "judge.pt", [base, mined], steps, rate, a.seed)])
    export([a.out / "judge.pt"], a.out / "judge")


if __name__ == "__main__":
    main()
