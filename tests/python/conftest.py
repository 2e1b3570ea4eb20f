# SPDX-License-Identifier: MIT OR Apache-2.0
"""Meshes and data that several tests share."""

import json
import pathlib

import numpy as np
import pytest

REFERENCE = pathlib.Path(__file__).resolve().parents[2] / ".." / "shared" / "reference"


def cuboid(low, high):
    """Vertices (8, 3) and triangles (12, 3) of an axis-aligned box."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
    vertices = np.asarray(low, np.float32) + corners * (
        np.asarray(high, np.float32) - np.asarray(low, np.float32)
    )
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return vertices, np.array(triangles, np.int32)


def subdivided(vertices, triangles, times):
    """Every triangle cut into four, `times` times; shared edges stay shared."""
    for _ in range(times):
        edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        unique, inverse = np.unique(edges, axis=0, return_inverse=True)
        middle = inverse.reshape(-1, 3).astype(np.int32) + len(vertices)
        vertices = np.concatenate([vertices, vertices[unique].mean(axis=1)]).astype(np.float32)
        (a, b, c), (ab, bc, ca) = triangles.T, middle.T
        triangles = np.concatenate(
            [np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
        )
    return np.ascontiguousarray(vertices), np.ascontiguousarray(triangles.astype(np.int32))


def joined(parts):
    """One mesh of several islands."""
    vertices, triangles, count = [], [], 0
    for v, t in parts:
        vertices.append(v)
        triangles.append(t + count)
        count += len(v)
    return np.concatenate(vertices).astype(np.float32), np.concatenate(triangles).astype(np.int32)


@pytest.fixture(scope="session")
def chair():
    """A dining chair of six islands, z up, front −y, seat 0.45 m high."""
    legs = [
        cuboid((x - 0.02, y - 0.02, 0), (x + 0.02, y + 0.02, 0.42))
        for x in (-0.18, 0.18)
        for y in (-0.18, 0.18)
    ]
    seat = cuboid((-0.22, -0.22, 0.41), (0.22, 0.22, 0.46))
    back = cuboid((-0.21, 0.18, 0.455), (0.21, 0.22, 0.95))
    return joined([subdivided(*part, 2) for part in (*legs, seat, back)])


@pytest.fixture(scope="session")
def guide():
    """The embedded guide, opened once."""
    import boxmorph

    return boxmorph.Guide.open()


@pytest.fixture(scope="session")
def reference():
    """The index of the reference data; a test that asks for it is skipped where it is missing."""
    if not (REFERENCE / "index.json").is_file():
        pytest.skip("the reference data is not beside the project")
    return json.loads((REFERENCE / "index.json").read_text())["shapes"]


def reference_mesh(shape):
    """Vertices and triangles of a reference shape, turned from y up to z up."""
    data = np.load(REFERENCE / shape["npz"])
    x, y, z = data["vertices"].T
    return np.ascontiguousarray(np.stack([x, -z, y], 1), np.float32), data["faces"].astype(np.int32)
