# SPDX-License-Identifier: MIT OR Apache-2.0
"""The stages of a search with the embedded guide, each beside its limit."""

import boxmorph
import encoding
import numpy as np
from machine import memory_bandwidth
from shapes import grid_chair
from timing import best_of


def rows(rounds):
    """Rows of (stage, figure, beside what, ratio)."""
    guide = boxmorph.Guide.open()
    vertices, triangles = grid_chair(20_000)
    mesh = boxmorph.Mesh(vertices, triangles)

    seconds = best_of(rounds, lambda: boxmorph.BoxDefGraph.build(mesh, splits=4))
    # Without symmetry the chair has 15 parameters.
    graph = boxmorph.BoxDefGraph.build(mesh, splits=4, symmetry="none")
    shape = f"{len(vertices):,} vertices, {len(triangles):,} triangles"
    yield "graph and field", f"{1e3 * seconds:.0f} ms", shape, ""

    scales = np.linspace(0.8, 1.3, 3 * graph.parameter_rows, dtype=np.float32).reshape(-1, 3)
    seconds = best_of(20 * rounds, lambda: graph.deform(scales))
    bound = (graph.field().nbytes + 2 * vertices.nbytes) / memory_bandwidth()
    what = f"{scales.size} parameters, one core; memory bandwidth alone {1e3 * bound:.2f} ms"
    yield "one deformation", f"{1e3 * seconds:.2f} ms", what, f"{seconds / bound:.1f} ×"

    for size in (guide.image_size, 224):
        seconds = best_of(
            4 * rounds, lambda size=size: boxmorph.render(vertices, triangles, size=size, renderer="cpu")
        )
        yield f"four views of {size} pixels", f"{1e3 * seconds:.1f} ms", "one candidate alone, CPU", ""

    found = encoding.rates(None, 432, rounds)
    yield encoding.row("encoding, the embedded guide, 432 images at once", found)
    yield from job_rows(mesh, guide, found["ours"])


def job_rows(mesh, guide, rate):
    """Whole jobs, and what of one is not encoding; `rate` is the encoder's, in images a second."""
    for prompt in ("a bar stool", "a sofa"):
        job = boxmorph.Job(mesh, prompt, guide=guide, renderer="cpu")
        job.start()
        job.join()
        result = job.result()
        what = f"{result.evaluations} candidates, {result.evaluations / result.seconds:.0f} a second"
        yield f"whole job, “{prompt}”", f"{result.seconds:.1f} s", what, ""
    generations = result.report()["generations"]
    generation, images = result.seconds / generations, result.images_encoded / generations
    what = f"encoding alone, {images:.0f} images, {1e3 * images / rate:.0f} ms"
    yield "one generation of it", f"{1e3 * generation:.0f} ms", what, f"{generation * rate / images:.1f} ×"
