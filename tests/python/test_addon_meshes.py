# SPDX-License-Identifier: MIT OR Apache-2.0
"""Meshes as people have them, in Blender: n-gons with holes, objects turned in their own space, odd units."""

import json

import addon_blender as blender
import numpy as np
import pytest
from mathutils import Matrix

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def outcome(obj):
    """Deform the active object; return the key's positions and the record."""
    blender.deform(PROMPT)
    keys = obj.data.shape_keys
    return blender.positions(keys.key_blocks[PROMPT]), json.loads(keys["boxmorph"])[PROMPT]


def holed_stool():
    """Add a stool whose seat is, above and below, two n-gons bent about a round hole to carry it by."""
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    n, half = len(turn), len(turn) // 2
    rings = [np.insert(circle * r, 2, z, axis=1) for z in (0.46, 0.5) for r in (0.2, 0.06)]
    halves = [
        [*range(half + 1), *range(n + half, n - 1, -1)],
        [*range(half, n), 0, n, *range(2 * n - 1, n + half - 1, -1)],
    ]
    upper = [[2 * n + i for i in face] for face in halves]
    rims = [
        (a + i, a + (i + 1) % n, b + (i + 1) % n, b + i)
        for a, b in ((0, 2 * n), (3 * n, n))
        for i in range(n)
    ]
    vertices, faces = np.concatenate(rings), [face[::-1] for face in halves] + upper + rims
    corners = np.array([(x, y, z) for z in (0, 0.46) for y in (-0.02, 0.02) for x in (-0.02, 0.02)])
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    for x, y in ((-0.1, -0.1), (0.1, -0.1), (-0.1, 0.1), (0.1, 0.1)):
        faces += [[len(vertices) + i for i in side] for side in sides]
        vertices = np.concatenate([vertices, corners + np.array((x, y, 0))])
    return blender.add("Stool", vertices, faces), n


def test_ngons_with_holes_keep_their_holes():
    obj, n = holed_stool()
    before = blender.fingerprint(obj)
    triangles = blender.addon("mesh_io").mesh_triangles(obj.data)
    rest = blender.evaluated_positions(obj)
    corners = rest[triangles[(triangles < 2 * n).all(axis=1)]][..., :2]
    edges = corners[:, 1:] - corners[:, :1]
    areas = np.abs(edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0]) / 2
    ring = n / 2 * np.sin(2 * np.pi / n) * (0.2**2 - 0.06**2)
    assert areas.sum() == pytest.approx(ring, rel=1e-4), "the hole is covered, or part of the seat is not"
    key, record = outcome(obj)
    assert blender.fingerprint(obj) == before
    assert record["boxes"] > 1 and record["score_after"] > record["score_before"]
    rim, hole = (np.linalg.norm(key[i * n : (i + 1) * n, :2], axis=1) for i in (0, 1))
    assert hole.max() < 0.6 * rim.min() and hole.min() > 0.01


@pytest.mark.parametrize("degrees", [45.0, -20.0])
def test_an_object_turned_in_its_own_space_is_deformed_along_its_own_axes(degrees):
    _, expected = outcome(blender.chair())
    blender.empty_scene()
    obj = blender.chair()
    turn = Matrix.Rotation(np.radians(degrees), 4, "Z")
    obj.data.transform(turn)
    rest = blender.evaluated_positions(obj)
    key, record = outcome(obj)
    for name in ("boxes", "parameter_rows"):
        assert record[name] == expected[name]
    assert record["score_after"] > expected["score_after"] - 0.1
    # Still its own mirror image: as wide to one side of its own axis as to the other.
    along = np.array(turn)[:3, :3]
    moved, sides = (key - rest) @ along, rest @ along
    left, right = (np.abs(moved[side, 0]).max() for side in (sides[:, 0] < -1e-3, sides[:, 0] > 1e-3))
    assert np.isclose(left, right, atol=1e-3)


@pytest.mark.parametrize("unit", [1e-6, 1e6])
def test_millionths_and_millions_of_a_unit_are_deformed_alike(unit):
    expected, _ = outcome(blender.chair())
    blender.empty_scene()
    obj = blender.chair()
    obj.data.transform(Matrix.Scale(unit, 4))
    key, record = outcome(obj)
    assert record["score_after"] > record["score_before"] + 0.05
    assert np.abs(key / unit - expected).max() < 0.02
