# SPDX-License-Identifier: MIT OR Apache-2.0
"""Train one pair of encoders: the cosine of every (shape, prompt) pair is fitted to its graded truth."""

import argparse
import time
from pathlib import Path

import numpy as np
import torch
from families import NAMES
from model import MARGIN, SEEN, ImageEncoder, TextEncoder
from prompts import OWNER, Graded
from text import Words, phrases
from torch.nn.functional import binary_cross_entropy_with_logits

BACKGROUNDS = torch.tensor([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.5, 0.0]])
SHAPES = 160  # shapes a batch, one view each: many shapes teach more than many views
PROMPTS = 90  # of them that get a prompt with an adjective
MINED = 0.4  # share of a batch that comes from searches, once there are any
HELD_OUT = 3000  # shapes at the end of the first folder that no net is trained on
OTHER_FAMILY = 0.2  # weight of a pair whose shape and prompt are of different families
# Where a processor only imitates bfloat16, a batch in it takes twelve times as long as in float32.
BFLOAT16 = any(torch.cpu.get_capabilities().get(unit) for unit in ("amx_bf16", "avx512_bf16"))


def goal(gap):
    """The cosine wanted at a squared distance: 0.9 inside a kind, falling in three lengths.

    A peak to rank by, a slope to climb, and a tail that still points home from the far end of the family.
    """
    root = gap.clamp(min=1e-6).sqrt()
    return 0.5 * torch.exp(-gap) + 0.28 * torch.exp(-0.7 * root) + 0.12 * torch.exp(-0.25 * root)


def composite(images, rng):
    """Grey and coverage (k, s, s, 2) uint8 to what the encoder sees of them, (k, 3, SEEN, SEEN) in -1..1:
    random backgrounds, small shifts.
    """
    y, x = MARGIN + rng.integers(-1, 2, 2)
    flat = torch.from_numpy(images[:, None, y : y + SEEN, x : x + SEEN])
    grey, cover = flat[..., 0].float() / 255, flat[..., 1].float() / 255
    ground = BACKGROUNDS[torch.from_numpy(rng.integers(0, 3, len(images)))][:, :, None, None]
    return (grey * cover + ground * (1 - cover)) * 2 - 1


class Shapes:
    """Random batches from folders of arrays: all of the first but its last shapes, and a share of mined
    ones.
    """

    def __init__(self, folders, rng, held_out=HELD_OUT):
        self.rng = rng
        self.images = [np.load(Path(f) / "images.npy") for f in folders]
        self.facts = [
            [np.load(Path(f) / f"{name}.npy") for name in ("gaps", "quantities", "family")] for f in folders
        ]
        self.counts = [len(i) for i in self.images]
        self.counts[0] -= held_out
        self.order, self.at = [], 0

    def batch(self):
        """One view each (SHAPES, s, s, 2) uint8, gaps (SHAPES, names), quantities and families."""
        mined = self.rng.binomial(SHAPES, MINED) if len(self.counts) > 1 else 0
        fresh = SHAPES - mined
        if self.at + fresh > len(self.order):
            self.order, self.at = self.rng.permutation(self.counts[0]), 0
        picks = [(0, i) for i in self.order[self.at : self.at + fresh]]
        self.at += fresh
        for _ in range(mined):
            f = 1 + int(self.rng.integers(len(self.counts) - 1))
            picks.append((f, int(self.rng.integers(self.counts[f]))))
        picks = [picks[i] for i in self.rng.permutation(SHAPES)]
        views = self.rng.integers(0, 4, SHAPES)
        images = np.stack([self.images[f][i, v] for (f, i), v in zip(picks, views, strict=True)])
        gaps, rows, family = (np.stack([self.facts[f][column][i] for f, i in picks]) for column in range(3))
        return images, gaps.astype(np.float32), rows, family


def fit(folders, out, steps, seed, threads, resume=None, rate=2e-3):
    """Train on the shapes of `folders`, from the weights `resume` or from scratch, and save the weights to
    `out`.
    """
    torch.set_num_threads(threads)
    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    shapes, graded, ids = Shapes(folders, rng), Graded(folders[0], rng), Words()
    eye, text = ImageEncoder().to(memory_format=torch.channels_last), TextEncoder()
    if resume:
        state = torch.load(resume)
        eye.load_state_dict(state["image"])
        text.load_state_dict(state["text"])
    ways = [phrases(name) for name in NAMES]
    weights = [*eye.parameters(), *text.parameters()]
    optimiser = torch.optim.AdamW(weights, lr=rate, weight_decay=2e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, rate, steps, pct_start=0.06)
    start = time.time()
    for step in range(steps):
        pictures, gaps, rows, family = shapes.batch()
        x = composite(pictures, rng).contiguous(memory_format=torch.channels_last)
        texts, graded_gaps = graded.prompts(PROMPTS, gaps, rows, family)
        texts = [p[rng.integers(len(p))] for p in ways] + texts
        gap = torch.from_numpy(np.concatenate([gaps, graded_gaps], 1))
        owner = np.concatenate([OWNER, family[:PROMPTS]])
        near = torch.from_numpy(np.where(owner == family[:, None], 1.0, OTHER_FAMILY).astype(np.float32))
        words = text(torch.tensor(ids.encode(texts)))
        with torch.autocast("cpu", dtype=torch.bfloat16, enabled=BFLOAT16):
            seen = eye(x)
        score = seen @ words.T
        wanted = goal(gap)
        weight = near + 2.5 * wanted
        loss = (weight * (score - wanted) ** 2).mean()
        loss = (
            loss
            + 0.01
            * (
                near
                * binary_cross_entropy_with_logits(14 * (score - 0.45), torch.exp(-gap), reduction="none")
            ).mean()
        )
        if not torch.isfinite(loss):
            raise SystemExit(f"training: the loss of batch {step} is no number; look for one in {folders}")
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        schedule.step()
        if step % 200 == 0 or step == steps - 1:
            own = near > OTHER_FAMILY
            error = (score - wanted).abs()[own].mean().item()
            print(
                f"net {seed} step {step} loss {loss.item():.4f} error in the family {error:.4f} "
                f"{time.time() - start:.0f} s",
                flush=True,
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
