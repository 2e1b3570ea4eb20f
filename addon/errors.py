# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception of the extension: a sentence for the person at the keyboard."""

import functools


class Refusal(Exception):  # noqa: N818 (no error: the answer to a request)
    """Boxmorph does not do what was asked; the message says why and what to do instead."""


def tells_refusals(execute):
    """Decorate an operator's execute(): a Refusal becomes its error report, and it is cancelled."""

    @functools.wraps(execute)
    def told(self, context):
        try:
            return execute(self, context)
        except Refusal as refusal:
            self.report({"ERROR"}, str(refusal))
            return {"CANCELLED"}

    return told
