# SPDX-License-Identifier: GPL-3.0-or-later
"""The metrics against those of libigl, MeshLab and the authors, where their data is at hand."""

import json
from pathlib import Path

import boxmorph
import numpy as np
import pytest

REFERENCE = Path(__file__).parents[2] / ".." / "shared" / "reference"

INDEX = REFERENCE / "index.json"
SHAPES = json.loads(INDEX.read_text())["shapes"] if INDEX.is_file() else []


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
