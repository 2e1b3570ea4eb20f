# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a search, from the record of its outcome: what is needed to search the same again."""

from . import wordings

#: What outcomes were searched with before there was a choice.
_DEFAULTS = wordings.DEFAULTS | {"seconds": 20.0}

#: Seeds of Blender's properties end here.
_SEEDS = 2**31


def settings_of(record):
    """Return what an outcome was searched with, by the names of SearchProperties.

    Of records that do not hold what was asked, what came of it is taken: the number of splits that won and
    the symmetry that was found.
    """
    asked = record.get("asked")
    if asked is not None:
        return _DEFAULTS | asked
    least, greatest = record["scale_range"]
    return _DEFAULTS | {
        "prompt": record["prompt"],
        "preset": record["preset"],
        "seed": record["seed"],
        "splits": "auto" if record["splits"] is None else str(record["splits"]),
        "symmetry": record["symmetry"],
        "keep_size": "auto",
        "least_scale": least,
        "greatest_scale": greatest,
        "shift_parts": record["shifts"] is not None,
    }


def next_seed(seed, steps=1):
    """Return the seed `steps` after this one."""
    return (seed + steps) % _SEEDS
