# SPDX-License-Identifier: MIT OR Apache-2.0
"""RESULTS.md: one section a script, so that each can write its own anew and leave the others."""

import os
import re

PATH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "RESULTS.md")


def write(title, script, lines):
    """Puts `lines` under the heading `title`, in place of what is there; a new section goes to the end."""
    section = "\n".join([f"## {title}", "", f"By `{script}`.", "", *lines])
    with open(PATH, encoding="utf-8") as file:
        head, *sections = re.split(r"^(?=## )", file.read(), flags=re.MULTILINE)
    titles = [known.splitlines()[0].removeprefix("## ") for known in sections]
    if title in titles:
        sections[titles.index(title)] = section
    else:
        sections.append(section)
    with open(PATH, "w", encoding="utf-8") as file:
        file.write("\n\n".join(part.strip() for part in [head, *sections]) + "\n")
