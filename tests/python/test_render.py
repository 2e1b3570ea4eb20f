# SPDX-License-Identifier: MIT OR Apache-2.0
"""render: colors of triangles, and what of them is refused."""

import boxmorph
import numpy as np
import pytest


def test_colors_tint_the_grey(chair):
    white = np.full(chair[1].shape, 255, np.uint8)
    plain = boxmorph.render(*chair, size=64)
    assert np.array_equal(boxmorph.render(*chair, size=64, colors=white), plain)
    red = white * np.array([1, 0, 0], np.uint8)
    tinted = boxmorph.render(*chair, size=64, renderer="cpu", colors=red)
    assert np.array_equal(tinted, plain * np.array([1, 0, 0, 1], np.uint8))


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
