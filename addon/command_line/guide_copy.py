# SPDX-License-Identifier: GPL-3.0-or-later
"""`guides --quantize`: a copy of a guide in eight bits."""

from ..core import guide_copies
from ..errors import Refusal
from .command_checks import DONE


def make(folder):
    """Make the copy of the guide in a folder, and say what it is worth; None is the embedded guide."""
    guide_copies.start(folder)
    try:
        copy, figures = guide_copies.wait()
    except KeyboardInterrupt:
        guide_copies.stop()
        raise Refusal("Interrupted; nothing of the copy is left") from None
    print(f"boxmorph: {copy}: {guide_copies.summary(figures)}", flush=True)
    return DONE
