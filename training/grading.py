# SPDX-License-Identifier: MIT OR Apache-2.0
"""Graded truth of adjectives: a tall chair is taller than chairs are, measured over the shapes drawn.

Each noun (a kind, or a family's word) has its usual value of every quantity and each family a step: the
spread inside one kind. An adjective holds fully `FULL` steps beyond the usual.
"""

import numpy as np
from families import FAMILIES, NAMES
from shapes.attributes import attributes

FULL = 2.5  # steps from the usual value at which an adjective holds fully
SLOPE = 0.4  # squared sigmas per squared step short of that
KIND_SHARE = 0.4  # how much of the distance to the noun counts beside an adjective
WIDTH = max(len(f.quantities) for f in FAMILIES.values())


def quantities(shape, proportions):
    """The quantities of the shape's family, (WIDTH,) float32, each on its axis of comparison."""
    family = FAMILIES[shape.family]
    general = attributes(shape)
    row = np.zeros(WIDTH, np.float32)
    for i, name in enumerate(family.quantities):
        own = family.measured.get(name)
        row[i] = own.place(proportions[name]) if own else general[name]
    return np.nan_to_num(row, nan=0.0, posinf=0.0, neginf=0.0)


def usual(gaps, rows, family):
    """Usual value (names, WIDTH) of every quantity for every noun, and the step (families, WIDTH).

    `gaps` (k, names) squared distances, `rows` (k, WIDTH) quantities, `family` (k,) indices of shapes drawn.
    """
    center, step = np.zeros((len(NAMES), WIDTH)), np.ones((len(FAMILIES), WIDTH))
    for f, module in enumerate(FAMILIES):
        inside = family == f
        weight = np.exp(-gaps[inside].astype(float)) + 1e-9
        values = rows[inside].astype(float)
        spreads = []
        for n, (owner, kind) in enumerate(NAMES):
            if owner != module:
                continue
            w = weight[:, n] / weight[:, n].sum()
            center[n] = w @ values
            if kind:
                spreads.append(w @ (values - center[n]) ** 2)
        step[f] = np.sqrt(np.mean(spreads, 0)) + 0.02
    return center, step


def lack(steps):
    """Squared sigmas that an adjective lacks at a value `steps` beyond the usual, in its own direction."""
    return SLOPE * np.maximum(FULL - steps, 0.0) ** 2
