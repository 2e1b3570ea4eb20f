# SPDX-License-Identifier: MIT OR Apache-2.0
"""Standing lamps: a foot, a stem or an arm, a shade, perhaps a cap. The unit is the width of the foot."""

import numpy as np

from .axis import amount, outside, ratio
from .lampshades import add_cap, lampshade
from .shape import Shape
from .solids import bar, block, cushion, fit, lathe, outline, slab, tube

# All but the first and the last are shares of the whole height: the shade's width and height, how far it
# stands out from the stem, the foot's height, the stem's thickness. `oval` is the shade's long side over
# its short one.
RANGES = {
    "height": ratio(0.7, 22.0),
    "shade": ratio(0.03, 1.7),
    "hood": ratio(0.02, 0.95),
    "reach": amount(0.0, 1.0),
    "foot": ratio(0.008, 0.8),
    "stem": ratio(0.01, 0.35),
    "oval": ratio(1.0, 4.0),
}


def build(p, traits, rng):
    """A lamp with the parameters of `RANGES` and the traits jointed, up, cap, ball (drawn when missing)."""
    h = p["height"]
    shade = np.clip(p["shade"] * h, 0.2, 4.5)
    hood = min(p["hood"] * h, 6 * shade)
    reach = p["reach"] * h if p["reach"] > 0.06 else 0.0
    foot = min(p["foot"] * h, 2.2, max(0.97 * h - hood, 0.03 * h))
    stem = min(p["stem"] * h, 0.85, 0.85 * shade)
    jointed = traits.get("jointed", p["reach"] > 0.1 and rng.random() < 0.6)
    up = traits.get("up", not reach and h > 3 and hood < 0.6 * shade and rng.random() < 0.4)
    up = up and not reach
    big = hood > 0.42 * h and not (reach or up)
    cap = not (reach or up) and traits.get(
        "cap", big and "ball" not in traits and shade < min(0.62 * h, hood) and rng.random() < 0.4
    )
    ball = big and not cap and traits.get("ball", 0.7 < hood / shade < 1.4 and rng.random() < 0.7)
    if big and 0.15 * h < foot < 0.36 * h and foot + hood > 0.68 * h:
        cap, ball = True, False
    flags = {"jointed": jointed, "up": up, "cap": cap, "ball": ball}
    shape = Shape("lamps", traits={t: bool(v) for t, v in flags.items()})
    _foot(shape, rng, h, foot, shade, cap)
    width = shade * 2 / (1 + 1 / p["oval"])
    size = np.array([width, width / p["oval"], hood])
    if reach:
        _arm(shape, rng, h, size, reach * rng.choice([-1, 1]), foot, stem, jointed)
    else:
        _straight(shape, rng, h, size, foot, stem, shape.traits)
    if rng.random() < 0.5:
        _turn(shape, rng.choice([1, 2, 3]) * np.pi / 2)
    return shape


def _turn(shape, angle):
    """Turn the whole about z, in place."""
    c, s = np.cos(angle), np.sin(angle)
    spin = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    for part in shape.parts:
        part.vertices, part.attach = part.vertices @ spin, part.attach @ spin


def _foot(shape, rng, h, foot, shade, cap):
    """A plate, a dome, a star of bars, a block as high as a vase, or a tripod."""
    if foot > 0.35 * h:
        _tripod(shape, rng, foot)
        return
    if foot > 0.15 * h:
        waist = np.clip(0.42 * shade, 0.15, 0.46)
        profile = [(0.5, 0), (0.48, foot * 0.06), (waist, foot * 0.9), (waist * 1.1, foot)]
        shape.add("foot", lathe(profile, sides=20))
        return
    style = rng.choice(["disc", "disc", "square", "dome", "star"][: 3 if cap else 5])
    if style == "square":
        shape.add("foot", block((-0.5, -0.5, 0), (0.5, 0.5, foot), rng.uniform(0, 0.3) * foot, 0.08))
    elif style == "dome":
        profile = [(0.5, 0), (0.5, 0.2), (0.4, 0.55), (0.15, 0.9), (0.06, 1.0)]
        shape.add("foot", lathe([(r, foot * z) for r, z in profile], sides=20))
    elif style == "star":
        count = int(rng.choice([3, 4]))
        rings = [bar((0, 0, 0.8), (*_around(i, count), 0.1), 0.06, sides=6) for i in range(count)]
        _legs(shape, rings, foot)
    else:
        shape.add("foot", slab(outline(20) * 0.5, 0, foot, rng.uniform(0, 0.4) * foot))


def _around(i, count):
    """The place of leg `i` of `count` on a unit circle."""
    a = i * 2 * np.pi / count + np.pi / 2
    return np.cos(a), np.sin(a)


def _legs(shape, solids, foot):
    """Legs as parts of the foot, together one unit wide and `foot` high."""
    every = np.concatenate([v for v, _ in solids])
    low, size = every.min(0), np.ptp(every, 0)
    scale = np.array([1 / size[:2].max()] * 2 + [foot / size[2]])
    for v, f in solids:
        shape.add("foot", ((v - (0, 0, low[2])) * scale, f))


def _tripod(shape, rng, foot):
    """Legs that run up to a hub, perhaps with a shelf between them."""
    count = int(rng.choice([3, 3, 3, 4]))
    thick, top = rng.uniform(0.02, 0.055), rng.uniform(0.05, 0.14)
    solids, past = [], rng.choice([0.0, 0.0, 0.25])
    for i in range(count):
        c, s = _around(i, count)
        # Legs may cross below the shade and go on to the other side.
        end = (-past * 0.4 * c, -past * 0.4 * s, foot) if past else (top * c, top * s, foot)
        solids.append(bar((0.5 * c, 0.5 * s, 0), end, thick * rng.choice([0.6, 1]), thick, 6))
    solids.append(slab(outline(12) * (top + thick), 0.97 * foot - 0.05, foot))
    if rng.random() < 0.3:
        z, r = foot * rng.uniform(0.3, 0.5), 0.3
        solids.append(slab(outline(12) * r, z, z + 0.03))
    _legs(shape, solids, foot)


def _straight(shape, rng, h, size, foot, stem, traits):
    """A stem under a shade; a lantern's shade has a cap over it."""
    up, cap = traits["up"], traits["cap"]
    lid = min(rng.uniform(0.1, 0.35) * size[2], 0.2 * h) if cap else 0.0
    ring = min(rng.choice([0.0, rng.uniform(0.3, 0.8)]) * size[:2].mean(), 0.25 * h) if lid else 0.0
    if size[2] + foot + lid + ring > 0.99 * h:
        ring = 0.0
        lid *= 0.5
    if cap and 0.15 * h < foot:
        # A lava lamp: no gap between the foot, the glass and the lid.
        ring, lid = 0.0, max(h - foot - size[2], 0.03 * h)
    size[2] = min(size[2], h - foot - lid - ring)
    low = h - size[2] - lid - ring
    reach = low + size[2] * (0.1 if up else 0.5)
    shape.add("stem", _post(rng, foot, low, reach, stem), (0, 0, foot), "foot")
    solid = lampshade(rng, size, up=up, cap=cap, ball=traits["ball"], dome=size[0] > 0.85 * h)
    at = np.array([0, 0, low])
    shape.add("shade", (solid[0] + at, solid[1]), at, "stem")
    if lid:
        add_cap(shape, rng, size, low + size[2], lid, ring)


def _post(rng, foot, low, top, stem):
    """The stem from the foot into the shade, `stem` wide at its widest."""
    r, thin = stem / 2, min(stem / 2, 0.03)
    foot = min(foot, low)
    rise = max(low - foot, 0.02 * low)
    if stem < 0.06 * top or rng.random() < 0.12 or rise < 0.1 * top:
        z = [foot * 0.5, foot + rise * rng.uniform(0.2, 0.6), top]
        knob = rng.choice([1.0, rng.uniform(0.5, 0.9)])
        solid = lathe([(r, z[0]), (r, z[1]), (r * knob, z[1]), (r * knob, z[2])], sides=10)
    else:
        style = rng.choice(["column", "ball", "vase", "balls"])
        t = np.linspace(0, 1, 9)
        if style == "column":
            k = np.interp(t, [0, 0.1, 0.9, 1], [1, rng.uniform(0.6, 1), rng.uniform(0.5, 1), 0.5])
        elif style == "ball":
            k = np.maximum(np.sin(np.pi * t), 0.15)
        elif style == "balls":
            t = np.linspace(0, 1, 17)
            k = 0.35 + 0.65 * np.abs(np.sin(np.pi * t * rng.choice([2, 3])))
        else:
            k = np.interp(t, np.linspace(0, 1, 5), rng.uniform(0.4, 1, 5))
        k = r * k / k.max()
        solid = lathe([*zip(k, foot + t * 0.93 * rise, strict=True), (thin, foot + rise), (thin, top)])
    w = np.array([r, r])
    return fit(solid, [*-w, solid[0][:, 2].min()], [*w, top])


def _arm(shape, rng, h, size, reach, foot, stem, jointed):
    """A stem that carries its shade aside: jointed, or bent to a crook or an arc."""
    r, at, side = stem / 2 / 0.924, (0, 0, foot), np.sign(reach)
    if jointed:
        bend = np.array([0, -side * rng.uniform(0, 0.3) * min(abs(reach), 0.4 * h) - reach * 0.1, 0.0])
        bend[2] = h * rng.uniform(0.45, 0.85)
        end = np.array([0, reach, h * rng.choice([1.0, rng.uniform(0.7, 1.0)])])
        joint = r * rng.uniform(1.2, 2.0)
        solids = [bar((0, 0, foot * 0.5), bend, r, sides=8), cushion(bend, (joint,) * 3, 2, 8, 5)]
        solids.append(bar(bend, end, r * 0.9, sides=8))
        if rng.random() < 0.4:
            aside = np.array([stem * 1.2, 0, 0])
            solids.append(bar(aside + np.array(at), bend + aside, r * 0.5, sides=6))
    else:
        # A quarter of an ellipse up, then over: a crook when the reach is small, an arc when it is big.
        drop = rng.choice([0.0, rng.uniform(0.05, 0.3)])
        rise = rng.uniform(0.5, 0.85) if abs(reach) < 0.35 * h else rng.uniform(0.05, 0.4)
        a = np.linspace(0, np.pi * (0.5 + drop), 10)
        far = reach / (1 - np.cos(a[-1]))
        path = np.column_stack([0 * a, far * (1 - np.cos(a)), h * (rise + (1 - rise) * np.sin(a))])
        end = path[-1]
        path = np.concatenate([[[0, 0, 0.5 * foot]], path])
        solids = [tube(path, r * np.linspace(1, rng.uniform(0.6, 1), len(path)), 8)]
    low, top = foot * 0.5, max(v[:, 2].max() for v, _ in solids)
    stretch = (h - low) / (top - low)
    for v, f in solids:
        v[:, 2] = low + (v[:, 2] - low) * stretch
        shape.add("stem", (v, f), at, "foot")
    end[2] = min(low + (end[2] - low) * stretch, h)
    size[2] = min(size[2], 0.8 * end[2])
    tilt = -side * rng.choice([0.0, rng.uniform(-0.2, 1.0)])
    solid = lampshade(rng, size, tilt)
    shape.add("shade", (solid[0] + end - (0, 0, 0.97 * size[2]), solid[1]), end, "stem")


def measure(shape):
    """The proportions of `RANGES` read off the vertices, and the faults as log distances."""
    foot, shade = shape.points("foot"), shape.points("shade")
    stem = next((p.vertices for p in shape.parts if p.label == "stem"), None)
    every = np.concatenate([p.vertices for p in shape.parts])
    base = np.ptp(foot, 0)
    width, height = base[:2].max(), np.ptp(every[:, 2])
    m = {"height": height / width, "foot": base[2] / height}
    faults = [0.8 * outside(base[2] / width, 0.008, 2.6), 0.8 * outside(base[0] / base[1], 0.75, 1.33)]
    if shade is None or stem is None:
        m.update(shade=0.03, hood=0.02, reach=0.0, stem=0.01, oval=1.0)
        return m, [*faults, 1.0]
    size, post = np.ptp(shade, 0), np.ptp(stem, 0)
    start = stem[stem[:, 2] <= stem[:, 2].min() + 0.02 * post[2]].mean(0)
    mid = (shade.min(0) + shade.max(0)) / 2
    across = size[:2].mean()
    m["shade"] = across / height
    m["hood"] = size[2] / height
    m["reach"] = np.linalg.norm((mid - start)[:2]) / height
    m["stem"] = post[:2].min() / height
    m["oval"] = size[:2].max() / size[:2].min()
    faults += [
        0.6 * outside(size[2] / across, 0.08, 7.0),
        0.7 * outside(across / width, 0.15, 5.5),
        0.8 * outside(post[:2].min() / min(width, across), 0.005, 0.95),
    ]
    if m["reach"] < 0.05:
        faults += [0.8 * outside(post[0] / post[1], 0.7, 1.45)]
    cap = shape.points("cap")
    if cap is not None:
        lid = np.ptp(cap, 0)
        faults += [
            0.8 * outside(lid[:2].mean() / across, 0.7, 1.7),
            0.7 * outside(lid[0] / lid[1], 0.7, 1.45),
            0.6 * outside(lid[2] / size[2], 0.05, 1.3),
        ]
    return m, faults
