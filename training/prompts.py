# SPDX-License-Identifier: MIT OR Apache-2.0
"""Prompts with adjectives for the shapes of a batch, and what each shape lacks of them."""

from pathlib import Path

import numpy as np
from families import FAMILIES, NAMES
from grading import KIND_SHARE, lack
from kinds.adjectives import forms
from text import bag, phrases

# What names a thing already cannot be an adjective as well: "a high chair", "a heavy rocket".
NAMED = {bag(phrase) for name in NAMES for phrase in phrases(name)}
OWNER = np.array([list(FAMILIES).index(module) for module, _ in NAMES])
WORDS = np.flatnonzero([kind is None for _, kind in NAMES])  # the name of each family as a whole
BARE = 0.08  # share of the prompts that name nothing: "taller"
TWICE = 0.4  # share of the others that ask for two things at once
FOREIGN = 2.0  # squared sigmas that a shape of another family lacks of an adjective
SILENT = 6.0  # the same where nothing is named and the family has no such adjective


def held_back(n, adjectives):
    """Whether a name (an index) with two adjectives is one of the eighth that no prompt ever says, to see
    what the guide makes of what it has never read.
    """
    known = list(list(FAMILIES.values())[OWNER[n]].adjectives)
    return (n + sum(known.index(a) for a in adjectives)) % 8 == 0


class Graded:
    """Draws prompts such as "a tall bar stool", "a low wide table", and grades shapes by them."""

    def __init__(self, base, rng):
        self.rng = rng
        stored = np.load(Path(base) / "usual.npz")
        self.center, self.step = stored["center"], stored["step"]

    def _pick(self, options):
        return options[self.rng.integers(len(options))]

    def prompts(self, count, gaps, rows, family):
        """A prompt for each of the first `count` shapes: texts, and squared distances (shapes, prompts)."""
        pairs = [self._prompt(i, gaps, rows, family) for i in range(count)]
        texts, columns = zip(*pairs, strict=True)
        return list(texts), np.stack(columns, 1).astype(np.float32)

    def gap(self, n, adjectives, gaps, rows, own=True):
        """Squared distances (shapes,) from a name (an index) with adjectives; `own` says which shapes are
        of its family.
        """
        lacks = (np.where(own, self._lack(n, adjective, rows), FOREIGN) for adjective in adjectives)
        return KIND_SHARE * gaps[:, n] + sum(lacks)

    def _prompt(self, i, gaps, rows, family):
        own = list(FAMILIES.values())[family[i]]
        wanted = [self._adjective(own, WORDS[family[i]], rows[i])]
        if self.rng.random() < BARE:
            return self._pick(forms(wanted[0])), self._bare_gap(wanted[0], gaps, rows, family)
        n = self._noun(gaps[i], family[i])
        if self.rng.random() < TWICE:
            wanted.append(self._adjective(own, n, rows[i]))
            if wanted[1] == wanted[0] or held_back(n, wanted):
                wanted.pop()
        text = self._pick(phrases(NAMES[n]))
        for adjective in wanted:
            said = [f"{form} {text}" for form in forms(adjective)]
            text = self._pick([s for s in said if bag(s) not in NAMED])
        return text, self.gap(n, wanted, gaps, rows, family == family[i])

    def _adjective(self, own, n, row):
        """Any adjective of the family, or of three the one that is truest of the shape."""
        options = [self._pick(list(own.adjectives)) for _ in range(3)]
        if self.rng.random() < 0.4:
            return options[0]
        return min(options, key=lambda adjective: self._lack(n, adjective, row[None])[0])

    def _noun(self, gaps, f):
        """The name (an index) that a shape's prompt says: the family's word, the likeliest kind, or any."""
        kinds, choice = np.flatnonzero(f == OWNER)[:-1], self.rng.random()
        if choice < 0.25:
            return WORDS[f]
        return kinds[gaps[kinds].argmin()] if choice < 0.7 else self._pick(kinds)

    def _lack(self, n, adjective, rows):
        """Squared sigmas that shapes (rows of quantities) lack of an adjective beside the name `n`."""
        own = list(FAMILIES.values())[OWNER[n]]
        quantity, sign = own.adjectives[adjective]
        q = own.quantities.index(quantity)
        return lack(sign * (rows[:, q] - self.center[n, q]) / self.step[OWNER[n], q])

    def _bare_gap(self, adjective, gaps, rows, family):
        """Squared distances from an adjective alone: each shape beside what is usual in its own family."""
        lacks = np.full(len(rows), SILENT)
        for f, own in enumerate(FAMILIES.values()):
            if adjective in own.adjectives:
                inside = family == f
                lacks[inside] = self._lack(WORDS[f], adjective, rows[inside])
        return KIND_SHARE * gaps[np.arange(len(gaps)), WORDS[family]] + lacks
