# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences in a layout, which breaks no lines of its own."""

import textwrap


def draw_lines(box, lines, letters):
    """Draw lines with icons, broken after so many letters."""
    column = box.column(align=True)
    for line, icon in lines:
        for number, piece in enumerate(textwrap.wrap(line, letters)):
            column.label(text=piece, icon="BLANK1" if number else icon, translate=False)
