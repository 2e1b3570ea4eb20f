# SPDX-License-Identifier: MIT OR Apache-2.0
"""Aircraft: from an airship to a delta jet. The nose looks to -y; the unit is the length of the fuselage."""

import numpy as np

from .seats import _outside
from .shape import Shape
from .solids import bar, block, cushion, lathe, loft, outline, wing

RANGES = {
    "span": (0.06, 3.4),
    "slim": (0.025, 0.45),
    "chords": (0.8, 34.0),
    "sweep": (-0.1, 2.2),
}
ENGINES = ("none", "under", "under", "under4", "rear", "nose", "props", "intakes")


def build(p, traits, rng):
    """An aircraft with the parameters of `RANGES` and the traits engines, biplane, blunt (missing ones are
    drawn).
    """
    span, radius = max(p["span"], 0.06), p["slim"] / 2
    engines = traits.get("engines", rng.choice(ENGINES))
    biplane = traits.get("biplane", rng.random() < 0.06)
    blunt = traits.get("blunt", rng.uniform(0.2, 1.0))
    shape = Shape(
        "aeroplane", traits={"engines": engines, "biplane": biplane, "airship": traits.get("airship", False)}
    )
    tail_up = rng.uniform(0, 0.7) * radius
    _fuselage(shape, rng, radius, blunt, tail_up, traits.get("airship", False))
    mean_chord = min(span / p["chords"], 0.75)
    taper = traits.get("taper", rng.uniform(0.12, 1.0) if p["sweep"] > 0.15 else rng.uniform(0.45, 1.0))
    root_chord = 2 * mean_chord / (1 + taper)
    tip_chord = root_chord * taper
    half = span / 2
    # The sweep is that of the quarter-to-mid chord line, so that it can be read off the vertices.
    lead_sweep = p["sweep"] * half + (root_chord - tip_chord) / 2
    middle = rng.uniform(-0.1, 0.08) if p["sweep"] < 0.7 else rng.uniform(0.02, 0.15)
    lead = middle - root_chord / 2 - 0.25 * p["sweep"] * half
    lead = np.clip(lead, -0.4, 0.47 - root_chord)
    height = rng.choice([-0.7, -0.5, 0.0, 0.6, 0.85]) * radius
    dihedral = half * rng.choice([0.0, rng.uniform(-0.05, 0.12)])
    thickness = rng.uniform(0.06, 0.15) if p["chords"] > 3 else rng.uniform(0.025, 0.08)
    if half > radius * 1.05:
        _wings(
            shape,
            rng,
            radius,
            half,
            lead,
            lead_sweep,
            root_chord,
            tip_chord,
            height,
            dihedral,
            thickness,
            biplane,
        )
    _tail(shape, rng, radius, span, p, tail_up, traits.get("airship", False))
    _engines(shape, rng, engines, radius, half, lead, lead_sweep, root_chord, height, dihedral)
    if rng.random() < 0.12 and engines in ("nose", "none"):
        for x in (-1, 0, 1):
            at = np.array([x * (radius + 0.04), -0.15 if x else -0.36, -radius - 0.07])
            shape.add("gear", cushion(at, (0.012, 0.03, 0.03), 2, 8, 5), (at[0], at[1], -radius), "fuselage")
            shape.add(
                "gear",
                bar(at, (x * radius * 0.5, at[1], -radius * 0.7), 0.006),
                (at[0], at[1], -radius),
                "fuselage",
            )
    return shape


def _fuselage(shape, rng, radius, blunt, tail_up, airship):
    n = 17
    t = np.linspace(0, 1, n)
    if airship:
        e = rng.uniform(0.5, 0.75)
        profile = (4 * t * (1 - t)) ** e * (1 + rng.uniform(0, 0.25) * (0.5 - t))
        z = np.zeros(n)
    else:
        nose, tail = 0.06 + 0.3 * (1 - blunt) * rng.uniform(0.6, 1), rng.uniform(0.2, 0.6)
        e = 0.5 + 0.45 * (1 - blunt)
        profile = np.minimum(np.clip(t / nose, 0, 1) ** e, 1)
        end = rng.uniform(0.08, 0.5)
        k = np.clip((t - (1 - tail)) / tail, 0, 1)
        profile *= 1 - (1 - end) * k ** rng.uniform(1.2, 2.2)
        z = tail_up * k**1.5 - 0.25 * radius * (1 - np.clip(t / nose, 0, 1)) * rng.uniform(0, 1)
    profile = np.maximum(profile, 0.04)
    ring = outline(14, rng.choice([2, 2, 2, 2.6, 3.5]), 0.1) * (
        1.0,
        rng.choice([1.0, rng.uniform(0.85, 1.25)]),
    )
    rings = [
        np.column_stack([ring[:, 0] * radius * r, np.full(14, y - 0.5), ring[:, 1] * radius * r + h])
        for r, y, h in zip(profile, t, z, strict=False)
    ]
    shape.add("fuselage", loft(rings))
    if airship:
        size = np.array([0.25 * radius, rng.uniform(0.06, 0.14), 0.2 * radius])
        at = np.array([0, rng.uniform(-0.2, 0), -radius * 1.08])
        shape.add("cabin", block(at - size, at + size, 0.1 * radius), at, "fuselage")
    elif rng.random() < 0.4:
        y = rng.uniform(-0.36, -0.12)
        shape.add(
            "cabin",
            cushion(
                (0, y, radius * 0.75), (radius * 0.55, rng.uniform(0.06, 0.13), radius * 0.6), 2.2, 10, 6
            ),
            (0, y, radius * 0.7),
            "fuselage",
        )


def _wings(
    shape, rng, radius, half, lead, sweep, root_chord, tip_chord, height, dihedral, thickness, biplane
):
    inner = min(0.3 * radius, 0.3 * half)
    share = (half - inner) / half
    levels = [height]
    if biplane:
        gap = rng.uniform(1.3, 2.4) * max(radius, 0.3 * root_chord)
        levels = [-0.6 * radius, -0.6 * radius + gap]
    curve = rng.choice([1.0, 1.0, rng.uniform(0.7, 1.6)])
    for z in levels:
        low = inner if not (biplane and z == levels[1]) else 0.0
        root = (low, lead + sweep * low / half, z)
        tip = (half, lead + sweep, z + dihedral)
        solid = wing(root, tip, root_chord, tip_chord, thickness, 6, curve=curve)
        shape.add_pair("wing", solid, (radius * 0.8, lead + root_chord / 2, z), "fuselage")
        if not biplane and rng.random() < 0.2:
            top = (half * 1.02, lead + sweep + tip_chord * 0.5, z + dihedral + 0.12 * half * share)
            fin = wing(
                (half, lead + sweep, z + dihedral),
                top,
                tip_chord,
                tip_chord * 0.4,
                thickness,
                3,
                vertical=True,
            )
            shape.add_pair("wing", fin, (radius * 0.8, lead + root_chord / 2, z), "fuselage")
    if biplane:
        for x in (0.35, 0.75):
            for y in (0.2, 0.75):
                at = lead + sweep * x + root_chord * y
                shape.add_pair(
                    "wing",
                    bar((x * half, at, levels[0]), (x * half, at, levels[1] + dihedral * x), 0.007),
                    (radius * 0.8, lead + root_chord / 2, 0),
                    "fuselage",
                )


def _tail(shape, rng, radius, span, p, tail_up, airship):
    style = rng.choice(
        ["low", "low", "low", "tee", "twin", "vee", "none"], p=[0.32, 0.2, 0.12, 0.14, 0.12, 0.05, 0.05]
    )
    if airship:
        reach, chord = radius * rng.uniform(1.0, 1.5), rng.uniform(0.1, 0.2)
        turn = rng.choice([0, np.pi / 4]) if rng.random() < 0.3 else 0
        y = 0.46 - chord
        for i in range(4):
            a = turn + i * np.pi / 2
            solid = wing((0.3 * radius, y, 0), (reach, y + chord * 0.4, 0), chord, chord * 0.6, 0.08, 3)
            c, s = np.cos(a), np.sin(a)
            v = solid[0] @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
            shape.add("tail", (v, solid[1]), (0, y + chord / 2, 0), "fuselage")
        return
    size = float(np.clip(rng.uniform(0.26, 0.42) * np.sqrt(max(span, 0.3)), 0.12, 0.45))
    chord = rng.uniform(0.09, 0.17) * (1.3 if p["sweep"] > 0.6 else 1.0)
    back = size / 2 * (p["sweep"] * rng.uniform(0.6, 1.2) + rng.uniform(0, 0.3))
    y = min(0.48 - chord - rng.uniform(0, 0.04), 0.44)
    z = tail_up * 0.8
    fin = rng.uniform(0.1, 0.2) + radius * 0.5
    lean = rng.uniform(0.2, 0.9) * fin + 0.15 * back
    at = (0, y + chord / 2, z)
    if style in ("low", "tee"):
        shape.add(
            "tail",
            wing(
                (0, y - 0.02, z),
                (0, y - 0.02 + lean, z + fin),
                chord * 1.25,
                chord * 0.7,
                0.09,
                4,
                vertical=True,
            ),
            at,
            "fuselage",
        )
    if style in ("low", "twin"):
        shape.add_pair(
            "tail",
            wing((0, y, z), (size / 2, y + back, z), chord, chord * rng.uniform(0.4, 0.9), 0.09, 4),
            at,
            "fuselage",
        )
    if style == "tee":
        h = z + fin * 0.97
        y2 = y - 0.02 + lean
        shape.add_pair(
            "tail",
            wing((0, y2, h), (size / 2, y2 + back * 0.6, h), chord * 0.8, chord * 0.5, 0.09, 4),
            at,
            "fuselage",
        )
    if style == "twin":
        x = rng.choice([radius * 0.8, size / 2])
        shape.add_pair(
            "tail",
            wing((x, y, z), (x * 1.15, y + lean, z + fin * 0.9), chord, chord * 0.6, 0.08, 4, vertical=True),
            at,
            "fuselage",
        )
    if style == "vee":
        shape.add_pair(
            "tail",
            wing((0, y, z), (size * 0.35, y + lean, z + size * 0.4), chord, chord * 0.6, 0.1, 4),
            at,
            "fuselage",
        )


def _engines(shape, rng, engines, radius, half, lead, sweep, root_chord, height, dihedral):
    r = float(np.clip(rng.uniform(0.35, 0.6) * radius, 0.018, 0.05))
    length = r * rng.uniform(2.6, 4.6)
    pod = [(r * 0.8, 0), (r, 0.15 * length), (r, 0.55 * length), (r * 0.55, length)]
    if engines in ("under", "under4", "props"):
        places = (0.3, 0.6) if engines == "under4" else (rng.uniform(0.28, 0.42),)
        for s in places:
            x = s * half
            if x < radius * 1.2:
                continue
            y = lead + sweep * s - length * rng.uniform(0.3, 0.7)
            z = height + dihedral * s - (r * 1.2 if engines != "props" else 0)
            v, f = lathe(pod, sides=12)
            v = np.column_stack([v[:, 0] + x, v[:, 2] + y, v[:, 1] + z])
            label = "engine" if rng.random() < 0.7 else "wing"
            at, parent = (
                ((x, y + length / 2, z + r), "wing")
                if label == "engine"
                else ((radius * 0.8, lead + root_chord / 2, height), "fuselage")
            )
            shape.add_pair(label, (v, f[:, ::-1]), at, parent)
            if engines == "props":
                _propeller(shape, rng, (x, y, z), r * 3, label, at, parent, True)
    elif engines == "rear":
        y, x = rng.uniform(0.2, 0.3), radius * 0.95 + r
        v, f = lathe(pod, sides=12)
        v = np.column_stack([v[:, 0] + x, v[:, 2] + y, v[:, 1] + radius * 0.35])
        shape.add_pair("engine", (v, f[:, ::-1]), (radius * 0.8, y + length / 2, radius * 0.3), "fuselage")
    elif engines == "nose":
        _propeller(
            shape, rng, (0, -0.5, 0), rng.uniform(0.1, 0.17), "engine", (0, -0.48, 0), "fuselage", False
        )
    elif engines == "intakes":
        w = radius * rng.uniform(0.35, 0.6)
        y0, y1 = rng.uniform(-0.22, -0.05), rng.uniform(0.3, 0.5)
        low, high = (radius * 0.6, y0, -w), (radius * 0.75 + w, y1, w * 0.8)
        shape.add_pair("fuselage", block(low, high, 0.15 * w), (0, 0, 0), None)


def _propeller(shape, rng, center, reach, label, at, parent, pair):
    put = shape.add_pair if pair else shape.add
    center = np.asarray(center)
    put(label, cushion(center, (0.016, 0.03, 0.016), 2, 8, 5), at, parent)
    turn, count = rng.uniform(0, np.pi), int(rng.choice([2, 3, 4]))
    for i in range(count):
        a = turn + 2 * np.pi * i / count
        tip = center + reach * np.array([np.cos(a), 0, np.sin(a)])
        put(label, bar(center, tip, (0.012, 0.012), (0.006, 0.006)), at, parent)


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults of the build as log distances
    (list).
    """
    body = shape.points("fuselage")
    size = np.ptp(body, 0)
    length = size[1]
    wings = [p for p in shape.parts if p.label == "wing"]
    reach = max(
        [np.abs(p.vertices[:, 0]).max() for p in wings] + [np.abs(shape.points("fuselage")[:, 0]).max()]
    )
    m = {"span": 2 * reach / length, "slim": np.sqrt(size[0] * size[2]) / length}
    faults = [0.8 * _outside(size[0] / size[2], 0.65, 1.55)]
    right = [p for p in wings if p.vertices[:, 0].mean() > 0 and np.ptp(p.vertices[:, 0]) > 0.5 * reach]
    if right:
        p = right[0]
        a, b, c = (p.vertices[p.faces[:, i]][:, :2] for i in range(3))
        area = np.abs(np.cross(np.c_[b - a, 0 * b[:, :1]], np.c_[c - a, 0 * a[:, :1]])[:, 2]).sum() / 4
        x, y = p.vertices[:, 0], p.vertices[:, 1]
        inner, outer = x < x.min() + 0.12 * np.ptp(x), x > x.max() - 0.12 * np.ptp(x)

        def mid(k):
            return (y[k].min() + y[k].max()) / 2

        m["chords"] = np.ptp(x) ** 2 / max(area, 1e-6) * 2
        m["sweep"] = (mid(outer) - mid(inner)) / np.ptp(x)
        thick = np.ptp(p.vertices[inner, 2]) / np.ptp(y[inner])
        faults += [0.7 * _outside(thick, 0.03, 0.3), 0.5 * _outside(np.ptp(y[inner]) / length, 0.02, 0.75)]
    else:
        m["chords"], m["sweep"] = 1.0, 0.3
    tail = shape.points("tail")
    if tail is not None:
        t = np.ptp(tail, 0)
        faults += [0.6 * _outside(t[0] / length, 0.12, 0.75), 0.7 * _outside(t[2] / length, 0.08, 0.6)]
        faults += [0.7 * _outside(t[1] / length, 0.06, 0.35)]
        faults += [
            0.7 * _outside(t[0] / max(2 * reach, size[0]), 0.05, 1.2 if right and reach > size[0] else 3)
        ]
    else:
        faults += [0.35]
    for e in (p.vertices for p in shape.parts if p.label == "engine"):
        s = np.ptp(e, 0)
        if s[1] > 0.06 * length:
            faults += [
                0.4 * _outside(s[1] / s[0], 1.3, 6.0),
                0.4 * _outside(s[0] / s[2], 0.55, 1.8),
                0.5 * _outside(s[0] / size[0], 0.1, 0.9),
            ]
    return m, faults
