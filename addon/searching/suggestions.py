# SPDX-License-Identifier: GPL-3.0-or-later
"""Prompts to suggest while one is typed: the names that the guide was taught."""

import re

from ..core import engine
from ..errors import Refusal

#: All of a prompt up to where its next part begins.
_BEHIND_WEIGHT = re.compile(r".*:\s*[\d.]+\s*,\s*")


def suggest(_settings, _context, text):
    """Return the prompts that complete what is typed so far (the callback of the prompt's field)."""
    try:
        return completions(text, engine.open_guide().classes)
    except Refusal:
        # Without a guide the button says why; typing goes on.
        return []


def completions(text, names):
    """Return prompts that end `text` as one of `names` ("a bar stool"); all names where it is empty.

    The last words typed count, as many as begin a name or a word of one: "a tall bar st" gives
    "a tall bar stool". Behind a weight a new prompt begins: "a sofa:1, a th" gives "a sofa:1, a throne".
    """
    if behind := _BEHIND_WEIGHT.match(text):
        earlier, text = behind[0], text[behind.end() :]
        return [earlier + found for found in completions(text, names)]
    words = text.lower().split()
    if not words:
        return list(names)
    for start in range(len(words)):
        # A blank at the end ends the word: "a bar " is no barn.
        head, typed = words[:start], " ".join(words[start:]) + text[-1:].isspace() * " "
        found = [name for name in names if name.startswith(typed) or _bare(name).startswith(typed)]
        found += [n for n in names if n not in found and f" {typed}" in f" {_bare(n)}"]
        if found:
            return [" ".join([*head, _bare(name)]) if head else name for name in found]
    return []


def _bare(name):
    """The name without its article."""
    article, _, rest = name.partition(" ")
    return rest if article in ("a", "an") else name
