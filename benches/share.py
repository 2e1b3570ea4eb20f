# SPDX-License-Identifier: MIT OR Apache-2.0
"""What share of the bare encoder's throughput the evaluation of candidates reaches, rendering and all.

Usage: python benches/share.py GUIDE_FOLDER [--vertices N] [--candidates N] [--rounds N]

GUIDE_FOLDER is "mini" for the embedded guide, or such as tests/python/random_clip.py makes. The bare encoder
is ONNX Runtime called from Python on pixels that lie ready, with the same threads and images a run, in turn
with ours. Each figure is the difference between a long and a short call, the best of the rounds of either, so
that what is done once a call (reading the prompt and the mesh) does not count.
"""

import argparse
import pathlib
import time
from concurrent.futures import ThreadPoolExecutor

import boxmorph
import numpy as np
import onnxruntime
from shapes import grid_chair

# Images of a candidate, which are one run of the network; networks up to this size are opened once a thread.
IMAGES = 12
SMALL = 64 << 20
MINI = pathlib.Path(__file__).resolve().parents[1] / "guides" / "mini"
THREADS = 2


def bare_encoder(folder, size, threads=THREADS):
    """A function that encodes a number of candidates' images with nothing around it."""
    places = [folder / "vision_model.onnx", folder / "onnx" / "vision_model.onnx"]
    path = next(place for place in places if place.is_file())
    sessions = threads if path.stat().st_size <= SMALL else 1
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads, options.inter_op_num_threads = threads // sessions, 1
    opened = [onnxruntime.InferenceSession(path, options) for _ in range(sessions)]
    pixels = np.random.default_rng(0).random((IMAGES, 3, size, size), np.float32)
    threads = ThreadPoolExecutor(sessions)

    def encode(candidates):
        def some(session):
            for _ in range(candidates // sessions):
                session.run(None, {opened[0].get_inputs()[0].name: pixels})

        list(threads.map(some, opened))

    return encode


def cost(work, candidates):
    """Wall and processor seconds of `work` on so many candidates."""
    wall, cpu = time.perf_counter(), time.process_time()
    work(candidates)
    return time.perf_counter() - wall, time.process_time() - cpu


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--vertices", type=int, default=10_000)
    parser.add_argument("--candidates", type=int, default=8)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    folder = MINI if options.folder == "mini" else pathlib.Path(options.folder)
    guide = boxmorph.Guide.open(folder, threads=THREADS)
    vertices, triangles = grid_chair(options.vertices)
    mesh = boxmorph.Mesh(vertices, triangles)
    taller = (vertices * np.array([1, 1, 1.3])).astype(np.float32)

    def evaluate(candidates):
        alphas = np.linspace(-1, 2, candidates).astype(np.float32)
        boxmorph.spectrum_scores(mesh, taller, "a bar stool", guide=guide, alphas=alphas, renderer="cpu")

    bare = bare_encoder(folder, guide.image_size)
    lengths = (2, 2 + options.candidates)
    calls = [(work, length) for length in lengths for work in (bare, evaluate)]
    rounds = [[cost(*call) for call in calls] for _ in range(options.rounds)]
    short, long = np.min(rounds, axis=0).reshape(2, 2, 2)
    best = long - short
    images = options.candidates * IMAGES
    for name, (wall, cpu) in zip(("bare encoder", "evaluation"), best, strict=True):
        print(f"{name}: {images / wall:.1f} images/s, {1e3 * cpu / images:.2f} ms of processor an image")
    wall, cpu = best[0] / best[1]
    print(f"share of the bare encoder: {wall:.1%} by the clock, {cpu:.1%} by the processor's time")


if __name__ == "__main__":
    main()
