# SPDX-License-Identifier: MIT OR Apache-2.0
"""render: colors of triangles, and what of them is refused."""

import boxmorph
import numpy as np
import pytest


def test_triangles_are_drawn_in_their_colors(chair):
    plain = boxmorph.render(*chair, size=64, renderer="cpu")
    assert np.array_equal(boxmorph.render(*chair, size=64, renderer="cpu", colors=None), plain)
    red = np.broadcast_to(np.uint8((255, 0, 0)), chair[1].shape).copy()
    image = boxmorph.render(*chair, size=64, colors=red)
    assert np.array_equal(image[..., 3], plain[..., 3]) and not image[..., 1:3].any()
    seen = image[..., 3] > 0
    assert image[seen, 0].min() > 80 and image[seen, 0].max() > 250
    # The lighter the grey, the lighter the color.
    order = np.argsort(plain[seen, 0], kind="stable")
    assert (np.diff(image[seen, 0][order].astype(int)) >= -1).all()


def test_colors_that_do_not_fit_are_refused(chair):
    white = np.full(chair[1].shape, 255, np.uint8)
    with pytest.raises(ValueError, match="draws no colors"):
        boxmorph.render(*chair, renderer="gpu", colors=white)
    with pytest.raises(ValueError, match="one color each"):
        boxmorph.render(*chair, colors=white[1:])
    with pytest.raises(ValueError, match="shape"):
        boxmorph.render(*chair, colors=white[:, :2].copy())
    with pytest.raises(TypeError, match="uint8"):
        boxmorph.render(*chair, colors=white.astype(np.float32))
