# SPDX-License-Identifier: MIT OR Apache-2.0
"""What whole jobs with a large guide take: opening it, time, memory, the share of the bare encoder's speed.

Usage: python benches/whole.py GUIDE_FOLDER [--presets draft standard] [--prompt TEXT] [--threads N]

GUIDE_FOLDER is such as tests/python/random_clip.py makes, or a guide that was downloaded. Each job runs in a
process of its own, whose peak memory includes Python, numpy and the mesh. The bare encoder is ONNX Runtime
called from Python on pixels that lie ready, with the same threads, before and after each job. The share is of
the seconds that it would take for the job's images. The machine must have nothing else to do: jobs give way
to other programs, and the bare encoder does not.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import time

import boxmorph
from growth import peak_memory
from shapes import grid_chair
from share import IMAGES, bare_encoder, cost

#: Runs of the bare encoder, each of a candidate's images.
RUNS = 16


def mesh():
    """A chair of the reference meshes where they are beside the project, else one of boxes."""
    try:
        import reference

        return next(rest for category, *rest in reference.shapes() if category == "chair")
    except SystemExit:
        return grid_chair(10_000)


def job(folder, preset, prompt, threads):
    """Opens the guide and runs one job; returns the figures."""
    start = time.perf_counter()
    guide = boxmorph.Guide.open(folder, threads=threads)
    opening = time.perf_counter() - start
    vertices, triangles = mesh()

    def work(_):
        task.start()
        task.join()

    task = boxmorph.Job(
        boxmorph.Mesh(vertices, triangles), prompt, guide=guide, preset=preset, renderer="cpu"
    )
    wall, cpu = cost(work, 1)
    result = task.result()
    return {
        "opening": opening,
        "wall": wall,
        "cpu": cpu,
        "images": result.images_encoded,
        "before": result.score_before,
        "after": result.score_after,
        "peak": peak_memory(),
    }


def in_a_process(*arguments):
    """The figures of `job` in a process of its own."""
    command = [sys.executable, __file__, "--job", *map(str, arguments)]
    return json.loads(subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--presets", nargs="+", default=["draft", "standard"])
    parser.add_argument("--prompt", default="a bar stool")
    parser.add_argument("--threads", type=int, default=2)
    options = parser.parse_args()
    size = boxmorph.Guide.open(options.folder, threads=options.threads).image_size
    bare = bare_encoder(options.folder, size, options.threads)
    bare(2)
    for preset in options.presets:
        rounds = [cost(bare, RUNS)]
        figures = in_a_process(options.folder, preset, options.prompt, options.threads)
        rounds.append(cost(bare, RUNS))
        images = figures["images"]
        bare_wall, bare_cpu = (sum(each) / (2 * RUNS * IMAGES) for each in zip(*rounds, strict=True))
        print(
            f"{preset}: guide open in {figures['opening']:.2f} s, {images} images in "
            f"{figures['wall']:.1f} s, {figures['cpu']:.1f} s of all cores, "
            f"peak memory {figures['peak'] / 1e6:.0f} MB, "
            f"score {figures['before']:.4f} to {figures['after']:.4f}"
        )
        print(
            f"    {images / figures['wall']:.1f} images/s, bare encoder {1 / bare_wall:.1f} images/s: "
            f"{bare_wall * images / figures['wall']:.1%} of it by the clock, "
            f"{bare_cpu * images / figures['cpu']:.1%} by the processor's time",
            flush=True,
        )


if __name__ == "__main__":
    if sys.argv[1:2] == ["--job"]:
        print(json.dumps(job(sys.argv[2], *sys.argv[3:5], int(sys.argv[5]))))
    else:
        main()
