# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked for besides the prompt: from the settings to the library, and back from the record of an
outcome.
"""

from ..core import engine
from ..errors import Refusal

#: The settings that say what is asked for besides the prompt, and what leaves it as the prompt alone says.
DEFAULTS = {"negative": "", "source": "", "templates": "auto"}


def wording(prompt, negative="", source="", templates="auto"):
    """Return the library's Wording of these texts, each put on one line without outer blanks."""
    texts = (" ".join(text.split()) for text in (prompt, negative, source))
    return engine.library().Wording(*texts, templates)


def checked(guide, asked):
    """Return the words of a Wording that the guide does not know.

    Raises Refusal for texts that are misshapen, empty, endless or of unknown words alone, and where nothing
    is left of the prompt.
    """
    try:
        return asked.check(guide)
    except ValueError as error:
        raise Refusal(engine.capitalised(engine.sentence(error))) from error


def of_record(record):
    """Return the Wording that an outcome was searched for, from its record."""
    # Records of the first versions hold a prompt alone.
    return wording(
        record["prompt"],
        record.get("negative") or "",
        record.get("source") or "",
        "on" if record.get("templates") else "off",
    )
