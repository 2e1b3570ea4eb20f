# SPDX-License-Identifier: MIT OR Apache-2.0
"""The field as arrays: at the mesh's own vertices and at other points, with shifts and without."""

import boxmorph
import numpy as np
import pytest


@pytest.fixture(scope="module")
def mesh(chair):
    return boxmorph.Mesh(*chair)


@pytest.fixture(scope="module")
def graph(mesh):
    return boxmorph.BoxDefGraph.build(mesh, splits=3)


@pytest.fixture(scope="module")
def scales(graph):
    return np.random.default_rng(0).uniform(0.5, 2.0, (graph.parameter_rows, 3)).astype(np.float32)


@pytest.fixture(scope="module")
def shifts(graph):
    return np.random.default_rng(1).uniform(-0.1, 0.1, (graph.parameter_rows, 3)).astype(np.float32)


def test_scales_and_shifts_in_object_units_make_the_deformation(mesh, graph, scales, shifts):
    field = graph.field(with_shifts=True)
    rows = np.concatenate([scales - 1.0, shifts])
    assert field.shape == (3, len(rows), len(mesh.vertices))
    assert np.array_equal(field[:, : len(scales)], graph.field())
    moved = mesh.vertices + np.einsum("pa,apn->na", rows, field)
    np.testing.assert_allclose(moved, graph.deform(scales, shifts), atol=1e-5)


@pytest.mark.parametrize("with_shifts", [False, True])
def test_points_move_as_the_vertices_in_their_place(mesh, graph, with_shifts):
    own = np.ascontiguousarray(mesh.vertices[::-7])
    field = graph.field_at(own, with_shifts=with_shifts)
    np.testing.assert_array_equal(field, graph.field(with_shifts)[:, :, ::-7])


def test_points_within_a_part_go_along_with_it(mesh, graph, scales):
    leg = graph.assignment == graph.assignment[0]
    middle = mesh.vertices[leg].mean(axis=0, keepdims=True)
    moved = middle + np.einsum("pa,apn->na", scales - 1.0, graph.field_at(middle))
    deformed = graph.deform(scales)[leg]
    assert (deformed.min(0) <= moved).all() and (moved <= deformed.max(0)).all()


def test_no_points_and_bad_points(graph):
    assert graph.field_at(np.empty((0, 3), np.float32)).shape == (3, graph.parameter_rows, 0)
    with pytest.raises(ValueError, match="points"):
        graph.field_at(np.full((1, 3), np.nan, np.float32))
    with pytest.raises(TypeError, match="points"):
        graph.field_at(np.zeros((1, 3)))
