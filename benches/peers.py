# SPDX-License-Identifier: MIT OR Apache-2.0
"""Our whole job beside what one would write with the usual libraries: pycma driving CLIP in PyTorch, and the
embedded guide in ONNX Runtime from Python.

Usage: benches/.venv/bin/python benches/peers.py FOLDER [--generations N] [--rounds N]

FOLDER holds a ViT-B/32 of random weights from tests/python/random_clip.py; PyTorch makes the same weights
from the same seed. Prints rows of the bench's table as JSON. The peers are given our renderer, our boxes and
our field: those of the paper's program need CUDA, and take longer. So only search, preparing images and
encoding differ.
"""

import argparse
import json
import os
import pathlib
import sys
import time

import boxmorph
import cma
import encoding
import numpy as np
import shapes
import torch
import transformers

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "tests" / "python"))
import random_clip  # noqa: E402 (it lies with the tests)

PROMPT = "a bar stool"
BACKGROUNDS = torch.tensor([(0, 0, 0), (1, 1, 1), (1, 0.5, 0)])
#: The bounds of the search variable, and the scale change of one unit of it: the paper's protocol.
BOUNDS, SCALE_PER_X = [-1, 3], 0.7


class Encoder:
    """What both encoders share: images between 0 and 1, (k, 3, h, w), to unit embeddings (k, d)."""

    def __init__(self, folder):
        settings = json.loads(pathlib.Path(folder, "preprocessor_config.json").read_text())
        self.mean, self.std = (
            torch.tensor(settings[key])[:, None, None] for key in ("image_mean", "image_std")
        )

    def embeddings(self, pixels):
        """Unit embeddings (k, d) of images (k, 3, h, w)."""
        with torch.inference_mode():
            return torch.nn.functional.normalize(self.network((pixels - self.mean) / self.std))

    def encode_bytes(self, pixels):
        """Unit embeddings (k, d) of bytes (k, h, w, 3)."""
        return self.embeddings(torch.from_numpy(pixels).permute(0, 3, 1, 2) / 255)


class TorchClip(Encoder):
    """CLIP in PyTorch, with the weights of `random_clip.make`."""

    def __init__(self, folder):
        super().__init__(folder)
        settings = random_clip.config("vit-b-32", None)
        torch.manual_seed(0)
        vision = transformers.CLIPVisionModelWithProjection(settings.vision_config).eval()
        # `make` draws an example in between.
        torch.rand(2, 3, settings.vision_config.image_size, settings.vision_config.image_size)
        text = transformers.CLIPTextModelWithProjection(settings.text_config).eval()
        self.network = lambda pixels: vision(pixels).image_embeds
        tokenizer = transformers.PreTrainedTokenizerFast(
            tokenizer_file=os.path.join(folder, "tokenizer.json")
        )
        with torch.inference_mode():
            tokens = torch.tensor([tokenizer(PROMPT)["input_ids"]])
            self.text = torch.nn.functional.normalize(text(tokens).text_embeds)


class BareMini(Encoder):
    """The embedded guide's image network in ONNX Runtime from Python."""

    def __init__(self, folder):
        super().__init__(folder)
        session = encoding.bare_session(folder)
        self.network = lambda pixels: torch.from_numpy(
            session.run(["image_embeds"], {"pixel_values": pixels.numpy()})[0]
        )
        self.text = torch.from_numpy(boxmorph.Guide.open(folder).text_embedding(PROMPT))[None]


class Script:
    """The script one would write: from a candidate of pycma to its score."""

    def __init__(self, encoder, size, vertices, triangles):
        self.encoder, self.size, self.triangles = encoder, size, triangles
        self.mesh, self.rest = boxmorph.Mesh(vertices, triangles), torch.from_numpy(vertices)
        graph = boxmorph.BoxDefGraph.build(self.mesh, splits=4, symmetry="x", boundary="paper")
        self.field, self.rows = torch.from_numpy(graph.field()), graph.parameter_rows

    def loss(self, x):
        """The paper's: −mean cosine of 12 images + 0.25 × normal error."""
        change = SCALE_PER_X * torch.from_numpy(x).float().reshape(self.rows, 3)
        moved = self.rest + torch.einsum("pa,apn->na", change, self.field)
        vertices = moved.contiguous().numpy()
        views = boxmorph.render(vertices, self.triangles, size=self.size, renderer="cpu")
        views = torch.from_numpy(views).permute(0, 3, 1, 2) / 255
        color, alpha = views[:, :3], views[:, 3:]
        images = torch.cat([color * alpha + ground[:, None, None] * (1 - alpha) for ground in BACKGROUNDS])
        cosine = (self.encoder.embeddings(images) @ self.encoder.text.T).mean().item()
        return -cosine + 0.25 * boxmorph.metrics.normal_error(self.mesh, vertices)

    def search(self, generations):
        """Seconds of some generations, and candidates."""
        n = 3 * self.rows
        options = {"bounds": BOUNDS, "popsize": int(12 + 9 * np.log(n)), "verbose": -9, "seed": 1}
        start = time.perf_counter()
        search = cma.CMAEvolutionStrategy([0.0] * n, 1.0, options)
        for _ in range(generations):
            candidates = search.ask()
            search.tell(candidates, [self.loss(x) for x in candidates])
        return time.perf_counter() - start, search.countevals


def our_search(guide, vertices, triangles, candidates):
    """Seconds from a mesh until about so many candidates are scored, and their number."""
    mesh = boxmorph.Mesh(vertices, triangles)
    job = boxmorph.Job(mesh, PROMPT, guide=guide, preset="paper", splits=4, renderer="cpu")
    start = time.perf_counter()
    job.start()
    progress = job.progress()
    while progress["evaluations"] < candidates and not progress["finished"]:
        time.sleep(0.001)
        progress = job.progress()
    seconds = time.perf_counter() - start
    job.cancel()
    try:
        job.join()
    except boxmorph.Cancelled:
        pass
    return seconds, progress["evaluations"]


def seconds_a_candidate(script, guide, shape, generations, rounds):
    """Least seconds a candidate, ours and the script's, in turn; and the candidates of a search."""
    ours = theirs = float("inf")
    for _ in range(rounds):
        seconds, candidates = script.search(generations)
        theirs = min(theirs, seconds / candidates)
        seconds, scored = our_search(guide, *shape, candidates)
        ours = min(ours, seconds / scored)
    return ours, theirs, candidates


def candidate_rows(model, names, ours, theirs, limit):
    """Rows of a candidate, beside the peers and beside encoding alone; seconds."""
    what = f"a candidate of 12 images, {model}"
    yield what, f"{1e3 * ours:.1f} ms", f"{names} {1e3 * theirs:.1f} ms", f"{theirs / ours:.2f} × as fast"
    beside = f"bare ONNX Runtime, encoding alone, {1e3 * limit:.1f} ms"
    yield what, f"{1e3 * ours:.1f} ms", beside, f"{limit / ours:.2f} × as fast"


def clip_rows(folder, shape, generations, rounds):
    """CLIP ViT-B/32, where encoding is nearly all."""
    start = time.perf_counter()
    encoder = TorchClip(folder)
    peers_open = time.perf_counter() - start
    start = time.perf_counter()
    guide = boxmorph.Guide.open(folder)
    guide.text_embedding(PROMPT)
    ours_open = time.perf_counter() - start

    check = encoding.images(4, guide.image_size)
    apart = np.abs(guide.image_embeddings(check) - encoder.encode_bytes(check).numpy()).max()
    if apart > 1e-3:
        raise SystemExit(f"PyTorch's embeddings are {apart:.1e} from ours: these are not the same weights")

    found = encoding.rates(folder, 12, 3 * rounds, torch=encoder.encode_bytes)
    yield encoding.row("encoding, ViT-B/32, 12 images at once", found)
    mine, its = encoding.rate(found["ours"]), encoding.rate(found["torch"])
    yield "the same", mine, f"PyTorch {its}", f"{found['ours'] / found['torch']:.2f} ×"

    script = Script(encoder, guide.image_size, *shape)
    ours, theirs, candidates = seconds_a_candidate(script, guide, shape, generations, rounds)
    yield from candidate_rows("ViT-B/32", "pycma and PyTorch", ours, theirs, 12 / found["bare"])
    ours, theirs = ours_open + ours * candidates, peers_open + theirs * candidates
    yield (
        f"a job of {candidates} such candidates, from opening the model",
        f"{ours:.1f} s",
        f"pycma and PyTorch {theirs:.1f} s",
        f"{theirs / ours:.2f} × as fast",
    )


def mini_rows(shape, rounds):
    """The embedded guide, where everything else counts."""
    guide = boxmorph.Guide.open()
    script = Script(BareMini(encoding.MINI), guide.image_size, *shape)
    ours, theirs, _ = seconds_a_candidate(script, guide, shape, 10, 2 * rounds)
    bare = encoding.rates(None, 12, 50 * rounds)["bare"]
    names = "pycma and bare ONNX Runtime"
    yield from candidate_rows("the embedded guide", names, ours, theirs, 12 / bare)


def main():
    """Print the rows, one JSON list a line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("--generations", type=int, default=2)
    parser.add_argument("--rounds", type=int, default=2)
    arguments = parser.parse_args()
    torch.set_num_threads(os.cpu_count())
    shape = shapes.grid_chair(20_000)
    versions = f"PyTorch {torch.__version__.split('+')[0]}, transformers {transformers.__version__}"
    versions += f", pycma {cma.__version__}"
    print(json.dumps(("peers", versions, "on all cores, given our renderer, boxes and field", "")))
    for row in mini_rows(shape, arguments.rounds):
        print(json.dumps(row), flush=True)
    for row in clip_rows(arguments.folder, shape, arguments.generations, arguments.rounds):
        print(json.dumps(row), flush=True)


if __name__ == "__main__":
    main()
