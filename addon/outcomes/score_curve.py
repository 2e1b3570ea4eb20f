# SPDX-License-Identifier: GPL-3.0-or-later
"""The score of an outcome along its slider: measured, kept in the outcome's record, drawn as one line of
text.
"""

import numpy as np

from ..core import engine, mesh_io
from ..errors import Refusal
from ..preferences import preferences
from . import shape_key, wordings

#: Slider values at which the score is measured. It bends only gently between them.
SAMPLES = 33

#: Field of the outcome's record that holds the curve.
FIELD = "score_curve"

_BARS = "▁▂▃▄▅▆▇█"
#: As many as the sidebar is wide enough for, as it opens.
_BARS_DRAWN = 11


def measure(obj, context, key, alpha_from, alpha_to, renderer=None):
    """Return the curve of the outcome `key` of `obj` between two slider values, as it is kept.

    That is a dict of `alphas`, increasing, and `scores`, lists of SAMPLES floats. A score is how much the
    shape, as it is searched (without pose, other keys at 0), looks like the outcome's prompt to the guide of
    the preferences. Raises Refusal where the shape cannot be seen or the guide cannot be opened.
    """
    boxmorph = engine.library()
    guide = engine.open_guide()
    wording = wordings.of_record(shape_key.records(obj.data)[key.name])
    arrays, mesh = engine.searched(obj, context)
    outcome = seen(obj, context, key, arrays) @ arrays.place.T
    alphas = np.linspace(*sorted((alpha_from, alpha_to)), SAMPLES)
    try:
        scores = boxmorph.spectrum_scores(
            mesh, np.ascontiguousarray(outcome), wording, guide, alphas, renderer or preferences().renderer
        )
    except (boxmorph.GuideError, boxmorph.RenderError, ValueError, RuntimeError) as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error
    return {"alphas": alphas.round(6).tolist(), "scores": scores.round(6).tolist()}


def keep(obj, key, curve):
    """Put a curve into the record of an outcome, in place of an earlier one."""
    shape_key.note(obj.data, key.name, FIELD, curve)


def text(report):
    """Return the curve of a record as one line, the scores at its ends beside it; None where it has none."""
    curve = report.get(FIELD)
    if curve is None:
        return None
    scores = np.array(curve["scores"])
    drawn = np.interp(np.linspace(0, 1, _BARS_DRAWN), np.linspace(0, 1, len(scores)), scores)
    low, high = drawn.min(), drawn.max()
    heights = (drawn - low) / max(high - low, 1e-9) * (len(_BARS) - 1)
    bars = "".join(_BARS[round(height)] for height in heights)
    return f"{scores[0]:.2f} {bars} {scores[-1]:.2f}"


def seen(obj, context, key, arrays):
    """Return the outcome's positions at value 1 as searched, (n,3) float32 in the object's own coordinates.

    `arrays` are those of the object. Raises Refusal where modifiers give the outcome other vertices.
    """
    if arrays.points is None:
        return mesh_io.key_positions(key)
    index = obj.data.shape_keys.key_blocks.find(key.name)
    with mesh_io.as_modelled(obj, context, index) as evaluated:
        positions = mesh_io.mesh_positions(evaluated)
    if len(positions) != len(arrays.vertices):
        raise Refusal(
            "Under the modifiers of “{name}”, “{outcome}” has other vertices than the object, so the "
            "shapes between cannot be scored. Apply the modifiers first",
            name=obj.name,
            outcome=key.name,
        )
    return positions
