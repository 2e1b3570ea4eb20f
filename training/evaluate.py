# SPDX-License-Identifier: MIT OR Apache-2.0
"""Figures for the model card: how well a guide names held-out shapes, and unseen meshes in a folder of .obj
files.
"""

import argparse
import itertools
import json
from pathlib import Path

import numpy as np
import onnxruntime
from families import FAMILIES, NAMES
from fit import HELD_OUT
from generate import SIZE, grey_views
from kinds.adjectives import forms
from prompts import OWNER, Graded, held_back
from tokenizers import Tokenizer

BACKGROUNDS = np.array([[0, 0, 0], [255, 255, 255], [255, 128, 0]], np.float32)


class GuideFiles:
    """The two sessions and the tokenizer of a guide folder."""

    def __init__(self, folder, threads=1):
        folder = Path(folder)
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = threads
        self.image = onnxruntime.InferenceSession(str(folder / "vision_model.onnx"), options)
        self.text = onnxruntime.InferenceSession(str(folder / "text_model.onnx"))
        self.tokenizer = Tokenizer.from_file(str(folder / "tokenizer.json"))
        self.config = json.loads((folder / "config.json").read_text())
        self.classes = self.config["boxmorph"]["classes"]
        self.nets = self.config["boxmorph"].get("networks", 1)

    def words(self, texts):
        """Unit embeddings (k, d) of texts."""
        rows = self.tokenizer.encode_batch(list(texts))
        ids, mask = np.array([r.ids for r in rows]), np.array([r.attention_mask for r in rows])
        return self.text.run(None, {"input_ids": ids, "attention_mask": mask})[0]

    def shapes(self, images, grounds=3):
        """Mean embeddings (k, d) over 4 views and the first backgrounds; images are grey and coverage."""
        grey, cover = (images[:, :, None, ..., i].astype(np.float32) for i in range(2))
        out = 0
        for ground in BACKGROUNDS[:grounds]:
            x = (grey * cover + ground[:, None, None] * (255 - cover)) / (127.5 * 255) - 1
            out = out + self.image.run(None, {"pixel_values": x.reshape(-1, 3, SIZE, SIZE)})[0]
        return out.reshape(len(images), 4, -1).mean(1) / grounds


def held_out(guide, folder, count=HELD_OUT):
    """By family, among held-out shapes that clearly are of one kind: how many, and the shares whose kind is
    ranked first, and in the first three, of all kinds; and the correlation of score and truth over all.
    """
    kinds = np.array([kind is not None for _, kind in NAMES])
    images = np.load(Path(folder) / "images.npy", mmap_mode="r")[-count:]
    truth = np.exp(-np.load(Path(folder) / "gaps.npy")[-count:].astype(float))[:, kinds]
    family = np.load(Path(folder) / "family.npy")[-count:]
    seen = np.concatenate([guide.shapes(images[i : i + 100]) for i in range(0, len(images), 100)])
    score = seen @ guide.words(guide.classes).T
    order = np.argsort(-truth, 1)
    best, second = (np.take_along_axis(truth, order[:, i : i + 1], 1)[:, 0] for i in range(2))
    clear = (best > 0.7) & (second < 0.5)
    rank = (score > np.take_along_axis(score, order[:, :1], 1)).sum(1)
    figures = {}
    for i, module in enumerate(FAMILIES):
        pick = clear & (family == i)
        figures[module] = {
            "shapes": int(pick.sum()),
            "first": round(float((rank[pick] == 0).mean()), 3),
            "first three": round(float((rank[pick] < 3).mean()), 3),
        }
    figures["correlation of score and truth"] = round(
        float(np.corrcoef(score.ravel(), truth.ravel())[0, 1]), 3
    )
    return figures


def ranks(values):
    """The rank of every value."""
    return np.argsort(np.argsort(values))


def combinations(guide, folder, count=HELD_OUT, prompts=400):
    """Mean rank correlation of score and truth, among a family's held-out shapes, for prompts of a kind and
    two adjectives: those that training may say, and those that it never does.
    """
    rng = np.random.default_rng(0)
    graded = Graded(folder, rng)
    images = np.load(Path(folder) / "images.npy", mmap_mode="r")[-count:]
    facts = [np.load(Path(folder) / f"{n}.npy", mmap_mode="r") for n in ("gaps", "quantities", "family")]
    gaps, rows, family = (f[-count:] for f in facts)
    seen = np.concatenate([guide.shapes(images[i : i + 100]) for i in range(0, len(images), 100)])
    found = {True: [], False: []}
    for _ in range(prompts):
        f = rng.integers(len(FAMILIES))
        adjectives = list(list(FAMILIES.values())[f].adjectives)
        n = rng.choice(np.flatnonzero(f == OWNER)[:-1])
        wanted = list(rng.choice(adjectives, 2, replace=False))
        text = f"{forms(wanted[0])[0]} {forms(wanted[1])[0]} {NAMES[n][1]}"
        inside = family == f
        score = seen[inside] @ guide.words([text])[0]
        gap = graded.gap(n, wanted, gaps[inside], rows[inside])
        found[held_back(n, wanted)].append(np.corrcoef(ranks(score), ranks(-gap))[0, 1])
    return {
        "said": round(float(np.mean(found[False])), 3),
        "never said": round(float(np.mean(found[True])), 3),
    }


def read_obj(path):
    """Vertices and triangles of a y-up .obj file, turned z up."""
    vertices, triangles = [], []
    for line in Path(path).read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            x, y, z = map(float, rest[:3])
            vertices.append((x, -z, y))
        elif word == "f":
            ring = [int(r.split("/")[0]) - 1 for r in rest]
            triangles += [(ring[0], b, c) for b, c in itertools.pairwise(ring)]
    return np.array(vertices, np.float32), np.array(triangles, np.uint32)


def name_meshes(guide, folder):
    """File stem to the three best class prompts with scores, for every .obj in the folder."""
    words = guide.words(guide.classes)
    named = {}
    for path in sorted(Path(folder).glob("*.obj")):
        score = guide.shapes(grey_views(*read_obj(path))[None])[0] @ words.T
        named[path.stem] = [(guide.classes[i], round(float(score[i]), 3)) for i in np.argsort(-score)[:3]]
    return named


def family_of(guide, view):
    """The word for the family that a shape belongs to: the one whose three best names score highest together.

    One name alone would not do: a low table without drawers is a bench as well.
    """
    score = dict(zip(guide.classes, guide.shapes(view[None])[0] @ guide.words(guide.classes).T, strict=True))
    families = guide.config["boxmorph"]["families"]
    return max(families, key=lambda name: sum(sorted(score[kind] for kind in families[name])[-3:]))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("guide")
    parser.add_argument("--data", help="folder made by generate.py")
    parser.add_argument("--meshes", help="folder of .obj files")
    arguments = parser.parse_args()
    opened = GuideFiles(arguments.guide)
    if arguments.data:
        print(json.dumps(held_out(opened, arguments.data), indent=2))
        print("two adjectives:", json.dumps(combinations(opened, arguments.data)))
    if arguments.meshes:
        print(json.dumps(name_meshes(opened, arguments.meshes), indent=2))
