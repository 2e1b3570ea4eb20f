# SPDX-License-Identifier: GPL-3.0-or-later
"""An outcome in the numbers by which the method's authors judge one: likeness, curvature, crossing faces;
and the turn of the normals and the largest scale.

Measured on the object as it is searched: with the modifiers that shape it, without pose, other keys at 0.
"""

import numpy as np

from ..core import engine
from ..errors import Refusal
from ..preferences import preferences
from . import score_curve, shape_key, wordings

#: Field of the outcome's record that holds the evaluation.
FIELD = "evaluation"

#: Triangles up to which crossing faces are counted: more take longer than a search.
_COUNTED = 200_000

#: From where the paper evaluates: no view that a search has looked from.
FRONT_RIGHT = "front right"


def evaluate(obj, context, key, renderer=None, prompt=None):
    """Return the evaluation of the outcome `key` of `obj` at value 1, as a dict that JSON can hold; with
    `prompt`, how alike it is to that one instead of its own.

    Scores are mean cosines of images with what was asked for: of all 12, and of the front-right view before
    the three backgrounds. `curvature_change` is the mean change of a vertex's angle deficit in radians,
    `normal_error` the mean of 1 − cos between old and new vertex normals, `self_intersections_*` the share of
    triangles that cross others, None where there are too many to ask. Scales are those of parts, under the
    gauge; None where the record has none. Raises Refusal where the shape cannot be seen or the guide cannot
    be opened.
    """
    boxmorph = engine.library()
    guide = engine.open_guide()
    renderer = renderer or preferences().renderer
    report = shape_key.records(obj.data)[key.name]
    arrays, mesh, after = shapes(obj, context, key)
    wording = wordings.of_record(report) if prompt is None else wordings.wording(prompt)
    metrics = boxmorph.metrics
    counted = len(arrays.triangles) <= _COUNTED
    try:
        scores, front = (
            boxmorph.spectrum_scores(mesh, after, wording, guide, [0.0, 1.0], renderer, views)
            for views in ("paper", FRONT_RIGHT)
        )
        crossing = [
            metrics.self_intersection_ratio(mesh, vertices) if counted else None
            for vertices in (arrays.vertices, after)
        ]
        curvature, normals = metrics.gaussian_curvature_change(mesh, after), metrics.normal_error(mesh, after)
    except (boxmorph.GuideError, boxmorph.RenderError, ValueError, RuntimeError) as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    scales = report.get("gauge_scale", 1.0) * np.array(report.get("scales", ()))
    return {
        "guide": {"name": guide.name, "sha256": guide.sha256},
        "triangles": len(arrays.triangles),
        "score_before": float(scores[0]),
        "score_after": float(scores[1]),
        "front_right_before": float(front[0]),
        "front_right_after": float(front[1]),
        "curvature_change": curvature,
        "self_intersections_before": crossing[0],
        "self_intersections_after": crossing[1],
        "normal_error": normals,
        "least_scale": float(scales.min()) if scales.size else None,
        "largest_scale": float(scales.max()) if scales.size else None,
    }


def shapes(obj, context, key):
    """Return the ObjectArrays of `obj`, their Mesh, and the outcome's positions at 1 in the same coordinates,
    (n,3) float32. Raises Refusal where the shape cannot be seen.
    """
    arrays, mesh = engine.searched(obj, context)
    return arrays, mesh, np.ascontiguousarray(score_curve.seen(obj, context, key, arrays) @ arrays.place.T)


def keep(obj, key, evaluation):
    """Put an evaluation into the record of an outcome, in place of an earlier one."""
    shape_key.note(obj.data, key.name, FIELD, evaluation)


def lines(evaluation, say=str):
    """Return an evaluation in plain words, a line for each measure; in English, unless `say` translates."""
    e = evaluation
    if e["self_intersections_after"] is None:
        crossing = say("Crossing faces: not counted, for there are more than {:,} triangles").format(_COUNTED)
    else:
        before, after = e["self_intersections_before"], e["self_intersections_after"]
        crossing = say("Crossing faces: {:.2%} before, {:.2%} now").format(before, after)
    likeness = say("Likeness to the prompt: {:.3f} before, {:.3f} now")
    front_right = say("From the front right: {:.3f} before, {:.3f} now")
    curvature = say("Curvature: changed by {:.3f} radians at a vertex on average")
    shading = say("Shading: normals turned by {:.1f}° on average")
    out = [
        likeness.format(e["score_before"], e["score_after"]),
        front_right.format(e["front_right_before"], e["front_right_after"]),
        crossing,
        curvature.format(e["curvature_change"]),
        shading.format(np.degrees(_angle(e["normal_error"]))),
    ]
    if e["largest_scale"] is not None:
        out.append(say("Parts: scaled by {:.2f} to {:.2f}").format(e["least_scale"], e["largest_scale"]))
    return out


def _angle(error):
    """Return the angle whose 1 − cos is `error`, in radians."""
    return np.arccos(np.clip(1.0 - error, -1.0, 1.0))
