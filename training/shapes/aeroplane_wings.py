# SPDX-License-Identifier: MIT OR Apache-2.0
"""Wings and tails of aircraft: their plan, winglets, struts, fins and tailplanes."""

from typing import NamedTuple

import numpy as np

from .solids import bar, wing

# Heights of the wings on the fuselage, in its radii.
LEVELS = {"low": -0.6, "mid": 0.0, "high": 0.75}
FEW = 0.04  # a tail or fin smaller than this is left out


class Wing(NamedTuple):
    """One wing: its leading edge runs from (inner, lead) to (half, lead + back), its height is z + rise."""

    inner: float
    half: float
    lead: float
    back: float
    root: float
    tip: float
    z: float
    rise: float
    thickness: float

    def at(self, x):
        """The leading edge (y) and the height over |x|."""
        t = np.clip((x - self.inner) / (self.half - self.inner), 0, 1)
        return self.lead + t * self.back, self.z + t * self.rise


def wing_plan(rng, p, radius, facts, flying_wing):
    """The wing's plan, or None where the span leaves no room for one."""
    half = max(p["span"], 0.06) / 2
    if facts["airship"] or half < radius * 1.05:
        return None
    inner = 0.3 * min(radius, half)
    across, sweep, chords = half - inner, p["sweep"], p["chords"]
    mean = min(2 * across / chords, 0.62 if flying_wing else 0.45)
    # lean: (root - tip) / (root + tip), so chosen that the trailing edge is swept neither much nor forwards.
    lean = rng.uniform(0.3, 0.65) if sweep > 0.25 else rng.uniform(0.0, 0.45)
    aspect = 2 * across / mean
    lean = np.clip(np.clip(lean, (sweep - 0.5) * aspect / 4, (sweep + 0.25) * aspect / 4), 0.0, 0.93)
    root = min(mean * (1 + lean), 0.98 if flying_wing else 0.74)
    tip = 2 * mean - root if root < mean * (1 + lean) else mean * (1 - lean)
    middle = rng.uniform(-0.08, 0.05) + 0.1 * np.clip(sweep - 0.5, 0, 1.2)
    lead = middle - mean / 2 - 0.42 * sweep * across
    lead = np.clip(lead, -0.48, max(0.49 - root, -0.48))
    thickness = rng.uniform(0.08, 0.15) if chords > 3.5 else rng.uniform(0.035, 0.08)
    if p["slim"] > 0.22:
        thickness *= 1.5
    thickness = min(thickness, 0.9 * radius / root)
    z = LEVELS[facts["level"]] * radius * (0.3 if flying_wing else 1.0)
    rise = half * (0.0 if flying_wing else rng.choice([0.0, rng.uniform(-0.05, 0.12)]))
    return Wing(inner, half, lead, sweep * across, root, tip, z, rise, thickness)


def add_wings(shape, rng, radius, w, biplane):
    """Add the wings: two pairs with struts on a biplane, otherwise one, perhaps with winglets."""
    levels = [w.z]
    if biplane:
        levels = [-0.6 * radius, -0.6 * radius + rng.uniform(1.3, 2.4) * max(radius, 0.3 * w.root)]
    for z in levels:
        attach = (radius * 0.8, w.lead + w.root / 2, z)
        root, tip = (w.inner, w.lead, z), (w.half, w.lead + w.back, z + w.rise)
        shape.add_pair("wing", wing(root, tip, w.root, w.tip, w.thickness, 3), attach, "fuselage")
    if biplane:
        for t in (0.35, 0.8):
            x = t * w.half
            y, rise = w.lead + w.back * t + 0.4 * w.root, w.rise * t
            strut = bar((x, y, levels[0] + rise), (x, y, levels[1] + rise), (0.007, 0.02))
            shape.add_pair("wing", strut, (radius * 0.8, w.lead + w.root / 2, levels[0]), "fuselage")
    elif rng.random() < 0.2 and w.half > 0.3:
        tip = (w.half - 0.003, w.lead + w.back, w.z + w.rise)
        top = (w.half - 0.003, w.lead + w.back + w.tip * 0.6, w.z + w.rise + rng.uniform(0.06, 0.13) * w.half)
        fin = wing(tip, top, w.tip, w.tip * 0.4, min(w.thickness, 0.006 / w.tip), 3, vertical=True)
        shape.add_pair("wing", fin, (radius * 0.8, w.lead + w.root / 2, w.z), "fuselage")


def add_tail(shape, rng, radius, p, style, tail_up):
    """Add the tailplane and the fins; `style` says how they stand: low, tee, twin, vee or cross."""
    half, fin = p["tail"] / 2, p["fin"]
    z = tail_up * 0.8
    lean = np.clip(p["sweep"], 0.1, 1.0) * rng.uniform(0.7, 1.1)
    chord = np.clip(half * rng.uniform(0.5, 0.8), 0.05, 0.18)
    fin_chord = np.clip(fin * rng.uniform(0.7, 1.1), 0.07, 0.24)
    taper, fin_taper = rng.uniform(0.4, 0.9), rng.uniform(0.4, 0.8)
    end = 0.49 - rng.uniform(0, 0.03)
    fin_lean = fin * rng.uniform(0.35, 0.7) + 0.2 * lean * fin
    has_fin, has_tail = fin > FEW, half * 2 > FEW
    if style == "vee" and has_fin and has_tail:
        y = end - chord
        tip = (half, y + chord * 0.5, z + fin - 0.05 * chord)
        shape.add_pair(
            "tail", wing((0, y, z), tip, chord, chord * taper, 0.1, 3), (0, y + chord / 2, z), "fuselage"
        )
        return
    y = end - fin_chord
    if has_fin:
        at = (0, y + fin_chord / 2, z)
        x = 0.0
        if style == "twin":
            x = half * 0.98 if has_tail and p["sweep"] < 0.4 else radius * rng.uniform(0.5, 0.9)
            tip = (x * (1.0 if x > radius else rng.uniform(1.0, 1.5)), y + fin_lean, z + fin)
            solid = wing((x, y, z), tip, fin_chord, fin_chord * fin_taper, 0.08, 3, vertical=True)
            shape.add_pair("fin", solid, (min(x, radius * 0.5), y + fin_chord / 2, z), "fuselage")
        elif style == "cross":
            for s in (-1, 1):
                solid = wing(
                    (0, y, 0),
                    (0, y + fin_lean / 2, s * fin / 2),
                    fin_chord,
                    fin_chord * fin_taper,
                    0.07,
                    3,
                    vertical=True,
                )
                shape.add("fin", solid, (0, y + fin_chord / 2, 0), "fuselage")
        else:
            solid = wing(
                (0, y, z),
                (0, y + fin_lean, z + fin),
                fin_chord,
                fin_chord * fin_taper,
                0.09,
                4,
                vertical=True,
            )
            shape.add("fin", solid, at, "fuselage")
    if has_tail:
        high = style == "tee" and has_fin
        z = 0.0 if style == "cross" else z + 0.96 * fin * high
        y = y + fin_lean * 0.96 if high else end - chord
        solid = wing((0, y, z), (half, y + half * lean, z), chord, chord * taper, 0.09, 3)
        shape.add_pair("tail", solid, (0, y + chord / 2, z), "fin" if high else "fuselage")
