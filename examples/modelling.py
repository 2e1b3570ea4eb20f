# SPDX-License-Identifier: GPL-3.0-or-later
"""Modelling by script: solids of quads with UVs, collected as loose parts of one mesh object.

Metres, z up, the front looks to -y, the floor is z = 0. UVs are in metres too.
"""

import bmesh
import bpy
import numpy as np
from mathutils import Vector

_UP = Vector((0, 0, 1))


def rounded_rectangle(half_x, half_y, radius, corner=4):
    """The outline of a rectangle with round corners, (4·(corner+1), 2), counterclockwise."""
    angles = np.linspace(0, np.pi / 2, corner + 1)
    arc = np.column_stack([np.cos(angles), np.sin(angles)]) * radius
    signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    quarters = []
    for i, (sx, sy) in enumerate(signs):
        turned = arc if i % 2 == 0 else arc[::-1]
        quarters.append((turned + np.array((half_x - radius, half_y - radius))) * (sx, sy))
    return np.concatenate(quarters)


def circle(sides):
    """The unit circle, (sides, 2), counterclockwise, no corner on the axes."""
    angles = (np.arange(sides) + 0.5) * 2 * np.pi / sides
    return np.column_stack([np.cos(angles), np.sin(angles)])


def rounding(thickness, radius, steps=3):
    """(inset, height) pairs up the side of a slab whose lower and upper edges are rounded."""
    angles = np.linspace(0, np.pi / 2, steps + 1)
    inset, height = radius * (1 - np.sin(angles)), radius * (1 - np.cos(angles))
    low = list(zip(inset, height, strict=True))
    return low + [(i, thickness - h) for i, h in reversed(low)]


class Model:
    """Collects loose parts for one object.

    `materials` is {name: (red, green, blue, metallic, roughness)}. A part is given the name of its material
    and, where wanted, of a vertex group.
    """

    def __init__(self, name, materials):
        self.name, self.materials = name, materials
        self.groups = []
        self.parts = []

    def loft(self, rings, material, group=None, loop=False, cut=None):
        """A closed solid through rings, (k, m, 3), counterclockwise seen from the last ring.

        With `loop` the last ring joins the first, else both ends are capped. `cut` makes loop cuts that far
        apart on all three axes.
        """
        rings = np.asarray(rings, float)
        count, sides = rings.shape[:2]
        part = bmesh.new()
        uv = part.loops.layers.uv.new("UVMap")
        verts = [[part.verts.new(p) for p in ring] for ring in rings]
        around = _lengths(np.concatenate([rings, rings[:, :1]], axis=1).swapaxes(0, 1))
        along = _lengths(np.concatenate([rings, rings[:1]]))
        for i in range(count if loop else count - 1):
            for j in range(sides):
                corners = ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))
                face = part.faces.new([verts[a % count][b % sides] for a, b in corners])
                for corner, (a, b) in zip(face.loops, corners, strict=True):
                    corner[uv].uv = (around[b], along[a])
        if not loop:
            for ring in (verts[0][::-1], verts[-1]):
                _project(part.faces.new(ring), uv)
        return self._add(part, material, group, cut)

    def block(self, low, high, material, bevel, group=None, cut=None):
        """A box between two corners with its edges bevelled."""
        low, high = Vector(low), Vector(high)
        part = bmesh.new()
        part.loops.layers.uv.new("UVMap")
        bmesh.ops.create_cube(part, size=1.0)
        for v in part.verts:
            v.co = (low + high) / 2 + v.co * (high - low)
        bmesh.ops.bevel(
            part,
            geom=part.edges[:],
            offset=bevel,
            offset_type="OFFSET",
            segments=2,
            profile=0.5,
            affect="EDGES",
            clamp_overlap=True,
        )
        for face in part.faces:
            _project(face, part.loops.layers.uv[0])
        return self._add(part, material, group, cut)

    def slab(self, outline, z, levels, material, group=None, cut=None):
        """A solid through level outlines: `outline(inset)` at z + height for each of `levels`."""
        rings = [np.column_stack([o := outline(inset), np.full(len(o), z + h)]) for inset, h in levels]
        return self.loft(rings, material, group, cut=cut)

    def tube(self, points, radii, material, sides=10, group=None):
        """A bar with a round section along points, with a radius at each, its ends slightly rounded."""
        points = [Vector(p) for p in points]
        first, last = (points[1] - points[0]).normalized(), (points[-2] - points[-1]).normalized()
        points[1:1] = [points[0] + first * 0.3 * radii[0]]
        points[-1:-1] = [points[-1] + last * 0.3 * radii[-1]]
        radii = [radii[0] * 0.75, *radii, radii[-1] * 0.75]
        side = None
        rings = []
        for i, (point, radius) in enumerate(zip(points, radii, strict=True)):
            way = (points[min(i + 1, len(points) - 1)] - points[max(i - 1, 0)]).normalized()
            if side is None:
                side = way.cross(_UP if abs(way.z) < 0.5 else Vector((0, 1, 0)))
            side = (side - way * side.dot(way)).normalized()
            up = way.cross(side)
            rings.append([point + (side * x + up * y) * radius for x, y in circle(sides)])
        return self.loft(rings, material, group)

    def lathe(self, profile, material, at=(0, 0, 0), axis=_UP, sides=24, group=None, loop=False):
        """A solid of revolution: (radius, height) pairs about `axis` through `at`, upwards on the outside."""
        turn = _UP.rotation_difference(Vector(axis))
        rings = [
            [Vector(at) + turn @ Vector((x * radius, y * radius, height)) for x, y in circle(sides)]
            for radius, height in profile
        ]
        return self.loft(rings, material, group, loop)

    def halve(self):
        """Cut everything at x = 0 and keep the right half, for a Mirror modifier."""
        for part in self.parts:
            _cut(part, 0, 0.0, clear=True)
            for v in part.verts:
                if abs(v.co.x) < 1e-5:
                    v.co.x = 0.0

    def paint(self, part, material, where):
        """Give the faces of a part whose centre answers to `where(centre)` another material."""
        index = list(self.materials).index(material)
        for face in part.faces:
            if where(face.calc_center_median()):
                face.material_index = index

    def finish(self, mirror=False, subdivisions=0):
        """Stand the object on the floor, link it into the scene, active and selected, and return it.

        The model is used up.
        """
        mesh = bpy.data.meshes.new(self.name)
        whole = bmesh.new()
        piece = bpy.data.meshes.new("piece")
        for part in self.parts:
            part.to_mesh(piece)
            part.free()
            whole.from_mesh(piece)
        bpy.data.meshes.remove(piece)
        floor = min(v.co.z for v in whole.verts)
        for v in whole.verts:
            v.co.z -= floor
        # Cuts leave the faces in an order that changes from run to run.
        whole.verts.index_update()
        whole.faces.sort(key=lambda f: f.verts[0].index * len(whole.verts) + f.verts[1].index)
        whole.to_mesh(mesh)
        whole.free()
        mesh.shade_smooth()
        mesh.set_sharp_from_angle(angle=np.radians(40))
        for name, (*color, metallic, roughness) in self.materials.items():
            mesh.materials.append(_material(name, color, metallic, roughness))
        obj = bpy.data.objects.new(self.name, mesh)
        for group in self.groups:
            obj.vertex_groups.new(name=group)
        if mirror:
            modifier = obj.modifiers.new("Mirror", "MIRROR")
            modifier.use_clip = True
            modifier.merge_threshold = 1e-4
        if subdivisions:
            modifier = obj.modifiers.new("Subdivision", "SUBSURF")
            modifier.levels, modifier.render_levels = subdivisions, subdivisions + 1
        bpy.context.scene.collection.objects.link(obj)
        for other in bpy.context.selected_objects:
            other.select_set(False)
        obj.select_set(True)
        bpy.context.view_layer.objects.active = obj
        return obj

    def _add(self, part, material, group, cut):
        if cut:
            for axis in range(3):
                at = [v.co[axis] for v in part.verts]
                steps = max(1, round((max(at) - min(at)) / cut))
                for k in range(1, steps):
                    _cut(part, axis, min(at) + (max(at) - min(at)) * k / steps)
        index = list(self.materials).index(material)
        for face in part.faces:
            face.material_index = index
        if group is not None:
            if group not in self.groups:
                self.groups.append(group)
            layer = part.verts.layers.deform.verify()
            for v in part.verts:
                v[layer][self.groups.index(group)] = 1.0
        self.parts.append(part)
        return part


def _cut(part, axis, at, clear=False):
    normal = Vector((0, 0, 0))
    normal[axis] = 1.0
    bmesh.ops.bisect_plane(
        part,
        geom=part.verts[:] + part.edges[:] + part.faces[:],
        dist=1e-5,
        plane_co=normal * at,
        plane_no=normal,
        clear_inner=clear,
    )


def _lengths(rows):
    """How far each of `rows`, (k, m, 3), lies from the first, row by row and on the average of its points."""
    steps = np.linalg.norm(np.diff(rows, axis=0), axis=2).mean(axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _project(face, uv):
    """Flat UVs along the axis that the face looks to most."""
    face.normal_update()
    axis = max(range(3), key=lambda a: abs(face.normal[a]))
    u, v = ((1, 2), (0, 2), (0, 1))[axis]
    for corner in face.loops:
        corner[uv].uv = (corner.vert.co[u], corner.vert.co[v])


def _material(name, color, metallic, roughness):
    material = bpy.data.materials.get(name)
    if material is None:
        material = bpy.data.materials.new(name)
        if material.node_tree is None:
            material.use_nodes = True
        material.diffuse_color = (*color, 1.0)
        shader = material.node_tree.nodes["Principled BSDF"]
        shader.inputs["Base Color"].default_value = (*color, 1.0)
        shader.inputs["Metallic"].default_value = metallic
        shader.inputs["Roughness"].default_value = roughness
    return material
