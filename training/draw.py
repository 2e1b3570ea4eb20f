# SPDX-License-Identifier: MIT OR Apache-2.0
"""Parameters of random shapes: inside a kind, between two kinds of a family, or anywhere in its ranges."""

import numpy as np

INSIDE, BETWEEN = 0.36, 0.44  # shares of the draws; the rest is anywhere


def draw(family, rng, name=None):
    """Parameters and traits of a random shape of a family; inside the kind `name` when given."""
    names = list(family.kinds)
    choice = rng.random()
    p = {n: axis.between(axis.low, axis.high, rng.random()) for n, axis in family.axes.items()}
    traits = {}
    if name or choice < INSIDE:
        kind = family.kinds[name or names[rng.integers(len(names))]]
        p.update(_inside(family, kind, rng))
        traits = _traits(kind, rng)
    elif choice < INSIDE + BETWEEN:
        a, b = (family.kinds[names[i]] for i in rng.choice(len(names), 2, replace=False))
        t = rng.uniform(-0.15, 1.15)
        pa, pb = {**p, **_inside(family, a, rng)}, {**p, **_inside(family, b, rng)}
        p = {n: axis.between(pa[n], pb[n], t) for n, axis in family.axes.items()}
        traits = _traits(a if rng.random() < 0.5 else b, rng)
    p = {n: float(np.clip(p[n], axis.low, axis.high)) for n, axis in family.axes.items()}
    return p, traits


def _inside(family, kind, rng):
    return {
        n: family.axes[n].between(low, high, rng.random())
        for n, (low, high, *_) in kind.ranges.items()
        if n in family.axes
    }


def _traits(kind, rng):
    if rng.random() > 0.85:
        return {}
    return {t: wanted[rng.integers(len(wanted))] for t, (wanted, _) in kind.traits.items()}
