# SPDX-License-Identifier: GPL-3.0-or-later
"""The field and the parts against the authors' own results, where their data is at hand."""

import json
from itertools import product
from pathlib import Path

import boxmorph
import numpy as np
import pytest

REFERENCE = Path(__file__).parents[2] / ".." / "shared" / "reference"
LEVELS = (2, 3, 4)
CELL = 0.01  # edge of the authors' voxels

if not (REFERENCE / "index.json").is_file():
    pytest.skip("the authors' reference data is not at hand", allow_module_level=True)

SHAPES = [shape["npz"] for shape in json.loads((REFERENCE / "index.json").read_text())["shapes"]]


@pytest.fixture(scope="module", params=SHAPES)
def data(request):
    with np.load(REFERENCE / request.param) as archive:
        return {name: archive[name] for name in archive.files}


def mesh_of(data):
    return boxmorph.Mesh(data["vertices"], np.ascontiguousarray(data["faces"], np.int32))


def graph_of(mesh, data, level, boundary="paper"):
    def part(name, dtype):
        return np.ascontiguousarray(data[f"L{level}_{name}"], dtype)

    return boxmorph.BoxDefGraph.from_parts(
        mesh,
        part("box_center", np.float32),
        part("box_half_size", np.float32),
        part("box_kind", np.int8),
        part("assignment", np.int32),
        part("tree_edges", np.int32),
        part("tree_parent_point", np.float32),
        part("tree_child_point", np.float32),
        part("graph_edges_executed", np.int32),
        boundary,
    )


@pytest.mark.parametrize("level", LEVELS)
def test_given_parts_deform_as_the_authors_do(data, level):
    mesh = mesh_of(data)
    graph = graph_of(mesh, data, level)
    for params, expected in zip(data[f"L{level}_params"], data[f"L{level}_deformed"], strict=True):
        moved = graph.deform(np.float32(1.0) + np.float32(0.7) * params)
        errors = np.linalg.norm(moved - expected, axis=1)
        assert np.percentile(errors, 99.9) <= 1e-4
        assert errors.max() <= 1e-3


@pytest.mark.parametrize("level", LEVELS)
def test_the_field_is_the_deformation(data, level):
    graph = graph_of(mesh_of(data), data, level)
    field = graph.field()
    assert field.shape == (3, graph.parameter_rows, len(data["vertices"]))
    change = np.float32(0.7) * data[f"L{level}_params"][0]
    moved = data["vertices"] + np.einsum("pa,apn->na", change, field)
    np.testing.assert_allclose(moved, graph.deform(1 + change), atol=2e-6)


def worst_stretch(data, level, moved):
    """Return by how much the edge that crosses a boundary and stretches most does so."""
    corners = data["faces"]
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    a, b = edges[np.ptp(data[f"L{level}_assignment"][edges], axis=1) > 0].T
    length = np.linalg.norm(data["vertices"][a] - data["vertices"][b], axis=1)
    return (np.linalg.norm(moved[a] - moved[b], axis=1) / length).max()


def test_the_smooth_boundary_stretches_less_than_half_as_much_and_spoils_less():
    stretch, spoilt = [], []
    for name, level in product(SHAPES, LEVELS):
        with np.load(REFERENCE / name) as archive:
            data = {key: archive[key] for key in archive.files}
        mesh = mesh_of(data)
        graph = graph_of(mesh, data, level, "smooth")
        worst = []
        for k, (params, theirs) in enumerate(
            zip(data[f"L{level}_params"], data[f"L{level}_deformed"], strict=True)
        ):
            ours = graph.deform(np.float32(1.0) + np.float32(0.7) * params)
            worst.append((worst_stretch(data, level, ours), worst_stretch(data, level, theirs)))
            spoilt.append(
                (
                    boxmorph.metrics.gaussian_curvature_change(mesh, ours),
                    data[f"L{level}_gc_change"][k],
                    boxmorph.metrics.self_intersection_ratio(mesh, ours),
                    data[f"L{level}_self_intersection_ratio"][k],
                )
            )
        stretch.append(np.max(worst, axis=0))
    ours, theirs = np.median(stretch, axis=0)
    assert ours <= 0.5 * theirs
    ours, theirs = np.max(stretch, axis=0)
    assert ours <= 0.5 * theirs
    curvature, their_curvature, crossed, their_crossed = np.mean(spoilt, axis=0)
    assert curvature <= their_curvature
    assert crossed <= their_crossed


def overlap(a, b):
    """Intersection over union of two boxes (center, half size)."""
    low = np.maximum(a[0] - a[1], b[0] - b[1])
    high = np.minimum(a[0] + a[1], b[0] + b[1])
    common = np.prod(np.maximum(high - low, 0))
    return common / (8 * np.prod(a[1]) + 8 * np.prod(b[1]) - common)


def whole_cells(center, half):
    """The half sizes (n, 3) of the authors' boxes, reaching to the ends of the cells that they hold.

    Their boxes end at the centres of the outermost cells, ours at the surface, so half a cell is added on
    each side. A merged box is tight around vertices, not on the grid, and is left as it is.
    """
    cells = (center - half + 1.1) / CELL - 0.5
    on_grid = (np.abs(cells - np.round(cells)) < 0.01).all(axis=1)
    return half + CELL / 2 * on_grid[:, None]


def test_own_parts_are_near_the_authors_where_their_number_is_the_same():
    best = []
    for name, level in product(SHAPES, LEVELS):
        with np.load(REFERENCE / name) as archive:
            data = {key: archive[key] for key in archive.files}
        graph = boxmorph.BoxDefGraph.build(mesh_of(data), splits=level)
        center, half = data[f"L{level}_box_center"], data[f"L{level}_box_half_size"]
        theirs = list(zip(center, whole_cells(center, half), strict=True))
        ours = list(zip(graph.box_center, graph.box_half_size, strict=True))
        if len(ours) == len(theirs):
            best += [max(overlap(box, own) for own in ours) for box in theirs]
    assert len(best) >= 40
    # Not nearer on purpose: a table top ends where it does, not up to a slab below. See docs/parts.md.
    assert np.median(best) >= 0.8


def test_all_shapes_are_found_symmetric(data):
    graph = boxmorph.BoxDefGraph.build(mesh_of(data), splits=4)
    side = graph.box_side
    np.testing.assert_allclose(
        graph.box_center[side == 1] * [-1, 1, 1], graph.box_center[side == 2], atol=0.02
    )
    assert np.isin(graph.assignment, np.arange(len(side))).all()
