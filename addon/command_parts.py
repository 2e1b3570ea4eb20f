# SPDX-License-Identifier: GPL-3.0-or-later
"""`parts`: list the parts of one object."""

import bpy
import numpy as np

from . import parts
from .command_checks import DONE, named_collection, named_object, opened_file
from .properties import SPLITS, SYMMETRY


def add_to(commands):
    """Add the sub-command to the parser."""
    command = commands.add_parser(
        "parts",
        help="list the parts of one object, to be locked by name",
        description="List the parts of one object: what deform --lock takes.",
    )
    command.add_argument("--object", metavar="NAME", help="the object (default: the active one)")
    command.add_argument("--splits", choices=[item[0] for item in SPLITS], default="auto")
    command.add_argument("--symmetry", choices=[item[0] for item in SYMMETRY], default="auto")
    command.add_argument("--boxes", metavar="COLLECTION", help="as in deform")
    command.set_defaults(run=_parts)


def _parts(options):
    opened_file()
    obj = named_object(options.object)
    parts.find(obj, bpy.context, options.splits, options.symmetry, named_collection(options.boxes))
    boxes = parts.geometry(obj)["boxes"]
    for row, part in enumerate(obj.boxmorph.items):
        own = [2 * np.array(half) for _center, half, r in boxes if r == row]
        size = " × ".join(f"{extent:.3g}" for extent in own[0])
        print(f"{part.name}: {size}" + (" (two)" if len(own) == 2 else ""))
    return DONE
