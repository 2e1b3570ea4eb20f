# SPDX-License-Identifier: MIT OR Apache-2.0
"""Random shapes, their four views and the truth for every caption, into one folder of arrays.

images.npy (k, 4, size, size, 2) uint8: grey and coverage; gaps.npy (k, captions) float16: squared
distances to each caption's region in sigmas; family.npy (k,) uint8.
"""

import argparse
from multiprocessing import Pool
from pathlib import Path

import boxmorph
import numpy as np
from kinds import CAPTIONS, draw, truth
from shapes import FAMILIES
from shapes.shape import break_parts, roughen, scale_parts, warp

SIZE = 64
FAMILY_SHARE = {"seat": 0.32, "table": 0.24, "lamp": 0.16, "aeroplane": 0.28}


def make(rng):
    """One random shape, possibly scaled part by part, stretched or broken: family index, shape."""
    families = list(FAMILY_SHARE)
    index = int(rng.choice(len(families), p=list(FAMILY_SHARE.values())))
    module = FAMILIES[families[index]]
    shape = module.build(*draw(families[index], module, rng), rng)
    if rng.random() < 0.5:
        scale_parts(shape, rng, rng.uniform(0.1, 1.0))
    if rng.random() < 0.25:
        warp(shape, rng, rng.uniform(0.2, 1.0))
    if rng.random() < 0.1:
        break_parts(shape, rng)
    roughen(shape, rng)
    return index, shape


def grey_views(vertices, triangles):
    """The four views as grey and coverage, (4, SIZE, SIZE, 2) uint8."""
    vertices = np.ascontiguousarray(vertices, np.float32)
    image = boxmorph.render(vertices, triangles, size=SIZE, views="paper", renderer="cpu")
    return np.ascontiguousarray(image[..., [0, 3]])


def views(shape, rng):
    """The four views of a shape turned by 0 or 180 degrees and a little, as grey and coverage."""
    vertices, triangles = shape.mesh()
    turn = np.pi * rng.integers(2) + (rng.normal(0, 0.04) if rng.random() < 0.3 else 0.0)
    c, s = np.cos(turn), np.sin(turn)
    spin = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]], np.float32)
    return grey_views(vertices @ spin, triangles)


def _chunk(job):
    seed, count = job
    rng = np.random.default_rng(seed)
    images = np.empty((count, 4, SIZE, SIZE, 2), np.uint8)
    gaps = np.empty((count, len(CAPTIONS)), np.float16)
    family = np.empty(count, np.uint8)
    for i in range(count):
        family[i], shape = make(rng)
        gaps[i] = np.minimum(truth(shape, FAMILIES[shape.family].measure)[1], 60.0)
        images[i] = views(shape, rng)
    return images, gaps, family


def generate(folder, count, seed, processes=2, chunk=500):
    """Fill `folder` with `count` shapes."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    jobs = [((seed, i), min(chunk, count - i)) for i in range(0, count, chunk)]
    shape = (count, 4, SIZE, SIZE, 2)
    images = np.lib.format.open_memmap(folder / "images.npy", "w+", np.uint8, shape)
    gaps, family, at = [], [], 0
    with Pool(processes) as pool:
        for part, gap, kind in pool.imap(_chunk, jobs):
            images[at : at + len(part)] = part
            at += len(part)
            gaps.append(gap)
            family.append(kind)
    np.save(folder / "gaps.npy", np.concatenate(gaps))
    np.save(folder / "family.npy", np.concatenate(family))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=28_000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    generate(arguments.folder, arguments.count, arguments.seed)
