# SPDX-License-Identifier: MIT OR Apache-2.0
"""Shapes as our own search makes them: deformed by real fields towards a prompt that a guide likes, then
measured.

Whatever the guide believes, the truth is read off the vertices, so outcomes that score high and are wrong
become negatives, and good ones become examples. Kept are early candidates, the best by score, and those
that the guide's two networks judge most differently. Writes the same arrays as generate.py, and
figures.json: how often the best of a search was no such thing.
"""

import argparse
import json
from multiprocessing import Pool
from pathlib import Path

import boxmorph
import numpy as np
from draw import draw
from evaluate import GuideFiles
from families import FAMILIES, NAMES
from generate import SHARES, grey_views, save
from grading import quantities
from kinds.adjectives import forms
from shapes.shape import roughen
from text import article
from truth import truth

LOWEST, HIGHEST = np.log(0.3), np.log(3.1)
KEPT_EARLY, KEPT_BEST, KEPT_DISPUTED = 5, 10, 5
ADJECTIVES = 0.3  # share of searches towards an adjective
GENERATIONS, SIZE = 8, 16
BELIEVED, TRUE = 0.5, 0.2  # a score above the first with a truth below the second is a hole in the guide


def search(score, rows, rng):
    """Cross-entropy search over log scale factors (rows, 3): all candidates in order, with their scores."""
    mean, spread = np.zeros((rows, 3)), np.full((rows, 3), 0.5)
    tried, scores = [], []
    for _ in range(GENERATIONS):
        candidates = np.clip(mean + spread * rng.normal(size=(SIZE, rows, 3)), LOWEST, HIGHEST)
        value = score(np.exp(candidates))
        best = candidates[np.argsort(-value)[: SIZE // 4]]
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


def _prompt(family, rng):
    """A random prompt of the family, and the index of its name (None with an adjective)."""
    kinds = list(family.kinds)
    kind = kinds[rng.integers(len(kinds))]
    if rng.random() < ADJECTIVES:
        adjectives = list(family.adjectives)
        adjective = forms(adjectives[rng.integers(len(adjectives))])[0]
        return f"{adjective} {kind if rng.random() < 0.5 else family.word}", None
    return article(kind), NAMES.index((family.module, kind))


def _rebuild(family, parameters, traits, state):
    """The same shape again: parts, noise and all."""
    rng = np.random.default_rng(state)
    shape = family.build(parameters, dict(traits), rng)
    roughen(shape, rng)
    return shape


def climb(guide, rng):
    """One search: images, gaps, quantities, family of the kept candidates, and (score, truth, dispute) of
    the best; None where the shape has no graph.
    """
    index = int(rng.choice(len(SHARES), p=SHARES))
    family = list(FAMILIES.values())[index]
    state = rng.integers(1 << 60)
    parameters, traits = draw(family, rng)
    vertices, triangles = _rebuild(family, parameters, traits, state).mesh()
    try:
        graph = boxmorph.BoxDefGraph.build(boxmorph.Mesh(vertices, triangles), int(rng.integers(2, 5)))
    except ValueError:
        return None
    prompt, name = _prompt(family, rng)
    wish = guide.words([prompt])[0]
    seen, disputes = [], []

    def score(scales):
        batch = np.stack([grey_views(graph.deform(s.astype(np.float32)), triangles) for s in scales])
        seen.append(batch)
        pairs = (guide.shapes(batch, grounds=1) * wish).reshape(len(batch), guide.nets, -1).sum(2)
        disputes.append(np.ptp(pairs, axis=1) * guide.nets)
        return pairs.sum(1)

    tried, value = search(score, graph.parameter_rows, rng)
    views, dispute = np.concatenate(seen), np.concatenate(disputes)
    early = rng.choice(2 * SIZE, KEPT_EARLY, replace=False)
    best = np.setdiff1d(np.argsort(-value), early, assume_unique=True)[:KEPT_BEST]
    disputed = np.setdiff1d(np.argsort(-dispute), [*early, *best], assume_unique=True)[:KEPT_DISPUTED]
    gaps, rows, kept = [], [], [*best, *early, *disputed]
    for i in kept:
        copy = _rebuild(family, parameters, traits, state)
        set_vertices(copy, graph.deform(np.exp(tried[i]).astype(np.float32)))
        gap, proportions = truth(copy, FAMILIES, NAMES)
        gaps.append(gap)
        rows.append(quantities(copy, proportions))
    figures = (value[best[0]], np.exp(-gaps[0][name]), dispute[best[0]]) if name is not None else None
    family_column = np.full(len(kept), index, np.uint8)
    return (views[kept], np.array(gaps, np.float16), np.array(rows), family_column), figures


def _open(path):
    global _guide  # one guide a process: sessions cannot be sent between processes
    _guide = GuideFiles(path)


def _chunk(job):
    seed, count = job
    rng = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        outcome = climb(_guide, rng)
        found += [outcome] if outcome else []
    columns = zip(*(arrays for arrays, _ in found), strict=True)
    return [np.concatenate(c) for c in columns], [f for _, f in found if f]


def mine(guide, folder, count, seed, processes=2, chunk=20):
    """Run `count` searches and keep twenty candidates of each in `folder`; returns its figures."""
    jobs = [((seed, i), min(chunk, count - i)) for i in range(0, count, chunk)]
    with Pool(processes, _open, (guide,)) as pool:
        chunks = list(pool.imap(_chunk, jobs))
    save(folder, [arrays for arrays, _ in chunks])
    score, fact, dispute = np.array([f for _, figures in chunks for f in figures]).T
    figures = {
        "searches": count,
        "mean score of the best": round(float(score.mean()), 3),
        "mean truth of the best": round(float(fact.mean()), 3),
        "believed but not true": round(float(((score > BELIEVED) & (fact < TRUE)).mean()), 3),
        "mean dispute of the networks": round(float(dispute.mean()), 3),
    }
    (Path(folder) / "figures.json").write_text(json.dumps(figures, indent=2) + "\n")
    return figures


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("guide")
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    print(json.dumps(mine(arguments.guide, arguments.folder, arguments.count, arguments.seed), indent=2))
