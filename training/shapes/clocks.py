# SPDX-License-Identifier: MIT OR Apache-2.0
"""Clocks: a case with a dial, on a foot, a trunk or a post.

The front looks to -y; the unit is the width of the case (in a longcase that of its head).
"""

import numpy as np

from .axis import amount, outside, ratio
from .clock_cases import add_case, add_dial
from .clock_stands import add_foot, add_trunk, add_weights
from .clock_tops import add_bells, add_top
from .shape import Shape

# Trunk, foot and top are shares of the height; neck, spread, eave and dial are widths of trunk, foot, top
# and dial over that of the case.
RANGES = {
    "height": ratio(0.25, 12.0),
    "depth": ratio(0.04, 1.3),
    "dial": ratio(0.25, 1.0),
    "trunk": amount(0.0, 0.88),
    "neck": ratio(0.05, 1.2),
    "foot": amount(0.0, 0.3),
    "spread": ratio(0.25, 2.0),
    "top": amount(0.0, 0.5),
    "eave": ratio(0.2, 1.7),
}


def build(p, traits, rng):
    """A clock with the parameters of `RANGES` and the traits round, bells (drawn when missing)."""
    height, depth = p["height"], p["depth"]
    share = {
        n: p[n] if p[n] > limit else 0.0 for n, limit in (("trunk", 0.05), ("foot", 0.015), ("top", 0.04))
    }
    over = max(sum(share.values()) / 0.88, 1.0)
    foot, trunk, top = (share[n] / over * height for n in ("foot", "trunk", "top"))
    if p["neck"] < 0.35 and trunk > 0.5 * height and rng.random() < 0.7:
        # The head on a post is about as high as wide.
        trunk = np.clip(height - foot - top - rng.uniform(0.95, 1.2), 0.5 * height, 0.88 * height)
        trunk = min(trunk, height - foot - top - 0.1)
    low, high = foot + trunk, height - top
    square = 0.75 < high - low < 1.3
    bells = (
        top > 0.05 and not trunk and traits.get("bells", square and p["eave"] < 1.2 and rng.random() < 0.3)
    )
    post = trunk and p["neck"] < 0.35
    likely = 0.8 if post or depth < 0.2 else 0.45
    is_round = square and (bells or not top) and traits.get("round", bells or rng.random() < likely)
    shape = Shape("clocks", traits={"round": bool(is_round), "bells": bool(bells)})
    add_case(shape, rng, low, high, depth, is_round, top)
    add_dial(shape, rng, low, high, depth, p["dial"], is_round, both=post)
    if trunk:
        add_trunk(shape, rng, foot, low, depth, p["neck"])
    if foot:
        add_foot(shape, rng, foot, depth, p["spread"], trunk, p["neck"], is_round)
    if bells:
        add_bells(shape, rng, high, top, depth, p["eave"])
    elif top:
        add_top(shape, rng, high, top, depth, p["eave"], is_round)
    if rng.random() < (0.5 if p["eave"] > 1.15 and top > 0.2 * height else 0.1) and not (foot or trunk):
        add_weights(shape, rng, low, height)
    return shape


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    case, dial, foot = shape.points("case"), shape.points("dial"), shape.points("foot")
    trunk, top = shape.points("trunk"), shape.points("top", "bell")
    low, high = case.min(0), case.max(0)
    size = high - low
    width = size[0]
    floor = min(v[:, 2].min() for v in (case, foot, trunk) if v is not None)
    peak = high[2] if top is None else max(high[2], top[:, 2].max())
    height = peak - floor
    step = 0.0 if foot is None else max(min(foot[:, 2].max(), low[2]) - floor, 0.0)
    m = {
        "height": height / width,
        "depth": size[1] / width,
        "dial": 0.25 if dial is None else np.ptp(dial[:, 0]) / width,
        "trunk": 0.0 if trunk is None else max(low[2] - floor - step, 0.0) / height,
        "neck": 1.0 if trunk is None else np.ptp(trunk[:, 0]) / width,
        "foot": step / height,
        "spread": 1.0 if foot is None else np.ptp(foot[:, 0]) / width,
        "top": (peak - high[2]) / height,
        "eave": 1.0 if top is None else np.ptp(top[:, 0]) / width,
    }
    return m, _faults(shape, m, case, size)


def _faults(shape, m, case, size):
    """The faults of the build as log distances."""
    dial, foot, trunk, top = (shape.points(n) for n in ("dial", "foot", "trunk", "top"))
    round_case = shape.traits["round"]
    faults = [0.8 * outside(size[0] / size[2], 0.85, 1.18)] if round_case else []
    if dial is None:
        faults += [1.0]
    else:
        face = np.ptp(dial, 0)
        faults += [
            0.8 * outside(face[2] / size[2], 0.08, 1.0),
            0.8 * outside(m["dial"], 0.2, 1.02),
            # A dial in front, and just that.
            0.7 * outside(1 + (case[:, 1].min() - dial[:, 1].min()) / size[0], 0.99, 1.12),
        ]
        if not shape.traits["flat"]:
            faults += [outside(face[0] / face[2], 0.87, 1.15)]
    if foot is not None:
        deep = np.ptp(foot[:, 1])
        faults += [0.7 * outside(m["spread"], 0.25, 2.1)]
        faults += [0.7 * outside(deep / max(size[1], 0.3 * size[0]), 0.15, 9.0 if m["neck"] < 0.3 else 1.4)]
    if trunk is not None:
        post = np.ptp(trunk, 0)
        thin = m["neck"] < 0.35
        faults += [
            0.6 * outside(post[1] / max(size[1], 0.3 * size[0]), 0.1, 2.0 if thin else 1.3),
            0.7 * outside(m["neck"], 0.03, 1.3),
        ]
        faults += [0.6 * outside(post[0] / post[1], 0.6, 1.6 if thin else 8.0)]
    if top is not None:
        faults += [0.6 * outside(np.ptp(top[:, 1]) / size[1], 0.05, 1.6), 0.6 * outside(m["eave"], 0.15, 1.9)]
    bell = shape.points("bell")
    if bell is not None:
        faults += [
            0.7 * outside(m["eave"], 0.5, 1.4),
            0.7 * outside(np.ptp(bell[:, 2]) / size[2], 0.08, 0.75),
        ]
    return faults
