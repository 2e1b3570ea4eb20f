# SPDX-License-Identifier: MIT OR Apache-2.0
"""Rockets and what is shaped like them, upright on their tails, nose up.

The unit is the widest diameter of the body.
"""

import numpy as np

from .axis import amount, outside, ratio
from .shape import Shape
from .solids import block, cushion, lathe, slab

# slender: height over diameter; nose: its share of the height; stage: width of the upper body to the lower;
# fins: how far they reach beyond the body on both sides, in diameters; root: their share of the height;
# boosters: height of the rockets at the sides, of the whole; stick: length below the body, of its height.
RANGES = {
    "slender": ratio(0.6, 32.0),
    "nose": ratio(0.04, 0.97),
    "stage": ratio(0.3, 1.6),
    "fins": amount(0.0, 3.2),
    "root": amount(0.0, 0.6),
    "boosters": amount(0.0, 0.9),
    "stick": amount(0.0, 3.0),
}
TIP = 0.02  # radius of a sharp end


def build(p, traits, rng):
    """A rocket with the parameters of `RANGES`."""
    shape = Shape("rockets", traits=dict(traits))
    tall, stage = p["slender"], p["stage"]
    nose = p["nose"] * tall
    plain = p["nose"] > 0.7
    low = 0.5 if plain else 0.5 * min(1.0, 1 / stage)  # radii of the two stages
    high = 0.5 * min(1.0, stage)
    trunk = tall - nose
    with_fins = p["fins"] > 0.08 and p["root"] > 0.015 and not plain
    foot = 0.0
    nozzles = rng.random() < (0.5 if with_fins else 0.7) and (with_fins or (tall > 5 and p["boosters"] < 0.1))
    if nozzles:
        foot = min(0.04 * tall, 0.3) * rng.uniform(0.5, 1)
    cased = p["stage"] < 0.75 and tall < 7.5 and not with_fins  # a cartridge: mostly case
    split = foot + (trunk - foot) * (rng.uniform(0.72, 0.84) if cased else rng.uniform(0.4, 0.72))
    _trunk(shape, rng, p, low, high, foot, split, trunk)
    _nose(shape, rng, p, low if plain else high, trunk, nose)
    if nozzles:
        _nozzles(shape, rng, low, foot)
    if with_fins:
        _fins(shape, rng, p, low, foot)
    if p["boosters"] > 0.08:
        _boosters(shape, rng, p, low, foot)
    if p["stick"] > 0.08:
        r = rng.uniform(0.04, 0.09)
        y = rng.choice([0.0, low + r * 0.7])
        stick = block((-r, y - r, -p["stick"] * tall), (r, y + r, foot + (0.8 * split if y else 0.05 * tall)))
        shape.add("stick", stick, (0, y, foot + 0.05 * tall), "body")
    return shape


def _trunk(shape, rng, p, low, high, foot, split, trunk):
    """The lower stage, which is the root, and the upper one with the cone between."""
    sides = int(rng.choice([16, 20, 24]))
    z = np.linspace(0, 1, 6)
    stout = p["slender"] < 7 and p["fins"] > 0.25 and 0.8 < p["stage"] < 1.25
    if p["nose"] > 0.7:  # a capsule: only its shield lies below the cone
        edge = [(0.75 * low, 0), (0.93 * low, 0.3 * trunk), (low, trunk)]
        shape.add("body", lathe(edge, sides=sides))
        return
    belly = np.ones(6)
    if stout and rng.random() < 0.8:  # a cigar
        belly = 1 - (1 - rng.uniform(0.45, 0.8)) * (1 - z) ** rng.uniform(1.2, 2.2)
    elif rng.random() < 0.3:  # a boat tail, or the rim of a cartridge
        belly[0] = rng.uniform(0.75, 0.95)
    lower = [(low * b, foot + (split - foot) * t) for b, t in zip(belly, z, strict=True)]
    shape.add("body", lathe(lower, sides=sides))
    cone = min((trunk - split) * 0.4, abs(high - low) * rng.uniform(0.6, 2.0))
    upper = [(low, split), (high, split + cone), (high, (split + cone + trunk) / 2), (high, trunk)]
    shape.add("upper", lathe(upper, sides=sides), (0, 0, split), "body")
    if p["slender"] > 6 and rng.random() < 0.35:
        for t in rng.uniform(0.1, 0.95, int(rng.integers(1, 4))):
            at, half = foot + (split - foot) * t, 0.015 * (split - foot)
            band = lathe([(low * 1.06, at - half), (low * 1.06, at + half)], sides=sides)
            shape.add("trim", band, (0, 0, at), "body")
    elif stout and rng.random() < 0.6:  # a porthole
        at = (0, -0.93 * high, split + 0.4 * (trunk - split))
        r = min(0.18, 0.25 * (trunk - split))
        shape.add("trim", cushion(at, (r, 0.1, r), 2, 10, 5), (0, 0, at[2]), "upper")


def _nose(shape, rng, p, radius, base, length):
    style = "cone" if p["nose"] > 0.7 else rng.choice(["ogive", "ogive", "cone", "dome"])
    t = np.linspace(0, 1, 9)
    if style == "cone":
        blunt = rng.uniform(0.15, 0.45) if p["nose"] > 0.7 else rng.uniform(0.0, 0.2)
        profile = (1 - t) + blunt * t
        profile[-1] *= 0.75
    elif style == "dome":
        profile = np.sqrt(np.maximum(1 - t**2, 0))
    else:
        profile = 1 - t ** rng.uniform(1.5, 2.2)
    rings = [(max(radius * r, TIP), base + length * s) for r, s in zip(profile, t, strict=True)]
    if style == "cone" and p["slender"] > 6 and rng.random() < 0.4:  # a capsule with its escape tower on top
        thin = 0.16 * radius
        rings = [(radius, base), (radius * 0.55, base + 0.5 * length), (thin, base + 0.55 * length)]
        rings += [(thin, base + 0.95 * length), (TIP, base + length)]
    elif style != "cone" and p["nose"] < 0.35 and p["slender"] > 6 and rng.random() < 0.25:  # a wide fairing
        rings.insert(1, (radius * 1.0, base + 0.2 * length))
    above = shape.points("upper") is not None
    shape.add("nose", lathe(rings, sides=16), (0, 0, base), "upper" if above else "body")


def _nozzles(shape, rng, radius, height):
    def bell(x, y, r):
        profile = [(r, 0), (0.75 * r, 0.5 * height), (0.4 * r, 1.3 * height)]
        return lathe(profile, (x, y), 10)

    if rng.random() < 0.5:
        shape.add("nozzle", bell(0, 0, radius * rng.uniform(0.5, 0.85)), (0, 0, height), "body")
        return
    for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1), (0, 0)):
        shape.add("nozzle", bell(0.62 * radius * x, 0.62 * radius * y, 0.32 * radius), (0, 0, height), "body")


def _fins(shape, rng, p, radius, foot):
    """Three or four fins about the foot; two of four point to the sides, so that their reach is exact."""
    reach, root = p["fins"] / 2, p["root"] * p["slender"]
    count = 4 if rng.random() < 0.65 else 3
    thick = rng.uniform(0.02, 0.05) * (1.5 if p["slender"] < 6 else 1.0)
    style = rng.choice(["swept", "clipped", "triangle", "curved"])
    # The fin's plan from its root's top: (out 0-1, up 0-1).
    outlines = {
        "swept": [(0, 1), (1, 0.35), (1, -rng.uniform(0.1, 0.3)), (0, 0)],
        "clipped": [(0, 1), (1, 0.65), (1, 0.0), (0, 0)],
        "triangle": [(0, 1), (0.5, 0.5), (1, 0), (0, 0)],
        "curved": [(0, 1), (0.75, 0.6), (1, 0.1), (1, -0.2), (0.7, 0.0), (0, 0.3)],
    }
    plan = np.array(outlines[style])
    plan[:, 1] = (plan[:, 1] - plan[:, 1].min()) / np.ptp(plan[:, 1])
    base = foot * rng.uniform(0, 1) - (0.1 * root if p["slender"] < 6 and rng.random() < 0.5 else 0)
    for i in range(count):
        turn = 2 * np.pi * i / count + (0 if count == 4 else np.pi / 2)
        stretch = 1.0 if count == 4 else (radius + reach) / np.cos(np.pi / 6) - radius
        out = 0.45 * radius + plan[:, 0] * ((stretch if count == 3 else reach) + 0.55 * radius)
        v, f = slab(np.column_stack([out, base + plan[:, 1] * root]), -thick, thick)
        c, s = np.cos(turn), np.sin(turn)
        v = np.column_stack([v[:, 0] * c - v[:, 2] * s, v[:, 0] * s + v[:, 2] * c, v[:, 1]])
        shape.add("fin", (v, f), (0.8 * radius * c, 0.8 * radius * s, base + root / 2), "body")


def _boosters(shape, rng, p, low, foot):
    height = p["boosters"] * p["slender"]
    r = rng.uniform(0.2, 0.5) if rng.random() < 0.5 else low * rng.uniform(0.7, 1.0)
    r = min(r, height / 5)
    x = low + 0.92 * r
    cap = min(r * rng.uniform(1.2, 3.5), 0.4 * height)
    profile = [(r * 0.8, foot), (r, foot + 0.06 * height), (r, foot + height - cap)]
    profile += [(0.75 * r, foot + height - 0.5 * cap), (0.15 * r, foot + height)]
    at = (0.8 * low, 0, foot + 0.4 * height)
    shape.add_pair("booster", lathe(profile, (x, 0), 12), at, "body")
    if rng.random() < 0.4:
        v, f = lathe(profile, (x, 0), 12)
        for s in (1, -1):
            turned = np.column_stack([-s * v[:, 1], s * v[:, 0], v[:, 2]])
            shape.add("booster", (turned, f), (0, s * at[0], at[2]), "body")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    body, upper, nose = (shape.points(n) for n in ("body", "upper", "nose"))
    core = [v for v in (body, upper, nose, shape.points("nozzle")) if v is not None]
    core = np.concatenate(core)
    low, high = core.min(0), core.max(0)
    tall = high[2] - low[2]
    sizes = [np.ptp(v, 0) for v in (body, upper, nose) if v is not None]
    wide = max(np.sqrt(s[0] * s[1]) for s in sizes)
    cone = sizes[-1] if nose is not None else np.zeros(3)
    above = sizes[1] if upper is not None and len(sizes) > 2 else sizes[0]
    head = _width_on_top(upper) if upper is not None else sizes[0][0]
    m = {"slender": tall / wide, "nose": cone[2] / tall, "stage": head / sizes[0][0]}
    m |= {"fins": 0.0, "root": 0.0, "boosters": 0.0, "stick": 0.0}
    faults = [0.9 * outside(s[0] / s[1], 0.75, 1.33) for s in (sizes[0], above)]
    if nose is None:
        faults += [1.0]
    else:
        faults += [
            0.9 * outside(cone[0] / max(head, 1e-6), 0.8, 1.25),
            0.8 * outside(cone[0] / cone[1], 0.75, 1.33),
        ]
    fins, boosters, stick = (shape.points(n) for n in ("fin", "booster", "stick"))
    if fins is not None:
        size = np.ptp(fins, 0)
        m |= {"fins": max(size[0] - sizes[0][0], 0) / wide, "root": size[2] / tall}
        faults += [
            0.8 * outside(size[0] / size[1], 0.7, 1.45),
            0.6 * outside(size[2] / (size[0] - 0.5 * sizes[0][0]), 0.15, 14),
        ]
        faults += [0.7 * outside(size[0] / sizes[0][0], 1.02, 8)]
    if boosters is not None:
        each = [p.vertices for p in shape.parts if p.label == "booster"]
        size = np.ptp(each[0], 0)
        gap = (np.abs((each[0].max(0) + each[0].min(0))[:2] / 2).max() - size[0] / 2) / (sizes[0][0] / 2)
        m["boosters"] = size[2] / tall
        faults += [0.8 * outside(size[0] / size[1], 0.7, 1.43), 0.7 * outside(size[0] / wide, 0.12, 1.15)]
        faults += [0.7 * outside(gap, 0.6, 1.25), 0.7 * outside(size[2] / size[0], 2.2, 22)]
        faults += [0.5 * outside(1 + abs(each[0][:, 2].min() - low[2]) / tall, 1, 1.2)]
    if stick is not None:
        size = np.ptp(stick, 0)
        m["stick"] = max(low[2] - stick[:, 2].min(), 0) / tall
        faults += [
            0.7 * outside(np.sqrt(size[0] * size[1]) / wide, 0.03, 0.35),
            0.5 * outside(size[0] / size[1], 0.5, 2),
        ]
    return m, faults


def _width_on_top(v):
    """Width of the uppermost ring of an upper stage, in x."""
    z = v[:, 2]
    return np.ptp(v[z > z.max() - 0.02 * np.ptp(z), 0])
