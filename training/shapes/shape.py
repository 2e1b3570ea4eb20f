# SPDX-License-Identifier: MIT OR Apache-2.0
"""A shape of labelled parts, and what a search may do to it: scale part by part, children following."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Part:
    """One solid: label, vertices (n, 3), triangles (m, 3), and where it meets its parent's label."""

    label: str
    vertices: np.ndarray
    faces: np.ndarray
    attach: np.ndarray
    parent: str | None


@dataclass
class Shape:
    """Parts in order, the root first.

    `traits` are facts that scaling cannot change; `damage` is 0 (whole) to 1.
    """

    family: str
    parts: list = field(default_factory=list)
    traits: dict = field(default_factory=dict)
    damage: float = 0.0

    def add(self, label, solid, attach=(0, 0, 0), parent=None):
        self.parts.append(Part(label, *solid, np.asarray(attach, float), parent))

    def add_pair(self, label, solid, attach=(0, 0, 0), parent=None):
        """The solid and its mirror image in x = 0."""
        vertices, faces = solid
        self.add(label, solid, attach, parent)
        self.add(label, (vertices * (-1, 1, 1), faces[:, ::-1]), np.asarray(attach) * (-1, 1, 1), parent)

    def points(self, *labels):
        """All vertices of the labels, (n, 3), or None where the shape has no such part."""
        found = [p.vertices for p in self.parts if p.label in labels]
        return np.concatenate(found) if found else None

    def mesh(self):
        """Vertices (n, 3) float32 and triangles (m, 3) uint32 of all parts as separate islands."""
        vertices, faces, count = [], [], 0
        for p in self.parts:
            vertices.append(p.vertices)
            faces.append(p.faces + count)
            count += len(p.vertices)
        return (
            np.ascontiguousarray(np.concatenate(vertices), np.float32),
            np.ascontiguousarray(np.concatenate(faces), np.uint32),
        )


def scale_parts(shape, rng, reach):
    """Scale the parts by label as the boxes of a graph are scaled, in place.

    A part keeps the point where it meets its parent. Labels may share their parent's box, and the parts of
    one label may lie in one box or in one each. `reach` is 0 (nothing) to 1 (factors 0.3 to 3.1).
    """
    labels = list(dict.fromkeys(p.label for p in shape.parts))
    parent = {p.label: p.parent for p in shape.parts}
    together = {label: rng.random() < 0.5 for label in labels}
    factor = {}
    for label in labels:
        if parent[label] in factor and rng.random() < 0.25:
            factor[label] = factor[parent[label]]
            together[label] = True
        else:
            log = rng.uniform(np.log(0.3), np.log(3.1), 3) * reach
            log[rng.random(3) < 0.35] = 0.0
            factor[label] = np.exp(log)
    moved = {}
    for p in shape.parts:
        attach = p.attach
        if together[p.label]:
            attach = np.mean([q.attach for q in shape.parts if q.label == p.label], 0)
        own = factor[p.label]
        side = np.sign(p.attach[0])
        base_factor, base_move = np.ones(3), np.zeros(3)
        if p.parent in factor:
            base_factor, base_move = (
                factor[p.parent],
                moved.get((p.parent, side), moved.get((p.parent, 0.0), base_move)),
            )
        move = base_move + (base_factor - own) * attach
        moved.setdefault((p.label, side), move)
        p.vertices = p.vertices * own + move


def warp(shape, rng, reach):
    """Stretch slices of the whole along z or y (and x about its middle) by different factors, in place."""
    for axis in (0, 1, 2):
        if rng.random() < 0.5:
            continue
        points = np.concatenate([p.vertices[:, axis] for p in shape.parts])
        low, high = points.min(), points.max()
        cuts = np.sort(rng.uniform(low, high, 2))
        if axis == 0:
            cuts = np.array([-1, 1]) * abs(cuts[0])
        knots = np.array([low - 1e-6, *cuts, high + 1e-6])
        steps = np.diff(knots) * np.exp(rng.uniform(-1.1, 1.1, 3) * reach)
        if axis == 0:
            steps[2] = steps[0]
        target = np.concatenate([[0], np.cumsum(steps)])
        target -= target.mean() if axis == 0 else 0
        for p in shape.parts:
            p.vertices[:, axis] = np.interp(p.vertices[:, axis], knots, target)


def break_parts(shape, rng):
    """Lose, shift or tilt one part that is not the root, in place; the damage is noted for the targets."""
    loose = [i for i, p in enumerate(shape.parts) if p.parent]
    if not loose:
        return
    i = int(rng.choice(loose))
    part = shape.parts[i]
    size = np.ptp(np.concatenate([p.vertices for p in shape.parts]), 0)
    share = min(1.0, np.linalg.norm(np.ptp(part.vertices, 0) / size) / 1.2)
    kind = rng.integers(3)
    if kind == 0:
        del shape.parts[i]
        shape.damage = max(shape.damage, 0.5 * share + 0.2)
    elif kind == 1:
        part.vertices = part.vertices + rng.normal(0, 0.12, 3) * size
        shape.damage = max(shape.damage, 0.4 * share + 0.2)
    else:
        shear = np.eye(3) + rng.normal(0, 0.25, (3, 3)) * (1 - np.eye(3))
        part.vertices = (part.vertices - part.attach) @ shear + part.attach
        shape.damage = max(shape.damage, 0.3 * share + 0.15)


def roughen(shape, rng):
    """Small global squeeze and vertex noise that change no kind, in place."""
    squeeze = np.exp(rng.normal(0, 0.025, 3))
    size = np.ptp(np.concatenate([p.vertices for p in shape.parts]), 0).max()
    noise = size * abs(rng.normal(0, 0.0012)) * (rng.random() < 0.5)
    for p in shape.parts:
        p.vertices = p.vertices * squeeze + rng.normal(0, 1, p.vertices.shape) * noise
