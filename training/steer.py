# SPDX-License-Identifier: MIT OR Apache-2.0
"""Judge a guide by what it makes: search shapes it was never trained on towards every kind of their family.

`python training/steer.py GUIDE JUDGE OUT --meshes FOLDER` writes OUT/steering.json (a row for each mesh,
prompt and seed), prints the summary and draws the ten worst. Without `--meshes` the shapes are drawn by the
generators, from seeds that no training uses. `--adjectives` steers drawn shapes to adjectives instead and
measures whether the quantity asked for moved the right way. The judge is a second network that was trained
with another seed and never searched against.
"""

import argparse
import json
import os
from multiprocessing import get_context
from pathlib import Path

os.environ.setdefault("RAYON_NUM_THREADS", "1")  # one search a process

import boxmorph
import numpy as np
from draw import draw
from evaluate import GuideFiles, family_of, read_obj
from families import FAMILIES
from generate import grey_views
from grading import quantities
from kinds.adjectives import forms
from mine import set_vertices
from PIL import Image, ImageDraw
from text import article

UNSEEN = 7_000_000  # seeds from here on are of no training
ALPHAS = np.linspace(0, 1, 11)
MOVABLE = 0.05  # spread of a quantity over random scalings from which on a shape can be asked for it
SIDE = 160


def drawn(module, number):
    """A whole shape of a family that no training has seen, the same for the same number."""
    family = FAMILIES[module]
    rng = np.random.default_rng((UNSEEN, list(FAMILIES).index(module), number))
    kinds = list(family.kinds)
    return family.build(*draw(family, rng, kinds[rng.integers(len(kinds))]), rng)


def _open(guide):
    global _guide, _files  # sessions cannot be sent between processes
    _guide, _files = boxmorph.Guide.open(guide, threads=1), GuideFiles(guide)


def _search(vertices, triangles, prompt, seed):
    job = boxmorph.Job(boxmorph.Mesh(vertices, triangles), prompt, guide=_guide, seed=seed, renderer="cpu")
    job.start()
    job.join()
    return job.result()


def _rank(files, view, prompt):
    """How many class names the files' guide ranks before the prompt."""
    score = files.shapes(view[None])[0] @ files.words(files.classes).T
    return int((score > score[files.classes.index(prompt)]).sum())


def steer(task):
    """One row, and the outcome's views for the judge: a mesh searched to a prompt from a seed, measured."""
    name, vertices, triangles, prompt, seed = task
    result = _search(vertices, triangles, prompt, seed)
    mesh = boxmorph.Mesh(vertices, triangles)
    line = [grey_views(vertices + t * (result.vertices - vertices), triangles) for t in ALPHAS]
    scores = _files.shapes(np.stack(line)) @ _files.words([prompt])[0]
    span = max(np.ptp(scores), 1e-9)
    ratio = boxmorph.metrics.self_intersection_ratio
    row = {
        "mesh": name,
        "prompt": prompt,
        "seed": seed,
        "before": round(float(result.score_before), 3),
        "after": round(float(result.score_after), 3),
        "rank": _rank(_files, line[-1], prompt),
        "normal error": round(float(boxmorph.metrics.normal_error(mesh, result.vertices)), 3),
        "intersection": round(float(ratio(mesh, result.vertices) - ratio(mesh, vertices)), 4),
        "dip": round(float(np.maximum(np.maximum.accumulate(scores) - scores, 0).max() / span), 3),
        "seconds": round(result.seconds, 2),
    }
    return row, line[-1]


def _quantity(module, number, q, vertices):
    """A quantity of a drawn shape with its vertices moved."""
    shape = drawn(module, number)
    set_vertices(shape, vertices)
    return quantities(shape, FAMILIES[module].measure(shape)[0])[q]


def adjust(task):
    """One row: a drawn shape searched to an adjective; whether its quantity moved the right way. None where
    no scaling moves it: a cup without a stem has no longer one.
    """
    module, number, adjective, seed = task
    family = FAMILIES[module]
    quantity, sign = family.adjectives[adjective]
    q = family.quantities.index(quantity)
    vertices, triangles = drawn(module, number).mesh()
    graph = boxmorph.BoxDefGraph.build(boxmorph.Mesh(vertices, triangles), 3)
    scales = np.exp(np.random.default_rng(0).normal(0, 0.4, (12, graph.parameter_rows, 3))).astype(np.float32)
    if np.ptp([_quantity(module, number, q, graph.deform(s)) for s in scales]) < MOVABLE:
        return None
    form = forms(adjective)[min(1, len(forms(adjective)) - 1)]
    prompt = article(f"{family.word} {form}" if form.startswith("with ") else f"{form} {family.word}")
    result = _search(vertices, triangles, prompt, seed)
    before, after = (_quantity(module, number, q, v) for v in (vertices, result.vertices))
    moved = sign * (after - before)
    return {
        "family": module,
        "prompt": prompt,
        "shape": number,
        "seed": seed,
        "moved": round(float(moved), 3),
    }


def tasks_of_meshes(guide, folder, seeds):
    """Every mesh of the folder to every kind of the family that the guide takes it for."""
    files = GuideFiles(guide)
    meshes = {path.stem: read_obj(path) for path in sorted(Path(folder).glob("*.obj"))}
    family = {name: family_of(files, grey_views(*mesh)) for name, mesh in meshes.items()}
    for seed in range(seeds):
        for name, mesh in meshes.items():
            kinds = files.config["boxmorph"]["families"][family[name]]
            yield from ((name, *mesh, kind, seed) for kind in kinds)


def tasks_of_families(shapes, seeds):
    """Some drawn shapes of every family to every kind of it."""
    for module, family in FAMILIES.items():
        for number in range(shapes):
            vertices, triangles = drawn(module, number).mesh()
            name = f"{module}{number}"
            yield from (
                (name, vertices, triangles, article(k), seed) for k in family.kinds for seed in range(seeds)
            )


def summary(rows):
    """Shares of rows that meet each demand."""

    def share(holds):
        return round(float(np.mean([holds(r) for r in rows])), 3)

    return {
        "searches": len(rows),
        "score rises": share(lambda r: r["after"] > r["before"]),
        "prompt ranked first": share(lambda r: r["rank"] == 0),
        "in the judge's first three": share(lambda r: r["judge"] < 3),
        "normal error under 0.15": share(lambda r: r["normal error"] < 0.15),
        "self-intersection at most 0.02 over": share(lambda r: r["intersection"] <= 0.02),
        "no dip above a tenth": share(lambda r: r["dip"] <= 0.1),
        "mean score before": round(float(np.mean([r["before"] for r in rows])), 3),
        "mean score after": round(float(np.mean([r["after"] for r in rows])), 3),
        "worst normal error": max(r["normal error"] for r in rows),
        "worst self-intersection": max(r["intersection"] for r in rows),
        "median seconds": float(np.median([r["seconds"] for r in rows])),
    }


def badness(row):
    """How far a row is from what it should be: by the judge, the guide, and the score."""
    return (row["judge"] >= 3) + (row["rank"] > 0) + 0.1 * min(row["judge"], 10) - row["after"]


def sheet(rows, tasks):
    """Before and after of the rows, two views each, as a PIL image."""
    found = {(t[0], t[3], t[4]): t for t in tasks}
    picture = Image.new("RGB", (4 * SIDE, len(rows) * (SIDE + 14)), "white")
    pen = ImageDraw.Draw(picture)
    for r, row in enumerate(rows):
        _, vertices, triangles, prompt, seed = found[row["mesh"], row["prompt"], row["seed"]]
        result = _search(vertices, triangles, prompt, seed)
        for half, shown in enumerate((vertices, result.vertices)):
            views = boxmorph.render(shown, triangles, size=SIDE, views="paper", renderer="cpu")
            for i in range(2):
                picture.paste(Image.fromarray(views[i][..., :3]), ((2 * half + i) * SIDE, r * (SIDE + 14)))
        note = f"{row['mesh'][:10]} to {prompt} {row['before']} > {row['after']}, judge {row['judge'] + 1}."
        pen.text((4, r * (SIDE + 14) + SIDE), note, fill="black")
    return picture


def main():
    """Run the searches, two at a time, and write what came out."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("guide", type=Path)
    parser.add_argument("judge", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--meshes", type=Path, help="folder of .obj files, y up")
    parser.add_argument("--shapes", type=int, default=2, help="drawn shapes a family, without --meshes")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--adjectives", action="store_true")
    parser.add_argument("--processes", type=int, default=2)
    a = parser.parse_args()
    a.out.mkdir(parents=True, exist_ok=True)
    if a.adjectives:
        work, tasks = (
            adjust,
            [
                (module, number, adjective, seed)
                for module, family in FAMILIES.items()
                for number in range(a.shapes)
                for adjective in family.adjectives
                for seed in range(a.seeds)
            ],
        )
    elif a.meshes:
        work, tasks = steer, list(tasks_of_meshes(a.guide, a.meshes, a.seeds))
    else:
        work, tasks = steer, list(tasks_of_families(a.shapes, a.seeds))
    # Not forked: the renderer's threads, once started here, would be missing there.
    with get_context("spawn").Pool(a.processes, _open, (a.guide,)) as pool:
        rows = []
        for done, row in enumerate(pool.imap(work, tasks, chunksize=2), 1):
            rows += [row] if row else []
            if done % 50 == 0:
                print(f"{done} of {len(tasks)}", flush=True)
    if not a.adjectives:
        judge = GuideFiles(a.judge)
        rows = [{**row, "judge": _rank(judge, view, row["prompt"])} for row, view in rows]
    (a.out / "steering.json").write_text("[\n" + ",\n".join(json.dumps(r) for r in rows) + "\n]\n")
    if a.adjectives:
        right = {m: np.mean([r["moved"] > 0 for r in rows if r["family"] == m]) for m in FAMILIES}
        print(json.dumps({m: round(float(s), 3) for m, s in right.items()}, indent=2))
        print("moved the right way:", np.mean([r["moved"] > 0 for r in rows]).round(3), "of", len(rows))
        return
    print(json.dumps(summary(rows), indent=2))
    _open(a.guide)
    sheet(sorted(rows, key=badness)[-10:], tasks).save(a.out / "worst.png")


if __name__ == "__main__":
    main()
