# SPDX-License-Identifier: MIT OR Apache-2.0
"""The paper's Table 2 made again: CMA-ES on the box scales against Adam and others at equal image encodes.

Usage: benches/.venv/bin/python benches/optimisers.py [--record] [--tune] [--candidates N] [--seeds N]

Six reference meshes × six prompts, the embedded guide, the paper's objective: −mean cosine of 12 images +
0.25 × normal error. All start from the unchanged object, search the same variables within the same bounds and
may score the same number of candidates. As our CMA-ES costs what pycma does (see `cmaes.py`), pycma stands
for it here; our whole job, on the paper's loss and on ours, has rows of its own, at its own cost.
"""

import argparse
import multiprocessing
import os
import statistics

import boxmorph
import methods
import numpy as np
import reference
import results
from presets import AS_THE_PAPER

BACKGROUNDS = np.array([(0, 0, 0), (255, 255, 255), (255, 128, 0)], np.float32)
#: Of the search variable, with the scale change of one unit of it: the paper's protocol.
BOUNDS, SCALE_PER_X, SPLITS = (-1.0, 3.0), 0.7, 4
MARKS = (100, 200, 400)
#: Pairs on which Adam's settings were chosen: number of the shape, and prompt.
TUNED_ON = ((2, "a bar stool"), (4, "a coffee table"))

#: Name in the table, the search, whether it draws random numbers.
METHODS = (
    ("CMA-ES, the paper's population", methods.cma_es, True),
    ("CMA-ES, small population", methods.small_cma_es, True),
    ("Adam on forward differences", methods.forward_adam, False),
    ("Adam on central differences", methods.central_adam, False),
    ("Nelder–Mead (SciPy)", methods.nelder_mead, False),
    ("random search", methods.random_search, True),
)
#: Our job in the table, and its options.
JOBS = (
    ("our job `standard`, the paper's loss, joints and symmetry", AS_THE_PAPER),
    ("our job `standard`", {}),
)


class BudgetSpent(Exception):  # noqa: N818 (not an error: how every search here ends)
    """As many candidates are scored as may be."""


class Pair:
    """A mesh and a prompt: what a candidate x is worth."""

    def __init__(self, guide, vertices, triangles, prompt):
        self.guide, self.triangles, self.prompt = guide, triangles, prompt
        self.mesh = boxmorph.Mesh(vertices, triangles)
        self.graph = boxmorph.BoxDefGraph.build(self.mesh, splits=SPLITS)
        self.text = guide.text_embedding(prompt)
        self.variables = 3 * self.graph.parameter_rows

    def cosine(self, vertices):
        """Mean cosine of 12 images with the prompt."""
        views = boxmorph.render(vertices, self.triangles, size=self.guide.image_size, renderer="cpu")
        views = views.astype(np.float32)
        alpha = views[..., 3:] / 255
        images = [np.rint(views[..., :3] * alpha + ground * (1 - alpha)) for ground in BACKGROUNDS]
        seen = self.guide.image_embeddings(np.concatenate(images).astype(np.uint8))
        return float((seen @ self.text).mean())

    def worth(self, x):
        """Loss and mean cosine of x."""
        scales = (1 + SCALE_PER_X * np.asarray(x)).astype(np.float32).reshape(-1, 3)
        vertices = self.graph.deform(scales)
        cosine = self.cosine(vertices)
        return 0.25 * boxmorph.metrics.normal_error(self.mesh, vertices) - cosine, cosine

    def search(self, method, candidates, seed):
        """Cosine of the candidate of least loss so far, after each of the candidates."""
        best, curve = (float("inf"), 0.0), []

        def function(x):
            nonlocal best
            if len(curve) == candidates:
                raise BudgetSpent
            found = self.worth(x)
            best = min(best, found)
            curve.append(best[1])
            return found[0]

        try:
            method(function, np.zeros(self.variables), BOUNDS, seed)
        except BudgetSpent:
            return curve

    def job(self, seed, options):
        """Cosine of the outcome of our job `standard`, and the images that it encoded."""
        job = boxmorph.Job(self.mesh, self.prompt, guide=self.guide, seed=seed, renderer="cpu", **options)
        job.start()
        job.join()
        result = job.result()
        return self.cosine(result.vertices), result.images_encoded


def pairs():
    """Every mesh with each of its prompts: numbers of shapes, and prompts."""
    for number, (category, _, _) in enumerate(reference.shapes()):
        for prompt in reference.PROMPTS[category]:
            yield number, prompt


def pair_of(number, prompt):
    """The pair, on one thread: there is a process a core."""
    _, vertices, triangles = [*reference.shapes()][number]
    return Pair(boxmorph.Guide.open(threads=1), vertices, triangles, prompt)


def workers():
    """Processes of one thread each, one a core."""
    os.environ["RAYON_NUM_THREADS"] = "1"
    return multiprocessing.get_context("spawn").Pool(os.cpu_count())


def tried(task):
    """The settings of Adam in `task`, and the final scores on two pairs."""
    gradient, rate, step, candidates = task

    def method(function, start, bounds, _seed):
        methods.adam(function, start, bounds, rate, step, getattr(methods, gradient))

    return task, [pair_of(*pair).search(method, candidates, 0)[-1] for pair in TUNED_ON]


def tune(candidates):
    """Prints what Adam's step length and differences do."""
    tasks = [
        (gradient, rate, step, candidates)
        for gradient in ("forward_gradient", "central_gradient")
        for rate in (0.05, 0.1, 0.2, 0.4)
        for step in (0.05, 0.1, 0.2)
    ]
    with workers() as pool:
        for (gradient, rate, step, _), scores in pool.imap(tried, tasks):
            named = ", ".join(f"{score:.3f}" for score in scores)
            print(f"{gradient}, rate {rate}, step {step}: {named}", flush=True)


def measured(task):
    """For a pair: its prompt, its score unchanged, its variables, the curves of each method and our jobs."""
    number, prompt, candidates, seeds = task
    pair = pair_of(number, prompt)
    curves = {
        name: [pair.search(method, candidates, seed) for seed in range(seeds if random else 1)]
        for name, method, random in METHODS
    }
    jobs = {name: [pair.job(seed, options) for seed in range(seeds)] for name, options in JOBS}
    return prompt, pair.worth(np.zeros(pair.variables))[1], pair.variables, curves, jobs


def measure(candidates, seeds):
    """What `measured` finds for every pair."""
    found = []
    with workers() as pool:
        for pair in pool.imap(measured, [(*pair, candidates, seeds) for pair in pairs()]):
            found.append(pair)
            ends = ", ".join(f"{statistics.median(c[-1] for c in runs):.3f}" for runs in pair[3].values())
            print(f"{pair[0]}: {pair[1]:.3f} unchanged, then {ends}", flush=True)
    return found


def finals(found, name):
    """The median final score of a method over seeds, for each pair."""
    return [statistics.median(curve[-1] for curve in pair[3][name]) for pair in found]


def job_finals(found, name):
    """The median score of the outcomes of our job over seeds, for each pair."""
    return [statistics.median(score for score, _ in pair[4][name]) for pair in found]


def table(found, candidates, seeds):
    """The tables as lines of Markdown."""
    marks = [mark for mark in MARKS if mark < candidates] + [candidates]
    variables = [pair[2] for pair in found]
    lines = [
        f"{len(found)} pairs of mesh and prompt, {SPLITS} splits, {min(variables)} to {max(variables)} "
        f"variables, {candidates} candidates of 12 images each; {seeds} seeds of what draws random numbers. "
        "The score is the mean cosine of the candidate of least loss so far; of several seeds the median. "
        f"Adam's step lengths ({methods.FORWARD[0]} and {methods.CENTRAL[0]}) and differences "
        f"({methods.FORWARD[1]} and {methods.CENTRAL[1]}) are the best of a grid on two of the pairs. "
        '"First" is among the searches of so many candidates.',
        "",
        "| search | " + " | ".join(f"score after {mark}" for mark in marks) + " | gain | first or equal |",
        "|---" * (len(marks) + 3) + "|",
    ]
    unchanged = statistics.median(pair[1] for pair in found)
    lines.append("| unchanged |" + f" {unchanged:.3f} |" * len(marks) + "  |  |")
    best = [max(scores) for scores in zip(*(finals(found, name) for name, _, _ in METHODS), strict=True)]
    for name, _, _ in METHODS:
        at = [
            statistics.median(statistics.median(curve[mark - 1] for curve in pair[3][name]) for pair in found)
            for mark in marks
        ]
        ends = finals(found, name)
        gain = statistics.median(end - pair[1] for end, pair in zip(ends, found, strict=True))
        first = sum(end >= top - 1e-6 for end, top in zip(ends, best, strict=True))
        figures = " | ".join(f"{score:.3f}" for score in at)
        lines.append(f"| {name} | {figures} | {gain:.3f} | {first}/{len(found)} |")
    for name, _ in JOBS:
        ends = job_finals(found, name)
        images = statistics.median(images for pair in found for _, images in pair[4][name])
        gain = statistics.median(end - pair[1] for end, pair in zip(ends, found, strict=True))
        cells = [*[""] * (len(marks) - 1), f"{statistics.median(ends):.3f}", f"{gain:.3f}", ""]
        lines.append(f"| {name}, {images:,.0f} images at the median | " + " | ".join(cells) + " |")
    lines += ["", *prompt_table(found)]
    return lines


def prompt_table(found):
    """Table 2 itself: the final scores by prompt, each the mean of two meshes."""
    shown = [name for name, *_ in METHODS]
    lines = [
        "| prompt | unchanged | " + " | ".join([*shown, JOBS[0][0]]) + " |",
        "|---" * (len(shown) + 3) + "|",
    ]
    for prompt in dict.fromkeys(pair[0] for pair in found):
        same = [pair for pair in found if pair[0] == prompt]
        scores = [statistics.mean(pair[1] for pair in same)]
        scores += [statistics.mean(finals(same, name)) for name in shown]
        scores.append(statistics.mean(job_finals(same, JOBS[0][0])))
        top = max(scores)
        cells = (f"**{score:.3f}**" if score == top else f"{score:.3f}" for score in scores)
        lines.append(f"| {prompt} | " + " | ".join(cells) + " |")
    return lines


def main():
    """Print the tables, and keep them where asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--candidates", type=int, default=400)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--tune", action="store_true", help="only try Adam's settings")
    parser.add_argument("--record", action="store_true", help="write the tables into benches/RESULTS.md")
    arguments = parser.parse_args()
    if arguments.tune:
        tune(arguments.candidates)
        return
    lines = table(measure(arguments.candidates, arguments.seeds), arguments.candidates, arguments.seeds)
    print("\n".join(lines))
    if arguments.record:
        results.write("CMA-ES, Adam, random search", "benches/optimisers.py", lines)


if __name__ == "__main__":
    main()
