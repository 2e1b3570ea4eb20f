# SPDX-License-Identifier: MIT OR Apache-2.0
"""Standing lamps: a foot, a stem or a jointed arm, a shade. The unit is the width of the foot."""

import numpy as np

from .seats import _outside
from .shape import Shape
from .solids import bar, block, cushion, lathe, outline, slab

RANGES = {
    "tall": (0.7, 22.0),
    "shade": (0.04, 1.7),
    "reach": (0.0, 0.8),
}


def build(p, traits, rng):
    """A lamp with the parameters of `RANGES` and the trait jointed (drawn when missing)."""
    height, shade, reach = p["tall"], p["shade"] * p["tall"], p["reach"] * p["tall"]
    jointed = traits.get("jointed", reach > 0.1 * height)
    shape = Shape("lamp", traits={"jointed": jointed})
    foot = min(rng.uniform(0.04, 0.16), 0.1 * height)
    _foot(shape, rng, foot)
    stem = rng.uniform(0.025, 0.06) * max(1.0, min(height / 4, 2.0))
    tilt = rng.choice([-1, 1])
    if reach < 0.04 * height:
        _straight(shape, rng, height, shade, foot, stem)
    else:
        _arm(shape, rng, height, shade, reach * tilt, foot, stem, jointed)
    if rng.random() < 0.5:
        turn = rng.choice([1, 2, 3])
        for part in shape.parts:
            c, s = np.cos(turn * np.pi / 2), np.sin(turn * np.pi / 2)
            spin = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
            part.vertices, part.attach = part.vertices @ spin, part.attach @ spin
    return shape


def _foot(shape, rng, foot):
    style = rng.choice(["disc", "disc", "square", "dome", "tripod"])
    if style == "square":
        shape.add("foot", block((-0.5, -0.5, 0), (0.5, 0.5, foot), rng.uniform(0, 0.3) * foot, 0.08))
    elif style == "dome":
        shape.add(
            "foot",
            lathe(
                [(0.5, 0), (0.5, foot * 0.3), (0.4, foot * 0.9), (0.15, foot * 1.5), (0.06, foot * 1.7)],
                sides=20,
            ),
        )
    elif style == "tripod":
        for i in range(3):
            a = i * 2 * np.pi / 3 + 0.5
            shape.add(
                "foot", bar((0, 0, foot * 2), (0.55 * np.cos(a), 0.55 * np.sin(a), 0.02), 0.03, sides=6)
            )
    else:
        shape.add("foot", slab(outline(20) * 0.5, 0, foot, rng.uniform(0, 0.4) * foot))


def _hood(shape, rng, at, width, tall, tilt, parent):
    style = rng.choice(["cone", "drum", "bell", "dome", "bulb"], p=[0.35, 0.2, 0.2, 0.15, 0.1])
    r, h = width / 2, tall
    if style == "cone":
        profile = [(r, 0), (r * 0.97, 0), (r * rng.uniform(0.3, 0.7), h)]
    elif style == "drum":
        profile = [(r, 0), (r, h)]
    elif style == "bell":
        profile = [(r, 0), (r * 0.75, h * 0.3), (r * 0.5, h * 0.65), (r * 0.3, h)]
    elif style == "dome":
        a = np.linspace(0, 0.48 * np.pi, 6)
        profile = [(r * np.cos(x), h * np.sin(x)) for x in a]
    else:
        a = np.linspace(-0.46 * np.pi, 0.46 * np.pi, 7)
        profile = [(r * np.cos(x), h / 2 + h / 2 * np.sin(x)) for x in a]
    v, f = lathe(profile, sides=18)
    if tilt:
        c, s = np.cos(tilt), np.sin(tilt)
        v = v @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    shape.add("shade", (v + at, f), at, parent)


def _straight(shape, rng, height, shade, foot, stem):
    tall = min(shade * rng.uniform(0.45, 0.95), 0.6 * height)
    low = height - tall
    top = low + 0.5 * tall
    style = "pole" if height > 4 or rng.random() < 0.35 else rng.choice(["vase", "ball", "column"])
    if style == "pole":
        solid = bar((0, 0, foot * 0.5), (0, 0, top), stem, sides=10)
    elif style == "column":
        solid = lathe([(0.3, foot), (0.22, low * 0.5), (0.2, low * 0.9), (stem, low * 0.92), (stem, top)])
    elif style == "ball":
        z = np.linspace(0, np.pi, 7)
        r = rng.uniform(0.25, 0.5)
        solid = lathe(
            [(max(r * np.sin(a), stem), foot + (low - foot) * 0.45 * (1 - np.cos(a))) for a in z]
            + [(stem, top)]
        )
    else:
        k = rng.uniform(0.2, 0.48, 5)
        z = np.linspace(foot, low * 0.92, 5)
        solid = lathe([*zip(k, z, strict=True), (stem, low * 0.95), (stem, top)])
    shape.add("stem", solid, (0, 0, foot), "foot")
    _hood(shape, rng, np.array([0, 0, low]), shade, tall, 0.0, "stem")


def _arm(shape, rng, height, shade, reach, foot, stem, jointed):
    tall = shade * rng.uniform(0.6, 1.3)
    head = np.array([0, reach, height - 0.6 * tall])
    at = (0, 0, foot)
    if jointed:
        bend = np.array(
            [
                0,
                -np.sign(reach) * rng.uniform(0, 0.35) * abs(reach) - reach * 0.1,
                height * rng.uniform(0.4, 0.75),
            ]
        )
        joint = stem * rng.uniform(1.2, 2.0)
        shape.add("stem", bar((0, 0, foot * 0.5), bend, stem, sides=8), at, "foot")
        shape.add("stem", cushion(bend, (joint, joint, joint), 2, 8, 5), at, "foot")
        shape.add("stem", bar(bend, head + np.array([0, 0, 0.6 * tall]), stem * 0.9, sides=8), at, "foot")
        if rng.random() < 0.4:
            side = np.array([stem * 2.2, 0, 0])
            shape.add(
                "stem", bar(side + np.array([0, 0, foot]), bend + side, stem * 0.5, sides=6), at, "foot"
            )
    else:
        low = height * rng.uniform(0.55, 0.85)
        shape.add("stem", bar((0, 0, foot * 0.5), (0, 0, low), stem, sides=10), at, "foot")
        bow = np.array([0, 0, 0.16 * height * rng.uniform(0.3, 1)])
        shape.add(
            "stem",
            bar((0, 0, low), head + np.array([0, 0, 0.6 * tall]), stem * 0.9, stem * 0.7, 8, bow, 7),
            at,
            "foot",
        )
    tilt = -np.sign(reach) * rng.choice([0.0, rng.uniform(-0.2, 1.0)])
    _hood(shape, rng, head, shade, tall, tilt, "stem")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults of the build as log distances
    (list).
    """
    foot, stem, shade = shape.points("foot"), shape.points("stem"), shape.points("shade")
    every = np.concatenate([p.vertices for p in shape.parts])
    base = np.ptp(foot, 0)
    width = base[:2].max()
    height = np.ptp(every[:, 2])
    m = {"tall": height / width}
    faults = [0.8 * _outside(base[2] / width, 0.015, 0.5), 0.7 * _outside(base[0] / base[1], 0.65, 1.55)]
    if shade is None or stem is None:
        m.update(shade=0.04, reach=0.0)
        return m, [*faults, 1.0]
    size = np.ptp(shade, 0)
    mid = (shade.min(0) + shade.max(0)) / 2
    center = (foot.min(0) + foot.max(0)) / 2
    m["shade"] = size[:2].mean() / height
    m["reach"] = np.linalg.norm((mid - center)[:2]) / height
    faults += [
        0.8 * _outside(size[0] / size[1], 0.6, 1.7),
        0.6 * _outside(size[2] / size[:2].mean(), 0.3, 2.2),
    ]
    faults += [
        0.7 * _outside(np.ptp(stem[:, 0]) / height, 0.008, 0.55 if not shape.traits["jointed"] else 1.2)
    ]
    return m, faults
