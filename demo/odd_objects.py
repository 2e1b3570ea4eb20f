# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects as people really have them, one for each kind of odd mesh in docs/meshes.md.

Each function builds one object, active and selected, and returns it. Metres unless the kind says
otherwise, z up, the front looks to -y, the floor is z = 0.
"""

import bpy
import numpy as np

from examples import aeroplane

_CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
_SIDES = {
    "bottom": (0, 2, 3, 1),
    "top": (4, 5, 7, 6),
    "front": (0, 1, 5, 4),
    "back": (2, 6, 7, 3),
    "left": (0, 4, 6, 2),
    "right": (1, 3, 7, 5),
}


class Pieces:
    """Collects loose pieces, vertices (n, 3) and polygons, for one object."""

    def __init__(self):
        self.vertices, self.faces = np.empty((0, 3)), []

    def add(self, vertices, faces):
        """Add a piece."""
        first = len(self.vertices)
        self.vertices = np.concatenate([self.vertices, np.asarray(vertices, float)])
        self.faces += [tuple(int(i) + first for i in face) for face in faces]

    def box(self, low, high, without=(), taper=1.0):
        """A box of eight vertices, some sides left out, its lower end narrowed to `taper`."""
        low, high = np.array(low, float), np.array(high, float)
        corners = low + _CORNERS * (high - low)
        middle = (low + high)[:2] / 2
        corners[:4, :2] = middle + (corners[:4, :2] - middle) * taper
        self.add(corners, [side for name, side in _SIDES.items() if name not in without])

    def sheet(self, *corners):
        """One polygon without thickness."""
        self.add(corners, [range(len(corners))])

    def lathe(self, profile, at=(0, 0, 0), axis=2, sides=16):
        """A closed solid of revolution: (radius, height) pairs about an axis, upwards on the outside."""
        turn = (np.arange(sides) + 0.5) * 2 * np.pi / sides
        rings = [np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(sides, h)]) for r, h in profile]
        # Cyclic, so that a turned piece keeps its winding.
        vertices = np.roll(np.concatenate(rings), axis - 2, axis=1) + at
        faces = [range(sides)[::-1], range((len(rings) - 1) * sides, len(rings) * sides)]
        for i in range(len(rings) - 1):
            for j in range(sides):
                a, b = i * sides + j, i * sides + (j + 1) % sides
                faces.append((a, b, b + sides, a + sides))
        self.add(vertices, faces)

    def prism(self, outline, low, high, axis=1):
        """A solid between two copies of an outline, (n, 2): in x and z for axis 1, in x and y for axis 2."""
        n = len(outline)
        flat = [np.insert(np.asarray(outline, float), axis, level, axis=1) for level in (low, high)]
        around = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
        self.add(np.concatenate(flat), [range(n)[::-1], range(n, 2 * n), *around])

    def object(self, name):
        """Link the object into the scene."""
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(self.vertices.tolist(), [], self.faces)
        obj = bpy.data.objects.new(name, mesh)
        bpy.context.scene.collection.objects.link(obj)
        for other in bpy.context.selected_objects:
            other.select_set(False)
        obj.select_set(True)
        bpy.context.view_layer.objects.active = obj
        return obj


def open_shells():
    """A sideboard as a game has it: no underside, no back, doors that are a front and a rim, hollow feet."""
    p = Pieces()
    p.box((-0.75, -0.22, 0.18), (0.75, 0.22, 0.68), without=("bottom", "back"))
    p.box((-0.8, -0.25, 0.68), (0.8, 0.24, 0.72), without=("bottom",))
    for x in (-0.5, 0, 0.5):
        p.box((x - 0.22, -0.245, 0.22), (x + 0.22, -0.22, 0.64), without=("back",))
        p.box((x + 0.14, -0.27, 0.4), (x + 0.17, -0.245, 0.5), without=("back",))
    for x in (-0.68, 0.68):
        for y in (-0.16, 0.16):
            p.box((x - 0.035, y - 0.035, 0), (x + 0.035, y + 0.035, 0.18), ("bottom", "top"), 0.6)
    return p.object("Sideboard")


def planes():
    """A writing desk cut from card: every board one polygon without thickness."""
    p = Pieces()
    p.sheet((-0.7, -0.35, 0.74), (0.7, -0.35, 0.74), (0.7, 0.35, 0.74), (-0.7, 0.35, 0.74))
    p.sheet((-0.6, 0.28, 0.45), (0.6, 0.28, 0.45), (0.6, 0.28, 0.74), (-0.6, 0.28, 0.74))
    for x in (-0.6, 0.6):
        p.sheet((x, -0.3, 0), (x, 0.3, 0), (x, 0.3, 0.74), (x, -0.3, 0.74))
    return p.object("Card Desk")


def intersecting_shells():
    """A sofa of blocks pushed into each other."""
    p = Pieces()
    p.box((-0.95, -0.4, 0.12), (0.95, 0.42, 0.34))
    p.box((-0.98, 0.2, 0.2), (0.98, 0.44, 0.84))
    for x in (-0.93, 0.93):
        p.box((x - 0.13, -0.46, 0.1), (x + 0.13, 0.4, 0.6))
        for y in (-0.32, 0.32):
            p.lathe([(0.025, 0), (0.045, 0.2)], (0.9 * x, y, 0), sides=10)
    for x in (-0.42, 0.42):
        p.box((x - 0.44, -0.43, 0.28), (x + 0.44, 0.26, 0.46))
        p.box((x - 0.4, 0.08, 0.4), (x + 0.4, 0.26, 0.78))
    return p.object("Sofa")


def loose_parts():
    """A garden bench of some fifty loose slats, rails, posts and bolts."""
    p = Pieces()
    for i in range(8):
        y = -0.24 + 0.066 * i
        p.box((-0.75, y, 0.42), (0.75, y + 0.05, 0.445))
        for x in (-0.66, 0.66):
            p.box((x - 0.012, y + 0.013, 0.445), (x + 0.012, y + 0.037, 0.455))
    for i in range(5):
        z = 0.52 + 0.075 * i
        p.box((-0.75, 0.245, z), (0.75, 0.27, z + 0.055))
        for x in (-0.66, 0.66):
            p.box((x - 0.012, 0.235, z + 0.015), (x + 0.012, 0.245, z + 0.04))
    for x in (-0.66, 0.66):
        p.box((x - 0.03, 0.27, 0), (x + 0.03, 0.33, 0.9))
        p.box((x - 0.03, -0.24, 0), (x + 0.03, -0.18, 0.62))
        p.box((x - 0.025, -0.18, 0.36), (x + 0.025, 0.27, 0.42))
        p.box((x - 0.045, -0.26, 0.62), (x + 0.045, 0.24, 0.645))
        p.box((x - 0.02, -0.18, 0.12), (x + 0.02, 0.27, 0.16))
    return p.object("Garden Bench")


def coarse():
    """A chair of boxes, eight vertices to a leg."""
    p = Pieces()
    p.box((-0.23, -0.23, 0.43), (0.23, 0.23, 0.48))
    for x in (-0.2, 0.2):
        p.box((x - 0.025, -0.225, 0), (x + 0.025, -0.175, 0.43), taper=0.7)
        p.box((x - 0.025, 0.175, 0), (x + 0.025, 0.225, 0.43), taper=0.7)
        p.box((x - 0.02, 0.185, 0.48), (x + 0.02, 0.225, 0.92))
    for z in (0.6, 0.72, 0.84):
        p.box((-0.18, 0.19, z), (0.18, 0.215, z + 0.07))
    return p.object("Chair")


def non_manifold():
    """A pigeonhole cabinet of single walls that share edges, three and four to an edge, on crossed feet."""
    p = Pieces()
    xs, zs = np.linspace(-0.6, 0.6, 5), np.linspace(0.22, 1.0, 4)
    grid = [(x, y, z) for y in (-0.2, 0.2) for z in zs for x in xs]
    at = {corner: i for i, corner in enumerate((i, j, k) for k in (0, 1) for j in range(4) for i in range(5))}
    floors = [
        (at[i, j, 0], at[i + 1, j, 0], at[i + 1, j, 1], at[i, j, 1]) for j in range(4) for i in range(4)
    ]
    walls = [(at[i, j, 0], at[i, j, 1], at[i, j + 1, 1], at[i, j + 1, 0]) for j in range(3) for i in range(5)]
    backs = [
        (at[i, j, 1], at[i + 1, j, 1], at[i + 1, j + 1, 1], at[i, j + 1, 1])
        for j in range(3)
        for i in range(4)
    ]
    p.add(grid, floors + walls + backs)
    for x in (-0.53, 0.53):
        for y in (-0.14, 0.14):
            ends = [(x, y), *((x + a, y + b) for a, b in ((0.05, 0), (0, 0.05), (-0.05, 0), (0, -0.05)))]
            low, high = ([(*end, z) for end in ends] for z in (0, 0.22))
            p.add(low + high, [(0, k, k + 5, 5) for k in (1, 2, 3, 4)])
    return p.object("Pigeonholes")


def duplicate_vertices():
    """A table lamp from an STL file: every triangle has corners of its own, and some vertices are lost."""
    p = Pieces()
    p.lathe([(0.1, 0), (0.1, 0.015), (0.012, 0.02), *((0.012, z) for z in np.linspace(0.04, 0.34, 9))])
    p.lathe([(r, 0.26 + (0.16 - r) * 18 / 7) for r in np.linspace(0.16, 0.09, 5)], sides=24)
    vertices, faces = [], []
    for face in p.faces:
        for i in range(1, len(face) - 1):
            faces.append(range(len(vertices), len(vertices) + 3))
            vertices += [p.vertices[face[k]] for k in (0, i, i + 1)]
    lost = np.random.default_rng(0).uniform(-0.4, 0.4, (30, 3))
    q = Pieces()
    q.add([*vertices, *lost, (0, 0, 90)], faces)
    return q.object("Table Lamp")


def flipped_normals():
    """The example airliner with every third face inside out."""
    made = aeroplane.build()
    mesh = bpy.data.meshes.new_from_object(made.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    p = Pieces()
    faces = [tuple(f.vertices)[:: -1 if f.index % 3 == 0 else 1] for f in mesh.polygons]
    p.add([v.co for v in mesh.vertices], faces)
    bpy.data.objects.remove(made)
    return p.object("Airliner")


def ngons():
    """A guitar whose front and back are two n-gons each, bent about the sound hole."""
    turn = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    waist = 0.19 - 0.045 * np.cos(turn) + 0.035 * np.cos(2 * turn) ** 3
    outline = np.column_stack([np.sin(turn) * waist, 0.25 - 0.25 * np.cos(turn)])
    hole = np.column_stack([0.045 * np.sin(turn), 0.33 - 0.045 * np.cos(turn)])
    p = Pieces()
    n = len(turn)
    rings = [np.insert(ring, 1, y, axis=1) for y in (-0.05, 0.05) for ring in (outline, hole)]
    front = [
        [*range(n // 2 + 1), *range(n + n // 2, n - 1, -1)],
        [*range(n // 2, n), 0, n, *range(2 * n - 1, n + n // 2 - 1, -1)],
    ]
    back = [range(2 * n, 3 * n)]
    rim = [(i, (i + 1) % n, 2 * n + (i + 1) % n, 2 * n + i) for i in range(n)]
    p.add(np.concatenate(rings), front + back + rim)
    p.box((-0.028, -0.065, 0.4), (0.028, -0.05, 0.5))
    p.box((-0.028, -0.065, 0.5), (0.028, -0.03, 0.92))
    p.box((-0.045, -0.06, 0.92), (0.045, -0.035, 1.08))
    for x in (-0.055, 0.055):
        for z in (0.95, 1.0, 1.05):
            p.box((x - 0.014, -0.055, z - 0.008), (x + 0.014, -0.04, z + 0.008))
    p.box((-0.075, -0.065, 0.15), (0.075, -0.05, 0.17))
    return p.object("Guitar")


def turned():
    """A double bed that was modelled at 45 degrees to its own axes."""
    p = Pieces()
    p.box((-0.8, -1.0, 0.22), (0.8, 1.0, 0.34))
    p.box((-0.76, -0.97, 0.34), (0.76, 0.97, 0.52))
    p.box((-0.8, 0.98, 0.2), (0.8, 1.04, 0.95))
    for x in (-0.36, 0.36):
        p.box((x - 0.3, 0.55, 0.52), (x + 0.3, 0.93, 0.62))
    for x in (-0.76, 0.76):
        for y in (-0.95, 0.98):
            p.box((x - 0.04, y - 0.04, 0), (x + 0.04, y + 0.04, 0.22))
    x, y, z = p.vertices.T
    p.vertices = np.column_stack([(x - y) * np.sqrt(0.5), (x + y) * np.sqrt(0.5), z])
    return p.object("Bed")


def _car(length=1.0):
    """A saloon along y, its front to -y."""
    p = Pieces()
    side = [(-2.2, 0.3), (2.2, 0.3), (2.25, 0.85), (1.5, 0.95), (-1.0, 0.95), (-2.2, 0.75)]
    glass = [(-1.0, 0.95), (1.5, 0.95), (1.0, 1.42), (-0.35, 1.42)]
    for outline, half in ((side, 0.85), (glass, 0.7)):
        p.prism([(-y * length, z) for y, z in outline], -half, half)
    for x in (-1.4 * length, 1.35 * length):
        for y in (-0.86, 0.86):
            p.lathe([(0.3, -0.1), (0.33, -0.08), (0.33, 0.08), (0.3, 0.1)], (x, 0, 0.33), axis=1, sides=20)
            p.vertices[-80:, 1] += y
    x, y, z = p.vertices.T
    p.vertices = np.column_stack([y, -x, z])
    return p


def symmetric_on_y():
    """A car that drives along x, so that its sides mirror about y."""
    p = _car()
    p.vertices = p.vertices[:, [1, 0, 2]] * (1, -1, 1)
    return p.object("Car")


def symmetric_on_two():
    """A dining table: a top and four legs, its sides alike and its front and back alike."""
    p = Pieces()
    p.box((-0.8, -0.45, 0.7), (0.8, 0.45, 0.74))
    p.box((-0.7, -0.36, 0.62), (0.7, 0.36, 0.7))
    for x in (-0.7, 0.7):
        for y in (-0.36, 0.36):
            p.box((x - 0.04, y - 0.04, 0), (x + 0.04, y + 0.04, 0.7), taper=0.6)
    return p.object("Table")


def symmetric_on_none():
    """A desk with drawers on one side and two legs on the other."""
    p = Pieces()
    p.box((-0.75, -0.35, 0.71), (0.75, 0.35, 0.75))
    p.box((0.3, -0.32, 0.08), (0.7, 0.32, 0.71))
    for i in range(3):
        p.box((0.32, -0.34, 0.11 + 0.2 * i), (0.68, -0.32, 0.29 + 0.2 * i))
        p.box((0.44, -0.36, 0.19 + 0.2 * i), (0.56, -0.34, 0.21 + 0.2 * i))
    for y in (-0.3, 0.3):
        p.box((-0.71, y - 0.03, 0), (-0.65, y + 0.03, 0.71))
        p.box((0.33, y - 0.02, 0), (0.37, y + 0.02, 0.08))
        p.box((0.63, y - 0.02, 0), (0.67, y + 0.02, 0.08))
    return p.object("Desk")


def plain_box():
    """A trunk that is one box."""
    p = Pieces()
    p.box((-0.45, -0.25, 0), (0.45, 0.25, 0.45))
    return p.object("Trunk")


def sphere():
    """A globe lamp that is one ball."""
    p = Pieces()
    turn = np.linspace(0, np.pi, 17)[1:-1]
    p.lathe([(0.2 * np.sin(t), 0.2 - 0.2 * np.cos(t)) for t in turn], sides=32)
    return p.object("Ball")


def very_flat():
    """An aeroplane cut from card, 30 cm across and a fifth of a millimetre thick."""
    p = Pieces()
    body = [(0, -0.16), (0.011, -0.14), (0.014, -0.05), (0.014, 0.03), (0.01, 0.14)]
    p.prism([*body, *((-x, y) for x, y in body[:0:-1])], 0, 0.0002, axis=2)
    for side in (1, -1):
        for plan in (
            [(0.014, -0.05), (0.15, -0.01), (0.15, 0.015), (0.014, 0.02)],
            [(0.01, 0.1), (0.055, 0.125), (0.055, 0.14), (0.01, 0.14)],
        ):
            p.prism([(side * x, y) for x, y in plan][::side], 0, 0.0002, axis=2)
    return p.object("Card Aeroplane")


def very_long():
    """A street lamp, nine metres tall on a pole as thick as an arm."""
    p = Pieces()
    p.lathe([(0.28, 0), (0.28, 0.1), (0.16, 0.2), (0.14, 0.8), (0.05, 0.9)], sides=12)
    p.lathe([(0.05, z) for z in np.linspace(0.9, 8, 24)], sides=12)
    p.lathe([(0.06, 7.95), (0.34, 8.75), (0.42, 8.8), (0.08, 9.0), (0.03, 9.2)], sides=12)
    return p.object("Street Lamp")


def very_small():
    """A car whose file is in another unit: four millionths of a unit long."""
    p = _car()
    p.vertices *= 1e-6
    return p.object("Tiny Car")


def very_large():
    """A rocket whose file is in another unit: two million units tall."""
    p = Pieces()
    profile = [(0.13, 0), (0.16, 0.12), (0.16, 0.15), (0.17, 1.3), (0.15, 1.55), (0.1, 1.78), (0.03, 1.93)]
    p.lathe(profile, (0, 0, 0.08), sides=24)
    for k in range(4):
        a = np.radians(90 * k)
        out, side = np.array((np.cos(a), np.sin(a))), np.array((-np.sin(a), np.cos(a)))
        plan = [(0.14, 0.55), (0.4, 0.25), (0.4, 0.0), (0.14, 0.2)]
        ring = [[(*(out * r + side * s), z) for r, z in plan] for s in (-0.015, 0.015)]
        around = [(i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i) for i in range(4)]
        p.add(np.concatenate(ring), [range(4)[::-1], range(4, 8), *around])
    p.vertices *= 1e6
    return p.object("Rocket")
