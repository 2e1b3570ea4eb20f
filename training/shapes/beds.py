# SPDX-License-Identifier: MIT OR Apache-2.0
"""Beds: from a mattress to a bunk bed. The foot looks to -y; the unit is the length of the mattress."""

import numpy as np

from .axis import amount, outside, ratio
from .shape import Shape
from .solids import bar, block, cushion, loft, outline, slab

# Heights of boards, guards and posts are above the top of the mattress; `slim` is mattress and frame.
RANGES = {
    "width": ratio(0.2, 1.4),
    "rise": ratio(0.06, 1.2),
    "head": amount(0.0, 0.9),
    "foot": amount(0.0, 0.8),
    "side": amount(0.0, 0.6),
    "post": amount(0.0, 1.3),
    "slim": amount(0.02, 0.4),
    "leg": ratio(0.025, 0.07),
}
# The share of the floor gap in the height of the mattress, and of the legs in the whole height.
MEASURED = {"open": amount(0.0, 0.98), "legs": amount(0.0, 1.0)}
LEAST = 0.045  # boards and guards lower than this are left out


def build(p, traits, rng):
    """A bed with the parameters of `RANGES` and the traits canopy and bunk (missing ones are drawn)."""
    hx, rise = p["width"] / 2, p["rise"]
    slim = min(p["slim"], 0.98 * rise)
    low = rise - slim
    low = 0.0 if low < 0.025 else low
    post = p["post"] if p["post"] > 0.1 else 0.0
    canopy = bool(traits.get("canopy", rng.random() < 0.4)) and post > 0.25
    bunk = bool(traits.get("bunk", rng.random() < 0.3)) and low > 0.4
    shape = Shape("beds", traits={"canopy": canopy, "bunk": bunk})
    frame = rise - slim * rng.uniform(0.45, 0.75)
    _lying(shape, rng, hx, low, frame, rise)
    half = p["leg"] / 2
    if low:
        _legs(shape, rng, hx, low, half)
    boards = rng.choice(["panel", "panel", "cushion", "slats", "slats", "curved"])
    if p["side"] > 0.15 and rng.random() < 0.85:
        boards = "slats"
    for label, height, y in (("head", p["head"], 0.5), ("foot", p["foot"], -0.5)):
        if height > LEAST:
            _board(shape, rng, label, hx, y, (low, rise, rise + height), half, boards)
    if p["side"] > LEAST:
        _guards(shape, rng, hx, (low, rise, rise + p["side"]), half, p["head"] > LEAST and p["side"] > 0.15)
    if post:
        _posts(shape, rng, hx, low, rise + post, half)
        if canopy:
            _canopy(shape, rng, hx, rise + post, half)
    if bunk:
        deep = 0.18 * rng.uniform(0.7, 1.2)
        top = rng.uniform(0.3, 0.5) * low + deep / 2
        solid = block((-hx, -0.5, top - deep), (hx, 0.5, top), 0.02)
        shape.add("deck", solid, (0, 0, low), "frame")
    return shape


def _lying(shape, rng, hx, low, frame, rise):
    """The frame, the mattress in it (half of the time as one part with it) and the bedding on it."""
    label = rng.choice(["mattress", "frame"])
    edge = rng.uniform(0.0, 0.03 if label == "mattress" else 0.008)
    bevel = rng.choice([0.0, 0.2]) * (frame - low)
    shape.add("frame", block((-hx - edge, -0.5 - edge, low), (hx + edge, 0.5 + edge, frame), bevel))
    soft = rng.uniform(0.1, 0.45) * (rise - frame)
    mattress = block((-hx, -0.5, frame), (hx, 0.5, rise), soft, rng.uniform(0.01, 0.06))
    shape.add(label, mattress, *(((0, 0, frame), "frame") if label == "mattress" else ()))
    if rng.random() < 0.6:
        deep, tall = rng.uniform(0.09, 0.14), rng.uniform(0.02, 0.035)
        count = 1 if hx < 0.29 else 2
        wide = min(hx / count * 0.88, 0.2)
        for i in range(count):
            x, y = (2 * i + 1 - count) * hx / count, 0.48 - deep
            pillow = cushion((x, y, rise + 0.7 * tall), (wide, deep, tall), rng.uniform(2.5, 5), 12, 5)
            shape.add("bedding", pillow, (0, 0, rise), label)
    if rng.random() < 0.5:
        over, end = rng.uniform(0.0, 0.03), rng.uniform(-0.1, 0.2)
        hang = rng.uniform(0.2, 0.9) * (rise - low)
        blanket = block((-hx - over, -0.5 - over, rise - hang), (hx + over, end, rise + 0.015), 0.01, 0.03)
        shape.add("bedding", blanket, (0, 0, rise), label)


def _legs(shape, rng, hx, low, half):
    top = low + 0.01
    if low > 0.12:
        style = rng.choice(["post", "post", "post", "turned", "trestle"])
    else:
        style = rng.choice(["post", "turned", "recessed", "trestle"])
    if style == "recessed":
        inset = rng.uniform(0.6, 0.9)
        plinth = block((-hx * inset, -0.5 * inset, 0), (hx * inset, 0.5 * inset, top))
        shape.add("leg", plinth, (0, 0, low), "frame")
        return
    x, y = hx - half, 0.5 - half
    sides, taper = (4, 1.0) if style == "post" else (int(rng.choice([4, 10])), rng.uniform(0.5, 1.0))
    for s in (-1, 1):
        at = (x, s * y, low)
        shape.add_pair("leg", bar((x, s * y, top), (x, s * y, 0), half, half * taper, sides), at, "frame")
        if style == "trestle":
            foot = bar((-x, s * y, half), (x, s * y, half), half * 0.8)
            shape.add("leg", foot, (0, s * y, low), "frame")


def _board(shape, rng, label, hx, y, levels, half, style):
    """A headboard or footboard at the end `y`, outside the mattress."""
    low, rise, top = levels
    out, at = np.sign(y), (0, y, low)
    t = rng.uniform(0.06, 0.12) if style == "cushion" else max(half * rng.uniform(0.6, 1.2), 0.015)
    mid, wide = y + out * t / 2, hx + rng.uniform(0.0, 0.04)
    if style == "curved":
        z = np.linspace(0, 1, 6)[:, None]
        plan = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * (wide, t / 2)
        lean = out * rng.uniform(0.25, 0.6) * (top - low)
        levels = [(low + (top - low) * a, mid + lean * a**2) for a in z[:, 0]]
        rings = [np.column_stack([plan[:, 0], plan[:, 1] + m, np.full(4, h)]) for h, m in levels]
        shape.add(label, loft(rings), at, "frame")
    elif style == "slats":
        for s in (-1, 1):
            shape.add(
                label, bar((s * (wide - half), mid, low), (s * (wide - half), mid, top), half), at, "frame"
            )
        cap = min(2 * half, 0.4 * (top - rise))
        shape.add(label, block((-wide, mid - half, top - cap), (wide, mid + half, top)), at, "frame")
        count = max(3, round(2 * hx / rng.uniform(0.08, 0.16)))
        x = np.linspace(-wide + half, wide - half, count + 1)[1:-1]
        slat = bar((0, mid, low), (0, mid, top - cap / 2), max(half * 0.4, 0.009))
        shape.add(label, _copies(slat, np.outer(x, (1, 0, 0))), at, "frame")
    elif style == "panel" and rng.random() < 0.3 and top - rise > 0.08:
        plan = outline(24, rng.uniform(2.2, 4)) * (wide, top - rise)
        plan[:, 1] = np.where(plan[:, 1] > 0, plan[:, 1], plan[:, 1] * (rise - low) / (top - rise))
        v, f = slab(plan, -t / 2, t / 2)
        shape.add(label, (np.column_stack([v[:, 0], v[:, 2] + mid, v[:, 1] + rise]), f[:, ::-1]), at, "frame")
    else:
        bevel = (0.3 if style == "cushion" else 0.15) * t
        shape.add(label, block((-wide, mid - t / 2, low), (wide, mid + t / 2, top), bevel), at, "frame")


def _guards(shape, rng, hx, levels, half, whole):
    """Rails along both sides: the bars of a crib, or what keeps a sleeper in."""
    low, rise, top = levels
    x, r = hx + half * 0.6, half * 0.6
    a, b = (-0.5, 0.5) if whole else (-rng.uniform(0.1, 0.5), rng.choice([0.5, rng.uniform(0.2, 0.5)]))
    at = (x, 0, rise)
    cap = min(2.2 * r, 0.4 * (top - rise))
    shape.add_pair("side", block((x - r, a, top - cap), (x + r, b, top)), at, "frame")
    style = rng.choice(["bars", "bars", "panel", "rails"] if top - rise < 0.15 else ["bars"])
    if style == "panel":
        shape.add_pair("side", block((x - r * 0.6, a, rise - 0.03), (x + r * 0.6, b, top)), at, "frame")
        return
    count = 3 if style == "rails" else max(4, round((b - a) / rng.uniform(0.06, 0.14)))
    upright = bar((x, 0, min(low + 0.02, rise - 0.03)), (x, 0, top - cap / 2), max(0.5 * r, 0.008))
    shape.add_pair(
        "side", _copies(upright, np.outer(np.linspace(a + r, b - r, count), (0, 1, 0))), at, "frame"
    )
    if style == "rails":
        z = (rise + top - cap) / 2
        shape.add_pair("side", block((x - r, a, z - cap / 2), (x + r, b, z + cap / 2)), at, "frame")


def _posts(shape, rng, hx, low, top, half):
    """Four corner posts as one part, so that what lies on them follows them."""
    r, sides = half * rng.uniform(0.8, 1.2), int(rng.choice([4, 4, 8]))
    x, y = hx + 0.3 * r, 0.5 + 0.3 * r
    taper = rng.choice([1.0, rng.uniform(0.5, 0.9)])
    corners = [(i * x, j * y, 0) for i in (-1, 1) for j in (-1, 1)]
    solid = _copies(bar((0, 0, low), (0, 0, top), r, r * taper, sides), corners)
    if rng.random() < 0.3:
        ball = cushion((0, 0, top - 1.2 * r), (1.4 * r, 1.4 * r, 1.2 * r), 2.2, 8, 5)
        solid = _together(solid, _copies(ball, corners))
    shape.add("post", solid, (0, 0, low), "frame")


def _canopy(shape, rng, hx, top, half):
    """A roof over the posts: a cloth, a frame of bars, a low gable; sometimes with a hem."""
    at, x, y = (0, 0, top), hx + half, 0.5 + half
    style = rng.choice(["cloth", "cloth", "bars", "gable"])
    if style == "bars":
        across = _copies(bar((-x, 0, top), (x, 0, top), half), [(0, s * y, 0) for s in (-1, -0.33, 0.33, 1)])
        along = _copies(bar((0, -y, top), (0, y, top), half), [(-x, 0, 0), (x, 0, 0)])
        shape.add("canopy", _together(across, along), at, "post")
        return
    hem = rng.choice([0.02, rng.uniform(0.03, 0.12)])
    cloth = block((-x, -y, top - hem), (x, y, top + 0.015))
    if style == "gable":
        peak = rng.uniform(0.08, 0.2)
        rings = [(1.0, -hem), (1.0, 0.0), (0.05, peak)]
        plan = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * (x, y)
        cloth = loft([np.column_stack([plan * (s, 1), np.full(4, top + z)]) for s, z in rings])
    shape.add("canopy", cloth, at, "post")


def _copies(solid, offsets):
    """The solid at every offset (n, 3), as one."""
    (vertices, faces), offsets = solid, np.asarray(offsets, float)
    starts = len(vertices) * np.arange(len(offsets))
    return (vertices + offsets[:, None]).reshape(-1, 3), (faces + starts[:, None, None]).reshape(-1, 3)


def _together(a, b):
    """Two solids as one."""
    return np.concatenate([a[0], b[0]]), np.concatenate([a[1], b[1] + len(a[0])])


def resembles(shape, proportions):
    """A bed without posts, guards and footboard is a seat to the eye: a narrow one a chaise longue."""
    if proportions["post"] > 0.12 or proportions["side"] > 0.06 or proportions["foot"] > 0.12:
        return None
    wide = min(proportions["width"], 1.0)
    seat = {
        "aspect": proportions["width"],
        "rise": proportions["rise"] / wide,
        "back": proportions["head"] / wide,
        "arm": 0.0,
        "slim": proportions["slim"] / wide,
        "open": proportions["open"],
        "leg": proportions["leg"] / wide,
        "legs": proportions["legs"],
    }
    return "seats", seat, {"base": "legs", "round": False, "soft": True}


def measure(shape):
    """The proportions of `RANGES` and `MEASURED` read off the vertices, and the faults as log distances."""
    every = np.concatenate([p.vertices for p in shape.parts])
    mattress, frame, leg = shape.points("mattress"), shape.points("frame"), shape.points("leg")
    mattress = frame if mattress is None else mattress
    lo, hi = mattress.min(0), mattress.max(0)
    width, length, _ = hi - lo
    frame_lo, frame_hi = frame.min(0), frame.max(0)
    frame_size = frame_hi - frame_lo
    low, floor = min(lo[2], frame_lo[2]), every[:, 2].min()
    rise = max(hi[2] - floor, 1e-6)
    m = {"width": width / length, "rise": rise / length, "slim": (hi[2] - low) / length}
    for label in ("head", "foot", "side", "post"):
        points = shape.points(label)
        m[label] = 0.0 if points is None else max(points[:, 2].max() - hi[2], 0.0) / length
    m["open"] = (low - floor) / rise
    m["legs"] = (low - floor) / max(np.ptp(every[:, 2]), 1e-6)
    m["leg"] = 0.07
    faults = [0.8 * outside(s, 0.85, 1.1) for s in ((hi - lo) / frame_size)[:2]]
    faults += [
        outside((hi[2] - frame_lo[2]) / length, 0.01, 0.5),
        outside((hi[2] - frame_hi[2]) / rise + 1, 1.0, 2.0),
    ]
    if leg is not None:
        spread = np.ptp(leg, 0)[:2] / frame_size[:2]
        faults += [outside(s, 0.55, 1.12) for s in spread]
        thick = np.array([_thickness(p.vertices) for p in shape.parts if p.label == "leg"])
        if len(thick) > 1:
            m["leg"] = np.median(thick.min(1)) / length
            faults += [outside(np.median(thick.max(1)) / length, 0.012, 0.1)]
            faults += [0.6 * outside(np.median(thick[:, 0] / thick[:, 1]), 0.4, 2.5)]
    elif m["open"] > 0.05:
        faults += [0.7]
    faults += _ends(shape, frame_lo, frame_hi, length)
    faults += _tops(shape, frame_size, length, hi[2], low, floor)
    return m, faults


def _ends(shape, lo, hi, length):
    """Faults of head, foot and sides: as wide as the bed, thin, standing at its edge."""
    faults = []
    for label, axis in (("head", 0), ("foot", 0), ("side", 1)):
        points = shape.points(label)
        if points is None:
            continue
        across = np.ptp(points[:, axis]) / (hi - lo)[axis]
        faults += [outside(across, 0.8 if axis == 0 else 0.3, 1.25)]
        if axis == 0:
            faults += [0.8 * outside(np.ptp(points[:, 1]) / length + 0.1, 0.1, 0.5)]
        else:
            faults += [outside(np.ptp(points[:, 0]) / (hi - lo)[0], 0.8, 1.25)]
    return faults


def _tops(shape, frame_size, length, top, low, floor):
    """Faults of posts, canopy, bedding and the lower bunk against the frame."""
    faults = []
    post, canopy = shape.points("post"), shape.points("canopy")
    bedding, deck = shape.points("bedding"), shape.points("deck")
    if post is not None:
        faults += [outside(s, 0.85, 1.2) for s in np.ptp(post, 0)[:2] / frame_size[:2]]
        corner = post[(post[:, 0] > 0) & (post[:, 1] > post[:, 1].mean())]
        if len(corner):
            faults += [0.8 * outside(s / length, 0.01, 0.12) for s in np.ptp(corner, 0)[:2]]
    if canopy is not None and post is not None:
        faults += [outside(s, 0.85, 1.2) for s in np.ptp(canopy, 0)[:2] / np.ptp(post, 0)[:2]]
        faults += [outside(np.ptp(canopy[:, 2]) / length, 0.005, 0.45)]
    if bedding is not None:
        faults += [0.7 * outside(np.ptp(bedding[:, 0]) / frame_size[0], 0.4, 1.2)]
        faults += [0.8 * outside((bedding[:, 2].max() - top) / length + 1, 1.0, 1.12)]
    if deck is not None:
        faults += [outside(s, 0.8, 1.2) for s in np.ptp(deck, 0)[:2] / frame_size[:2]]
        faults += [outside((deck[:, 2].max() - floor) / max(low - floor, 1e-6), 0.15, 0.85)]
    return faults


def _thickness(vertices):
    """How thick a leg is in x and y at its top end."""
    top = vertices[:, 2].max() - 0.1 * np.ptp(vertices[:, 2])
    return np.maximum(np.ptp(vertices[vertices[:, 2] >= top][:, :2], 0), 1e-6)
