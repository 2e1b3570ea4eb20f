# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception of the extension: a sentence for the person at the keyboard."""


class Refusal(Exception):  # noqa: N818 (no error: the answer to a request)
    """Boxmorph does not do what was asked; the message says why and what to do instead."""
