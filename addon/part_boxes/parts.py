# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of an object: found on request, kept with the object, and locked by the user.

A part is one parameter row of the BoxDefGraph: a box, or two or four that mirror each other and scale alike.
What
is found is kept in `Object.boxmorph`, so that locks survive saving and undo.
"""

import colorsys
import hashlib
import json

import bpy
import numpy as np
from bpy.props import (
    BoolVectorProperty,
    CollectionProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)
from mathutils import Vector

from ..core import engine, mesh_io
from ..errors import Refusal
from ..redraw import redraw_viewports
from .parts_shown import holders
from .spanning import coarse_faces

#: Blender 4.2 as a Python module crashes when it ends if lists or properties with callbacks of ours are
#: registered. It has no interface that would need them.
OLD_MODULE = not bpy.app.binary_path and bpy.app.version < (4, 3, 0)

#: Splits where the user leaves their number to us.
AUTOMATIC_SPLITS = 4

#: A box is off the middle, and named for its side, beyond this share of half the object's size.
_OFF_CENTER = 0.25

#: Parts found again may differ from what was kept by this share of the object's size.
_SAME = 1e-4


class BoxmorphPart(bpy.types.PropertyGroup):
    """One part; its index is its parameter row. `name` is the group's own."""

    lock: BoolVectorProperty(
        name="Lock",
        description="Keep the part's size along this axis of the object, in searches from now on",
        size=3,
        subtype="XYZ",
    )
    color: FloatVectorProperty(
        name="Color", description="Color of the part's boxes", size=3, subtype="COLOR_GAMMA", min=0.0, max=1.0
    )


class BoxmorphParts(bpy.types.PropertyGroup):
    """The parts of an object."""

    items: CollectionProperty(type=BoxmorphPart)
    active: IntProperty(name="Part", description="The part that is chosen in the list", default=0)
    splits: IntProperty()
    symmetry: StringProperty()
    #: Triangles that span parts and are too long to be bent gently.
    coarse: IntProperty()
    #: JSON, in coordinates of the search: boxes [center, half size, part], tree edges [parent, child], the
    #: user's boxes, if any, as they were given, the place (3,3) of the object's own coordinates, the number
    #: of vertices, and which of them hold each box.
    geometry: StringProperty()


class Found:
    """The parts of a mesh: those of the user's boxes `given`, (b,2,3), where there are any, else our own."""

    def __init__(self, mesh, splits, symmetry, given=None):
        graph = engine.library().BoxDefGraph
        self.splits = AUTOMATIC_SPLITS if splits == "auto" else int(splits)
        self.given = None if given is None else np.float32(given)
        try:
            if self.given is None:
                self.graph = graph.build(mesh, splits=self.splits, symmetry=symmetry)
            else:
                center, half = (np.ascontiguousarray(self.given[:, i]) for i in (0, 1))
                self.graph = graph.from_boxes(mesh, center, half, symmetry=symmetry)
        except ValueError as error:
            raise Refusal(engine.sentence(error)) from error

    def geometry(self):
        """Return the boxes and the tree as plain lists."""
        graph = self.graph
        boxes = zip(graph.box_center, graph.box_half_size, graph.parameter_row_of_box, strict=True)
        return {
            "boxes": [[center.tolist(), half.tolist(), int(row)] for center, half, row in boxes],
            "tree": graph.tree_edges.tolist(),
            "given": None if self.given is None else self.given.tolist(),
        }


def find(obj, context, splits, symmetry, boxes=None):
    """Find the parts of `obj` and keep them with it; locks stay where as many parts are found again.

    `boxes`: a collection of mesh objects whose bounding boxes are the parts.
    """
    mesh_io.deformable(obj)
    arrays, mesh = engine.searched(obj, context)
    given = None if boxes is None else given_boxes(obj, boxes, arrays.place)
    found = Found(mesh, splits, symmetry, given)
    geometry = found.geometry() | {
        "place": arrays.place.tolist(),
        "vertices": len(arrays.vertices),
        "held": holders(arrays.vertices, found.graph),
    }
    kept = obj.boxmorph
    count = found.graph.parameter_rows
    locks = [tuple(part.lock) for part in kept.items] if len(kept.items) == count else [(False,) * 3] * count
    kept.items.clear()
    for row, (name, lock) in enumerate(zip(part_names(geometry["boxes"], count), locks, strict=True)):
        part = kept.items.add()
        part.name, part.lock = name, lock
        part.color = colorsys.hsv_to_rgb((0.58 + row * 0.618034) % 1.0, 0.65, 0.95)
    kept.active = min(kept.active, count - 1)
    kept.splits, kept.symmetry = found.splits, symmetry
    kept.coarse = len(coarse_faces(arrays.vertices, arrays.triangles, found.graph))
    kept.geometry = json.dumps(geometry)
    redraw_viewports()


def given_boxes(obj, collection, place):
    """Return center and half size of each box of a collection, (b,2,3), in coordinates of the search.

    `place`, (3,3), leads there from those of `obj`.
    """
    boxes = []
    for box in collection.all_objects:
        if box.type == "MESH" and box != obj:
            to_object = obj.matrix_world.inverted() @ box.matrix_world
            corners = np.array([to_object @ Vector(corner) for corner in box.bound_box]) @ place.T
            low, high = corners.min(0), corners.max(0)
            boxes.append(((low + high) / 2, (high - low) / 2))
    if not boxes:
        raise Refusal(
            "The collection “{collection}” holds no boxes. Put cubes around the parts of “{name}” into "
            "it, or clear the field",
            collection=collection.name,
            name=obj.name,
        )
    return np.array(boxes)


def forget(obj):
    """Forget the parts of `obj` and their locks."""
    obj.boxmorph.items.clear()
    obj.boxmorph.geometry = ""


def geometry(obj):
    """Return the kept boxes and tree of `obj`, or None."""
    if not obj.boxmorph.items or not obj.boxmorph.geometry:
        return None
    return json.loads(obj.boxmorph.geometry)


def locks(obj):
    """Return which part keeps its size on which axis, (P,3) bool; None where nothing is locked."""
    locked = np.array([tuple(part.lock) for part in obj.boxmorph.items], bool).reshape(-1, 3)
    return locked if locked.any() else None


def are_chosen(obj):
    """Whether the user locked parts of `obj` or gave its boxes, so that a search must keep to these parts."""
    return locks(obj) is not None or bool((geometry(obj) or {}).get("given"))


def kept_graph(obj, mesh):
    """Return the graph of the parts kept with `obj`. Raises Refusal if `mesh` has other parts now."""
    kept = obj.boxmorph
    then = geometry(obj)
    found = Found(mesh, kept.splits, kept.symmetry, then["given"])
    now, then = found.geometry()["boxes"], then["boxes"]
    if len(now) == len(then):
        now, then = (np.array([center + half for center, half, _row in boxes]) for boxes in (now, then))
        if np.abs(now - then).max() <= _SAME * np.abs(then).max():
            return found.graph
    raise Refusal(
        "“{name}” has changed since its parts were found. Find them again and check the locks, or forget "
        "them",
        name=obj.name,
    )


def identity(graph):
    """Return a hash of the parts of a graph: equal where the rows of two outcomes scale the same vertices."""
    arrays = (graph.box_center, graph.box_half_size, graph.parameter_row_of_box, graph.assignment)
    digest = hashlib.blake2b(digest_size=8)
    for array in arrays:
        digest.update(array.tobytes())
    return digest.hexdigest()


def part_names(boxes, count):
    """Return a name for each of `count` parts, from where its boxes lie: “Bottom Front Sides”."""
    centers = np.array([center for center, _half, _row in boxes])
    halves = np.array([half for _center, half, _row in boxes])
    rows = np.array([row for _center, _half, row in boxes])
    low, high = (centers - halves).min(0), (centers + halves).max(0)
    middle, reach = (low + high) / 2, np.maximum((high - low) / 2, 1e-12)
    if count == 1:
        return ["Whole"]
    names = []
    for row in range(count):
        own = np.flatnonzero(rows == row)
        x, y, z = (centers[own[0]] - middle) / reach
        words = []
        if halves[own[0]][2] < 0.7 * reach[2]:
            words.append("Top" if z > _OFF_CENTER else "Bottom" if z < -_OFF_CENTER else "Middle")
        pair = np.ptp(centers[own], axis=0)
        if pair[1] <= 1e-6 and abs(y) > _OFF_CENTER:
            words.append("Back" if y > 0 else "Front")
        if pair[0] > 1e-6 and pair[1] > 1e-6:
            words.append("Corners")
        elif pair[0] > 1e-6:
            words.append("Sides")
        elif pair[1] > 1e-6:
            words.append("Ends")
        elif abs(x) > _OFF_CENTER:
            words.append("Right" if x > 0 else "Left")
        names.append(" ".join(words) or "Body")
    return [
        name if names.count(name) == 1 else f"{name} {names[: i + 1].count(name)}"
        for i, name in enumerate(names)
    ]


classes = (BoxmorphPart, BoxmorphParts)


def register_object():
    """Attach the parts to every object."""
    bpy.types.Object.boxmorph = PointerProperty(type=BoxmorphParts)


def unregister_object():
    """Take the parts off the objects again."""
    del bpy.types.Object.boxmorph
