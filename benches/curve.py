# SPDX-License-Identifier: MIT OR Apache-2.0
"""Draws how the score grows with the images, from the rows of `presets.py`: curve.svg.

Usage: benches/.venv/bin/python benches/curve.py
"""

import json

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import presets

#: What is drawn: title, and the names of the rows.
PANELS = (
    ("the paper's loss, joints and symmetry", [f"{name}, as the paper" for name in presets.BUDGETS]),
    ("our loss", list(presets.BUDGETS)),
)
#: Presets that are named in the picture.
MARKS = ("draft", "standard", "best")


def draw(axes, title, found, names):
    """The share of the paper's gain that half of the outcomes reach, with the middle 80 %."""
    images = [found[name]["images"] for name in names]
    gains = [found[name]["gains"] for name in names]
    low, middle, high = np.transpose([np.quantile(some, (0.1, 0.5, 0.9)) for some in gains])
    paper = found["paper"]
    axes.fill_between(images, low, high, alpha=0.2, linewidth=0, label="the middle 80 %")
    axes.plot(images, middle, "o-", label="median")
    axes.errorbar(
        paper["images"],
        np.median(paper["gains"]),
        np.abs(np.quantile(paper["gains"], [[0.1], [0.9]]) - np.median(paper["gains"])),
        fmt="s",
        color="black",
        capsize=3,
        label="the paper's protocol",
    )
    for mark in MARKS:
        place = next(i for i, name in enumerate(names) if name.startswith(mark))
        axes.annotate(mark, (images[place], middle[place]), (0, 8), textcoords="offset points", ha="center")
    axes.set(title=title, xscale="log", xlabel="images encoded", ylim=(0, 1.1))
    axes.grid(alpha=0.3)


def main():
    """Writes curve.svg beside the rows."""
    matplotlib.rcParams["svg.hashsalt"] = "boxmorph"
    found = presets.compared(json.loads(presets.ROWS.read_text()))
    figure, panels = plt.subplots(1, len(PANELS), figsize=(10, 4), sharey=True, layout="constrained")
    for axes, (title, names) in zip(panels, PANELS, strict=True):
        draw(axes, title, found, names)
    panels[0].set_ylabel("share of the paper's gain in score")
    panels[0].legend(loc="lower right")
    figure.savefig(presets.ROWS.with_name("curve.svg"), metadata={"Date": None})


if __name__ == "__main__":
    main()
