# SPDX-License-Identifier: MIT OR Apache-2.0
"""Variations: several outcomes of one job that are nearly as good and look different."""

import hashlib
import json
import os
import subprocess
import sys
import time

import boxmorph
import numpy as np
import pytest

#: What a variation may lose of what the best gained, and how near two may be: as in src/job/variations.rs.
TOLERANCE = 0.15
DISTINCT = 0.03


def run(mesh, prompt, guide, **options):
    job = boxmorph.Job(boxmorph.Mesh(*mesh), prompt, guide=guide, splits=3, **options)
    job.start()
    job.join()
    return job.result()


@pytest.fixture(scope="module")
def stool(chair, guide):
    """The chair deformed to a bar stool."""
    return run(chair, "a bar stool", guide)


@pytest.fixture(scope="module")
def stools(chair, guide):
    """The chair deformed to four bar stools."""
    return run(chair, "a bar stool", guide, variations=4)


def test_a_job_has_one_outcome_unless_more_are_asked_for(stool):
    assert len(stool.variations) == 1
    np.testing.assert_array_equal(stool.variations[0].vertices, stool.vertices)
    report = stool.report()
    assert (report["variation"], report["variations_asked"], report["distance"]) == (0, 1, 0)


def test_the_first_is_what_a_job_without_variations_finds(stool, stools):
    assert len(stools.variations) == 4
    for result in (stools, stools.variations[0]):
        np.testing.assert_array_equal(result.vertices, stool.vertices)
        np.testing.assert_array_equal(result.scales, stool.scales)
        assert result.score_after == stool.score_after


def test_they_look_different(chair, stools):
    size = np.linalg.norm(np.ptp(chair[0], axis=0))
    shapes = [result.vertices for result in stools.variations]
    for i, one in enumerate(shapes):
        for other in shapes[:i]:
            # Over the vertices, which are not spread as evenly as what the job measures by.
            assert np.sqrt(((one - other) ** 2).sum(1).mean()) / size > 0.7 * DISTINCT
            views = [boxmorph.render(shape, chair[1], size=64, renderer="cpu") for shape in (one, other)]
            inside = [view[..., 3] > 127 for view in views]
            both, either = (inside[0] & inside[1]).sum(), (inside[0] | inside[1]).sum()
            assert both / either < 0.9
    for result in stools.variations[1:]:
        assert result.report()["distance"] >= DISTINCT


def test_they_are_nearly_as_good_and_best_first(stools):
    best, *others = stools.variations
    gain = best.score_after - best.score_before
    scores = [result.score_after for result in others]
    assert min(scores) >= best.score_after - TOLERANCE * gain
    assert scores == sorted(scores, reverse=True)


def test_they_are_in_one_piece(chair, stools):
    mesh = boxmorph.Mesh(*chair)
    before = boxmorph.metrics.self_intersection_ratio(mesh, chair[0])
    for result in stools.variations:
        assert boxmorph.metrics.self_intersection_ratio(mesh, result.vertices) <= before + 0.015


def test_each_has_its_own_record_scales_and_slider(stools):
    for number, result in enumerate(stools.variations):
        report = result.report()
        json.dumps(report)
        assert (report["variation"], report["variations_asked"]) == (number, 4)
        assert np.allclose(report["scales"], result.scales)
        assert report["score_after"] == result.score_after
        deformed = result.graph.deform(result.scales) * report["gauge_scale"]
        np.testing.assert_allclose(result.vertices, deformed + np.float32(report["gauge_shift"]), atol=1e-5)
        for alpha in (result.slider_min, result.slider_max):
            assert (1 + alpha * (report["gauge_scale"] * result.scales - 1)).min() >= 0.05 - 1e-4
    assert len({result.scales.tobytes() for result in stools.variations}) == 4


def test_all_keep_the_size_the_place_and_the_locks(chair, guide):
    mesh = boxmorph.Mesh(*chair)
    graph = boxmorph.BoxDefGraph.build(mesh, splits=3)
    locked = np.zeros((graph.parameter_rows, 3), bool)
    locked[2] = True
    points = np.ascontiguousarray(chair[0][::7])
    options = {"graph": graph, "locked": locked, "keep_size": "height", "points": points}
    job = boxmorph.Job(mesh, "a bar stool", guide=guide, variations=3, **options)
    job.start()
    job.join()
    results = job.result().variations
    assert len(results) > 1
    for result in results:
        assert (result.scales[2] == 1).all()
        assert np.ptp(result.vertices[:, 2]) == pytest.approx(np.ptp(chair[0][:, 2]), rel=1e-5)
        assert result.vertices[:, 2].min() == pytest.approx(chair[0][:, 2].min(), abs=1e-5)
        np.testing.assert_allclose(result.points, result.vertices[::7], atol=1e-5)


def test_where_there_are_no_others_there_are_fewer(guide):
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], np.int32)
    mesh = boxmorph.Mesh(corners, triangles)
    graph = boxmorph.BoxDefGraph.build(mesh, splits=1)
    locked = np.ones((graph.parameter_rows, 3), bool)
    locked[:, 2] = False
    options = {"graph": graph, "locked": locked, "scale_range": (0.98, 1.02)}
    job = boxmorph.Job(mesh, "a tower", guide=guide, variations=3, **options)
    job.start()
    job.join()
    assert len(job.result().variations) == 1
    assert job.result().report()["variations_asked"] == 3


def test_progress_rises_to_its_end_and_shows_the_best_throughout(chair, guide, stool):
    job = boxmorph.Job(boxmorph.Mesh(*chair), "a bar stool", guide=guide, splits=3, variations=3)
    job.start()
    seen, shown = [], []
    while not job.progress()["finished"]:
        seen.append(job.progress())
        shown.append(job.best())
        time.sleep(0.01)
    job.join()
    fractions = [progress["fraction"] for progress in seen]
    assert fractions == sorted(fractions) and fractions[-1] <= 1
    assert job.progress()["fraction"] == 1 and job.progress()["phase"] == "Done"
    assert any("variations" in progress["phase"] for progress in seen)
    evaluations = [progress["evaluations"] for progress in seen]
    assert evaluations == sorted(evaluations)
    scores = [best[0] for best in shown if best is not None]
    assert scores == sorted(scores)
    np.testing.assert_array_equal(job.best()[1], stool.vertices)


def test_cancelled_while_varying(chair, guide):
    job = boxmorph.Job(boxmorph.Mesh(*chair), "a bar stool", guide=guide, splits=2, variations=8)
    job.start()
    while "variations" not in job.progress()["phase"]:
        assert not job.progress()["finished"]
        time.sleep(0.005)
    job.cancel()
    with pytest.raises(boxmorph.Cancelled):
        job.join()
    with pytest.raises(boxmorph.Cancelled):
        job.result()


@pytest.mark.parametrize("count", [0, 9, 100, -1])
def test_other_numbers_are_refused(chair, guide, count):
    with pytest.raises(ValueError, match="variations must be a whole number from 1 to 8"):
        boxmorph.Job(boxmorph.Mesh(*chair), "a sofa", guide=guide, variations=count)


SCRIPT = """
import sys, numpy as np, boxmorph
data = np.load(sys.argv[1])
guide = boxmorph.Guide.open(threads=int(sys.argv[2]))
mesh = boxmorph.Mesh(data["v"], data["t"])
job = boxmorph.Job(mesh, "a bar stool", guide=guide, seed=7, splits=2, renderer="cpu", variations=3)
job.start(); job.join()
for r in job.result().variations:
    sys.stdout.buffer.write(r.vertices.tobytes() + r.scales.tobytes() + repr(r.score_after).encode())
"""


def test_same_seed_same_bytes_on_one_and_two_threads(chair, tmp_path):
    np.savez(tmp_path / "chair.npz", v=chair[0], t=chair[1])
    digests = set()
    for threads in ("1", "2"):
        environment = {**os.environ, "RAYON_NUM_THREADS": threads}
        command = [sys.executable, "-c", SCRIPT, str(tmp_path / "chair.npz"), threads]
        done = subprocess.run(command, env=environment, capture_output=True, check=True)
        digests.add(hashlib.sha256(done.stdout).hexdigest())
    assert len(digests) == 1


def test_progress_goes_on_while_variations_are_searched(chair, guide):
    job = boxmorph.Job(boxmorph.Mesh(*chair), "a bar stool", guide=guide, renderer="cpu", variations=3)
    job.start()
    seen = []
    while not (progress := job.progress())["finished"]:
        seen.append(progress)
        time.sleep(0.01)
    job.join()
    fractions = [progress["fraction"] for progress in seen]
    assert fractions == sorted(fractions)
    varying = {p["fraction"] for p in seen if p["phase"] == "Searching variations"}
    assert len(varying) > 3 and min(varying) < 0.8
