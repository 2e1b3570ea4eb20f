# SPDX-License-Identifier: GPL-3.0-or-later
"""The contact sheet of an evaluation: each outcome before and after, with its prompt and its numbers."""

import math

import numpy as np

from ..core import lettering
from . import evaluation
from .evaluations import PICTURE_SIZE

_TEXT_WIDTH = 460
_HEADING, _LINE = 26, 20
_GAP = 8

#: Rows below each other; more stand in columns beside them.
_ROWS = 24


def sheet(found, say=str):
    """Return the contact sheet of these Evaluated as a picture, (h,w,3) uint8; in English, unless `say`
    translates. There must be one.
    """
    columns = math.ceil(len(found) / _ROWS)
    rows = math.ceil(len(found) / columns)
    height, width = PICTURE_SIZE + _GAP, 2 * PICTURE_SIZE + _TEXT_WIDTH + 3 * _GAP
    picture = np.full((rows * height + _GAP, columns * width, 3), 255, np.uint8)
    for index, evaluated in enumerate(found):
        top, left = index % rows * height + _GAP, index // rows * width + _GAP
        if evaluated.picture is not None:
            picture[top : top + PICTURE_SIZE, left : left + 2 * PICTURE_SIZE] = evaluated.picture
        text = _text(evaluated, say)
        left += 2 * PICTURE_SIZE + _GAP
        picture[top : top + len(text), left : left + _TEXT_WIDTH] = text
    return picture


def _text(evaluated, say):
    """Return what is said of an outcome, at most as high as its picture."""
    place = " · ".join(filter(None, (evaluated.object, evaluated.file)))
    if evaluated.evaluation is None:
        lines = [evaluated.refusal.said(say)]
    else:
        lines = evaluation.lines(evaluated.evaluation, say)
    heading = lettering.text_picture(evaluated.prompt, _HEADING, _TEXT_WIDTH)
    parts = [heading, *(lettering.text_picture(line, _LINE, _TEXT_WIDTH) for line in (place, *lines))]
    return np.concatenate(parts, axis=0)[:PICTURE_SIZE]
