# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the presets find beside the paper's protocol, and for how many images: every reference mesh, six
prompts, several seeds, the embedded guide; scores by all twelve images.

Usage: python benches/presets.py [--presets draft standard ...] [--seeds N] [--every K] [--record]

Rows are kept in presets.json as they come, so that a run can be broken off and gone on with: the paper's
protocol takes a minute and more of a core for a pair and seed. Needs the reference meshes beside the project.

Our presets want more than a high score: rivals kept off, feet on the floor, no crossings, smooth joints.
"as the paper" has the paper's loss, joints and symmetry in their place: the same problem for fewer images.
Beside the presets, budgets between them show how the score grows with the images. `curve.py` draws that;
it is to be run after `--record`.
"""

import argparse
import collections
import concurrent.futures
import json
import multiprocessing
import os
import pathlib

import boxmorph
import numpy as np
import reference
import results

AS_THE_PAPER = {"paper_loss": True, "boundary": "paper", "symmetry": "x"}
BUDGETS = {
    "500 images": ("standard", {"images": 500}),
    "draft": ("draft", {}),
    "2,400 images": ("standard", {"images": 2_400}),
    "standard": ("standard", {}),
    "10,000 images": ("standard", {"images": 10_000}),
    "best": ("best", {}),
}
PRESETS = {
    **BUDGETS,
    **{
        f"{name}, as the paper": (preset, options | AS_THE_PAPER)
        for name, (preset, options) in BUDGETS.items()
    },
    "paper": ("paper", {}),
}

ROWS = pathlib.Path(__file__).with_name("presets.json")

#: A score this near the paper's counts as having reached it.
NEAR = 0.001


def search(task):
    """Runs one job on one thread; returns its row."""
    number, prompt, name, seed = task
    preset, options = PRESETS[name]
    category, vertices, triangles = list(reference.shapes())[number]
    guide = boxmorph.Guide.open(threads=1)
    mesh = boxmorph.Mesh(vertices, triangles)
    job = boxmorph.Job(mesh, prompt, guide=guide, preset=preset, seed=seed, renderer="cpu", **options)
    job.start()
    job.join()
    result = job.result()
    return {
        "mesh": f"{category} {number}",
        "prompt": prompt,
        "preset": name,
        "seed": seed,
        "before": result.score_before,
        "after": result.score_after,
        "normal_error": result.report()["normal_error"],
        "images": result.images_encoded,
    }


def compared(rows):
    """What each preset's outcomes are beside the medians of the paper's protocol: a dictionary a preset."""
    scores = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in rows:
        scores[row["preset"]][row["mesh"], row["prompt"]].append(row)
    paper = {pair: np.median([row["after"] for row in some]) for pair, some in scores["paper"].items()}
    found = {}
    for preset in PRESETS:
        pairs = {pair: some for pair, some in scores[preset].items() if pair in paper}
        if not pairs:
            continue
        rows = [row for some in pairs.values() for row in some]
        before, after = np.array([(row["before"], row["after"]) for row in rows]).T
        goal = np.array([paper[row["mesh"], row["prompt"]] for row in rows])
        found[preset] = {
            "pairs": len(pairs),
            "seeds": max(map(len, pairs.values())),
            "images": np.mean([row["images"] for row in rows]),
            "gains": (after - before) / (goal - before),
            "reached": np.mean(after >= goal - NEAR),
            "spread": np.mean([np.std([row["after"] for row in some]) for some in pairs.values()]),
            "normal_error": np.mean([row["normal_error"] for row in rows]),
        }
    return found


def table(rows):
    """Lines of Markdown: each preset beside the medians of the paper's protocol."""
    columns = (
        "preset",
        "pairs × seeds",
        "images",
        "of the paper's gain, median",
        "mean",
        "a tenth is below",
        "at least 90 % of it",
        "at least the paper's median",
        "spread over seeds",
        "normal error",
    )
    note = (
        "Gains are shares of the paper's median gain for the pair; its median counts as reached "
        f"from {NEAR} below."
    )
    lines = [note, "", "![Share of the paper's gain over images](curve.svg)", ""]
    lines += ["| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    for preset, found in compared(rows).items():
        gains = found["gains"]
        cells = [
            preset,
            f"{found['pairs']} × {found['seeds']}",
            f"{found['images']:,.0f}",
            f"{np.median(gains):.3f}",
            f"{np.mean(gains):.3f}",
            f"{np.quantile(gains, 0.1):.2f}",
            f"{np.mean(gains >= 0.9):.0%}",
            f"{found['reached']:.0%}",
            f"{found['spread']:.4f}" if found["seeds"] > 1 else "",
            f"{found['normal_error']:.3f}",
        ]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def main():
    """Runs what is missing, and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--presets", nargs="*", choices=PRESETS, default=PRESETS)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--every", type=int, default=1, help="take every n-th pair alone")
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    parser.add_argument("--record", action="store_true", help="write the table into RESULTS.md")
    arguments = parser.parse_args()
    rows = json.loads(ROWS.read_text()) if ROWS.is_file() else []
    done = {(row["mesh"], row["prompt"], row["preset"], row["seed"]) for row in rows}
    pairs = [
        (category, number, prompt)
        for number, (category, *_) in enumerate(reference.shapes())
        for prompt in reference.PROMPTS[category]
    ]
    tasks = [
        (number, prompt, preset, seed)
        for preset in arguments.presets
        for seed in range(arguments.seeds)
        for category, number, prompt in pairs[:: arguments.every]
        if (f"{category} {number}", prompt, preset, seed) not in done
    ]
    # One thread a job, several jobs at a time: what they find does not depend on threads.
    os.environ["RAYON_NUM_THREADS"] = "1"
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(arguments.processes, mp_context=context) as pool:
        for row in pool.map(search, tasks):
            rows.append(row)
            ROWS.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n")
    lines = table(rows)
    print("\n".join(lines))
    if arguments.record:
        results.write("Presets beside the paper's protocol", "benches/presets.py", lines)


if __name__ == "__main__":
    main()
