# SPDX-License-Identifier: MIT OR Apache-2.0
"""Aircraft, from airship to flying wing. The nose looks to -y; the unit is the length of the fuselage."""

import numpy as np

from .aeroplane_engines import add_body_engines, add_wing_engines
from .aeroplane_wings import add_tail, add_wings, wing_plan
from .axis import amount, outside, ratio, slope
from .fuselages import add_fuselage, add_hull
from .shape import Shape

# span: from tip to tip; slim: mean of the fuselage's width and height; chords: aspect ratio of the wings;
# sweep: of the leading edge (1 is 45 degrees); tail: span of the tailplane; fin: height of the fins.
RANGES = {
    "span": amount(0.06, 3.6),
    "slim": ratio(0.025, 0.55),
    "chords": ratio(0.8, 34.0),
    "sweep": slope(-0.1, 2.8),
    "tail": amount(0.0, 0.7),
    "fin": amount(0.0, 0.45),
}
MEASURED = {"perch": amount(0.0, 0.5)}  # how high the tailplane sits over the axis of the fuselage
ENGINES = ("none", "under", "under", "under4", "rear", "nose", "props", "props4", "intakes", "pusher")
TAILS = ("low", "low", "low", "tee", "twin", "vee")


def build(p, traits, rng):
    """An aircraft with the parameters of `RANGES`.

    The traits are engines, biplane, airship, level and fins (drawn when missing).
    """
    radius = max(p["slim"], 0.02) / 2
    fat = p["slim"] > 0.18 and p["span"] < 0.5
    facts = {
        "airship": traits.get("airship", fat and rng.random() < 0.6),
        "biplane": traits.get("biplane", rng.random() < 0.1 and p["sweep"] < 0.3 and p["span"] > 0.7),
        "level": traits.get("level", str(rng.choice(["low", "low", "mid", "high"]))),
    }
    facts["engines"] = "none" if facts["airship"] else traits.get("engines", str(rng.choice(ENGINES)))
    style = "cross" if facts["airship"] or p["span"] < 0.3 else traits.get("fins", str(rng.choice(TAILS)))
    facts["fins"] = style
    shape = Shape("aeroplanes", traits=facts)
    flying_wing = p["tail"] < 0.1 and p["fin"] < 0.1 and p["span"] > 1.2
    tail_up = 0.0 if facts["airship"] or p["sweep"] > 1 else rng.uniform(0, 0.6) * radius
    if facts["airship"]:
        add_hull(shape, rng, radius)
    else:
        add_fuselage(shape, rng, p, radius, tail_up, facts, flying_wing)
    w = wing_plan(rng, p, radius, facts, flying_wing)
    if w:
        add_wings(shape, rng, radius, w, facts["biplane"])
        add_wing_engines(shape, rng, facts["engines"], radius, w)
    if facts["engines"] in ("rear", "nose", "intakes", "pusher"):
        add_body_engines(shape, rng, facts["engines"], radius)
    if not flying_wing:
        add_tail(shape, rng, radius, p, style, tail_up)
    return shape


def measure(shape):
    """The proportions of `RANGES` and `MEASURED` read off the vertices, and the faults as log distances."""
    body = shape.parts[0].vertices
    size = np.ptp(body, 0)
    length, axis = size[1], (body[:, 2].max() + body[:, 2].min()) / 2
    wings, tail, fin = (shape.points(n) for n in ("wing", "tail", "fin"))
    reach = max(np.abs(wings[:, 0]).max() if wings is not None else 0.0, size[0] / 2)
    m = {"span": 2 * reach / length, "slim": np.sqrt(size[0] * size[2]) / length}
    m |= {"chords": 1.0, "sweep": 0.3, "tail": 0.0, "fin": 0.0, "perch": 0.0}
    flat = m["span"] > 1.2 and tail is None and fin is None
    faults = [0.8 * outside(size[0] / size[2], 0.7, 2.4 if flat else 1.45)]
    right = [p for p in shape.parts if p.label == "wing" and p.vertices[:, 0].mean() > 0]
    if right:
        found, wrong = _measure_wing(right[0], size, flat)
        m |= found
        faults += wrong
    if tail is not None:
        t = np.ptp(tail, 0)
        m |= {"tail": t[0] / length, "perch": max(tail[:, 2].mean() - axis - 0.3 * size[2], 0) / length}
        faults += [
            0.7 * outside(t[1] / length, 0.04, 0.3),
            0.7 * outside(t[0] / (2 * reach), 0.04, 0.75 if m["span"] > 0.5 else 2),
        ]
        faults += [0.6 * outside(t[2] / length, 0.002, 0.045 if shape.traits["fins"] != "vee" else 0.4)]
        if shape.traits["fins"] == "vee":
            m |= {"fin": t[2] / length, "perch": 0.0}
    if fin is not None:
        f = np.ptp(fin, 0)
        m["fin"] = f[2] / length
        faults += [0.7 * outside(f[1] / length, 0.05, 0.34), 0.7 * outside(f[1] / f[2], 0.3, 2.6)]
    faults += [0.35] if tail is None and fin is None and not flat else []
    return m, faults + _measure_pods(shape, size, reach)


def _measure_wing(part, body, flat):
    """Aspect ratio and sweep of the right wing, and its faults against the size of the fuselage."""
    v = part.vertices
    a, b, c = (v[part.faces[:, i]][:, :2] for i in range(3))
    u, w = b - a, c - a
    area = max(np.abs(u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]).sum() / 4, 1e-6)
    x, y = v[:, 0], v[:, 1]
    across = np.ptp(x)
    inner, outer = x < x.min() + 0.1 * across, x > x.max() - 0.1 * across
    chord, thick = np.ptp(y[inner]), np.ptp(v[inner, 2])
    found = {"chords": 2 * across**2 / area, "sweep": (y[outer].min() - y[inner].min()) / across}
    faults = [
        0.7 * outside(thick / chord, 0.025, 0.27),
        0.8 * outside(thick / body[2], 0.03, 1.0 if flat else 0.65),
        0.6 * outside(chord / body[1], 0.02, 1.05 if flat else 0.78),
        0.5 * outside(max((y[outer].max() - y[inner].min()) / body[1], 0.5), 0.1, 1.1),
    ]
    return found, faults


def _measure_pods(shape, body, reach):
    """Faults of engines, fairings and cabins: out of proportion, out of round or away from the aircraft."""
    faults = []
    for label, wide, high in (("root", 1.3, 0.75), ("cabin", 1.0, 0.95), ("intake", 2.2, 1.0)):
        v = shape.points(label)
        if v is not None:
            s = np.ptp(v, 0)
            faults += [0.6 * outside(s[0] / body[0], 0.1, wide), 0.8 * outside(s[2] / body[2], 0.1, high)]
            faults += [0.4 * outside(s[1] / body[1], 0.04, 0.75)]
    for p in shape.parts:
        s = np.ptp(p.vertices, 0)
        if p.label != "engine":
            continue
        middle = (p.vertices.max(0) + p.vertices.min(0)) / 2
        off = abs(middle[0]) / reach if p.parent == "wing" else abs(middle[0]) / (1.1 * body[0] + s[0] / 2)
        faults += [0.4 * outside(s[1] / s[0], 1.1, 5.5), 0.5 * outside(s[0] / s[2], 0.65, 1.55)]
        faults += [0.5 * outside(s[0] / body[0], 0.12, 0.72), 0.5 * outside(off, 0.05, 0.9)]
    return faults
