# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarse faces that span parts, cut at the parts' boundaries where the user asks for it.

A face that belongs to two parts shears when they scale differently. Two cuts, one on either side of the
boundary, leave that to a narrow band.
"""

from itertools import permutations

import bmesh
import numpy as np
from mathutils import Vector

from ..core import mesh_io
from ..errors import Refusal
from . import parts, spanning

#: Half the width of the band, as a share of half the object's diagonal.
BAND = 0.02

#: Cuts nearer to a vertex than this share of half the diagonal go through it.
_THROUGH = 1e-4


def refine(obj):
    """Cut the mesh of `obj` on either side of its parts' boundaries; return how many faces were added.

    UVs, materials, groups, attributes, custom normals and shape keys are kept: new vertices take what lies
    between their neighbours.
    """
    mesh_io.deformable(obj)
    geometry = parts.geometry(obj)
    if geometry is None:
        raise Refusal("The parts of “{name}” are not known yet. Find them first", name=obj.name)
    mesh = obj.data
    before = len(mesh.polygons)
    reach = spanning.reach(mesh_io.basis_positions(mesh))
    bm = bmesh.new()
    bm.from_mesh(mesh)
    normals = _keep_normals(bm, mesh)
    place = np.array(geometry["place"])
    cuts = _cuts(geometry["boxes"], reach)
    faces = _crossed_by_any(mesh, cuts, place, reach)
    bm.faces.ensure_lookup_table()
    faces = [bm.faces[index] for index in faces]
    for cut in cuts:
        _bisect(bm, faces, cut, place, reach)
    if len(bm.faces) > before:
        bm.to_mesh(mesh)
        _restore_normals(mesh, normals)
        mesh.update()
    bm.free()
    return len(mesh.polygons) - before


def _cuts(boxes, reach):
    """Return (low, high, axis, place) of the cuts: a plane, and the box that it is kept to.

    Where one box ends and another begins, two go along the boundary, and others around it.
    """
    bounds = [(np.array(center) - half, np.array(center) + half) for center, half, _row in boxes]
    band = BAND * reach
    cuts = []

    def add(low, high, axis, place):
        def is_same(cut):
            g, h, a, p = cut
            across = np.arange(3) != axis
            return axis == a and abs(place - p) < band / 2 and ((low < h) & (high > g))[across].all()

        if not any(map(is_same, cuts)):
            cuts.append((low, high, axis, place))

    for (below_low, below_high), (above_low, above_high) in permutations(bounds, 2):
        low, high = np.maximum(below_low, above_low) - band, np.minimum(below_high, above_high) + band
        for axis in range(3):
            across = np.arange(3) != axis
            if abs(below_high[axis] - above_low[axis]) > 2 * band or not (high > low)[across].all():
                continue
            place = (below_high[axis] + above_low[axis]) / 2
            near_low, near_high = low.copy(), high.copy()
            near_low[axis], near_high[axis] = place - band, place + band
            add(near_low, near_high, axis, place - band)
            add(near_low, near_high, axis, place + band)
            for other in np.flatnonzero(across):
                add(near_low, near_high, other, low[other])
                add(near_low, near_high, other, high[other])
    return cuts


def _crossed(least, most, cut, reach):
    """Whether a cut goes through faces whose corners lie between `least` and `most`, (n,3)."""
    low, high, axis, at = cut
    across = np.arange(3) != axis
    crossed = (least[:, axis] < at - _THROUGH * reach) & (most[:, axis] > at + _THROUGH * reach)
    return crossed & ((least <= high) & (most >= low))[:, across].all(axis=1)


def _crossed_by_any(mesh, cuts, place, reach):
    """Return the indices of the faces that one of the cuts goes through: the only ones to be looked at."""
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.attributes[".corner_vert"].data.foreach_get("value", corners)
    starts = np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("loop_start", starts)
    positions = (mesh_io.mesh_positions(mesh) @ place.T)[corners]
    least, most = (ends.reduceat(positions, starts, axis=0) for ends in (np.minimum, np.maximum))
    masks = [_crossed(least, most, cut, reach) for cut in cuts]
    return np.flatnonzero(np.any(masks, axis=0)) if masks else []


def _bisect(bm, faces, cut, place, reach):
    """Bisect those of `faces` that a cut goes through, and add what they fall into to the list."""
    if not faces:
        return
    starts = np.cumsum([0] + [len(face.verts) for face in faces[:-1]])
    corners = np.array([vertex.co[:] for face in faces for vertex in face.verts]) @ place.T
    least, most = (ends.reduceat(corners, starts, axis=0) for ends in (np.minimum, np.maximum))
    through = [faces[index] for index in np.flatnonzero(_crossed(least, most, cut, reach))]
    if not through:
        return
    edges = {edge for face in through for edge in face.edges}
    vertices = {vertex for face in through for vertex in face.verts}
    _low, _high, axis, at = cut
    normal = Vector(place[axis])
    pieces = bmesh.ops.bisect_plane(
        bm,
        geom=[*vertices, *edges, *through],
        dist=_THROUGH * reach,
        plane_co=normal * (at / normal.length_squared),
        plane_no=normal,
    )
    known = set(faces)
    faces += [
        piece for piece in pieces["geom"] if isinstance(piece, bmesh.types.BMFace) and piece not in known
    ]


def _keep_normals(bm, mesh):
    """Note custom normals at the face corners, where they are interpolated; return the layer's name."""
    if not mesh.has_custom_normals:
        return None
    layer = bm.loops.layers.float_vector.new("boxmorph normals")
    bm.faces.ensure_lookup_table()
    for polygon in mesh.polygons:
        for loop, index in zip(bm.faces[polygon.index].loops, polygon.loop_indices, strict=True):
            loop[layer] = mesh.corner_normals[index].vector
    return layer.name


def _restore_normals(mesh, name):
    if name is None:
        return
    attribute = mesh.attributes[name]
    normals = np.empty(len(mesh.loops) * 3, np.float32)
    attribute.data.foreach_get("vector", normals)
    mesh.attributes.remove(attribute)
    mesh.normals_split_custom_set(normals.reshape(-1, 3))
