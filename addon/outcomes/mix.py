# SPDX-License-Identifier: GPL-3.0-or-later
"""A pose of several outcomes: their values, and whether these leave every part thick enough.

An outcome at value α scales a part by 1 + α·(g·c − 1), with its scale factor c and the gauge's scale g, and
outcomes add up. Where they have the same parts, so do the changes of each part: exact. Where their parts
differ, nothing is known of which meet, and the most that each takes away is added up: safe.
"""

from typing import NamedTuple

import numpy as np
from bpy.app.translations import pgettext_rpt as rpt_

from ..errors import Refusal
from . import animation_curves, shape_key

#: The scale factor that outcomes together may not go below, as one alone on its slider (src/spectrum.rs).
LEAST_SCALE = 0.05

#: Slack for values, which Blender keeps in 32 bits.
_ROUNDING = 1e-5

#: Halvings of the range in which the greatest mix is sought.
_HALVINGS = 60


class _Share(NamedTuple):
    """What one outcome adds to the scale factors of its parts."""

    name: str
    parts: str  #: equal for outcomes with the same parts
    full: np.ndarray  #: (P,3) what it adds at value 1
    now: np.ndarray  #: (P,3) what it adds at its present values; where it is apart, what it adds at least
    key: object  #: its shape key; None where it is apart


def room(obj):
    """Return a sentence where the outcomes of `obj` at their present values make a part too thin together,
    else None. Muted ones do not count.
    """
    shares = [share for share in _shares(obj) if share.now.any()]
    # The slider of one alone ends in time.
    if len(shares) < 2 or _least(shares) >= _floor(shares):
        return None
    return "Together the outcomes make a part thinner than a twentieth of itself"


def mix(obj, amount=1.0):
    """Set the outcomes of `obj` to values in the ratio of their present ones, evenly where all are 0; return
    sentences on what else came of it.

    The values add up to `amount`, signs aside, or to as much of it as every slider and every part has room
    for. One that alone has a value keeps it. Muted outcomes are left out, and so are those taken apart: their
    pieces stay as they are and count. Raises Refusal, and then changes nothing, for a driven value and where
    nothing is to be mixed.
    """
    shares = _shares(obj)
    mixed = [share for share in shares if share.key is not None]
    apart = [share for share in shares if share.key is None]
    if len(mixed) < 2:
        raise Refusal(
            "“{name}” has fewer than two outcomes to mix: muted ones and those taken apart are left out",
            name=obj.name,
        )
    for share in mixed:
        if animation_curves.driver(share.key) is not None:
            raise Refusal(
                "“{name}” is driven, so its value cannot be set. Delete its driver first, or mute it",
                name=share.name,
            )
    of_apart = rpt_("“{}” is taken apart, and its pieces stay as they are")
    notes = [of_apart.format(share.name) for share in apart]
    weights = np.array([share.key.value for share in mixed], np.float64)
    if np.count_nonzero(weights) == 1:
        only = mixed[np.flatnonzero(weights)[0]].name
        return [*notes, rpt_("Only “{}” has a value other than 0, and it keeps that").format(only)]
    weights = weights if weights.any() else np.ones(len(mixed))
    values = amount * weights / np.abs(weights).sum()
    values *= _within_sliders(values, [share.key for share in mixed])
    values *= _within_parts(values, mixed, apart)
    for share, value in zip(mixed, values, strict=True):
        share.key.value = value
    reached = np.abs(values).sum()
    if reached < amount - _ROUNDING:
        notes.append(rpt_("There is room for an amount of {:.2f}, not {:.2f}").format(reached, amount))
    return notes


def posed(obj):
    """Return the shape keys that make the present pose: outcomes that are not muted, and the pieces of those
    taken apart.
    """
    keys = []
    for key in shape_key.outcomes(obj.data):
        keys += [piece for piece in (key, *shape_key.pieces(obj.data, key.name)) if not piece.mute]
    return keys


def _shares(obj):
    """Return the _Share of each outcome of `obj` that is not muted."""
    shares = []
    for name, report in shape_key.records(obj.data).items():
        key = obj.data.shape_keys.key_blocks[name]
        full, parts = _changes(report), report.get("parts_id", name)
        now = 0.0 * full if key.mute else key.value * full
        if shape_key.PIECES in report:
            shares.append(_Share(name, parts, full, now + _of_pieces(obj.data, report, full), None))
        elif not key.mute:
            shares.append(_Share(name, parts, full, now, key))
    return shares


def _changes(report):
    """Return what an outcome adds to scale factors at value 1, (P,3); no rows where its record has none."""
    return report.get("gauge_scale", 1.0) * np.array(report.get("scales", ())).reshape(-1, 3) - 1.0


def _of_pieces(mesh, report, full):
    """Return what the pieces of an outcome that was taken apart add to scale factors at least, (P,3).

    Which piece is of which part the record does not tell: for every part it is taken to be the one whose
    value makes it thinnest.
    """
    blocks = mesh.shape_keys.key_blocks
    pieces = (blocks.get(name) for name in report[shape_key.PIECES])
    values = [0.0 if piece is None or piece.mute else piece.value for piece in pieces]
    # The last piece is the rest, which holds the gauge: g·c − 1 = (g − 1) + g·(c − 1).
    gauge = report.get("gauge_scale", 1.0) - 1.0
    of_parts = full - gauge
    return values[-1] * gauge + np.minimum(min(values) * of_parts, max(values) * of_parts)


def _least(shares):
    """Return the least scale factor that these shares can make together."""
    together = {}
    for share in shares:
        together[share.parts] = together.get(share.parts, 0.0) + share.now
    return 1.0 + sum(change.min(initial=0.0) for change in together.values())


def _floor(shares):
    """Return the least scale factor that is in range: an outcome may itself be thinner than usual."""
    return min(LEAST_SCALE, *(1.0 + share.full.min(initial=0.0) for share in shares)) - _ROUNDING


def _within_sliders(values, keys):
    """Return the greatest share of `values`, at most 1, that all sliders can take."""
    ends = [
        key.slider_max if value > 0.0 else key.slider_min for value, key in zip(values, keys, strict=True)
    ]
    return min([1.0, *(end / value for end, value in zip(ends, values, strict=True) if value != 0.0)])


def _within_parts(values, mixed, others):
    """Return the greatest share of `values`, at most 1, at which no part is too thin, beside `others`."""

    def fits(share):
        shares = [m._replace(now=share * value * m.full) for m, value in zip(mixed, values, strict=True)]
        return _least(shares + others) >= _floor(mixed + others) + _ROUNDING

    if not fits(0.0):
        names = ", ".join(f"“{other.name}”" for other in others)
        raise Refusal(
            "The pieces of {names} already make a part thinner than a twentieth of itself. Put it "
            "together first, or set its pieces nearer to 0",
            names=names,
        )
    if fits(1.0):
        return 1.0
    # The least scale factor is concave along the way, so what fits is one interval from 0 on.
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if fits(middle) else (low, middle)
    return low
