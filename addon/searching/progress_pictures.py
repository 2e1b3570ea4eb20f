# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a running search for the panel: the best shape so far, and the course of its score.

They are previews of Blender's, no data-blocks: nothing of them gets into the file or the undo steps.
"""

import bpy
import bpy.utils.previews
import numpy as np

#: Pixels along each side.
SIZE = 112

#: RGBA, 0 to 1.
_LINE = np.array((0.45, 0.68, 1.0, 1.0), np.float32)
_AREA = np.array((0.28, 0.45, 0.70, 0.45), np.float32)
_GROUND = np.array((0.0, 0.0, 0.0, 0.25), np.float32)


class ProgressPictures:
    """The two pictures of one search."""

    def __init__(self):
        self._previews = None

    def show_view(self, view):
        """Show the best shape, (SIZE, SIZE, 4) uint8 with straight alpha, first row on top."""
        self._put("view", view[::-1].astype(np.float32) / 255.0)

    def show_course(self, course, fraction):
        """Draw the best score over the share of the work, up to `fraction`.

        `course` are pairs of share and score, both rising.
        """
        self._put("course", drawn_course(course, fraction))

    def icons(self):
        """Return the icon numbers of view and course, as far as there are any yet."""
        if self._previews is None:
            return []
        return [self._previews[name].icon_id for name in ("view", "course") if name in self._previews]

    def close(self):
        """Free them."""
        if self._previews is not None:
            bpy.utils.previews.remove(self._previews)
            self._previews = None

    def _put(self, name, pixels):
        if self._previews is None:
            self._previews = bpy.utils.previews.new()
        known = name in self._previews
        preview = self._previews[name] if known else self._previews.new(name)
        if not known:
            preview.image_size = (SIZE, SIZE)
        preview.image_pixels_float.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())


def drawn_course(course, fraction):
    """Return the picture of a course, (SIZE, SIZE, 4) float32, first row at the bottom."""
    pixels = np.empty((SIZE, SIZE, 4), np.float32)
    pixels[:] = _GROUND
    shares, scores = np.array(course, np.float64).T
    drawn = int(np.clip(round(fraction * SIZE), 2, SIZE))
    # The best so far holds until a better one is found.
    at = np.searchsorted(shares, np.arange(drawn) / SIZE, side="right") - 1
    values = scores[np.maximum(at, 0)]
    low, high = scores[0], max(scores[-1], scores[0] + 1e-3)
    heights = 4.0 + (SIZE - 12.0) * (values - low) / (high - low)
    rows = np.arange(SIZE)[:, None]
    rise = np.maximum(heights, np.append(heights[1:], heights[-1]))
    pixels[:, :drawn][rows < heights] = _AREA
    pixels[:, :drawn][(rows >= heights - 1.0) & (rows <= rise + 1.0)] = _LINE
    return pixels
