# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the user holds on to: given parts, locks, the range of scales, the size that is kept."""

import boxmorph
import numpy as np
import pytest


@pytest.fixture(scope="module")
def parts(chair):
    """A mesh and its graph."""
    mesh = boxmorph.Mesh(*chair)
    return mesh, boxmorph.BoxDefGraph.build(mesh, splits=3)


def run(parts, guide, prompt="a bar stool", **options):
    mesh, graph = parts
    job = boxmorph.Job(mesh, prompt, guide=guide, graph=graph, **options)
    job.start()
    job.join()
    return job.result()


def locks(graph, *rows):
    locked = np.zeros((graph.parameter_rows, 3), bool)
    locked[list(rows)] = True
    return locked


def test_given_parts_are_the_ones_that_are_scaled(parts, guide):
    outcome = run(parts, guide)
    np.testing.assert_array_equal(outcome.graph.box_center, parts[1].box_center)
    assert outcome.scales.shape == (parts[1].parameter_rows, 3)
    assert outcome.score_after > outcome.score_before
    assert outcome.report()["splits"] is None


def test_a_locked_part_keeps_its_size_to_the_last_bit(parts, guide):
    mesh, graph = parts
    locked = locks(graph, 0)
    outcome = run(parts, guide, locked=locked)
    report = outcome.report()
    assert report["locked"] == locked.tolist() and report["gauge_scale"] == 1.0
    assert (outcome.scales[0] == 1.0).all() and (outcome.scales[1:] != 1.0).any()
    # Away from its neighbours, which the boundary step lets it follow.
    boxes = np.flatnonzero(graph.parameter_row_of_box == 0)
    owned = np.isin(graph.assignment, boxes)
    free = mesh.vertices[~owned]
    far = owned & (np.linalg.norm(mesh.vertices[:, None] - free, axis=2).min(1) > 0.3)
    assert far.sum() > 20
    before, after = mesh.vertices[far], outcome.vertices[far]
    assert np.abs(np.ptp(after, axis=0) / np.ptp(before, axis=0) - 1).max() < 0.05


def test_one_axis_can_be_locked(parts, guide):
    locked = np.zeros((parts[1].parameter_rows, 3), bool)
    locked[:, 2] = True
    outcome = run(parts, guide, "a sofa", locked=locked)
    assert (outcome.scales[:, 2] == 1.0).all()
    assert (outcome.scales[:, 0] != 1.0).any()
    np.testing.assert_allclose(np.ptp(outcome.vertices[:, 2]), np.ptp(parts[0].vertices[:, 2]), rtol=1e-5)


def test_a_lock_of_nothing_changes_nothing(parts, guide):
    free = run(parts, guide)
    unlocked = run(parts, guide, locked=locks(parts[1]))
    assert free.vertices.tobytes() == unlocked.vertices.tobytes()


def test_scales_stay_in_their_range(parts, guide):
    outcome = run(parts, guide, scale_range=(0.8, 1.25))
    assert outcome.scales.min() >= 0.8 - 1e-6 and outcome.scales.max() <= 1.25 + 1e-6
    assert outcome.report()["scale_range"] == pytest.approx([0.8, 1.25])


def test_the_footprint_can_be_kept(parts, guide):
    outcome = run(parts, guide, keep_size="footprint")

    def footprint(positions):
        return np.linalg.norm(np.ptp(positions[:, :2], axis=0))

    assert footprint(outcome.vertices) == pytest.approx(footprint(parts[0].vertices), rel=1e-5)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"locked": np.zeros((1, 3), bool)}, "locked has 1 rows, but the graph has"),
        ({"locked": "all"}, "every axis of every part is locked"),
        ({"scale_range": (1.5, 3.0)}, "the range of scale factors is 1.5 to 3"),
        ({"scale_range": (0.0, 3.0)}, "the range of scale factors is 0 to 3"),
        ({"scale_range": (1.0, 1.0)}, "the range of scale factors is 1 to 1"),
        ({"scale_range": (0.5, float("nan"))}, "the range of scale factors is 0.5 to NaN"),
        ({"splits": 3}, "either the graph, or splits and boundary"),
        ({"boundary": "paper"}, "either the graph, or splits and boundary"),
        ({"boundary": "sharp"}, 'unknown boundary "sharp"'),
        ({"graph": None, "locked": np.zeros((1, 3), bool)}, "give that graph too"),
    ],
)
def test_what_cannot_be_searched_is_refused_in_a_sentence(parts, guide, options, words):
    mesh, graph = parts
    options = {"graph": graph, **options}
    if isinstance(options.get("locked"), str):
        options["locked"] = np.ones((graph.parameter_rows, 3), bool)
    with pytest.raises(ValueError, match=words):
        boxmorph.Job(mesh, "a bar stool", guide=guide, **options)


def test_a_graph_of_another_mesh_is_refused(parts, guide):
    mesh, graph = parts
    other = boxmorph.Mesh(mesh.vertices * np.float32(2), mesh.triangles)
    with pytest.raises(ValueError, match="built from a mesh of other vertices"):
        boxmorph.Job(other, "a bar stool", guide=guide, graph=graph)
