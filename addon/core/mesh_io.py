# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender objects to arrays: what may be deformed, and the positions and triangles of it.

Coordinates are object coordinates, z up, unless said otherwise. Nothing here changes the object for longer
than one call.
"""

from contextlib import contextmanager
from typing import NamedTuple

import bpy
import numpy as np

from ..errors import Refusal

#: Modifiers that bend the mesh away from its modelled shape. They are left out of what is split and scored:
#: parts are found on the object as it was modelled, not as it is posed.
POSING = frozenset(
    "ARMATURE CAST CLOTH CORRECTIVE_SMOOTH CURVE HOOK LAPLACIANDEFORM LATTICE MESH_CACHE MESH_DEFORM "
    "MESH_SEQUENCE_CACHE SHRINKWRAP SIMPLE_DEFORM SOFT_BODY SURFACE_DEFORM WARP WAVE".split()
)


class ObjectArrays(NamedTuple):
    """What a search needs of an object, in coordinates of the search.

    They are scaled as the object is seen, and may be turned about z so that its own axes lie along x and y.
    """

    vertices: np.ndarray  #: (n,3) float32 of the mesh that is seen, without its pose
    triangles: np.ndarray  #: (m,3) int32 into `vertices`
    points: np.ndarray | None  #: (k,3) float32 Basis positions; None where `vertices` are these already
    place: np.ndarray  #: (3,3) float32 from the object's own coordinates to these: place @ v
    left_out: tuple[str, ...]  #: names of the posing modifiers that were left out

    def to_object(self, positions):
        """Return positions (n,3) of the search in the object's own coordinates."""
        return positions @ np.linalg.inv(self.place).T.astype(np.float32)

    def turned(self, angle):
        """Return the same arrays turned about z by `angle`."""
        if angle == 0.0:
            return self
        cos, sin = np.cos(angle), np.sin(angle)
        turn = np.array([(cos, -sin, 0), (sin, cos, 0), (0, 0, 1)], np.float32)
        points = None if self.points is None else self.points @ turn.T
        return self._replace(vertices=self.vertices @ turn.T, points=points, place=turn @ self.place)


def deformable(obj):
    """Return `obj` if a shape key can be written on it. Raises Refusal with the reason otherwise."""
    own_mesh(obj)
    if obj.mode != "OBJECT":
        raise Refusal(
            "“{name}” is in {mode} Mode. Go to Object Mode first",
            name=obj.name,
            mode=_noun(obj.mode).title(),
        )
    keys = obj.data.shape_keys
    if keys is not None and not keys.use_relative:
        raise Refusal(
            "“{name}” has absolute shape keys, which play one after another. Turn on Relative in its "
            "shape key panel first",
            name=obj.name,
        )
    if len(obj.data.vertices) == 0:
        raise Refusal("The mesh of “{name}” is empty", name=obj.name)
    return obj


def own_mesh(obj):
    """Return `obj` if it is a mesh object of this file. Raises Refusal otherwise."""
    if obj is None:
        raise Refusal("There is no active object. Select the object to deform")
    if obj.type != "MESH":
        raise Refusal(
            "“{name}” is a {kind}, not a mesh. Convert it to a mesh first",
            name=obj.name,
            kind=_noun(obj.type),
        )
    if obj.override_library or obj.library or obj.data.library or not obj.data.is_editable:
        raise Refusal(
            "The mesh of “{name}” is linked from another file, where changes would be lost. Make the "
            "object and its data local first (Object > Relations > Make Local)",
            name=obj.name,
        )
    return obj


def object_arrays(obj, context, bare=False):
    """Return the ObjectArrays of a deformable object; with `bare`, without its modifiers. Raises Refusal for
    a mesh that has no usable surface.
    """
    base = basis_positions(obj.data)
    _require_finite(base, obj)
    shown = [modifier for modifier in obj.modifiers if modifier.show_viewport]
    left_out = tuple(modifier.name for modifier in shown if modifier.type in POSING)
    scale = _uneven_scale(obj)
    if bare or len(shown) == len(left_out):
        arrays = ObjectArrays(base * scale, mesh_triangles(obj.data), None, np.diag(scale), left_out)
    else:
        with as_modelled(obj, context) as mesh:
            vertices = mesh_positions(mesh) * scale
            arrays = ObjectArrays(vertices, mesh_triangles(mesh), base * scale, np.diag(scale), left_out)
    _require_surface(arrays.vertices, arrays.triangles, obj)
    return arrays


def shown_arrays(obj, context):
    """Return positions (n,3) float32 times scale and triangles (m,3) int32 as the viewport shows them now."""
    if obj.mode == "EDIT":
        raise Refusal("“{name}” is in Edit Mode. Go to Object Mode first", name=obj.name)
    evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    try:
        vertices, triangles = mesh_positions(mesh) * _uneven_scale(obj), mesh_triangles(mesh)
    finally:
        evaluated.to_mesh_clear()
    _require_surface(vertices, triangles, obj)
    return vertices, triangles


def mesh_positions(mesh):
    """Return the vertex positions of `mesh`, (n,3) float32. Not for a mesh in Edit Mode."""
    out = np.empty(len(mesh.vertices) * 3, np.float32)
    if out.size:
        mesh.attributes["position"].data.foreach_get("vector", out)
    return out.reshape(-1, 3)


def basis_positions(mesh):
    """Return the undeformed positions, (n,3) float32: the reference key's where there are shape keys."""
    if mesh.shape_keys is None:
        return mesh_positions(mesh)
    return key_positions(mesh.shape_keys.reference_key)


def key_positions(key):
    """Return the positions that a shape key holds, (n,3) float32."""
    out = np.empty(len(key.points) * 3, np.float32)
    key.points.foreach_get("co", out)
    return out.reshape(-1, 3)


def mesh_triangles(mesh):
    """Return the triangles of `mesh`, (m,3) int32 vertex indices; polygons are cut as Blender draws them."""
    corners = len(mesh.loops)
    if corners == 0:
        return np.empty((0, 3), np.int32)
    if corners == 3 * len(mesh.polygons):
        out = np.empty(corners, np.int32)
        mesh.attributes[".corner_vert"].data.foreach_get("value", out)
    else:
        mesh.calc_loop_triangles()
        out = np.empty(len(mesh.loop_triangles) * 3, np.int32)
        mesh.loop_triangles.foreach_get("vertices", out)
    return out.reshape(-1, 3)


@contextmanager
def as_modelled(obj, context, key_index=0):
    """Give the evaluated mesh of `obj` with its Basis, or another key at 1, pinned and its posing modifiers
    off; undo both afterwards.
    """
    if obj.name not in context.view_layer.objects:
        raise Refusal(
            "“{name}” is not in the view layer “{layer}”, so its modifiers cannot be evaluated. Enable "
            "its collection first",
            name=obj.name,
            layer=context.view_layer.name,
        )
    pinned, active = obj.show_only_shape_key, obj.active_shape_key_index
    posing = [m for m in obj.modifiers if m.show_viewport and m.type in POSING]
    hidden = obj.hide_viewport
    evaluated = None
    try:
        if obj.data.shape_keys is not None:
            obj.show_only_shape_key, obj.active_shape_key_index = True, key_index
        for modifier in posing:
            modifier.show_viewport = False
        if hidden:
            obj.hide_viewport = False
        evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
        yield evaluated.to_mesh()
    finally:
        if evaluated is not None:
            evaluated.to_mesh_clear()
        for modifier in posing:
            modifier.show_viewport = True
        if hidden:
            obj.hide_viewport = True
        obj.show_only_shape_key, obj.active_shape_key_index = pinned, active


def _require_finite(positions, obj):
    bad = int((~np.isfinite(positions)).any(axis=1).sum())
    if bad:
        raise Refusal(
            "{count} of the {total} vertices of “{name}” have coordinates that are not numbers. Delete "
            "or move them first",
            count=bad,
            total=len(positions),
            name=obj.name,
        )


def _require_surface(vertices, triangles, obj):
    _require_finite(vertices, obj)
    if len(triangles) == 0:
        raise Refusal(
            "The mesh of “{name}” has no faces, so there is nothing to see or to split",
            name=obj.name,
        )
    corners = vertices[triangles].astype(np.float64)
    corners -= corners.min(axis=(0, 1))
    size = corners.max()
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    if size == 0.0 or np.linalg.norm(normals, axis=1).sum() <= 1e-9 * size * size:
        raise Refusal(
            "The faces of “{name}” have no area, so there is nothing to see or to split",
            name=obj.name,
        )


def _uneven_scale(obj):
    """Return the object's scale in the world, (3,) float32; ones where it is even, which no view shows."""
    scale = np.abs(np.array(obj.matrix_world.to_scale(), np.float32))
    if scale.min() < 1e-6 or scale.max() < scale.min() * 1.0001:
        return np.ones(3, np.float32)
    return scale


def object_by_uid(uid, name):
    """Return the object of this session_uid, or None. `name` is only where to look first."""
    obj = bpy.data.objects.get(name)
    if obj is not None and obj.session_uid == uid:
        return obj
    return next((obj for obj in bpy.data.objects if obj.session_uid == uid), None)


def _noun(identifier):
    return identifier.replace("_", " ").lower()
