# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception of the extension: a sentence for the person at the keyboard."""

import collections
import functools

from bpy.app.translations import pgettext_rpt as rpt_

#: The last sentences told in this session, the newest last; for the report on a bug.
told = collections.deque(maxlen=10)


class Refusal(Exception):  # noqa: N818 (no error: the answer to a request)
    """Boxmorph does not do what was asked; the message says why and what to do instead.

    It is a template for translators, and the values of its fields. As a str it is English.
    """

    def __init__(self, template, **values):
        self._template, self._values = template, values
        super().__init__(self.said(str))

    def said(self, say):
        """Return the message as `say` translates it."""
        template = say(self._template)
        return template.format(**self._values) if self._values else template


def refused(error):
    """Return the Refusal that an operator told, from the RuntimeError that calling it from Python raised."""
    return Refusal(str(error).strip().removeprefix(f"{rpt_('Error')}: "))


def remember(sentence):
    """Keep a sentence that the user was told, unless it repeats the last."""
    if not told or told[-1] != sentence:
        told.append(sentence)


def tell(operator, refusal):
    """Make a Refusal the error report of an operator, and return what the operator is to return."""
    remember(str(refusal))
    operator.report({"ERROR"}, refusal.said(rpt_))
    return {"CANCELLED"}


def tells_refusals(execute):
    """Decorate an operator's execute(): a Refusal becomes its error report, and it is cancelled."""

    @functools.wraps(execute)
    def telling(self, context):
        try:
            return execute(self, context)
        except Refusal as refusal:
            return tell(self, refusal)

    return telling
