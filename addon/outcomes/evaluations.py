# SPDX-License-Identifier: GPL-3.0-or-later
"""Many outcomes evaluated: the paper's table of similarity, curvature change and self-intersections, as CSV
and as JSON.
"""

import csv
import json

import numpy as np

from ..core import engine, images
from ..errors import Refusal
from . import evaluation, shape_key

#: Pixels along a side of the pictures that go with an evaluation.
PICTURE_SIZE = 224

#: What is measured, in the order of the table.
MEASURES = (
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
)

_NAMED = ("file", "object", "outcome", "prompt", "negative", "source")
_COLUMNS = (*_NAMED, "guide", "triangles", *MEASURES, "refused")


class Evaluated:
    """An outcome and its evaluation; None, with the Refusal, where it cannot be evaluated. It is held against
    `asked`: a record, or another dict with a prompt.
    """

    def __init__(self, file, obj, key, asked):
        self.file, self.object, self.outcome, self.prompt = file, obj.name, key.name, asked["prompt"]
        self.negative, self.source = asked.get("negative"), asked.get("source")
        self.evaluation = self.refusal = None
        #: Before and after from the front right, (PICTURE_SIZE, 2·PICTURE_SIZE, 3) uint8; None without.
        self.picture = None

    def row(self):
        """Return the evaluation as a flat dict that JSON can hold."""
        named = {name: getattr(self, name) for name in _NAMED}
        if self.evaluation is None:
            return named | {"refused": str(self.refusal)}
        return named | self.evaluation | {"guide": self.evaluation["guide"]["name"]}


def with_outcomes(objects):
    """Return those of these objects whose meshes have outcomes, by name; of users of one mesh the first."""
    found = {}
    for obj in sorted(objects, key=lambda obj: obj.name):
        if obj.type == "MESH" and shape_key.records(obj.data):
            found.setdefault(obj.data, obj)
    return list(found.values())


def evaluate_all(objects, context, file="", renderer=None, prompt=None, pictures=False):
    """Yield an Evaluated for every outcome of these objects, evaluated while one waits for it.

    `prompt`: one that all are held against, instead of each against its own.
    """
    for obj in with_outcomes(objects):
        for key in shape_key.outcomes(obj.data):
            asked = shape_key.records(obj.data)[key.name] if prompt is None else {"prompt": prompt}
            evaluated = Evaluated(file, obj, key, asked)
            try:
                if obj.mode == "EDIT":
                    raise Refusal("“{name}” is in Edit Mode. Go to Object Mode first", name=obj.name)
                evaluated.evaluation = evaluation.evaluate(obj, context, key, renderer, prompt)
                if pictures:
                    evaluated.picture = _picture(*evaluation.shapes(obj, context, key), renderer)
            except Refusal as refusal:
                evaluated.refusal = refusal
            yield evaluated


def _picture(arrays, _mesh, after, renderer):
    boxmorph = engine.library()
    options = {"size": PICTURE_SIZE, "renderer": renderer or "auto", "views": evaluation.FRONT_RIGHT}
    shapes = (arrays.vertices, after)
    rows = [images.render_row(boxmorph, shape, arrays.triangles, **options) for shape in shapes]
    return np.concatenate(rows, axis=1)


def average(found):
    """Return the mean of each measure over these Evaluated, and how many there are; None for a measure that
    none has.
    """
    rows = [evaluated.evaluation for evaluated in found if evaluated.evaluation is not None]
    means = {"outcomes": len(rows)}
    for measure in MEASURES:
        values = [row[measure] for row in rows if row[measure] is not None]
        means[measure] = float(np.mean(values)) if values else None
    return means


def write_csv(found, path):
    """Write a table with a line for each outcome. Raises OSError."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, _COLUMNS, extrasaction="ignore")
        table.writeheader()
        table.writerows(evaluated.row() for evaluated in found)


def write_json(found, path):
    """Write all outcomes, the averages of each prompt, and those of all. Raises OSError."""
    prompts = list(dict.fromkeys(evaluated.prompt for evaluated in found))
    written = {
        "boxmorph": engine.library().__version__,
        "guide": next((e.evaluation["guide"] for e in found if e.evaluation is not None), None),
        "outcomes": [evaluated.row() for evaluated in found],
        "prompts": {prompt: average([e for e in found if e.prompt == prompt]) for prompt in prompts},
        "average": average(found),
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump(written, file, indent=2, ensure_ascii=False, allow_nan=False)
        file.write("\n")
