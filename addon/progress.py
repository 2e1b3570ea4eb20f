# SPDX-License-Identifier: GPL-3.0-or-later
"""A search's progress in words and pictures."""

from .progress_pictures import ProgressPictures


def progress_parts(progress):
    """Return progress in words: phase, generation, scores, time left; all but the first may be empty."""
    generation = scores = left = ""
    if progress["generation"]:
        total = f" of {progress['generations']}" if progress["generations"] else ""
        generation = f"Generation {progress['generation']}{total}"
    if progress["best_score"] is not None:
        before = progress["score_before"]
        before = "" if before is None else f"{before:.3f} → "
        scores = f"Score {before}{progress['best_score']:.3f}"
    if progress["seconds_left"] is not None:
        seconds = progress["seconds_left"]
        left = f"{seconds:.0f} s left" if seconds < 100 else f"{seconds / 60:.0f} min left"
    return progress["phase"].capitalize(), generation, scores, left


def progress_text(progress):
    """Return progress in one line."""
    return "   ".join(part for part in progress_parts(progress) if part)


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
