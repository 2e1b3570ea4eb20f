# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyframe Spectrum: keyframes on the value of an outcome's shape key, with linear, eased or semantic timing.

The blend of a shape key is linear, so every frame between the keys is a valid deformation too.
"""

import numpy as np

from ..errors import Refusal
from . import animation_curves, score_curve
from .semantic_timing import even_alphas

TIMINGS = (
    ("linear", "Linear", "The value changes evenly"),
    ("eased", "Eased", "The value starts and ends slowly"),
    ("semantic", "Semantic", "The likeness to the prompt grows evenly: keys are placed by the guide's score"),
)

#: Keyframes of semantic timing, fewer where there are fewer frames.
_SEMANTIC_KEYS = 11

#: Keyframes nearer than this lie on one frame.
_SAME_FRAME = 1e-3


def keyframe_spectrum(
    obj,
    context,
    key,
    frame_from,
    frame_to,
    alpha_from=0.0,
    alpha_to=1.0,
    timing="linear",
    renderer=None,
):
    """Key the value of the outcome `key` of `obj` from `alpha_from` at `frame_from` to `alpha_to` at
    `frame_to`.

    Keyframes that lay between the two frames are replaced; others stay. Semantic timing measures the score
    and keeps its curve in the outcome's record. Raises Refusal, before anything is changed, for frames that
    are one and the same, values that the key's slider cannot take, a value that is driven, keyframes that are
    linked or locked, and, in semantic timing, a score that cannot be measured or does not rise.
    """
    _check(key, frame_from, frame_to, alpha_from, alpha_to)
    frames, alphas = [frame_from, frame_to], [alpha_from, alpha_to]
    curve = None
    if timing == "semantic":
        curve = score_curve.measure(obj, context, key, alpha_from, alpha_to, renderer)
        frames, alphas = _semantic_keys(curve, frames, alphas)
    _replace_keyframes(key, frames, alphas, "BEZIER" if timing == "eased" else "LINEAR")
    if curve is not None:
        score_curve.keep(obj, key, curve)


def _check(key, frame_from, frame_to, alpha_from, alpha_to):
    if frame_from == frame_to:
        raise Refusal(
            "The spectrum needs two different frames, and both are {frame}",
            frame=frame_from,
        )
    for alpha in (alpha_from, alpha_to):
        if not key.slider_min - 1e-6 <= alpha <= key.slider_max + 1e-6:
            raise Refusal(
                "The value {alpha:g} is outside of what “{name}” can be, {least:.2f} to {greatest:.2f}",
                alpha=alpha,
                name=key.name,
                least=key.slider_min,
                greatest=key.slider_max,
            )
    _require_free(key)


def keyframe_pose(keys, frame):
    """Key the present values of these shape keys at `frame`.

    From one such pose to the next all values run along straight lines: between two mixes of outcomes that are
    in range, so are all others. Raises Refusal, before anything is changed, where one of them is driven
    or its keyframes are linked or locked.
    """
    for key in keys:
        _require_free(key)
    for key in keys:
        _insert(key, frame)
        curve = animation_curves.curve(key.id_data, key.path_from_id("value"))
        for point in curve.keyframe_points:
            if abs(point.co.x - frame) < _SAME_FRAME:
                point.interpolation = "LINEAR"
        curve.update()


def _require_free(key):
    if animation_curves.driver(key) is not None:
        raise Refusal(
            "“{name}” is driven, and a driven value cannot be keyframed. Delete its driver first, or "
            "keyframe what drives it",
            name=key.name,
        )
    if animation_curves.is_linked(key.id_data):
        raise Refusal(
            "The keyframes of “{name}” are linked from another file, where changes would be lost. Make "
            "them local first (Object > Relations > Make Local > All)",
            name=key.name,
        )
    curve = animation_curves.curve(key.id_data, key.path_from_id("value"))
    if curve is not None and (curve.lock or (curve.group is not None and curve.group.lock)):
        raise Refusal(
            "The animation of “{name}” is locked. Unlock its channel in the Graph Editor first",
            name=key.name,
        )


def _semantic_keys(curve, frames, alphas):
    """Return frames and slider values, lists of floats, such that the score of `curve` rises evenly over the
    frames from the lower of two slider values to the higher.
    """
    (low, first), (high, last) = sorted(zip(alphas, frames, strict=True))
    count = min(_SEMANTIC_KEYS, abs(last - first) + 1)
    whole = np.rint(np.linspace(first, last, count))
    values = even_alphas(curve["alphas"], curve["scores"], (whole - first) / (last - first))
    # The ends as they were asked for, not as they are recorded.
    values[0], values[-1] = low, high
    return whole.tolist(), values.tolist()


def _replace_keyframes(key, frames, alphas, interpolation):
    """Put keyframes with these values in the place of all from the first to the last of `frames`."""
    keys = key.id_data
    path = key.path_from_id("value")
    first, last = min(frames), max(frames)
    curve = animation_curves.curve(keys, path)
    if curve is not None:
        for point in reversed(list(curve.keyframe_points)):
            if first <= point.co.x <= last:
                curve.keyframe_points.remove(point, fast=True)
        curve.update()
    for frame, alpha in zip(frames, alphas, strict=True):
        key.value = alpha
        _insert(key, frame)
    curve = animation_curves.curve(keys, path)
    for point in curve.keyframe_points:
        if first <= point.co.x <= last:
            point.handle_left_type = point.handle_right_type = "AUTO_CLAMPED"
        if first <= point.co.x < last:
            point.interpolation = interpolation
    curve.update()


def _insert(key, frame):
    if not key.keyframe_insert("value", frame=frame):
        raise Refusal(
            "Blender refused a keyframe on “{name}”; its animation may be linked or locked",
            name=key.name,
        )
