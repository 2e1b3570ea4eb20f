# SPDX-License-Identifier: MIT OR Apache-2.0
"""Buildings, from a shed to a skyscraper. The front looks to -y; the unit is the walls' shorter side.

`elong` is the walls' plan, long side over short; `rise` the height of the walls; `roof` what stands on them;
`overhang` the roof's plan over the walls'; `tower` what rises above the roof (tower, chimney, antenna) over
the height of the rest, and `girth` how thick that is.
"""

import numpy as np

from .axis import amount, outside, ratio
from .roofs import add_roof
from .shape import Shape
from .towers import SLIM, add_towers
from .walls import add_porch, add_walls

RANGES = {
    "elong": ratio(1.0, 5.0),
    "rise": ratio(0.18, 11.0),
    "roof": amount(0.03, 2.2),
    "overhang": ratio(0.4, 2.7),
    "tower": amount(0.0, 2.5),
    "girth": ratio(0.06, 0.7),
}
NO_GIRTH = 0.15  # what a building without any tower measures: neither thick nor thin
LEAST_TOWER = 0.03


def build(p, traits, rng):
    """A building with the parameters of `RANGES` and the traits round and towers (drawn when missing)."""
    elong, rise, roof, over = p["elong"], p["rise"], max(p["roof"], 0.03), p["overhang"]
    lonely = p["tower"] < LEAST_TOWER
    is_round = traits.get("round", (rise > 1.8 or over > 1.38) and rng.random() < 0.5)
    is_round = bool(is_round and elong < 1.25 and (lonely or p["girth"] < SLIM))
    towers = 0 if lonely else 1 if p["girth"] < SLIM else traits.get("towers", _tower_count(p, roof, rng))
    axis = 1 if rng.random() < (0.75 if towers and p["girth"] > SLIM else 0.4) else 0
    if towers == 2:
        axis = 1
    half = np.array([0.5, 0.5])
    half[axis] *= elong
    shape = Shape("buildings", traits={"round": is_round, "towers": towers})
    tank = rise > 0.9 and over > 1.45
    keep = towers == 4 or (elong < 1.22 and 1.7 < rise < 4.4 and roof > 0.16 and over > 0.9 and not tank)
    add_walls(shape, rng, half, rise, over, is_round, tank, keep)
    add_roof(shape, rng, half, rise, roof, over, axis, is_round, tank, keep)
    if towers:
        tall = (1 + p["tower"]) * (rise + roof)
        add_towers(shape, rng, half, rise, roof, tall, p["girth"] / 2, towers, axis)
    if not is_round and not tank and towers < 2 and rise < 1.3 and rng.random() < 0.35:
        add_porch(shape, rng, half, rise)
    return shape


def _tower_count(p, roof, rng):
    """How many towers suit the building: four at the corners of a flat one, two or one before a nave."""
    if roof < 0.3 and p["elong"] < 2 and rng.random() < 0.6:
        return 4
    return 2 if p["girth"] < 0.4 and rng.random() < 0.2 else 1


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    walls = shape.parts[0].vertices  # the first part is the walls bare of windows
    roof, porch, spire = shape.points("roof"), shape.points("porch"), shape.points("spire")
    towers = [p.vertices for p in shape.parts if p.label in ("tower", "chimney")]
    lo, hi = walls.min(0), walls.max(0)
    plan = np.maximum(hi[:2] - lo[:2], 1e-6)
    short, rise = plan.min(), hi[2] - lo[2]
    m = {"elong": plan.max() / short, "rise": rise / short, "roof": 0.0, "overhang": 1.0, "tower": 0.0}
    m["girth"] = NO_GIRTH
    faults, top = [], hi[2]
    if shape.traits["round"]:
        faults.append(outside(plan[0] / plan[1], 0.8, 1.25))
    if roof is None:
        faults.append(0.7)
    else:
        share = np.ptp(roof, 0)[:2] / plan
        middle = (roof.min(0) + roof.max(0) - lo - hi)[:2] / 2 / plan
        top = max(top, roof[:, 2].max())
        m["roof"] = max(roof[:, 2].max() - hi[2], 0.0) / short
        m["overhang"] = np.sqrt(share.prod())
        faults += [
            outside(share[0] / share[1], 0.8, 1.25),
            outside(m["overhang"], 0.38, 2.8),
            0.8 * outside(1 + abs(middle).max(), 0.9, 1.08),
            0.8 * outside(1 + (roof[:, 2].min() - hi[2]) / rise, 0.8, 1.05),
            0.7 * outside(m["roof"] / m["rise"], 0.003, 3.5),
        ]
    if towers:
        every = np.concatenate(towers + ([] if spire is None else [spire]))
        size = max((np.ptp(v, 0) for v in towers), key=lambda s: s[0] * s[1])
        middle = np.array([(v.min(0) + v.max(0) - lo - hi)[:2] / 2 / plan for v in towers])
        m["tower"] = max(every[:, 2].max() - top, 0.0) / (top - lo[2])
        m["girth"] = np.sqrt(size[0] * size[1]) / short
        faults += [
            0.9 * outside(size[0] / size[1], 0.75, 1.35),
            0.8 * outside(m["girth"], 0.05, 0.8),
            0.8 * outside(1 + abs(middle).max(), 0.9, 1.57),
            0.7 * outside((every[:, 2].min() - lo[2]) / (top - lo[2]) + 1, 0.9, 1.98),
            0.7 * outside((every[:, 2].max() - lo[2]) / (top - lo[2]), 0.9, 4.0),
        ]
        if spire is not None:
            tip = max((np.ptp(p.vertices, 0) for p in shape.parts if p.label == "spire"), key=lambda s: s[0])
            faults += [0.8 * outside(tip[a] / size[a], 0.85, 1.3) for a in (0, 1)]
    if porch is not None:
        size = np.ptp(porch, 0)
        faults += [0.7 * outside(size[2] / rise, 0.15, 1.05), 0.7 * outside(size[0] / plan[0], 0.1, 1.1)]
        faults.append(0.6 * outside(size[1] / plan[1], 0.02, 0.6))
    return m, faults
