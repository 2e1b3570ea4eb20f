# SPDX-License-Identifier: MIT OR Apache-2.0
"""The score along the spectrum: that of the job at its ends, that of the rendered shape between."""

import boxmorph
import numpy as np
import pytest
from conftest import cuboid, subdivided

PROMPT = "a bar stool"


def deformed(mesh, guide, prompt=PROMPT):
    job = boxmorph.Job(mesh, prompt, guide=guide, splits=2, renderer="cpu")
    job.start()
    job.join()
    return job.result()


@pytest.fixture(scope="module")
def mesh(chair):
    return boxmorph.Mesh(*chair)


@pytest.fixture(scope="module")
def stool(mesh, guide):
    return deformed(mesh, guide)


def test_the_ends_have_the_scores_of_the_job(mesh, stool, guide):
    scores = boxmorph.spectrum_scores(mesh, stool.vertices, PROMPT, guide, [0, 1], "cpu")
    assert scores.dtype == np.float64 and scores.shape == (2,)
    assert scores == pytest.approx([stool.score_before, stool.score_after], abs=1e-6)


def test_a_value_between_or_beyond_is_that_very_shape(mesh, stool, guide):
    # More than are drawn at a time, in no order.
    alphas = np.concatenate(([0.4, -0.6, 1.3], np.linspace(1, 0, 30)))
    scores = boxmorph.spectrum_scores(mesh, stool.vertices, PROMPT, guide, alphas, "cpu")
    for alpha, score in list(zip(alphas, scores, strict=True))[:3]:
        shape = mesh.vertices + np.float32(alpha) * (stool.vertices - mesh.vertices)
        alone = boxmorph.Mesh(shape, mesh.triangles)
        own = boxmorph.spectrum_scores(alone, shape, PROMPT, guide, [0.0], "cpu")
        assert score == pytest.approx(own[0], abs=2e-3)
    assert scores[3] == pytest.approx(stool.score_after, abs=1e-6)
    assert scores[-1] == pytest.approx(stool.score_before, abs=1e-6)


def test_a_dense_mesh_is_scored_as_the_job_scores_it(guide):
    parts = [cuboid((-0.2, -0.2, 0), (0.2, 0.2, 0.1)), cuboid((-0.03, -0.03, 0), (0.03, 0.03, 1.2))]
    dense = [subdivided(*part, 6) for part in parts]
    vertices = np.concatenate([v for v, _ in dense])
    triangles = np.concatenate([dense[0][1], dense[1][1] + len(dense[0][0])])
    mesh = boxmorph.Mesh(vertices, triangles)
    lamp = deformed(mesh, guide, "a lamp")
    assert lamp.report()["scored_triangles"] < len(triangles)
    scores = boxmorph.spectrum_scores(mesh, lamp.vertices, "a lamp", guide, [0, 1], "cpu")
    assert scores == pytest.approx([lamp.score_before, lamp.score_after], abs=1e-6)


def test_no_values_no_scores(mesh, guide):
    assert boxmorph.spectrum_scores(mesh, mesh.vertices, PROMPT, guide, []).shape == (0,)


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"vertices": np.zeros((3, 3), np.float32)}, ValueError, "has 3 vertices and the mesh"),
        ({"vertices": np.zeros((3, 3))}, TypeError, "float32"),
        ({"alphas": [0.0, float("nan")]}, ValueError, "finite"),
        ({"prompt": " "}, ValueError, "prompt"),
        ({"renderer": "tpu"}, ValueError, "unknown renderer"),
    ],
)
def test_misuse_is_a_sentence(mesh, guide, change, error, words):
    options = {"vertices": mesh.vertices, "prompt": PROMPT, "guide": guide, "alphas": [0.0], **change}
    with pytest.raises(error, match=words):
        boxmorph.spectrum_scores(mesh, **options)
