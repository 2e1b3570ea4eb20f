# SPDX-License-Identifier: MIT OR Apache-2.0
"""Parts that are shifted as well as scaled."""

import json

import boxmorph
import numpy as np
import pytest


@pytest.fixture(scope="module")
def mesh(chair):
    return boxmorph.Mesh(*chair)


def run(mesh, guide, prompt="a bar stool", **options):
    job = boxmorph.Job(mesh, prompt, guide=guide, shift_parts=True, **options)
    job.start()
    job.join()
    return job.result()


@pytest.fixture(scope="module")
def outcome(mesh, guide):
    return run(mesh, guide)


def test_scales_and_shifts_make_the_outcome(outcome):
    report = outcome.report()
    moved = outcome.graph.deform(outcome.scales, outcome.shifts)
    gauged = np.float32(report["gauge_scale"]) * moved + np.float32(report["gauge_shift"])
    np.testing.assert_allclose(outcome.vertices, gauged, atol=1e-5)
    assert np.abs(outcome.shifts).max() > 0.001
    assert outcome.score_after > outcome.score_before
    np.testing.assert_allclose(report["shifts"], outcome.shifts)
    json.dumps(report)


def test_shifts_stay_within_their_room(outcome):
    room = outcome.graph.shift_room()
    assert (outcome.shifts >= room[..., 0] - 1e-6).all()
    assert (outcome.shifts <= room[..., 1] + 1e-6).all()


def test_the_same_seed_gives_the_same_bytes(mesh, guide, outcome):
    np.testing.assert_array_equal(run(mesh, guide).vertices, outcome.vertices)


def test_what_is_locked_keeps_its_place(mesh, guide):
    graph = boxmorph.BoxDefGraph.build(mesh, splits=3)
    locked = np.zeros((graph.parameter_rows, 3), bool)
    row = int(np.ptp(graph.shift_room(), axis=2).max(1).argmax())
    locked[row] = True
    outcome = run(mesh, guide, graph=graph, locked=locked)
    assert (outcome.scales[row] == 1).all() and (outcome.shifts[row] == 0).all()
    assert (outcome.shifts != 0).any()


def test_without_being_asked_nothing_is_shifted(mesh, guide):
    job = boxmorph.Job(mesh, "a bar stool", guide=guide)
    job.start()
    job.join()
    assert job.result().shifts is None
    assert job.result().report()["shifts"] is None


def test_shifts_of_other_parts_are_refused_in_words(outcome):
    with pytest.raises(ValueError, match="shifts has 1 rows"):
        outcome.graph.deform(outcome.scales, np.zeros((1, 3), np.float32))


def test_cpu_and_gpu_draw_shifted_parts_alike(mesh, guide):
    try:
        gpu = run(mesh, guide, renderer="gpu", splits=2)
    except boxmorph.RenderError as error:
        pytest.skip(str(error))
    cpu = run(mesh, guide, renderer="cpu", splits=2)
    assert gpu.score_before == pytest.approx(cpu.score_before, abs=1e-3)
    assert gpu.score_after == pytest.approx(cpu.score_after, abs=0.1)
