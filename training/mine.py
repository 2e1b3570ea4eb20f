# SPDX-License-Identifier: MIT OR Apache-2.0
"""Shapes as our own search makes them: deformed by real fields towards a caption that a guide likes, then
measured.

Whatever the guide believes, the truth is read off the vertices, so outcomes that score high and are wrong
become negatives, and good ones become examples. Writes the same arrays as generate.py.
"""

import argparse
from pathlib import Path

import boxmorph
import numpy as np
from evaluate import GuideFiles
from generate import FAMILY_SHARE, grey_views
from kinds import CAPTIONS, KINDS, draw, truth
from shapes import FAMILIES
from shapes.shape import roughen
from text import article

LOWEST, HIGHEST = np.log(0.3), np.log(3.1)
KEPT_EARLY, KEPT_BEST = 6, 14


def search(score, rows, rng, generations=8, size=16):
    """Cross-entropy search over log scale factors (rows, 3): all candidates in order, with their scores."""
    mean, spread = np.zeros((rows, 3)), np.full((rows, 3), 0.5)
    tried, scores = [], []
    for _ in range(generations):
        candidates = np.clip(mean + spread * rng.normal(size=(size, rows, 3)), LOWEST, HIGHEST)
        value = score(np.exp(candidates))
        best = candidates[np.argsort(-value)[: size // 4]]
        mean, spread = 0.3 * mean + 0.7 * best.mean(0), 0.5 * spread + 0.5 * (best.std(0) + 0.05)
        tried.append(candidates)
        scores.append(value)
    return np.concatenate(tried), np.concatenate(scores)


def set_vertices(shape, vertices):
    """Put (n, 3) vertices back into the parts they came from, in place; tilted faces count as damage."""
    at, tilt, count = 0, 0.0, 0
    for part in shape.parts:
        new = vertices[at : at + len(part.vertices)].astype(float)
        at += len(new)
        before, after = _normals(part.vertices, part.faces), _normals(new, part.faces)
        tilt += (1 - (before * after).sum(1)).sum()
        count += len(part.faces)
        part.vertices = new
    shape.damage = max(shape.damage, 2.0 * max(tilt / count - 0.12, 0.0))


def _normals(v, f):
    n = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
    return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-12)


def mine(guide, folder, count, seed):
    """Search on `count` shapes and keep twenty candidates of each."""
    rng = np.random.default_rng(seed)
    families = list(FAMILY_SHARE)
    images, gaps, family = [], [], []
    while len(images) < count:
        index = int(rng.choice(len(families), p=list(FAMILY_SHARE.values())))
        name = families[index]
        module, state = FAMILIES[name], rng.integers(1 << 60)
        parameters, traits = draw(name, module, rng)
        shape = _rebuild(module, parameters, traits, state)
        vertices, triangles = shape.mesh()
        try:
            graph = boxmorph.BoxDefGraph.build(boxmorph.Mesh(vertices, triangles), int(rng.integers(2, 5)))
        except ValueError:
            continue
        kinds = list(KINDS[name])
        wish = guide.words([article(kinds[rng.integers(len(kinds))])])[0]
        seen, turn = [], np.float32([1, 1, 1] if rng.random() < 0.5 else [-1, -1, 1])

        def score(scales, graph=graph, triangles=triangles, wish=wish, seen=seen, turn=turn):
            batch = np.stack(
                [grey_views(graph.deform(s.astype(np.float32)) * turn, triangles) for s in scales]
            )
            seen.append(batch)
            return guide.shapes(batch, grounds=1) @ wish

        tried, value = search(score, graph.parameter_rows, rng)
        views = np.concatenate(seen)
        early = rng.choice(32, KEPT_EARLY, replace=False)
        late = np.setdiff1d(np.argsort(-value), early, assume_unique=True)[:KEPT_BEST]
        picture, gap = [], []
        for i in [*early, *late]:
            copy = _rebuild(module, parameters, traits, state)
            set_vertices(copy, graph.deform(np.exp(tried[i]).astype(np.float32)))
            gap.append(np.minimum(truth(copy, module.measure)[1], 60.0))
            picture.append(views[i])
        images.append(np.stack(picture))
        gaps.append(np.array(gap, np.float16))
        family.append(np.full(len(gap), index, np.uint8))
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for file, data in (("images", images), ("gaps", gaps), ("family", family)):
        np.save(folder / f"{file}.npy", np.concatenate(data))
    wrong = np.array([np.exp(-g.astype(float)[:, : len(CAPTIONS)]).max(1) < 0.2 for g in gaps]).mean()
    print(f"{len(images)} shapes searched, {wrong:.0%} of the kept candidates are of no kind")


def _rebuild(module, parameters, traits, state):
    """The same shape again: parts, noise and all."""
    rng = np.random.default_rng(state)
    shape = module.build(parameters, dict(traits), rng)
    roughen(shape, rng)
    return shape


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("guide")
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    mine(GuideFiles(arguments.guide), arguments.folder, arguments.count, arguments.seed)
