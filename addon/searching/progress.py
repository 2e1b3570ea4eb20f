# SPDX-License-Identifier: GPL-3.0-or-later
"""A search's progress in words and pictures."""

import re

from .progress_pictures import ProgressPictures


def progress_parts(progress, say=str):
    """Return progress in words: phase, generation, scores, time left; all but the first may be empty.

    In English, unless `say` translates.
    """
    generation = scores = left = ""
    if progress["generation"]:
        words = say("Generation {} of {}") if progress["generations"] else say("Generation {}")
        generation = words.format(progress["generation"], progress["generations"])
    if progress["best_score"] is not None:
        before = progress["score_before"]
        before = "" if before is None else f"{before:.3f} → "
        scores = say("Score {}").format(f"{before}{progress['best_score']:.3f}")
    if progress["seconds_left"] is not None:
        seconds = progress["seconds_left"]
        is_short = seconds < 100
        words = say("{:.0f} s left") if is_short else say("{:.0f} min left")
        left = words.format(seconds if is_short else seconds / 60)
    return _phase(progress["phase"], say), generation, scores, left


def _phase(text, say):
    """Return what the library calls a phase; it is translated without its numbers."""
    return say(re.sub(r"\d+", "{}", text)).format(*re.findall(r"\d+", text))


def progress_text(progress, say=str):
    """Return progress in one line; in English, unless `say` translates."""
    return "   ".join(part for part in progress_parts(progress, say) if part)


class Progress:
    """What is known of the course of one search: its scores so far, and their pictures."""

    def __init__(self):
        #: Share of the work done and best score, each time that score rose.
        self.course = []
        self.pictures = ProgressPictures()

    def follow(self, search):
        """Take up where `search` stands now."""
        progress = search.progress
        score = progress["best_score"]
        if score is None:
            return
        if not self.course and progress["score_before"] is not None:
            self.course.append((0.0, progress["score_before"]))
        risen = not self.course or score > self.course[-1][1]
        if risen:
            self.course.append((progress["fraction"], score))
            self.pictures.show_view(search.best_view())
        self.pictures.show_course(self.course, progress["fraction"])

    def close(self):
        """Free the pictures."""
        self.pictures.close()
