# SPDX-License-Identifier: MIT OR Apache-2.0
"""Write the lists and tables of the guide's model card from what training and steering left behind.

`python training/card.py GUIDE/README.md rounds.json [name=steering.json ...]` replaces what stands between
`<!-- words -->`, `<!-- rounds -->` and each `<!-- name -->` and the closing mark `<!-- end -->`.
"""

import argparse
import json
import re
from pathlib import Path

from families import FAMILIES
from steer import summary


def words():
    """A line for every family: its word, its kinds and its adjectives."""
    lines = []
    for family in FAMILIES.values():
        lines.append(f"- **{family.word}**: {', '.join(family.kinds)}. *{', '.join(family.adjectives)}*")
    return "\n".join(lines)


def rounds(record):
    """A table of the held-out figures and of what mining found, one column a round."""
    head = "| | " + " | ".join(f"round {r['round'] + 1}" for r in record) + " |"
    lines = [head, "|---" * (len(record) + 1) + "|"]

    def row(name, value):
        lines.append(f"| {name} | " + " | ".join(value(r) for r in record) + " |")

    def shares(module):
        return lambda r: "{first:.0%}, {first three:.0%}".format(**r["held out"][module])

    for module in FAMILIES:
        row(f"{module}: first, first three", shares(module))
    row(
        "correlation of score and truth",
        lambda r: f"{r['held out']['correlation of score and truth']:.2f}",
    )
    for name in ("searches", "mean truth of the best", "believed but not true"):
        row(f"mined: {name}", lambda r, name=name: f"{r['mined'][name]:g}" if "mined" in r else "")
    row("minutes since the start", lambda r: f"{r['minutes']:.0f}")
    return "\n".join(lines)


def steering(rows):
    """A list of the summary's figures."""
    return "\n".join(f"- {name}: {value:g}" for name, value in summary(rows).items())


def replace(text, mark, body):
    """The text with what stands after a mark, up to the closing one, replaced."""
    pattern = re.compile(rf"<!-- {mark} -->.*?<!-- end -->", re.S)
    return pattern.sub(lambda _: f"<!-- {mark} -->\n{body}\n<!-- end -->", text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("card", type=Path)
    parser.add_argument("rounds", type=Path)
    parser.add_argument("steered", nargs="*", help="name=steering.json")
    a = parser.parse_args()
    text = replace(a.card.read_text(), "words", words())
    text = replace(text, "rounds", rounds(json.loads(a.rounds.read_text())))
    for pair in a.steered:
        mark, path = pair.split("=", 1)
        text = replace(text, mark, steering(json.loads(Path(path).read_text())))
    a.card.write_text(text)
