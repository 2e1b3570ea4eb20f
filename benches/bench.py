# SPDX-License-Identifier: MIT OR Apache-2.0
"""Measures the stages of a search in one run, each beside a limit or a peer, and how time and memory
grow with the mesh; prints both tables.

Usage: python benches/bench.py [--rounds N] [--markdown FILE]
"""

import argparse
import os
import platform
import time

import boxmorph
import growth
import numpy as np
from shapes import grid_chair


def best_of(rounds, work):
    """Least seconds of `rounds` calls, after one that is not counted."""
    work()
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def memory_bandwidth():
    """Bytes a second of a large copy, read and written."""
    source = np.ones(32_000_000, np.float32)
    target = np.empty_like(source)
    return 2 * source.nbytes / best_of(5, lambda: np.copyto(target, source))


def onnx_runtime_rate(images):
    """Images a second of the bare ONNX Runtime on the embedded vision network; None without it."""
    try:
        import onnxruntime
    except ImportError:
        return None
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = os.cpu_count()
    network = os.path.join(os.path.dirname(__file__), "..", "guides", "mini", "vision_model.onnx")
    session = onnxruntime.InferenceSession(network, options)
    pixels = (images.transpose(0, 3, 1, 2) / np.float32(127.5) - 1).astype(np.float32)
    return len(images) / best_of(5, lambda: session.run(None, {"pixel_values": pixels}))


def measure(rounds):
    """Rows of (stage, figure, beside what, ratio)."""
    rows = []
    guide = boxmorph.Guide.open()
    vertices, triangles = grid_chair(20_000)
    mesh = boxmorph.Mesh(vertices, triangles)
    shape = f"{len(vertices):,} vertices, {len(triangles):,} triangles"

    seconds = best_of(rounds, lambda: boxmorph.BoxDefGraph.build(mesh, splits=4))
    # Without symmetry the chair has 15 parameters.
    graph = boxmorph.BoxDefGraph.build(mesh, splits=4, symmetry="none")
    rows.append(("graph and field", f"{1e3 * seconds:.0f} ms", shape, ""))

    scales = np.linspace(0.8, 1.3, 3 * graph.parameter_rows, dtype=np.float32).reshape(-1, 3)
    seconds = best_of(20 * rounds, lambda: graph.deform(scales))
    bound = (graph.field().nbytes + 2 * vertices.nbytes) / memory_bandwidth()
    what = f"{scales.size} parameters, one core; memory bandwidth alone {1e3 * bound:.2f} ms"
    rows.append(("one deformation", f"{1e3 * seconds:.2f} ms", what, f"{seconds / bound:.1f} ×"))

    for size in (guide.image_size, 224):
        seconds = best_of(
            rounds, lambda size=size: boxmorph.render(vertices, triangles, size=size, renderer="cpu")
        )
        rows.append(
            (f"four views of {size} pixels", f"{1e3 * seconds:.1f} ms", "one candidate alone, CPU", "")
        )

    images = np.random.default_rng(0).integers(0, 256, (432, guide.image_size, guide.image_size, 3), np.uint8)
    rate = len(images) / best_of(rounds, lambda: guide.image_embeddings(images))
    bare = onnx_runtime_rate(images)
    beside = f"bare ONNX Runtime {bare:,.0f} images/s" if bare else "bare ONNX Runtime is not installed"
    rows.append(("encoding", f"{rate:,.0f} images/s", beside, f"{rate / bare:.2f} ×" if bare else ""))

    for prompt in ("a bar stool", "a sofa"):
        job = boxmorph.Job(mesh, prompt, guide=guide, renderer="cpu")
        job.start()
        job.join()
        result = job.result()
        candidates = result.evaluations / result.seconds
        what = f"{result.evaluations} candidates, {candidates:.0f} a second"
        rows.append((f"whole job, “{prompt}”", f"{result.seconds:.1f} s", what, ""))
    generations = result.report()["generations"]
    generation, images = result.seconds / generations, result.images_encoded / generations
    what = f"encoding alone, {images:.0f} images, {1e3 * images / rate:.0f} ms"
    rows.append(
        ("one generation of it", f"{1e3 * generation:.0f} ms", what, f"{generation * rate / images:.1f} ×")
    )
    return rows


def main():
    """Prints the tables, and writes them as Markdown where asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--markdown", help="write the tables to this file as well")
    arguments = parser.parse_args()
    rows = measure(arguments.rounds)
    machine = (
        f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()}, boxmorph {boxmorph.__version__}"
    )
    lines = [f"Machine: {machine}", "", "| stage | figure | beside | ratio |", "|---|---|---|---|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    lines += ["", *growth.table(min(3, arguments.rounds))]
    print("\n".join(lines))
    if arguments.markdown:
        with open(arguments.markdown, "w", encoding="utf-8") as file:
            file.write("# Results of `make bench`\n\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
