# SPDX-License-Identifier: MIT OR Apache-2.0
"""Sets our CMA-ES beside pycma: evaluations to known optima and how many of 21 seeds get there, from the same
starts, with the same step sizes, populations, bounds and budgets.

Usage: benches/.venv/bin/python benches/cmaes.py [--record | --time]

`--time` prints what a generation takes, as a row of the bench's table. `--record` writes the table into
benches/RESULTS.md, and pycma's figures where tests/cmaes.rs reads them.
Both programs draw random numbers of their own, so it is medians and successes that are compared.
"""

import argparse
import json
import math
import os
import subprocess
import time
import warnings

import cma
import numpy as np
import results

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
RECORD = os.path.join(ROOT, "tests", "functions", "pycma.json")
SEEDS = 21


def weights(n, condition):
    """From 1 to `condition`, (n,)."""
    return condition ** (np.arange(n) / (n - 1))


def rotation(n):
    """The matrix that turns every pair of neighbouring coordinates by an angle of its own, (n, n)."""
    turned = np.eye(n)
    for turn in range(n):
        for i in range(n - 1):
            sin, cos = math.sin(1 + turn * n + i), math.cos(1 + turn * n + i)
            turned[[i, i + 1]] = cos * turned[i] - sin * turned[i + 1], sin * turned[i] + cos * turned[i + 1]
    return turned


def ellipsoid(n):
    """Half-axes from 1 to 1/1000."""
    weight = weights(n, 1e6)
    return lambda x: weight @ (x * x)


def rotated_ellipsoid(n):
    """The same, turned."""
    weight, turn = weights(n, 1e6), rotation(n)
    return lambda x: weight @ np.square(turn @ x)


def rosenbrock(n):
    """A curved valley; from n = 4 on it has a second, local optimum."""
    return lambda x: 100 * np.sum((x[:-1] ** 2 - x[1:]) ** 2) + np.sum((x[:-1] - 1) ** 2)


def beyond_bounds(n):
    """Least squares to a target outside the bounds −1 and 3 on the first 8 coordinates."""
    reach = math.sqrt(8)
    target = np.array([3 + reach] * 4 + [-1 - reach] * 4 + [0.25 * (i - 8) for i in range(8, n)])
    return lambda x: np.sum((x - target) ** 2)


#: The cases of tests/functions/mod.rs: function of n, start, step size, target, further options.
CASES = {
    "sphere": (lambda n: lambda x: x @ x, 1.5, 0.5, 1e-8, {}),
    "ellipsoid": (ellipsoid, 1.5, 0.5, 1e-8, {}),
    "cigar": (lambda n: lambda x: x[0] ** 2 + 1e6 * (x[1:] @ x[1:]), 1.5, 0.5, 1e-8, {}),
    "tablet": (lambda n: lambda x: 1e6 * x[0] ** 2 + x[1:] @ x[1:], 1.5, 0.5, 1e-8, {}),
    "Rosenbrock": (rosenbrock, 0.0, 0.5, 1e-8, {}),
    "rotated ellipsoid": (rotated_ellipsoid, 1.5, 0.5, 1e-8, {}),
    "optimum on 8 of 15 bounds": (
        beyond_bounds,
        0.0,
        1.0,
        64 + 1e-9,
        {"bounds": [-1, 3], "popsize": 36},
    ),
}


def budget(n):
    """Evaluations after which a search counts as lost."""
    return 3000 * n


def evaluations(function, start, sigma, target, options, n, seed):
    """Evaluations until the best score is at most `target`; None where pycma ends before."""
    # pycma takes seed 0 for the clock's.
    search = cma.CMAEvolutionStrategy([start] * n, sigma, {"seed": seed + 1, "verbose": -9, **options})
    while search.countevals < budget(n) and not search.stop():
        candidates = search.ask()
        scores = [function(x) for x in candidates]
        search.tell(candidates, scores)
        if search.best.f <= target:
            return search.countevals
    return None


def ours(*arguments):
    """Our figures: the JSON of benches/cmaes.rs."""
    command = ["cargo", "bench", "--quiet", "--bench", "cmaes", "--", *arguments]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def time_row():
    """What pycma and ours take to ask and tell a generation: a row of the bench's table."""
    timed = ours("--time")
    n, population, mine = timed["n"], timed["population"], timed["generation_seconds"]
    options = {"bounds": [-1, 3], "popsize": population, "verbose": -9, "seed": 1}
    search, function, seconds = cma.CMAEvolutionStrategy([0.0] * n, 1.0, options), beyond_bounds(n), []
    for _ in range(timed["generations"]):
        start = time.perf_counter()
        candidates = search.ask()
        asked = time.perf_counter()
        scores = [function(x) for x in candidates]
        scored = time.perf_counter()
        search.tell(candidates, scores)
        seconds.append(time.perf_counter() - scored + asked - start)
    its = sum(seconds) / len(seconds)
    what = f"search, one generation of {population} candidates, {n} variables"
    return what, f"{1e3 * mine:.2f} ms", f"pycma {1e3 * its:.2f} ms", f"{its / mine:.1f} × as fast"


def compare():
    """Rows of (function, n, our evaluations, pycma's), each (21,) with None for a seed that is lost."""
    rows = []
    for case in ours()["cases"]:
        name, n = case["function"], case["n"]
        make, *rest = CASES[name]
        function = make(n)
        value = function(0.1 + 0.3 * np.arange(n))
        if not math.isclose(value, case["value"], rel_tol=1e-9):
            raise SystemExit(f"{name}, n = {n}: ours gives {case['value']}, pycma's {value}")
        rows.append(
            (name, n, case["evaluations"], [evaluations(function, *rest, n, seed) for seed in range(SEEDS)])
        )
        print(name, n, *(summary(row) for row in rows[-1][2:]), flush=True)
    return rows


def summary(runs):
    """Median over the seeds that solved it, and their number."""
    solved = sorted(run for run in runs if run is not None)
    return solved[len(solved) // 2], len(solved)


def table(rows):
    """The table as lines of Markdown."""
    lines = [
        f"From the same starts, step sizes, populations and bounds; {SEEDS} seeds; pycma {cma.__version__}. "
        "Target 1e-8 (on bounds: 1e-9 above the optimum), budget 3000 n evaluations. Medians are over the "
        "seeds that get there.",
        "",
        "| function | n | ours, evaluations | pycma, evaluations | ratio | ours, solved | pycma, solved |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, n, *both in rows:
        (mine, solved), (its, its_solved) = map(summary, both)
        cells = name, n, f"{mine:,}", f"{its:,}", f"{mine / its:.2f} ×", f"{solved}/{SEEDS}"
        lines.append("| " + " | ".join(map(str, (*cells, f"{its_solved}/{SEEDS}"))) + " |")
    return lines


def main():
    """Print the table, and record it where asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--record", action="store_true", help="write RESULTS.md and the test's figures")
    parser.add_argument("--time", action="store_true", help="only print what a generation takes, as JSON")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    if arguments.time:
        print(json.dumps(time_row()))
        return
    rows = compare()
    lines = table(rows)
    print("\n".join(lines))
    if arguments.record:
        results.write("CMA-ES beside pycma", "benches/cmaes.py", lines)
        figures = [
            json.dumps({"function": name, "n": n, "median": summary(its)[0], "solved": summary(its)[1]})
            for name, n, _, its in rows
        ]
        with open(RECORD, "w", encoding="utf-8") as file:
            file.write("[\n" + ",\n".join(figures) + "\n]\n")


if __name__ == "__main__":
    main()
