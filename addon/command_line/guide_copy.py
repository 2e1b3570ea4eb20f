# SPDX-License-Identifier: GPL-3.0-or-later
"""`guides --quantize`: a copy of a guide in eight bits."""

from ..core import guide_copies
from .command_checks import DONE


def make(folder):
    """Make the copy of the guide in a folder, and say what it is worth; None is the embedded guide."""
    copy, figures = guide_copies.eight_bit_copy(folder)
    print(f"boxmorph: {copy}: {guide_copies.summary(figures)}", flush=True)
    return DONE
