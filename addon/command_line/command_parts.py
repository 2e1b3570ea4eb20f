# SPDX-License-Identifier: GPL-3.0-or-later
"""`parts`: list the parts of one object, and draw them in the colors of the list."""

import colorsys
import os

import bpy
import numpy as np

from ..core import engine, images
from ..operators.properties import SPLITS, SYMMETRY
from ..outcomes import shape_key
from ..part_boxes import parts, spanning
from .command_checks import DONE, named_collection, named_object, opened_file, require_writable

#: What is said of parts with mirror images, by the number of their boxes.
_MIRRORED = {2: " (two)", 4: " (four)"}

#: Names of hues, from red around the circle.
_HUES = "red orange yellow lime green mint cyan azure blue violet magenta rose".split()


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
    command.add_argument(
        "--sheet",
        metavar="FILE.png",
        help="write the four views in the colors of the parts, with the colors in the list's order below",
    )
    command.set_defaults(run=_parts)


def _parts(options):
    opened_file()
    obj = named_object(options.object)
    if options.sheet is not None:
        require_writable(options.sheet)
    parts.find(obj, bpy.context, options.splits, options.symmetry, named_collection(options.boxes))
    boxes = parts.geometry(obj)["boxes"]
    colors = _colors(obj)
    split = "" if options.boxes else f"{_counted(obj.boxmorph.splits, 'split')}, "
    print(f"boxmorph: {split}{_counted(len(boxes), 'box', 'boxes')}, {_counted(len(colors), 'part')}")
    for row, (part, color) in enumerate(zip(obj.boxmorph.items, colors, strict=True)):
        own = [2 * np.array(half) for _center, half, r in boxes if r == row]
        size = " × ".join(f"{extent:.3g}" for extent in own[0])
        print(f"{part.name}: {size}{_MIRRORED.get(len(own), '')}, {color_name(color)}")
    if obj.boxmorph.coarse:
        name, report = shape_key.meant_outcome(obj)
        clauses = spanning.clauses(obj.boxmorph.coarse, report.get("worst_shear"))
        print(f"boxmorph: {'; '.join(clauses)}" + (f" in “{name}”" if len(clauses) > 1 else ""))
    if options.sheet is not None:
        images.save_png(_sheet(obj, colors), os.path.abspath(options.sheet))
    return DONE


def _colors(obj):
    """Return the colors of the parts in the list's order, (P,3) uint8."""
    return np.uint8([[round(255 * channel) for channel in part.color] for part in obj.boxmorph.items])


def _sheet(obj, colors):
    """Return the four views in these colors, (P,3) uint8; a face that spans parts has their mean."""
    arrays, mesh = engine.searched(obj, bpy.context)
    graph = parts.kept_graph(obj, mesh)
    corners = colors[graph.parameter_row_of_box[graph.assignment][arrays.triangles]]
    faces = np.rint(corners.mean(axis=1)).astype(np.uint8)
    row = images.colored_row(engine.library(), arrays.vertices, arrays.triangles, faces)
    return images.stack([row, images.swatches(colors, row.shape[1])])


def color_name(color):
    """Return a color, three numbers to 255, as the name of its hue and its digits: “blue #54a0f2”."""
    hue = colorsys.rgb_to_hsv(*(int(channel) / 255 for channel in color))[0]
    name = _HUES[round(hue * len(_HUES)) % len(_HUES)]
    return f"{name} #{color[0]:02x}{color[1]:02x}{color[2]:02x}"


def _counted(count, noun, nouns=None):
    return f"{count} {noun if count == 1 else nouns or noun + 's'}"
