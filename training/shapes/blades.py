# SPDX-License-Identifier: MIT OR Apache-2.0
"""Blades and tools: a handle and what it carries.

They stand with the handle at the bottom, the flat of the blade to -y or to the side; the unit is the length
of the handle. Half of them lie flat, the handle to -y; proportions are measured in the object's own axes.
"""

import numpy as np

from .axis import amount, outside, ratio
from .blade_heads import ACROSS, HEADS
from .pose import own_axes, take_pose
from .shape import Shape
from .solids import bar, block, cushion, fit, lathe, loft, outline

# Length of the blade per handle, its width per length, its thickness per width, the width of the guard per
# width of the blade, the width of the handle per length. A hammer's head is a blade wider than long.
RANGES = {
    "blade": ratio(0.04, 8.0),
    "width": ratio(0.014, 10.0),
    "thick": ratio(0.03, 1.2),
    "guard": amount(0.0, 8.0),
    "grip": ratio(0.012, 0.4),
}
# The width of the blade per handle; the whole length per greatest width.
MEASURED = {"head": ratio(0.02, 3.0), "reach": ratio(0.8, 60.0)}


def build(p, traits, rng):
    """A tool with the parameters of `RANGES` and the traits head, pose (missing ones are drawn)."""
    head = traits.get("head")
    if head is None or not HEADS[head][1] <= p["width"] <= HEADS[head][2]:
        head = _likely_head(p, rng)
    pose = traits.get("pose") or rng.choice(["lying", "upright", "side"], p=[0.5, 0.25, 0.25])
    shape = Shape("blades", traits={"head": str(head), "pose": str(pose)})
    size, deep = _sizes(p, head, rng)
    wide, thick, long = size
    grip = p["grip"]
    _handle(shape, rng, head, grip, deep)
    low = 1 - min(long, 0.5 + 0.2 * long) * rng.uniform(0.8, 1.0) if head in ACROSS else 1.0
    _head(shape, rng, head, size, np.array([0, 0, low]), grip)
    guard = p["guard"] * wide
    if head not in ACROSS and p["guard"] > 0.4 and guard > 0.8 * grip:
        _guard(shape, rng, min(guard, 1.6), deep, thick)
    if p["guard"] > 0.6 and head in ("double", "curved") and rng.random() < 0.85:
        r = grip * rng.uniform(0.5, 0.85)
        end = cushion((0, 0, 0), (r, max(r * 0.7, deep / 2), r * rng.uniform(0.6, 1)), 2.5, 10, 5)
        shape.add("pommel", end, (0, 0, 0), "handle")
    elif head == "scoop" and rng.random() < 0.5:
        w = grip * rng.uniform(1.4, 2.4)
        shape.add("pommel", block((-w, -deep * 0.6, -grip), (w, deep * 0.6, 0.02)), (0, 0, 0), "handle")
    take_pose(shape)
    return shape


def _likely_head(p, rng):
    """A head that a tool of these proportions may well have."""
    fits = [h for h, (_, low, high) in HEADS.items() if low <= p["width"] <= high]
    slim, flat = p["grip"] < 0.07, p["thick"] < 0.3
    odd = {
        "rod": p["thick"] < 0.45,
        "scoop": not slim,
        "jaw": slim or p["guard"] > 0.5 or not flat,
        "slab": p["guard"] > 0.5 or p["width"] < 0.25,
        "curved": p["guard"] < 0.5,
        "axe": not flat,
        "double": p["thick"] > 0.6 and p["width"] < 0.4,
        "single": p["guard"] > 2.5 or p["thick"] > 0.4,
    }
    return rng.choice([h for h in fits if not odd.get(h)] or fits)


def _sizes(p, head, rng):
    """The size of the head (x, y, z) and the depth of the handle, kept to what can be made."""
    long, grip = p["blade"], p["grip"]
    deep = grip * rng.uniform(0.6, 1.0)
    slimmest, widest = (1.3, 38.0) if head in ACROSS else (0.2, 14.0)
    if head == "rod":
        widest = 2.4 * deep / grip
    wide = np.clip(p["width"] * long, slimmest * grip, min(widest * grip, 3.0))
    thick = p["thick"] * wide
    if head in ACROSS:
        long = min(long, 8 * deep / ACROSS[head][0], 12 * deep)
        slimmest, widest = ACROSS[head]
        thick = np.clip(thick, max(slimmest * long, 0.3 * deep), max(widest * long, 0.3 * deep))
    elif head == "rod":
        thick = np.clip(thick, 0.45 * wide, 1.15 * wide)
    elif head != "scoop":
        thick = np.clip(thick, 0.05 * deep, 1.2 * deep)
    return np.array([wide, thick, long]), deep


def _handle(shape, rng, head, grip, deep):
    """A bar, a turned or a bent grip; a wrench's grows thinner towards its jaw."""
    half, low, high = grip / 2, (-grip / 2, -deep / 2, 0), (grip / 2, deep / 2, 1)
    if grip < 0.06:
        solid = bar((0, 0, 0), (0, 0, 1), half, half * rng.uniform(0.75, 1), int(rng.choice([4, 8])))
    elif head == "jaw":
        w = np.array([1, 1, 0.7, 0.65, 0.65]) * half
        solid = loft([np.array([(x, -1, z), (x, 1, z), (-x, 1, z), (-x, -1, z)])
                      for x, z in zip(w, (0, 0.1, 0.2, 0.6, 1), strict=True)])  # fmt: skip
    elif rng.random() < 0.5:
        swell = rng.uniform(0.75, 1.0, 3)
        radii = half * np.array([0.85, 1.0, swell[0], swell[1], swell[2], 0.8])
        solid = lathe([*zip(radii, (0, 0.08, 0.35, 0.55, 0.85, 1), strict=True)], sides=10)
    else:
        bend = rng.uniform(-0.15, 0.15) * half
        plan = outline(12, rng.choice([2.5, 5])) * half
        z = np.linspace(0, 1, 6)
        w = np.array([0.95, 1.0, 0.9, 0.9, 0.95, 0.85])
        rings = [np.column_stack([plan[:, 0] * k + bend * np.sin(6 * t), plan[:, 1] * k, np.full(12, t)])
                 for k, t in zip(w, z, strict=True)]  # fmt: skip
        solid = loft(rings)
    shape.add("handle", fit(solid, low, high))


def _guard(shape, rng, wide, deep, thick):
    """A bar, a bow or a disc between handle and blade."""
    half, tall = wide / 2, rng.uniform(0.03, 0.09) * min(1.0, 0.4 + wide)
    y = max(deep, thick) * rng.uniform(0.5, 0.7)
    style = rng.choice(["bar", "bar", "bow", "disc"])
    if style == "disc" and wide < 5 * deep:
        y = max(y, half * rng.uniform(0.6, 0.95))
        solid = lathe([(1, -1), (1, 1)], sides=14)
    elif style == "bow" and wide > 0.2:
        up = rng.choice([-1, 1]) * tall
        x = np.array([-1, -0.5, 0, 0.5, 1])
        w = tall * np.array([0.35, 0.4, 0.6, 0.4, 0.35])
        bow = up * x * x
        sides = [
            np.column_stack([x, np.full(5, y), bow + h * w]) for y, h in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
        rings = np.stack(sides, 1)
        solid, tall = loft(rings), tall * 1.6
    else:
        solid = block((-1, -1, -1), (1, 1, 1), rng.choice([0, 0.2]))
    at = (0, 0, 1)
    shape.add("guard", fit(solid, (-half, -y, 1 - tall / 2), (half, y, 1 + tall / 2)), at, "handle")


def _head(shape, rng, head, size, foot, grip):
    """Add the head `head` of the given size (x, y, z), its lowest point at the height of `foot`."""
    wide, thick, long = size
    made = HEADS[head][0](rng, size)
    shift = 0.0
    if head in ("single", "curved", "slab"):
        shift = max(0.0, (wide - grip) / 2) * rng.uniform(0.3, 1.0)
    elif head == "axe" and made[0][:, 0].max() > 1.05:
        shift = wide * rng.uniform(0.15, 0.35)
    low = foot + np.array([shift - wide / 2, -thick / 2, 0])
    at = (0, 0, foot[2] + (long / 2 if head in ACROSS else 0))
    solids = [made] if isinstance(made, tuple) else made
    points = np.concatenate([v for v, _ in solids])
    start, span = points.min(0), np.ptp(points, 0)
    for vertices, faces in solids:
        shape.add("blade", (low + (vertices - start) / span * size, faces), at, "handle")


def measure(shape):
    """The proportions of `RANGES` and `MEASURED` read off the vertices, and the faults as log distances."""
    blade, handle = own_axes(shape, "blade"), own_axes(shape, "handle")
    guard, pommel = own_axes(shape, "guard"), own_axes(shape, "pommel")
    every = own_axes(shape, *{part.label for part in shape.parts})
    grip, deep, length = np.ptp(handle, 0)
    whole = np.ptp(every, 0)
    m = {"grip": grip / length, "reach": whole[2] / whole[0], "guard": 0.0}
    faults = [outside(deep / grip, 0.58, 1.02)]
    if blade is None:
        m.update(blade=0.04, width=1.0, thick=0.5, head=0.04)
        return m, [*faults, 1.0]
    wide, thick, long = np.ptp(blade, 0)
    m.update(blade=long / length, width=wide / long, thick=thick / wide, head=wide / length)
    head = shape.traits["head"]
    if head in ACROSS:
        slimmest, widest = ACROSS[head]
        faults += [0.9 * outside(thick / long, 0.95 * slimmest, 1.05 * widest)]
        faults += [0.8 * outside(thick / deep, 0.28, 28), 0.8 * outside(wide / grip, 1.2, 40)]
    else:
        faults += [0.8 * outside(wide / grip, 0.19, 14.5)]
        if head != "scoop":
            faults += [0.8 * outside(thick / deep, 0.045, 1.25)]
    if head == "rod":
        faults += [0.8 * outside(thick / wide, 0.4, 1.3)]
    if guard is not None:
        size = np.ptp(guard, 0)
        m["guard"] = size[0] / wide
        faults += [
            0.8 * outside(size[1] / max(deep, thick), 0.97, 4.2),
            0.8 * outside(size[1] / size[0], 0.01, 1.5),
        ]
        faults += [0.8 * outside(size[2] / length, 0.013, 0.13)]
    if pommel is not None:
        size = np.ptp(pommel, 0) / (grip, deep, grip)
        faults += [0.8 * outside(size[0], 0.95, 4.8), 0.8 * outside(size[1], 0.95, 1.8)]
        faults += [0.8 * outside(size[2], 0.6, 1.8)]
    return m, faults
