# SPDX-License-Identifier: MIT OR Apache-2.0
"""Closed solids as (vertices (n, 3) float, triangles (m, 3) int): everything is a loft of rings.

Coordinates are z up, x left-right, y front-back, in any unit.
"""

import numpy as np


def loft(rings, caps=True):
    """Skin k rings of n points each, given as (k, n, 3).

    With `caps` both ends are closed by fans about their means, without it the surface stays open.
    """
    rings = np.asarray(rings, float)
    k, n, _ = rings.shape
    vertices = np.concatenate([rings.reshape(-1, 3), rings[:1].mean(1), rings[-1:].mean(1)])
    i = np.arange(n)
    j = (i + 1) % n
    faces = []
    for a in range(k - 1):
        p, q = a * n, (a + 1) * n
        faces.append(np.stack([p + i, p + j, q + j], 1))
        faces.append(np.stack([p + i, q + j, q + i], 1))
    if caps:
        start, end = k * n, k * n + 1
        faces.append(np.stack([np.full(n, start), j, i], 1))
        faces.append(np.stack([np.full(n, end), (k - 1) * n + i, (k - 1) * n + j], 1))
    else:
        vertices = vertices[:-2]
    faces = np.concatenate(faces)
    a, b, c = (vertices[faces[:, m]] for m in range(3))
    if np.einsum("ij,ij->i", a, np.cross(b, c)).sum() < 0:
        faces = faces[:, ::-1]
    return vertices, faces


def outline(sides, roundness=2.0, phase=0.0):
    """Unit closed curve (sides, 2): a superellipse of the given exponent, 2 a circle, large a square."""
    t = np.linspace(0, 2 * np.pi, sides, endpoint=False) + phase
    c, s = np.cos(t), np.sin(t)
    r = (np.abs(c) ** roundness + np.abs(s) ** roundness) ** (-1 / roundness)
    return np.stack([c * r, s * r], 1)


def rounded_rectangle(half_x, half_y, radius, steps=3):
    """Rectangle outline with corner arcs, (4 * steps, 2), counter-clockwise."""
    radius = min(radius, 0.98 * half_x, 0.98 * half_y)
    t = np.linspace(0, np.pi / 2, steps)
    corners = [(1, 1, 0), (-1, 1, np.pi / 2), (-1, -1, np.pi), (1, -1, 1.5 * np.pi)]
    points = [
        np.stack(
            [
                sx * (half_x - radius) + radius * np.cos(t + a),
                sy * (half_y - radius) + radius * np.sin(t + a),
            ],
            1,
        )
        for sx, sy, a in corners
    ]
    return np.concatenate(points)


def slab(plan, z0, z1, bevel=0.0, center=(0.0, 0.0), crown=0.0, divisions=1):
    """Prism over a plan outline (n, 2) about the origin from z0 to z1.

    Its edges are bevelled, its top bulges by `crown`.
    """
    plan = np.asarray(plan, float)
    reach = np.abs(plan).max(0)
    bevel = min(bevel, 0.49 * abs(z1 - z0), 0.45 * reach.min())
    shrink = 1 - bevel / reach
    levels = [(z0, shrink), (z0 + bevel, 1.0)] if bevel > 0 else [(z0, 1.0)]
    levels += [(z0 + (z1 - z0) * d / divisions, 1.0) for d in range(1, divisions)]
    levels += (
        [(z1 - bevel, 1.0), (z1 - 0.3 * bevel, (1 + shrink) / 2), (z1, shrink)] if bevel > 0 else [(z1, 1.0)]
    )
    if crown > 0:
        levels += [(z1 + crown * 0.7, 0.6 * shrink), (z1 + crown, 0.25 * shrink)]
    rings = [np.column_stack([plan * s + center, np.full(len(plan), z)]) for z, s in levels]
    return loft(rings)


def block(low, high, bevel=0.0, corner=None):
    """Box between two corners with bevelled edges.

    `corner` is the plan's corner radius (the bevel when None).
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    half = (high - low) / 2
    if bevel <= 0 and not corner:
        plan = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * half[:2]
    else:
        plan = rounded_rectangle(half[0], half[1], bevel if corner is None else corner)
    return slab(plan, low[2], high[2], bevel, (low[:2] + high[:2]) / 2)


def cushion(center, half, roundness=4.0, sides=16, rings=7):
    """Superellipsoid of the given half size: 2 is an ellipsoid, larger is boxier."""
    plan = outline(sides, roundness, np.pi / sides)
    w = np.sin(np.linspace(-0.47 * np.pi, 0.47 * np.pi, rings))
    z = np.sign(w) * np.abs(w) ** 0.8
    r = np.maximum(1 - np.abs(z) ** roundness, 0.02) ** (1 / roundness)
    return loft(
        [
            np.column_stack([plan * rr, np.full(sides, zz)]) * half + center
            for rr, zz in zip(r, z, strict=False)
        ]
    )


def bar(start, end, size_start, size_end=None, sides=4, bow=None, steps=2):
    """Straight or bowed bar between two points.

    Sizes are (half_a, half_b) or one number, `bow` is the offset half-way.
    """
    start, end = np.asarray(start, float), np.asarray(end, float)
    size_end = size_start if size_end is None else size_end
    sa, sb = np.broadcast_to(size_start, 2).astype(float), np.broadcast_to(size_end, 2).astype(float)
    bow = np.zeros(3) if bow is None else np.asarray(bow, float)
    steps = max(steps, 5) if bow.any() else steps
    axis = np.argmax(np.abs(end - start))
    u, v = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
    if axis == 1:
        u, v = v, u
    ring = outline(sides, 2.0, np.pi / sides) * (np.sqrt(2) if sides == 4 else 1.0)
    rings = []
    for t in np.linspace(0, 1, steps):
        size = sa + (sb - sa) * t
        center = start + (end - start) * t + bow * 4 * t * (1 - t)
        rings.append(center + ring[:, :1] * size[0] * u + ring[:, 1:] * size[1] * v)
    return loft(rings)


def lathe(profile, center=(0.0, 0.0), sides=16, squash=(1.0, 1.0), roundness=2.0, caps=True):
    """Surface of revolution about z from (radius, z) pairs; `squash` scales x and y, `caps` closes the ends.

    A profile may turn back on itself, as the wall of a cup does.
    """
    plan = outline(sides, roundness, np.pi / sides) * np.asarray(squash)
    return loft([np.column_stack([plan * r + center, np.full(sides, z)]) for r, z in profile], caps)


def tube(path, size, sides=8, caps=True):
    """A round tube along (k, 3) points in any directions; `size` is its radius, one number or one a point."""
    path = np.asarray(path, float)
    size = np.broadcast_to(size, len(path))
    along = np.gradient(path, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    side = np.eye(3)[np.argmin(np.abs(along).max(0))]
    rings = []
    for p, t, r in zip(path, along, size, strict=True):
        side = side - t * (side @ t)
        side /= max(np.linalg.norm(side), 1e-12)
        ring = outline(sides, 2.0, np.pi / sides) * r
        rings.append(p + ring[:, :1] * side + ring[:, 1:] * np.cross(t, side))
    return loft(rings, caps)


def airfoil(count=10):
    """Closed wing section (n, 2): chord from 0 to 1, half thickness about 0.5 at its thickest."""
    x = (1 - np.cos(np.linspace(0, np.pi, count))) / 2
    t = 1.6 * (np.sqrt(x) * 0.9 - 0.4 * x - 0.5 * x**2) + 0.02 * (1 - x)
    upper = np.column_stack([x, t])
    lower = np.column_stack([x[1:-1], -0.7 * t[1:-1]])
    return np.concatenate([upper, lower[::-1]])


def wing(root, tip, root_chord, tip_chord, thickness, steps=5, vertical=False, curve=1.0):
    """Lifting surface from leading-edge root to leading-edge tip; the chord runs towards +y.

    `thickness` is relative to the chord; `vertical` makes a fin; `curve` bends the taper.
    """
    section = airfoil()
    root, tip = np.asarray(root, float), np.asarray(tip, float)
    normal = np.array([1.0, 0, 0]) if vertical else np.array([0, 0, 1.0])
    rings = []
    for t in np.linspace(0, 1, steps):
        chord = root_chord + (tip_chord - root_chord) * t**curve
        lead = root + (tip - root) * t
        rings.append(
            lead
            + section[:, :1] * chord * np.array([0, 1.0, 0])
            + section[:, 1:] * chord * thickness * normal
        )
    return loft(rings)


def upright_slab(plan, y0, y1, bevel=0.0):
    """Prism over an outline in x and z, from y0 to y1."""
    v, f = slab(plan, y0, y1, bevel)
    return np.ascontiguousarray(v[:, [0, 2, 1]]), f[:, ::-1]


def fit(solid, low, high):
    """The solid stretched to fill the box between two corners."""
    v, f = solid
    low, high = np.asarray(low, float), np.asarray(high, float)
    return (v - v.min(0)) / np.maximum(np.ptp(v, 0), 1e-9) * (high - low) + low, f
