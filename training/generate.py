# SPDX-License-Identifier: MIT OR Apache-2.0
"""Random shapes, their four views and the truth for every name, into one folder of arrays.

images.npy (k, 4, size, size, 2) uint8: grey and coverage; gaps.npy (k, names) float16: squared distances to
each name's region in sigmas; quantities.npy (k, WIDTH) float32: what adjectives grade; family.npy (k,)
uint8; usual.npz: usual value and step of every quantity (see grading.py).
"""

import argparse
from multiprocessing import Pool
from pathlib import Path

import boxmorph
import numpy as np
from draw import draw
from families import FAMILIES, NAMES
from grading import WIDTH, quantities, usual
from shapes.shape import break_parts, roughen, scale_parts, warp
from truth import truth

SIZE = 64
SHARES = np.array([f.share for f in FAMILIES.values()])
SHARES = SHARES / SHARES.sum()


def make(rng):
    """One random shape, possibly scaled part by part, stretched or broken: family index, shape."""
    index = int(rng.choice(len(SHARES), p=SHARES))
    family = list(FAMILIES.values())[index]
    shape = family.build(*draw(family, rng), rng)
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
    """The four views of a shape, now and then turned a little about z, as grey and coverage."""
    vertices, triangles = shape.mesh()
    if rng.random() < 0.3:
        c, s = np.cos(a := rng.normal(0, 0.05)), np.sin(a)
        vertices = vertices @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]], np.float32)
    return grey_views(vertices, triangles)


def _chunk(job):
    seed, count = job
    rng = np.random.default_rng(seed)
    images = np.empty((count, 4, SIZE, SIZE, 2), np.uint8)
    gaps = np.empty((count, len(NAMES)), np.float16)
    rows = np.empty((count, WIDTH), np.float32)
    family = np.empty(count, np.uint8)
    for i in range(count):
        family[i], shape = make(rng)
        gaps[i], proportions = truth(shape, FAMILIES, NAMES)
        rows[i] = quantities(shape, proportions)
        images[i] = views(shape, rng)
    return images, gaps, rows, family


def generate(folder, count, seed, processes=2, chunk=500):
    """Fill `folder` with `count` shapes."""
    jobs = [((seed, i), min(chunk, count - i)) for i in range(0, count, chunk)]
    with Pool(processes) as pool:
        save(folder, pool.imap(_chunk, jobs))
    data = [np.load(Path(folder) / f"{n}.npy") for n in ("gaps", "quantities", "family")]
    center, step = usual(*data)
    np.savez(Path(folder) / "usual.npz", center=center, step=step)


def save(folder, chunks):
    """Write (images, gaps, quantities, family) chunks, joined, as the arrays of `folder`."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    columns = zip(*chunks, strict=True)
    for name, column in zip(("images", "gaps", "quantities", "family"), columns, strict=True):
        np.save(folder / f"{name}.npy", np.concatenate(column))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=80_000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    generate(arguments.folder, arguments.count, arguments.seed)
