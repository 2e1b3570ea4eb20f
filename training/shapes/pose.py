# SPDX-License-Identifier: MIT OR Apache-2.0
"""Poses of things that stand, lie or show their side, and points in their own axes whatever the pose."""

import numpy as np

# How row vectors turn into each pose: on the back (what pointed up points to +y), or upright but side on.
POSES = {
    "upright": np.eye(3),
    "lying": np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]),
    "side": np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
}


def take_pose(shape):
    """Turn a shape built upright into the pose of its trait, in place."""
    turn = POSES[shape.traits["pose"]]
    for part in shape.parts:
        part.vertices, part.attach = part.vertices @ turn, part.attach @ turn


def own_axes(shape, *labels):
    """The vertices of the labels as they stand upright whatever the pose, or None where there are none."""
    points = shape.points(*labels)
    return None if points is None else points @ POSES[shape.traits["pose"]].T
