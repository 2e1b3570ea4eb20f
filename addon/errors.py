# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception of the extension: a sentence for the person at the keyboard."""


class Refusal(Exception):
    """Boxmorph does not do what was asked; the message says why and what to do instead."""
