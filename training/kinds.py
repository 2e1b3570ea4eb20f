# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the words mean: every kind is a soft region in the measured proportions of its family.

A kind names a range for each proportion that matters, with how quickly belonging falls outside it (sigma,
in log
units), the traits it asks for with the price of lacking them, and how to draw an example. Truth for any
shape, interpolated, scaled or broken, is then read off its vertices.
"""

import numpy as np

SIGMA = 0.3
EPSILON = 0.1  # proportions that may be zero (a back, arms) are compared as log(value + EPSILON)
ZERO_BASED = {"back", "arm", "open", "slim", "body", "shade", "reach", "span"}


def _kind(traits=None, price=None, **ranges):
    return {"ranges": ranges, "traits": traits or {}, "price": price or {}}


KINDS = {
    "seat": {
        "chair": _kind(
            {"base": ("legs", "sled", "pedestal", "panels", "plinth")},
            {"base": 0.7},
            aspect=(0.78, 1.3),
            rise=(0.8, 1.25),
            back=(0.75, 1.5),
            arm=(0, 0.45),
            slim=(0, 0.32),
            open=(0.5, 1),
        ),
        "bar stool": _kind(
            aspect=(0.75, 1.3),
            rise=(1.65, 2.8),
            back=(0, 0.55, 0.45),
            arm=(0, 0.1),
            slim=(0, 0.45),
            open=(0.7, 1),
        ),
        "stool": _kind(
            aspect=(0.78, 1.3),
            rise=(0.85, 1.4),
            back=(0, 0.08, 0.4),
            arm=(0, 0.05),
            slim=(0, 0.35),
            open=(0.6, 1),
        ),
        "sofa": _kind(
            aspect=(1.9, 3.3),
            rise=(0.32, 0.68),
            back=(0.4, 1.0),
            arm=(0.15, 0.5, 0.9),
            slim=(0.18, 0.6, 0.7),
            open=(0, 0.65),
        ),
        "loveseat": _kind(
            aspect=(1.35, 1.75, 0.2),
            rise=(0.35, 0.7),
            back=(0.45, 1.0),
            arm=(0.15, 0.5, 0.8),
            slim=(0.18, 0.6, 0.7),
            open=(0, 0.65),
        ),
        "armchair": _kind(
            aspect=(0.78, 1.25),
            rise=(0.42, 0.8),
            back=(0.55, 1.2),
            arm=(0.15, 0.55, 0.5),
            slim=(0.15, 0.6, 0.6),
            open=(0, 0.7),
        ),
        "throne": _kind(
            aspect=(0.78, 1.3), rise=(0.6, 1.15), back=(2.0, 3.4), arm=(0.2, 0.6, 0.9), slim=(0, 0.6)
        ),
        "bench": _kind(
            aspect=(2.3, 4.4),
            rise=(0.75, 1.4),
            back=(0, 0.12, 0.8),
            arm=(0, 0.05, 0.8),
            slim=(0, 0.25),
            open=(0.6, 1),
        ),
        "lounge chair": _kind(
            aspect=(0.68, 1.15),
            rise=(0.34, 0.62),
            back=(0.6, 1.4),
            arm=(0, 0.06, 0.45),
            slim=(0, 0.35),
            open=(0.3, 1),
        ),
        "chaise longue": _kind(
            aspect=(0.28, 0.52), rise=(0.45, 0.85), back=(0.3, 1.0), arm=(0, 0.4), open=(0, 0.8)
        ),
        "ottoman": _kind(
            aspect=(0.75, 1.5),
            rise=(0.38, 0.8),
            back=(0, 0.05, 0.35),
            arm=(0, 0.04, 0.35),
            slim=(0.28, 0.9),
            open=(0, 0.5),
        ),
        "office chair": _kind(
            {"base": "star"},
            {"base": 1.6},
            aspect=(0.8, 1.25),
            rise=(0.75, 1.2),
            back=(0.85, 1.6),
            arm=(0, 0.5),
            slim=(0, 0.35),
            open=(0.6, 1),
        ),
    },
    "table": {
        "coffee table": _kind(aspect=(1.2, 2.4), rise=(0.32, 0.58), body=(0, 0.4)),
        "dining table": _kind(aspect=(1.45, 2.3), rise=(0.72, 0.98), body=(0, 0.28)),
        "desk": _kind(aspect=(1.75, 2.6), rise=(1.12, 1.45), body=(0, 0.95)),
        "console table": _kind(aspect=(2.9, 5.0), rise=(1.8, 3.0), body=(0, 0.35)),
        "side table": _kind(aspect=(1, 1.3, 0.25), rise=(1.05, 1.5), body=(0, 0.18, 0.2)),
        "nightstand": _kind(aspect=(1, 1.35, 0.25), rise=(0.9, 1.65), body=(0.32, 1.0)),
        "bar table": _kind(aspect=(1, 1.3, 0.25), rise=(1.85, 3.0), body=(0, 0.25)),
        "square table": _kind(
            {"round": False}, {"round": 1.5}, aspect=(1, 1.12, 0.2), rise=(0.55, 0.9), body=(0, 0.3)
        ),
        "round table": _kind(
            {"round": True}, {"round": 1.8}, aspect=(1, 1.15, 0.2), rise=(0.5, 0.9), body=(0, 0.3)
        ),
        "conference table": _kind(aspect=(2.8, 4.6), rise=(0.55, 1.0), body=(0, 0.35)),
        "sideboard": _kind(
            {"round": False}, {"round": 1.0}, aspect=(2.5, 4.5), rise=(1.5, 2.5), body=(0.6, 1.0)
        ),
        "chest of drawers": _kind(
            {"round": False}, {"round": 1.0}, aspect=(1.4, 2.1), rise=(1.5, 2.5), body=(0.7, 1.0)
        ),
    },
    "lamp": {
        "table lamp": _kind(
            {"jointed": False}, {"jointed": 0.4}, tall=(1.6, 3.1), shade=(0.42, 0.75), reach=(0, 0.06)
        ),
        "floor lamp": _kind(tall=(4.4, 7.5), shade=(0.14, 0.4), reach=(0, 0.2)),
        "desk lamp": _kind(tall=(1.7, 3.4), shade=(0.18, 0.4), reach=(0.15, 0.6)),
        "street lamp": _kind(tall=(9, 18), shade=(0.03, 0.12), reach=(0.02, 0.3, 0.6)),
        "mushroom lamp": _kind(
            {"jointed": False}, {"jointed": 0.6}, tall=(0.9, 2.0), shade=(0.85, 1.5), reach=(0, 0.06)
        ),
    },
    "aeroplane": {
        "airliner": _kind(
            {"engines": ("under", "under4", "rear")},
            {"engines": 0.8},
            span=(0.82, 1.12),
            slim=(0.09, 0.145),
            chords=(5.2, 10),
            sweep=(0.25, 0.75),
        ),
        "fighter jet": _kind(
            {"engines": ("none", "intakes")},
            {"engines": 0.35},
            span=(0.46, 0.78),
            slim=(0.065, 0.13),
            chords=(1.5, 3.6),
            sweep=(0.4, 1.3),
        ),
        "glider plane": _kind(
            {"engines": "none"},
            {"engines": 0.35},
            span=(1.7, 3.0),
            slim=(0.04, 0.11),
            chords=(13, 32),
            sweep=(-0.06, 0.16),
        ),
        "airship": _kind({"airship": True}, {"airship": 0.25}, span=(0.06, 0.42, 0.25), slim=(0.2, 0.42)),
        "propeller plane": _kind(
            {"engines": ("nose", "props")},
            {"engines": 0.8},
            span=(1.05, 1.55),
            slim=(0.1, 0.18),
            chords=(4.8, 9),
            sweep=(-0.06, 0.16),
        ),
        "biplane": _kind(
            {"biplane": True},
            {"biplane": 2.5},
            span=(0.95, 1.6),
            slim=(0.09, 0.18),
            chords=(4.5, 9),
            sweep=(-0.06, 0.2),
        ),
        "supersonic jet": _kind(
            {"engines": ("none", "intakes")},
            {"engines": 0.3},
            span=(0.34, 0.56),
            slim=(0.035, 0.066),
            chords=(0.9, 2.2),
            sweep=(0.9, 2.2),
        ),
        "missile": _kind({"engines": "none"}, {"engines": 0.4}, span=(0.1, 0.34), slim=(0.045, 0.1)),
    },
}
NAMES = [(family, kind) for family, kinds in KINDS.items() for kind in kinds]
FAMILY_WORDS = {"seat": "seat", "table": "table", "lamp": "lamp", "aeroplane": "aeroplane"}

LOOKALIKE = 0.7  # what a stool lacks to be a side table, and the reverse: the eye cannot tell, the maker can

# Attributes over a family: the proportion, where belonging is nil and where it is full (in that order).
ATTRIBUTES = {
    ("tall", "chair"): ("seat", "total", 1.3, 3.2),
    ("low", "chair"): ("seat", "rise", 0.95, 0.4),
    ("wide", "chair"): ("seat", "aspect", 0.9, 2.0),
    ("narrow", "chair"): ("seat", "aspect", 1.0, 0.5),
    ("tall", "table"): ("table", "rise", 0.7, 2.3),
    ("low", "table"): ("table", "rise", 0.95, 0.35),
    ("long", "table"): ("table", "aspect", 1.3, 3.5),
    ("tall", "lamp"): ("lamp", "tall", 2.2, 7.0),
    ("short", "lamp"): ("lamp", "tall", 3.0, 1.2),
    ("wide", "aeroplane"): ("aeroplane", "span", 0.9, 2.2),
    ("slender", "aeroplane"): ("aeroplane", "slim", 0.12, 0.045),
    ("fat", "aeroplane"): ("aeroplane", "slim", 0.11, 0.26),
}
CAPTIONS = [k for _, k in NAMES] + list(FAMILY_WORDS.values()) + [f"{a} {n}" for a, n in ATTRIBUTES]


def scale(name, value):
    """Where a proportion is compared: on a log axis, shifted if it may be zero; the sweep stays linear."""
    if name == "sweep":
        return value
    return np.log(value + (EPSILON if name in ZERO_BASED else 0.0))


def _trait_holds(have, want):
    return have in want if isinstance(want, tuple) else have == want


def distance(kind, measured, traits):
    """Squared distance, in sigmas, of measured proportions and traits to a kind's region: 0 inside."""
    total = sum(
        kind["price"][t] for t, want in kind["traits"].items() if not _trait_holds(traits.get(t, False), want)
    )
    for name, (low, high, *sigma) in kind["ranges"].items():
        x = scale(name, max(measured[name], 0.0) if name != "sweep" else measured[name])
        gap = (
            max(scale(name, low) - x, x - scale(name, high), 0.0)
            if low > 0 or name == "sweep"
            else max(x - scale(name, high), 0.0)
        )
        total += (gap / (sigma[0] if sigma else SIGMA)) ** 2
    return total


def _as_the_other(shape, m):
    """A backless seat measured as a table, and a table as a seat: (family, proportions, traits), or None."""
    if shape.family == "table":
        seat = {
            "aspect": m["aspect"],
            "rise": m["rise"],
            "back": 0.0,
            "arm": 0.0,
            "slim": m["body"] * m["rise"],
        }
        return "seat", {**seat, "open": 1 - m["body"]}, {"base": "legs"}
    if shape.family == "seat" and m["back"] < 0.06 and m["arm"] < 0.06:
        table = {
            "aspect": max(m["aspect"], 1 / m["aspect"]),
            "rise": m["rise"],
            "body": min(m["slim"] / m["rise"], 1.0),
        }
        return "table", table, {"round": shape.traits["round"]}
    return None


def truth(shape, measure):
    """One soft truth in [0, 1] for every caption, and the squared distances (in sigmas), from the shape's
    vertices.
    """
    measured, faults = measure(shape)
    fault = sum((f / 0.35) ** 2 for f in faults) + 3.0 * shape.damage
    gaps = np.full(len(CAPTIONS), 60.0)
    own = [i for i, (family, _) in enumerate(NAMES) if family == shape.family]
    twin = _as_the_other(shape, measured)
    for i, (family, name) in enumerate(NAMES):
        if family == shape.family:
            gaps[i] = distance(KINDS[family][name], measured, shape.traits) + fault
        elif twin and family == twin[0]:
            gaps[i] = distance(KINDS[family][name], twin[1], twin[2]) + fault + LOOKALIKE
    nearest = min(gaps[own])
    if shape.family == "aeroplane":
        nearest = min(gaps[i] for i in own if NAMES[i][1] not in ("airship", "missile"))
    gaps[len(NAMES) + list(FAMILY_WORDS).index(shape.family)] = max(fault, 0.25 * nearest)
    if shape.family == "seat":
        measured["total"] = measured["rise"] + measured["back"]
    for j, (family, name, nil, full) in enumerate(ATTRIBUTES.values()):
        if family == shape.family:
            x = (scale(name, measured[name]) - scale(name, nil)) / (scale(name, full) - scale(name, nil))
            lack = 2.2 * max(1 - x, 0.0) ** 2 + 1.5 * max(x - 1.8, 0.0) ** 2 + fault
            if family == "seat":
                lack += 2.0 * max(np.log(0.5 / (measured["back"] + 0.05)), 0.0) ** 2
            gaps[len(NAMES) + len(FAMILY_WORDS) + j] = lack
    return np.exp(-gaps), gaps


def draw(family, module, rng):
    """Parameters and traits of a random shape: near a kind, between two kinds, or anywhere in the family's
    ranges.
    """
    names = list(KINDS[family])
    choice = rng.random()
    p = _anywhere(module, rng)
    traits = {}
    if choice < 0.36:
        kind = KINDS[family][names[rng.integers(len(names))]]
        p.update(_inside(kind, rng))
        traits = _traits(kind, rng)
    elif choice < 0.8:
        a, b = (KINDS[family][names[i]] for i in rng.choice(len(names), 2, replace=False))
        t = rng.uniform(-0.15, 1.15)
        pa, pb = {**p, **_inside(a, rng)}, {**p, **_inside(b, rng)}
        p = {n: _between(n, pa[n], pb[n], t) for n in p}
        traits = _traits(a if rng.random() < 0.5 else b, rng)
    for name, (low, high) in module.RANGES.items():
        p[name] = float(np.clip(p[name], low, high))
    return p, traits


def _between(name, a, b, t):
    if name == "sweep":
        return a + (b - a) * t
    return np.exp(scale(name, a) + (scale(name, b) - scale(name, a)) * t) - (
        EPSILON if name in ZERO_BASED else 0.0
    )


def _anywhere(module, rng):
    return {n: _between(n, low, high, rng.random()) for n, (low, high) in module.RANGES.items()}


def _inside(kind, rng):
    return {n: _between(n, low, high, rng.uniform(0.0, 1.0)) for n, (low, high, *_) in kind["ranges"].items()}


def _traits(kind, rng):
    keep = rng.random() < 0.85

    def pick(want):
        return want[rng.integers(len(want))] if isinstance(want, tuple) else want

    return {t: pick(want) for t, want in kind["traits"].items()} if keep else {}
