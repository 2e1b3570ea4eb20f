# SPDX-License-Identifier: GPL-3.0-or-later
"""Variations of an outcome: keys beside it, numbered from 2, each with a record of its own."""

import numpy as np

from .shape_key import (
    keep_record,
    numbered_name,
    outcomes,
    pieces,
    records,
    remove_outcome,
    remove_pieces,
    set_limits,
)

#: In the record of a variation: the name of the outcome that it varies.
VARIATION_OF = "variation_of"


def variations(mesh, name):
    """Return the names of the variations of the outcome `name` of `mesh`, in order."""
    return [other for other, report in records(mesh).items() if report.get(VARIATION_OF) == name]


def keep_variations(obj, name, found):
    """Make keys at value 0 of what else was `found` beside the outcome `name`, in place of its earlier
    variations; return their names. Each is a tuple of positions, (n,3) float32, slider limits, and report.
    """
    blocks = obj.data.shape_keys.key_blocks
    earlier = variations(obj.data, name)
    names = []
    for number, (positions, slider_min, slider_max, report) in enumerate(found, 2):
        wanted = numbered_name(name, number)
        if wanted in earlier:
            earlier.remove(wanted)
            remove_pieces(obj, wanted)
            key = blocks[wanted]
        else:
            key = obj.shape_key_add(name=wanted, from_mix=False)
        key.points.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
        key.relative_key = obj.data.shape_keys.reference_key
        set_limits(key, slider_min, slider_max)
        key.value, key.mute = 0.0, False
        keep_record(obj.data, key.name, report | {VARIATION_OF: name})
        names.append(key.name)
    for other in earlier:
        remove_outcome(obj, other)
    obj.active_shape_key_index = blocks.find(name)
    obj.data.update()
    return names


def show_only(obj, name):
    """Set the outcome `name` to 1, or its pieces where it was taken apart, and all other outcomes to 0."""
    for key in outcomes(obj.data):
        parted = pieces(obj.data, key.name)
        for shown in parted or [key]:
            shown.value = 1.0 if key.name == name else 0.0
        if parted:
            key.value = 0.0
    obj.active_shape_key_index = obj.data.shape_keys.key_blocks.find(name)
