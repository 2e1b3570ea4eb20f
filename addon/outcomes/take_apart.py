# SPDX-License-Identifier: GPL-3.0-or-later
"""Take Apart: an outcome as one shape key per part and axis, which together equal it.

Positions follow scales and shifts linearly, so what each of them adds to the object at rest is a shape key
of its own. What the outcome has beyond that, its size and place, is another.
"""

from typing import NamedTuple

import numpy as np

from ..core import engine, mesh_io
from ..errors import Refusal
from ..part_boxes import parts
from . import animation_curves, shape_key

#: What moves nothing by this share of the object's size is no key of its own.
_VISIBLE = 1e-4

#: An outcome may differ from what its record makes by this share of its size.
_SAME = 1e-3

#: The sliders of a part scale it to no less and, unless the outcome itself does, no more than this.
_LEAST_SCALE, _GREATEST_SCALE = 0.05, 4.0

#: What scaling and shifting along x, y and z is called.
_SCALED = ("width", "depth", "height")
_SHIFTED = ("slides sideways", "slides back and forth", "slides up and down")
_REST = "size and place"


class Piece(NamedTuple):
    """What one part adds to the object along one axis."""

    label: str  #: “Bottom Corners height”
    change: np.ndarray  #: (n,) what it adds to the positions along the axis
    axis: int  #: of the search
    limits: tuple[float, float]  #: of the slider


def take_apart(obj, context, name):
    """Make the pieces of the outcome `name` of `obj` into shape keys at its value, set it to 0, and return
    their names. Raises Refusal, and then changes nothing.
    """
    mesh = obj.data
    key = mesh.shape_keys.key_blocks[name]
    report = shape_key.records(mesh)[name]
    if shape_key.pieces(mesh, name):
        raise Refusal("“{name}” is taken apart already. Put it together first", name=name)
    if animation_curves.is_animated(key):
        raise Refusal(
            "“{name}” is animated, and would move along with its pieces. Remove its keyframes or its "
            "driver first",
            name=name,
        )
    arrays, graph = _searched_again(obj, context, name, report)
    own = arrays.vertices if arrays.points is None else arrays.points
    shifted = report["shifts"] is not None
    if arrays.points is None:
        field = graph.field(with_shifts=shifted)
    else:
        field = graph.field_at(np.ascontiguousarray(own), with_shifts=shifted)
    gauged = _gauged(own, field, report)
    change = mesh_io.key_positions(key) - mesh_io.key_positions(key.relative_key)
    _require_same(obj, context, name, report, arrays, graph, arrays.to_object(gauged - own) - change)
    size = np.linalg.norm(np.ptp(arrays.vertices, axis=0))
    found = [
        piece for piece in _pieces(graph, field, report) if np.abs(piece.change).max() >= _VISIBLE * size
    ]
    if not found and np.abs(change).max() < _VISIBLE * size:
        raise Refusal(
            "“{name}” changes nothing that could be seen, so there is nothing to take apart",
            name=name,
        )
    return _make_keys(obj, name, found, np.linalg.inv(arrays.place).astype(np.float32), change)


def put_together(obj, name):
    """Remove the pieces of the outcome `name` of `obj` and show it again at the value that it had; return
    how many pieces were not found: deleted or renamed ones.
    """
    mesh = obj.data
    if not shape_key.is_apart(mesh, name):
        raise Refusal("“{name}” is not taken apart", name=name)
    missing, value = shape_key.remove_pieces(obj, name)
    mesh.shape_keys.key_blocks[name].value = value
    mesh.update()
    return missing


def _searched_again(obj, context, name, report):
    """Return the ObjectArrays of `obj` and the graph that the outcome was found with."""
    if not {"scales", "shifts", "splits", "gauge_scale", "gauge_shift"} <= report.keys():
        raise Refusal(
            "“{name}” has no record of its parts. Search again, then take that apart",
            name=name,
        )
    under_modifiers = "modifiers_depart" in report
    arrays, mesh = engine.searched(obj, context, bare=not under_modifiers)
    if report["splits"] is not None:
        options = {key: report[key] for key in ("splits", "symmetry", "boundary")}
        try:
            graph = engine.library().BoxDefGraph.build(mesh, **options)
        except ValueError as error:
            raise Refusal(engine.sentence(error)) from error
    elif parts.geometry(obj) is None:
        raise Refusal(
            "The parts that “{name}” was found with have been forgotten. Find or give them again",
            name=name,
        )
    else:
        graph = parts.kept_graph(obj, mesh)
    if graph.parameter_rows != len(report["scales"]) or under_modifiers != (arrays.points is not None):
        raise _changed(obj, name)
    return arrays, graph


def _changed(obj, name):
    return Refusal(
        "“{name}”, its parts or the shape key “{outcome}” have changed since the search, so that it "
        "cannot be told which part does what. Undo the change, or search again",
        name=obj.name,
        outcome=name,
    )


def _factors(report):
    """Return what each row of the field is multiplied by, (R,3): scale changes, then shifts."""
    return np.concatenate([np.array(report["scales"]) - 1.0, np.array(report["shifts"] or np.empty((0, 3)))])


def _gauged(rest, field, report):
    """Return the positions (n,3) that the record makes of those at rest, by their field (3,R,n)."""
    factors = _factors(report)
    moved = np.stack([rest[:, a] + factors[:, a].astype(np.float32) @ field[a] for a in range(3)], axis=1)
    return np.float32(report["gauge_scale"]) * moved + np.float32(report["gauge_shift"])


def _require_same(obj, context, name, report, arrays, graph, off):
    """Raise Refusal unless the outcome is what its record makes.

    `off`, (n,3): by how much its key is not. Under modifiers the key was corrected, and what is seen of it
    is compared, which may be as far off as the record says.
    """
    allowed = _SAME
    if report.get("modifiers_depart") is not None:
        rest, shifted = arrays.vertices, report["shifts"] is not None
        expected = arrays.to_object(_gauged(rest, graph.field(with_shifts=shifted), report))
        with mesh_io.as_modelled(obj, context, obj.data.shape_keys.key_blocks.find(name)) as mesh:
            off = mesh_io.mesh_positions(mesh)
        if len(off) != len(expected):
            raise _changed(obj, name)
        off, allowed = off - expected, allowed + report["modifiers_depart"]
    size = np.linalg.norm(np.ptp(arrays.to_object(arrays.vertices), axis=0))
    if not np.linalg.norm(off, axis=1).max() <= allowed * size:
        raise _changed(obj, name)


def _pieces(graph, field, report):
    """Yield the Piece of each part and axis, in the order of parts."""
    boxes = [
        [center, half, row]
        for center, half, row in zip(
            graph.box_center, graph.box_half_size, graph.parameter_row_of_box, strict=True
        )
    ]
    count = graph.parameter_rows
    names = parts.part_names(boxes, count)
    factors, room = _factors(report), graph.shift_room()
    for part in range(count):
        for row, words in ((part, _SCALED), (part + count, _SHIFTED)):
            for axis in range(3) if row < len(factors) else ():
                factor = factors[row, axis]
                if factor == 0.0:
                    continue
                bounds = room[part, axis] if row != part else (_LEAST_SCALE - 1.0, _GREATEST_SCALE - 1.0)
                change = np.float32(report["gauge_scale"] * factor) * field[axis, row]
                yield Piece(f"{names[part]} {words[axis]}", change, axis, _limits(factor, bounds))


def _limits(factor, bounds):
    """Return the values between which value · factor lies within the bounds; 0 and 1 are always among
    them.
    """
    low, high = sorted(float(bound) / factor for bound in bounds)
    return min(low, 0.0), max(high, 1.0)


def _make_keys(obj, name, found, to_object, change):
    """Make the keys of the pieces that were found, and of the rest of the outcome's `change`, (n,3)."""
    keys = obj.data.shape_keys
    outcome = keys.key_blocks[name]
    value, active = outcome.value, obj.active_shape_key_index
    basis = mesh_io.basis_positions(obj.data)
    left = change.astype(np.float64)
    made = []

    def make(label, positions, limits):
        key = obj.shape_key_add(name=shape_key.piece_name(name, label), from_mix=False)
        key.relative_key = keys.reference_key
        key.points.foreach_set("co", np.ascontiguousarray(positions, np.float32).ravel())
        shape_key.set_limits(key, min(limits[0], value), max(limits[1], value))
        key.value, key.mute, key.vertex_group = value, outcome.mute, outcome.vertex_group
        made.append(key.name)

    for piece in found:
        positions = basis + piece.change[:, None] * to_object[:, piece.axis]
        left -= positions - basis
        make(piece.label, positions, piece.limits)
    make(_REST, basis + left, (outcome.slider_min, outcome.slider_max))
    shape_key.keep_pieces(obj.data, name, made, value)
    outcome.value = 0.0
    obj.active_shape_key_index = active
    obj.data.update()
    return made
