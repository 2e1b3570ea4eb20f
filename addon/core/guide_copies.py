# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies of guides in eight bits: smaller, faster on most processors, a little less exact."""

import os

from ..errors import Refusal
from . import engine, guides

#: What the name of a copy's folder ends in.
_ENDING = "-8bit"


def eight_bit_copy(folder):
    """Write a copy of the guide in `folder` into the guides folder; return the copy's folder, and the figures
    of `boxmorph.Guide.quantize`. None is the embedded guide. Takes about a minute for a large one. Raises
    Refusal.
    """
    if folder is None:
        raise Refusal("The embedded guide is fast as it is. Choose a large one first")
    copy = os.path.join(guides.root(), os.path.basename(folder) + _ENDING)
    if os.path.exists(copy):
        raise Refusal("{folder} is there already. Choose that guide, or delete it first", folder=copy)
    boxmorph = engine.library()
    # Not three at once: they may be large.
    engine.close_guide()
    try:
        os.makedirs(guides.root(), exist_ok=True)
        return copy, boxmorph.Guide.quantize(folder, copy)
    except (boxmorph.GuideError, ValueError, OSError) as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error


def summary(figures, say=str):
    """Return in a line what a copy is worth; in English, unless `say` translates."""
    said = say(
        "{bytes} instead of {exact_bytes}, {speed:.1f} times as fast. Its embeddings agree to a cosine of "
        "{cosine:.4f}, and it puts candidates into the same order to {order:.2f} of 1"
    )
    return said.format(
        bytes=guides.megabytes(figures["bytes"]),
        exact_bytes=guides.megabytes(figures["exact_bytes"]),
        speed=figures["images_per_second"] / figures["exact_images_per_second"],
        cosine=figures["cosine_mean"],
        order=figures["rank_mean"],
    )
