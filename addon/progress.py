# SPDX-License-Identifier: GPL-3.0-or-later
"""A search's progress in words."""


def progress_parts(progress):
    """Return progress in words: the phase, how far it is, and the time left; the latter two may be empty."""
    done = []
    if progress["generation"]:
        total = f" of {progress['generations']}" if progress["generations"] else ""
        done.append(f"Generation {progress['generation']}{total}")
    if progress["best_score"] is not None:
        done.append(f"score {progress['best_score']:.3f}")
    left = progress["seconds_left"]
    if left is None:
        left = ""
    else:
        left = f"{left:.0f} s left" if left < 100 else f"{left / 60:.0f} min left"
    return progress["phase"].capitalize(), ", ".join(done), left


def progress_text(progress):
    """Return progress in one line."""
    return "   ".join(part for part in progress_parts(progress) if part)
