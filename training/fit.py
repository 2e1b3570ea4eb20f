# SPDX-License-Identifier: MIT OR Apache-2.0
"""Train one pair of encoders: the cosine of every (shape, caption) pair is fitted to its graded truth."""

import argparse
import time
from pathlib import Path

import numpy as np
import torch
from kinds import CAPTIONS, NAMES
from model import ImageEncoder, TextEncoder
from text import ADJECTIVES, attribute_of, encode, phrases
from torch.nn.functional import binary_cross_entropy_with_logits

BACKGROUNDS = torch.tensor([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.5, 0.0]])
SHAPES = 32  # shapes a batch, four images each
MINED = 0.35  # share of a batch that comes from searches, once there are any
HELD_OUT = 2000  # shapes at the end of the first folder that no net is trained on


def goal(gap):
    """The cosine wanted at a squared distance: near 0.9 inside a kind, with a tail long enough to climb
    from afar.
    """
    return 0.55 * torch.exp(-gap) + 0.35 * torch.exp(-0.7 * gap.clamp(min=1e-6).sqrt())


def composite(images, rng):
    """Grey and coverage (k, 4, s, s, 2) uint8 to (4k, 3, s, s) in -1..1: random backgrounds, small shifts."""
    k, v, s = images.shape[:3]
    flat = torch.from_numpy(np.roll(images, rng.integers(-1, 2, 2), (2, 3)).reshape(k * v, 1, s, s, 2))
    grey, cover = flat[..., 0].float() / 255, flat[..., 1].float() / 255
    ground = BACKGROUNDS[torch.from_numpy(rng.integers(0, 3, k * v))][:, :, None, None]
    return (grey * cover + ground * (1 - cover)) * 2 - 1


def mixed_captions(rng, count=14):
    """Kinds with an adjective of their family: texts, kind indices, attribute indices."""
    texts, kinds, attributes = [], [], []
    for i in rng.integers(0, len(NAMES), count):
        family, kind = NAMES[i]
        index, adjective = attribute_of(family)[rng.integers(len(attribute_of(family)))]
        forms = ADJECTIVES[adjective]
        texts.append(forms[rng.integers(len(forms))] + " " + kind)
        kinds.append(int(i))
        attributes.append(index)
    return texts, kinds, attributes


class Shapes:
    """Random batches from folders of arrays: all of the first but its last shapes, and a share of mined
    ones.
    """

    def __init__(self, folders, rng, held_out=HELD_OUT):
        self.rng = rng
        self.images = [np.load(Path(f) / "images.npy", mmap_mode="r") for f in folders]
        self.gaps = [np.load(Path(f) / "gaps.npy").astype(np.float32) for f in folders]
        self.counts = [len(i) for i in self.images]
        self.counts[0] -= held_out
        self.order, self.at = [], 0

    def batch(self):
        """Images (SHAPES, 4, s, s) uint8 and gaps (SHAPES, captions)."""
        mined = self.rng.binomial(SHAPES, MINED) if len(self.counts) > 1 else 0
        fresh = SHAPES - mined
        if self.at + fresh > len(self.order):
            self.order, self.at = self.rng.permutation(self.counts[0]), 0
        picks = [(0, i) for i in np.sort(self.order[self.at : self.at + fresh])]
        self.at += fresh
        for _ in range(mined):
            f = 1 + int(self.rng.integers(len(self.counts) - 1))
            picks.append((f, int(self.rng.integers(self.counts[f]))))
        return np.stack([self.images[f][i] for f, i in picks]), np.stack([self.gaps[f][i] for f, i in picks])


def fit(folders, out, steps, seed, threads, resume=None, rate=2e-3):
    """Train on the shapes of `folders`, from the weights `resume` or from scratch, and save the weights to
    `out`.
    """
    torch.set_num_threads(threads)
    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    shapes = Shapes(folders, rng)
    eye, text = ImageEncoder().to(memory_format=torch.channels_last), TextEncoder()
    if resume:
        state = torch.load(resume)
        eye.load_state_dict(state["image"])
        text.load_state_dict(state["text"])
    weights = [*eye.parameters(), *text.parameters()]
    optimiser = torch.optim.AdamW(weights, lr=rate, weight_decay=2e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, rate, steps, pct_start=0.06)
    start = time.time()
    for step in range(steps):
        pictures, gap = shapes.batch()
        x = composite(pictures, rng).contiguous(memory_format=torch.channels_last)
        gap = torch.from_numpy(gap)
        texts = [(p := phrases(c))[rng.integers(len(p))] for c in CAPTIONS]
        more, kinds, attributes = mixed_captions(rng)
        gap = torch.cat([gap, 0.6 * gap[:, kinds] + 0.6 * gap[:, attributes]], 1)
        words = text(torch.tensor(encode(texts + more)))
        with torch.autocast("cpu", dtype=torch.bfloat16):
            seen = eye(x)
        each = (seen @ words.T).view(SHAPES, 4, -1)
        wanted = goal(gap)
        weight = 0.4 + 2.5 * wanted
        mean = each.mean(1)
        loss = (weight * (mean - wanted) ** 2).mean() + 0.3 * (
            weight[:, None] * (each - wanted[:, None]) ** 2
        ).mean()
        loss = loss + 0.02 * binary_cross_entropy_with_logits(14 * (mean - 0.45), torch.exp(-gap))
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        schedule.step()
        if step % 200 == 0 or step == steps - 1:
            error = (mean - wanted).abs().mean().item()
            seconds = time.time() - start
            print(
                f"net {seed} step {step} loss {loss.item():.4f} error {error:.4f} {seconds:.0f} s", flush=True
            )
    torch.save({"image": eye.state_dict(), "text": text.state_dict()}, out)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--steps", type=int, default=6000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rate", type=float, default=2e-3)
    parser.add_argument("--resume")
    parser.add_argument("--threads", type=int, default=1)
    a = parser.parse_args()
    fit(a.folders, a.out, a.steps, a.seed, a.threads, a.resume, a.rate)
