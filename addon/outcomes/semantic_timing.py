# SPDX-License-Identifier: GPL-3.0-or-later
"""Semantic timing: where on the slider the score has risen by a given share."""

import numpy as np

from ..errors import Refusal

#: The least rise of a score that keys can be placed by: what three decimals show.
LEAST_RISE = 0.001


def even_alphas(alphas, scores, shares):
    """Return the slider values, (n,) float64, at which the score first reaches each of `shares` of its rise.

    `alphas`, (k,) increasing, and `scores`, (k,), are samples of the score along the slider, taken as
    straight between them. `shares`, (n,) increasing from 0 to 1, are of the rise from the first score to the
    last; 0 and 1 give the first and the last of `alphas` themselves. What lies where the score falls, stands
    still or is above the last is passed over between two values, so these increase. Raises Refusal where the
    score does not rise by LEAST_RISE.
    """
    alphas, scores = np.asarray(alphas, np.float64), np.asarray(scores, np.float64)
    rise = scores[-1] - scores[0]
    if not rise >= LEAST_RISE:
        raise Refusal(
            "The score does not rise from value {first:.3g} ({low:.3f}) to {last:.3g} ({high:.3f}), so "
            "keys cannot be placed by it. Choose other values or another timing",
            first=alphas[0],
            low=scores[0],
            last=alphas[-1],
            high=scores[-1],
        )
    highest = np.maximum.accumulate(scores)
    levels = scores[0] + rise * np.asarray(shares, np.float64)[1:-1]
    # The first sample that is as high: those before are lower, so that the step to it crosses the level.
    upper = np.searchsorted(highest, levels, side="left")
    lower = upper - 1
    part = (levels - scores[lower]) / (scores[upper] - scores[lower])
    inner = alphas[lower] + part * (alphas[upper] - alphas[lower])
    return np.concatenate((alphas[:1], inner, alphas[-1:]))
