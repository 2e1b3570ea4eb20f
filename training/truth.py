# SPDX-License-Identifier: MIT OR Apache-2.0
"""Truth, measured: how far the vertices of a shape lie from what every name means."""

import numpy as np

SIGMA = 0.3
FAULT_SIGMA = 0.35
DAMAGE = 3.0  # squared sigmas of a shape that is wholly broken
LOOKALIKE = 0.7  # what a stool lacks to be a side table, and the reverse: the eye cannot tell, the maker can
FAR = 400.0  # of another family: nothing is left to climb


def distance(family, kind, proportions, traits):
    """Squared distance, in sigmas, of measured proportions and traits to a kind's region: 0 inside."""
    total = sum(price for t, (wanted, price) in kind.traits.items() if traits.get(t) not in wanted)
    for name, (low, high, *sigma) in kind.ranges.items():
        axis = family.measured[name]
        x = axis.place(proportions[name])
        gap = max(axis.place(low) - x, x - axis.place(high), 0.0)
        if low == 0 and axis.shift is not None:
            gap = max(x - axis.place(high), 0.0)
        total += (gap / (sigma[0] if sigma else SIGMA)) ** 2
    return total


def truth(shape, families, names):
    """Squared distances (in sigmas, at most FAR) of a shape to every name of `names`, and its proportions.

    `names` is a list of (module, kind or None); None stands for the family's own word.
    """
    family = families[shape.family]
    proportions, faults = family.measure(shape)
    fault = sum((f / FAULT_SIGMA) ** 2 for f in faults) + DAMAGE * shape.damage
    other = family.resembles(shape, proportions)
    gaps = np.full(len(names), FAR)
    nearest = FAR
    for i, (module, kind) in enumerate(names):
        if kind is None:
            continue
        if module == shape.family:
            gap = distance(family, family.kinds[kind], proportions, shape.traits)
            nearest = min(nearest, gap)
            gaps[i] = gap + fault
        elif other and module == other[0]:
            seen = families[module]
            gaps[i] = distance(seen, seen.kinds[kind], other[1], other[2]) + fault + LOOKALIKE
    if (shape.family, None) in names:
        gaps[names.index((shape.family, None))] = max(fault, 0.25 * nearest)
    # A part flattened to nothing has no proportions: such a shape is nothing.
    return np.minimum(np.nan_to_num(gaps, nan=FAR, posinf=FAR), FAR), proportions
