# SPDX-License-Identifier: MIT OR Apache-2.0
"""The embedded guide steers shapes it was never trained on, and they stay in one piece."""

import boxmorph
import numpy as np
import pytest
from conftest import REFERENCE, reference_mesh

PROMPTS = {
    "airplane": ["an airship", "a glider plane"],
    "chair": ["a bar stool", "a sofa"],
    "table": ["a coffee table", "a nightstand"],
}
BACKGROUNDS = np.array([(0, 0, 0), (255, 255, 255), (255, 128, 0)], np.float32)


def ranking(guide, vertices, triangles):
    """The guide's class names, best first, over four views and three backgrounds."""
    views = boxmorph.render(vertices, triangles, size=guide.image_size, renderer="cpu").astype(np.float32)
    alpha = views[..., 3:] / 255
    images = np.concatenate([np.rint(views[..., :3] * alpha + b * (1 - alpha)) for b in BACKGROUNDS])
    seen = guide.image_embeddings(images.astype(np.uint8)).mean(0)
    return sorted(guide.classes, key=lambda name: -float(seen @ guide.text_embedding(name)))


def outcome_of(mesh, prompt, guide, seed=0):
    job = boxmorph.Job(mesh, prompt, guide=guide, seed=seed, renderer="cpu")
    job.start()
    job.join()
    return job.result()


def proportion(vertices, axis):
    """An extent over the geometric mean of the other two."""
    size = np.ptp(vertices, axis=0)
    return size[axis] / np.sqrt(np.prod(np.delete(size, axis)))


@pytest.mark.parametrize(
    "adjective, axis, sign", [("taller", 2, 1), ("lower", 2, -1), ("wider", 0, 1), ("narrower", 0, -1)]
)
def test_an_adjective_moves_the_proportion_it_names(chair, guide, adjective, axis, sign):
    vertices, triangles = chair
    outcome = outcome_of(boxmorph.Mesh(vertices, triangles), f"a {adjective} chair", guide)
    assert sign * np.log(proportion(outcome.vertices, axis) / proportion(vertices, axis)) > 0.05


@pytest.mark.skipif(not REFERENCE.is_dir(), reason="the reference data is not beside the project")
@pytest.mark.parametrize("which", range(6))
def test_reference_shapes_become_what_they_are_told(which, reference, guide):
    shape = reference[which]
    vertices, triangles = reference_mesh(shape)
    mesh = boxmorph.Mesh(vertices, triangles)
    broken = boxmorph.metrics.self_intersection_ratio(mesh, vertices)
    first = []
    for prompt in PROMPTS[shape["category"]]:
        outcome = outcome_of(mesh, prompt, guide)
        what = f"{shape['category']} {shape['id'][:6]} to {prompt}"
        assert outcome.score_after > outcome.score_before, what
        assert boxmorph.metrics.normal_error(mesh, outcome.vertices) < 0.15, what
        assert boxmorph.metrics.self_intersection_ratio(mesh, outcome.vertices) <= broken + 0.02, what
        first.append(ranking(guide, outcome.vertices, triangles)[0] == prompt)
    # One may miss: a desk with two feet makes no nightstand.
    assert sum(first) >= len(first) - 1, list(zip(PROMPTS[shape["category"]], first, strict=True))


@pytest.mark.skipif(not REFERENCE.is_dir(), reason="the reference data is not beside the project")
def test_where_another_name_is_ahead_another_way_is_tried(reference, guide):
    # Led by its rivals the search ended at a score of 0.2 with this seed, and other names stayed ahead.
    desk = next(shape for shape in reference if shape["id"].startswith("6e31a6"))
    vertices, triangles = reference_mesh(desk)
    outcome = outcome_of(boxmorph.Mesh(vertices, triangles), "a pool table", guide, seed=2)
    assert outcome.score_after > 0.4
    assert ranking(guide, outcome.vertices, triangles)[0] == "a pool table"
