# SPDX-License-Identifier: MIT OR Apache-2.0
"""Evaluate: an outcome in numbers, in its record, in words and in the report of the command line."""

import json

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"

MEASURES = {
    "guide",
    "triangles",
    "score_before",
    "score_after",
    "front_right_before",
    "front_right_after",
    "curvature_change",
    "self_intersections_before",
    "self_intersections_after",
    "normal_error",
    "least_scale",
    "largest_scale",
}


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def record(obj):
    return json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]


def evaluated(obj, **options):
    assert bpy.ops.boxmorph.evaluate(**options) == {"FINISHED"}
    return record(obj)["evaluation"]


@pytest.mark.parametrize("half", [False, True])
def test_scores_are_those_of_the_search_whatever_is_shown(half):
    obj = blender.chair(half)
    obj.scale = (1.3, 1.0, 0.8)
    bpy.context.view_layer.update()
    blender.deform(PROMPT)
    obj.data.shape_keys.key_blocks[PROMPT].value = 0.2
    shown = blender.evaluated_positions(obj)
    before = blender.fingerprint(obj)
    report = record(obj)
    found = evaluated(obj)
    assert found.keys() == MEASURES
    assert found["score_before"] == pytest.approx(report["score_before"], abs=2e-3)
    assert found["score_after"] == pytest.approx(report["score_after"], abs=2e-3)
    assert found["normal_error"] == pytest.approx(report["normal_error"], abs=2e-3)
    assert found["triangles"] == report["triangles"]
    scales = np.array(report["scales"]) * report["gauge_scale"]
    assert (found["least_scale"], found["largest_scale"]) == pytest.approx((scales.min(), scales.max()))
    # Nothing is changed by it.
    assert np.array_equal(blender.evaluated_positions(obj), shown)
    assert blender.fingerprint(obj) == before


def test_surface_measures_are_those_of_the_library():
    import boxmorph

    obj = blender.chair()
    blender.deform(PROMPT)
    found = evaluated(obj)
    arrays, mesh = blender.addon("engine").searched(obj, bpy.context)
    moved = blender.positions(obj.data.shape_keys.key_blocks[PROMPT])
    metrics = boxmorph.metrics
    assert found["curvature_change"] == metrics.gaussian_curvature_change(mesh, moved)
    assert found["self_intersections_after"] == metrics.self_intersection_ratio(mesh, moved)
    assert found["self_intersections_before"] == metrics.self_intersection_ratio(mesh, arrays.vertices)
    assert found["self_intersections_before"] > 0.0, "the test needs a chair whose parts cross"


def test_the_front_right_view_is_none_of_those_that_are_searched():
    import boxmorph

    obj = blender.chair()
    blender.deform(PROMPT)
    found = evaluated(obj)
    _arrays, mesh, after = blender.addon("evaluation").shapes(
        obj, bpy.context, obj.data.shape_keys.key_blocks[PROMPT]
    )
    guide = blender.addon("engine").open_guide()
    scores = boxmorph.spectrum_scores(mesh, after, PROMPT, guide, [0, 1], views="front right")
    assert [found["front_right_before"], found["front_right_after"]] == list(scores)
    assert abs(found["front_right_after"] - found["score_after"]) > 1e-4
    # A block and a bar, which stands elsewhere in each of the four views.
    blender.add("Block", *_bar())
    vertices, triangles = blender.addon("mesh_io").shown_arrays(bpy.context.active_object, bpy.context)
    (seen,), four = (
        boxmorph.render(vertices, triangles, size=64, views=name)[..., 3] > 0
        for name in ("front right", "paper")
    )
    alike = [(seen & view).sum() / (seen | view).sum() for view in four]
    assert np.argmax(alike) == 0 and 0.7 < alike[0] < 1.0


def _bar():
    """A cube and a bar beside it, to the front (−y) and the right (+x)."""
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    sides = np.array([(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
    bar = corners * 0.1 + (1.5, -1.5, -0.9)
    return np.concatenate([corners, bar]), np.concatenate([sides, sides + 8])


def test_in_plain_words(capfd):
    obj = blender.chair()
    blender.deform(PROMPT)
    capfd.readouterr()
    found = evaluated(obj)
    lines = blender.addon("evaluation").lines(found)
    assert len(lines) == 6 and all(len(line) < 80 for line in lines)
    assert f"{found['score_before']:.3f} before, {found['score_after']:.3f} now" in lines[0]
    assert all(line in "".join(capfd.readouterr()) for line in lines[:1])


def test_crossing_faces_of_dense_meshes_are_not_counted(monkeypatch):
    obj = blender.chair()
    blender.deform(PROMPT)
    evaluation = blender.addon("evaluation")
    monkeypatch.setattr(evaluation, "_COUNTED", 50)
    found = evaluated(obj)
    assert found["self_intersections_before"] is None and found["self_intersections_after"] is None
    assert "Crossing faces: not counted" in "".join(evaluation.lines(found))
    json.dumps(found, allow_nan=False)


def test_a_new_search_and_a_missing_guide():
    obj = blender.chair()
    blender.deform(PROMPT)
    evaluated(obj)
    before = record(obj)
    blender.preferences().guide_folder = "/none/such"
    try:
        with pytest.raises(RuntimeError, match="guide folder"):
            bpy.ops.boxmorph.evaluate()
    finally:
        blender.preferences().guide_folder = ""
    assert record(obj) == before
    blender.deform(PROMPT, seed=1)
    assert "evaluation" not in record(obj)


def test_the_command_line_evaluates(tmp_path, capfd):
    blender.chair()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    output, report = tmp_path / "out.blend", tmp_path / "report.json"
    arguments = ["deform", "--prompt", PROMPT, "--splits", "2", "--evaluate", "--take-apart"]
    arguments += ["--output", str(output), "--report", str(report)]
    assert blender.addon("command").main(arguments) == 0
    assert "boxmorph: Likeness to the prompt: " in capfd.readouterr().out
    found = json.loads(report.read_text(encoding="utf-8"))["evaluation"]
    assert found.keys() == MEASURES
    bpy.ops.wm.open_mainfile(filepath=str(output))
    assert record(bpy.context.active_object)["evaluation"] == found
