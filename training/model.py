# SPDX-License-Identifier: MIT OR Apache-2.0
"""The two encoders: a small convolutional network for the middle of 64 x 64 images, and a bag of words with a
head.
"""

import torch
from text import FILLERS, PAD, UNKNOWN, plural_pairs, vocabulary
from torch import nn
from torch.nn.functional import normalize

# Width and stride of each 3 x 3 convolution.
LAYERS = ((16, 2), (32, 2), (96, 2), (192, 2), (192, 1))
MARGIN = 8  # pixels that no view reaches: the unit sphere fills three quarters of the image
SEEN = 48
EMBEDDING = 128


class ImageEncoder(nn.Module):
    """The middles (k, 3, SEEN, SEEN) of normalised images to (k, EMBEDDING) unit vectors."""

    def __init__(self):
        super().__init__()
        layers, last = [], 3
        for width, stride in LAYERS:
            layers += [
                nn.Conv2d(last, width, 3, stride, 1, bias=False),
                nn.BatchNorm2d(width),
                nn.ReLU(inplace=True),
            ]
            last = width
        self.features = nn.Sequential(*layers)
        self.head = nn.Linear(last * 9, EMBEDDING)

    def forward(self, images):
        return normalize(self.head(self.features(images).flatten(1)).float(), dim=-1)


class TextEncoder(nn.Module):
    """(k, length) token ids to (k, EMBEDDING) unit vectors; padding, fillers and unknown words weigh
    nothing.
    """

    def __init__(self, width=96, hidden=256):
        super().__init__()
        ids = vocabulary()
        weight = torch.ones(len(ids), 1)
        weight[[ids[w] for w in (PAD, UNKNOWN, *FILLERS)]] = 0.0
        self.register_buffer("weight", weight)
        same = torch.arange(len(ids))
        for many, one in plural_pairs():
            same[many] = one
        self.register_buffer("same", same)
        self.words = nn.Embedding(len(ids), width)
        self.hidden = nn.Linear(width, hidden)
        self.out = nn.Linear(hidden, EMBEDDING)

    def table(self):
        """Word vectors with plurals tied to their singulars, (words, width)."""
        return self.words.weight[self.same]

    def forward(self, ids):
        weight = self.weight[ids]
        mean = (self.table()[ids] * weight).sum(1) / weight.sum(1).clamp(min=1.0).sqrt()
        return normalize(self.out(torch.relu(self.hidden(mean))), dim=-1)
