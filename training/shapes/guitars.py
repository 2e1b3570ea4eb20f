# SPDX-License-Identifier: MIT OR Apache-2.0
"""Stringed instruments: a body, a neck, a head.

They stand upright, the face to -y; the unit is the length of the body. A quarter lies on its back, the neck
towards +y; proportions are measured in the object's own axes.
"""

import numpy as np

from .axis import amount, outside, ratio
from .guitar_outlines import body_outline
from .pose import own_axes, take_pose
from .shape import Shape
from .solids import bar, block, cushion, loft, outline

# Neck and head beyond the body, width of the body, and endpin, per length of the body; depth of the body and
# width of the neck per width of the body.
RANGES = {
    "neck": ratio(0.2, 4.0),
    "slim": ratio(0.35, 1.9),
    "depth": ratio(0.07, 1.1),
    "head": amount(0.04, 0.8),
    "grip": ratio(0.06, 0.42),
    "pin": amount(0.0, 0.6),
}
# The whole length per width of the body.
MEASURED = {"reach": ratio(1.0, 12.0)}


def build(p, traits, rng):
    """An instrument with the parameters of `RANGES` and the traits form, pose (missing ones are drawn)."""
    form = traits.get("form") or _likely_form(p, rng)
    if p["depth"] > (0.65 if form == "viol" else 0.5) and form not in ("pear", "round"):
        form = rng.choice(["pear", "round"])
    pose = traits.get("pose", "lying" if rng.random() < 0.25 else "upright")
    shape = Shape("guitars", traits={"form": form, "pose": pose})
    width = p["slim"]
    deep = p["depth"] * width
    _body(shape, rng, form, width, deep)
    joint = _neck(shape, rng, form, width, deep, p["grip"] * width, p["neck"])
    _head(shape, rng, form, joint, p["head"])
    _bridge(shape, rng, form, width, deep)
    if p["pin"] > 0.01:
        r = rng.uniform(0.018, 0.03) * width
        shape.add("pin", bar((0, 0, 0.02), (0, 0, -p["pin"]), r, 0.7 * r, 8), (0, 0, 0), "body")
    take_pose(shape)
    return shape


def _likely_form(p, rng):
    """A form that suits the proportions."""
    if p["slim"] > 1.05 and rng.random() < 0.6:
        return "triangle"
    if p["pin"] > 0.06 and rng.random() < 0.7:
        return "viol"
    if p["depth"] < 0.2:
        return rng.choice(["horned", "horned", "horned", "waisted", "pear", "round"])
    if p["depth"] > 0.42:
        return rng.choice(["pear", "pear", "round", "viol", "waisted"])
    return rng.choice(["waisted", "waisted", "waisted", "viol", "pear", "round", "horned"])


def _body(shape, rng, form, width, deep):
    """The body, perhaps with a rim on the skin of a banjo or round the hole of a guitar."""
    plan = body_outline(form, rng)
    plan = (plan - plan.min(0)) / np.ptp(plan, 0) * (width, 1) - (width / 2, 0)
    # Every point of the outline is seen from here, which a notch between horns or wings asks for.
    middle = np.array([0, 0.62 if plan[np.abs(plan[:, 0]).argmin(), 1] > 0.2 and form == "horned" else 0.46])
    bowl = form in ("pear", "round") and deep > 0.38 * width and rng.random() < 0.85
    if bowl:
        a = np.linspace(0, 0.5 * np.pi, 7)
        levels = [(0.0, 0), *[(np.cos(x) ** 0.8, np.sin(x)) for x in a]]
    elif form == "viol":
        levels = [(0, 0), (0.45, 0.03), (0.9, 0.16), (1, 0.2), (1, 0.8), (0.9, 0.84), (0.45, 0.97), (0, 1)]
    else:
        edge = rng.choice([0.02, 0.1, 0.25])
        levels = [(0, 0), (1 - 0.25 * edge, 0), (1, edge), (1, 1 - edge), (1 - 0.25 * edge, 1), (0, 1)]
    rings = []
    for size, y in levels:
        flat = middle + (plan - middle) * max(size, 0.01)
        rings.append(np.column_stack([flat[:, 0], np.full(len(flat), (y - 0.5) * deep), flat[:, 1]]))
    shape.add("body", loft(rings))
    if form == "round" and not bowl and rng.random() < 0.6:
        ring = rng.uniform(0.86, 0.97)
        rim = [np.column_stack([plan[:, 0] * ring, np.full(len(plan), y), 0.5 + (plan[:, 1] - 0.5) * ring])
               for y in (-0.5 * deep, -0.5 * deep - 0.03 * width)]  # fmt: skip
        shape.add("trim", loft(rim), (0, -deep / 2, 0.5), "body")
    if form == "waisted" and rng.random() < 0.7:
        r, y = 0.13 * width, -0.5 * deep
        hole = [outline(16) * s for s in (r, 1.15 * r, 1.15 * r, r)]
        front = [y + 0.01, y + 0.01, y - 0.012, y - 0.012]
        rings = [
            np.column_stack([h[:, 0], np.full(16, f), 0.63 + h[:, 1]])
            for h, f in zip(hole, front, strict=True)
        ]
        shape.add("trim", loft([*rings, rings[0]], caps=False), (0, y, 0.63), "body")


def _neck(shape, rng, form, width, deep, grip, neck):
    """Add the neck and return where it meets the head."""
    thick = min(grip * rng.uniform(0.4, 0.75), 1.1 * deep)
    raised = 0.07 * width if form == "viol" else 0.0
    y = -deep / 2 + thick * rng.uniform(0.1, 0.5) - raised
    low = 0.7 if form == "horned" else 0.97
    at, top = np.array([0, y, 1.0]), 1 + neck
    taper = rng.uniform(0.75, 1.0)
    half = np.array([grip, thick]) / 2
    sides = int(rng.choice([4, 8]))
    size = half if sides == 4 else half * 1.08
    shape.add("neck", bar((0, y, low), (0, y, top), size, size * (taper, 1), sides), at, "body")
    start = 0.45 if form == "viol" else rng.uniform(0.6, 0.8)
    front = min(y - thick / 2, -deep / 2)
    board = block((-grip / 2, front - 0.15 * thick, start), (grip / 2, front + 0.2 * thick, top))
    squeeze = 1 + (taper - 1) * np.clip((board[0][:, 2:] - 1) / neck, 0, 1) * (1, 0, 0)
    shape.add("neck", (board[0] * squeeze, board[1]), at, "body")
    if form != "horned" and rng.random() < 0.6:
        heel = min(0.9 * deep, 3 * thick)
        foot = block((-grip * 0.3, y, 0.97), (grip * 0.3, min(y + heel, 0.45 * deep), 1.04))
        shape.add("neck", foot, at, "body")
    return np.array([0, y, top]), grip * taper, thick


def _head(shape, rng, form, joint, head):
    """The head from the neck's end: bent back, a scroll or a plate, with pegs."""
    at, wide, thick = joint
    y, top = at[1], at[2]
    half, t = wide / 2, thick * rng.uniform(0.3, 0.5)
    if form == "viol":
        style = "scroll"
    elif form == "pear" and head < 0.22:
        style = "bent"
    else:
        style = rng.choice(["inline", "paddle"] if form == "horned" else ["paddle", "paddle", "slotted"])
    pegs, peg = [], 0.12 * wide
    if style == "bent":
        tip = np.add(at, (0, rng.uniform(0.16, 0.3), 0))
        solid = bar(at, tip, (half, head / 2), (half * 0.8, head / 2))
        shape.add("head", (solid[0] + (0, 0, head / 2), solid[1]), at, "neck")
        pegs = [(half * 0.9, s * (tip[1] - y), top + head / 2) for s in (0.25, 0.5, 0.75)]
        pegs = [(x, y + d, z) for x, d, z in pegs]
    elif style == "scroll":
        shape.add(
            "head", bar(at, np.add(at, (0, 0.04 * head, 0.8 * head)), (half, t * 1.3), half * 0.5), at, "neck"
        )
        r = 0.2 * head
        curl = cushion(np.add(at, (0, 0, head - r)), (half * 0.9, min(r, 2.0 * t), r), 2.2, 10, 7)
        shape.add("head", curl, at, "neck")
        pegs = [(half * 0.8, y, top + s * head) for s in (0.2, 0.4, 0.6)]
        peg *= 0.8
    else:
        spread = rng.uniform(1.15, 1.9)
        flare = np.array([0.95, spread * 0.9, spread, spread * rng.uniform(0.85, 1.05)]) * half
        z = top + head * np.array([0, 0.15, 0.3, 1])
        left = half * np.array([0.95, 0.95, 0.95, 0.7]) if style == "inline" else flare
        lean = rng.choice([0, 0.12]) * head * np.array([0, 0.15, 0.3, 1])
        rings = [
            np.array([(b, m - t, h), (b, m + t, h), (-a, m + t, h), (-a, m - t, h)])
            for a, b, m, h in zip(left, flare, y + lean, z, strict=True)
        ]
        shape.add("head", loft(rings), at, "neck")
        pegs = [(spread * half, y + lean[-1] * s, top + s * head) for s in np.linspace(0.3, 0.85, 3)]
    for x, depth, z in pegs if rng.random() < 0.85 else ():
        tip = x + wide * 0.4
        if style == "inline":
            shape.add("head", bar((x * 0.8, depth, z), (tip, depth, z), peg, sides=4), at, "neck")
        else:
            shape.add_pair("head", bar((x * 0.8, depth, z), (tip, depth, z), peg, sides=4), at, "neck")


def _bridge(shape, rng, form, width, deep):
    """The bridge, with a tailpiece or pickups where the form has them."""
    y, half = -deep / 2, 0.5 * width * rng.uniform(0.22, 0.4)
    z = {"viol": 0.42, "round": 0.3, "waisted": 0.27}.get(form, rng.uniform(0.2, 0.32))
    high = 0.1 * width if form == "viol" else rng.uniform(0.02, 0.05) * width
    at = (0, y, z)
    if form == "viol":
        half *= 0.65
        shape.add("bridge", block((-half, y - high, z - 0.015), (half, y + 0.01, z + 0.015)), at, "body")
        tail = [(0, y - 0.01, 0.02), (0, y - high * 0.75, z - 0.08)]
        shape.add("trim", bar(*tail, (0.035 * width, 0.02 * width), (0.08 * width, 0.02 * width)), at, "body")
        return
    shape.add("bridge", block((-half, y - high, z - 0.025), (half, y + 0.005, z + 0.025)), at, "body")
    if form == "horned":
        for s in np.linspace(0.42, 0.62, int(rng.integers(1, 4))):
            pickup = block((-half * 0.7, y - high * 0.7, s - 0.025), (half * 0.7, y + 0.005, s + 0.025))
            shape.add("trim", pickup, (0, y, s), "body")


def measure(shape):
    """The proportions of `RANGES` and `MEASURED` read off the vertices, and the faults as log distances."""
    body, neck, head = (own_axes(shape, label) for label in ("body", "neck", "head"))
    bridge, pin = own_axes(shape, "bridge"), own_axes(shape, "pin")
    low, top = body[:, 2].min(), body[:, 2].max()
    width, deep, length = np.ptp(body, 0)
    m = {"slim": width / length, "depth": deep / width, "neck": 0.05, "head": 0.0, "grip": 0.05, "pin": 0.0}
    faults, end = [], top
    if neck is None:
        faults += [1.0]
    else:
        end = max(neck[:, 2].max(), top + 0.02 * length)
        size = np.ptp(neck, 0)
        m.update(neck=(end - top) / length, grip=size[0] / width)
        # The heel is deep; what a hand holds is as deep as at the nut.
        held = np.ptp(neck[neck[:, 2] > neck[:, 2].max() - 0.02 * length, 1])
        faults += [0.9 * outside(held / size[0], 0.4, 1.15), 0.7 * outside(held / deep, 0.08, 1.5)]
        faults += [0.7 * outside((end - top) / size[0], 1.4, 45)]
        if head is None:
            faults += [0.6]
        else:
            at, end = end, max(end, head[:, 2].max())
            m["head"] = (end - at) / length
            faults += [0.9 * outside(np.ptp(head[:, 0]) / size[0], 0.85, 2.5)]
            faults += [0.7 * outside(np.ptp(head[:, 1]) / length, 0.02, 0.3)]
    if bridge is not None:
        size = np.ptp(bridge, 0)
        faults += [0.7 * outside(size[0] / width, 0.14, 0.42), 0.5 * outside(size[2] / length, 0.025, 0.06)]
        faults += [0.7 * outside(size[1] / width, 0.02, 0.14)]
    if pin is not None:
        m["pin"] = max(low - pin[:, 2].min(), 0.0) / length
        across = np.ptp(pin, 0)[:2]
        faults += [
            0.5 * outside(across.mean() / width, 0.03, 0.06),
            0.4 * outside(across[0] / across[1], 0.5, 2),
        ]
    m["reach"] = (end - low) / width
    return m, faults
