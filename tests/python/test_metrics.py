# SPDX-License-Identifier: GPL-3.0-or-later
"""The metrics against those of libigl, MeshLab and the authors, where their data is at hand."""

import json
from pathlib import Path

import boxmorph
import igl
import numpy as np
import pymeshlab
import pytest

REFERENCE = Path(__file__).parents[2] / ".." / "shared" / "reference"

INDEX = REFERENCE / "index.json"
SHAPES = json.loads(INDEX.read_text())["shapes"] if INDEX.is_file() else []


def curvature_change(vertices, moved, triangles):
    """By libigl: the mean over vertices of the change of the angle deficit, in radians."""
    before, after = (igl.gaussian_curvature(v.astype(np.float64), triangles) for v in (vertices, moved))
    return np.abs(after - before).mean()


def intersecting_share(vertices, triangles):
    """By MeshLab: the share of the triangles that cross others."""
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(vertices.astype(np.float64), triangles))
    meshes.compute_selection_by_self_intersections_per_face()
    return meshes.current_mesh().selected_face_number() / len(triangles)


def agree(vertices, triangles, moved):
    mesh = boxmorph.Mesh(vertices, triangles)
    change = boxmorph.metrics.gaussian_curvature_change(mesh, moved)
    assert change == pytest.approx(curvature_change(vertices, moved, triangles), abs=1e-5)
    ratio = boxmorph.metrics.self_intersection_ratio(mesh, moved)
    assert ratio == pytest.approx(intersecting_share(moved, triangles), abs=1e-3)
    return change, ratio


def test_metrics_agree_with_libigl_and_meshlab():
    # A wavy sheet, folded over until it crosses itself.
    side = 40
    u, v = np.meshgrid(np.linspace(-1, 1, side), np.linspace(-1, 1, side))
    flat = np.stack([u.ravel(), v.ravel(), 0.1 * np.sin(5 * u * v).ravel()], 1).astype(np.float32)
    cell = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    corners = np.concatenate(
        [np.stack([cell, cell + 1, cell + side], 1), np.stack([cell + 1, cell + side + 1, cell + side], 1)]
    )
    triangles = np.ascontiguousarray(corners, np.int32)
    folded = flat.copy()
    folded[:, 0] = 0.6 * np.sin(4 * flat[:, 0])
    folded[:, 2] += 0.3 * flat[:, 0] * flat[:, 1]
    change, ratio = agree(flat, triangles, np.ascontiguousarray(folded))
    assert change > 0.001 and 0.01 < ratio < 0.9, "the test needs a sheet that bends and crosses itself"


@pytest.mark.skipif(not SHAPES, reason="the authors' reference data is not at hand")
@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape["npz"])
def test_metrics_agree_with_libigl_and_meshlab_on_the_reference(shape):
    with np.load(REFERENCE / shape["npz"]) as data:
        triangles = np.ascontiguousarray(data["faces"], np.int32)
        for level in (2, 3, 4):
            agree(data["vertices"], triangles, np.ascontiguousarray(data[f"L{level}_deformed"][level]))


@pytest.mark.skipif(not SHAPES, reason="the authors' reference data is not at hand")
@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape["npz"])
def test_metrics_agree_with_the_reference(shape):
    with np.load(REFERENCE / shape["npz"]) as data:
        mesh = boxmorph.Mesh(data["vertices"], np.ascontiguousarray(data["faces"], np.int32))
        own = boxmorph.metrics.self_intersection_ratio(mesh, data["vertices"])
        assert own == pytest.approx(shape["self_intersection_ratio_original"], abs=1e-3)
        for level in (2, 3, 4):
            for row, vertices in enumerate(data[f"L{level}_deformed"]):
                vertices = np.ascontiguousarray(vertices)

                def expected(name, level=level, row=row):
                    return float(data[f"L{level}_{name}"][row])

                change = boxmorph.metrics.gaussian_curvature_change(mesh, vertices)
                assert change == pytest.approx(expected("gc_change"), abs=1e-5)
                error = boxmorph.metrics.normal_error(mesh, vertices)
                assert error == pytest.approx(expected("normal_error"), abs=1e-5)
                ratio = boxmorph.metrics.self_intersection_ratio(mesh, vertices)
                assert ratio == pytest.approx(expected("self_intersection_ratio"), abs=1e-3)


def test_another_number_of_vertices_is_refused():
    corners = np.eye(3, dtype=np.float32)
    mesh = boxmorph.Mesh(corners, np.array([[0, 1, 2]], np.int32))
    for metric in ("gaussian_curvature_change", "self_intersection_ratio", "normal_error"):
        with pytest.raises(ValueError, match="one for each vertex"):
            getattr(boxmorph.metrics, metric)(mesh, np.zeros((4, 3), np.float32))
