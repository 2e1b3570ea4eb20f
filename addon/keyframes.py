# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyframe Spectrum: two linear keyframes on the value of an outcome's shape key.

The blend of a shape key is linear, so every frame between the two is a valid deformation too.
"""

from .errors import Refusal


def keyframe_spectrum(key, frame_from, frame_to, alpha_from=0.0, alpha_to=1.0):
    """Key the value of shape key `key` from `alpha_from` at `frame_from` to `alpha_to` at `frame_to`,
    linearly.

    Keyframes that lay between the two frames are replaced; others stay. Raises Refusal for frames that are
    one and the same, and for values that the key's slider cannot take.
    """
    if frame_from == frame_to:
        raise Refusal(f"The spectrum needs two different frames, and both are {frame_from}")
    for alpha in (alpha_from, alpha_to):
        if not key.slider_min - 1e-6 <= alpha <= key.slider_max + 1e-6:
            raise Refusal(
                f"The value {alpha:g} is outside of what “{key.name}” can be, "
                f"{key.slider_min:.2f} to {key.slider_max:.2f}"
            )
    keys = key.id_data
    path = key.path_from_id("value")
    first, last = sorted((frame_from, frame_to))
    curve = _curve(keys, path)
    if curve is not None:
        for point in reversed(list(curve.keyframe_points)):
            if first <= point.co.x <= last:
                curve.keyframe_points.remove(point, fast=True)
        curve.update()
    for frame, alpha in ((frame_from, alpha_from), (frame_to, alpha_to)):
        key.value = alpha
        if not key.keyframe_insert("value", frame=frame):
            raise Refusal(
                f"Blender refused a keyframe on “{key.name}”; its animation may be linked or locked"
            )
    curve = _curve(keys, path)
    for point in curve.keyframe_points:
        if first <= point.co.x < last:
            point.interpolation = "LINEAR"
    curve.update()


def is_animated(key):
    """Whether keyframes or a driver set the value of shape key `key`."""
    animation = key.id_data.animation_data
    path = key.path_from_id("value")
    if animation is None:
        return False
    return _curve(key.id_data, path) is not None or animation.drivers.find(path) is not None


def remove_curve(keys, path):
    """Delete the animation curve of `path` on the Key data-block `keys`, if there is one."""
    curve = _curve(keys, path)
    if curve is not None:
        _curves(keys).remove(curve)


def _curve(keys, path):
    curves = _curves(keys)
    return None if curves is None else curves.find(path)


def _curves(keys):
    """Return the F-curves of a Key data-block, or None without animation: slotted actions since Blender
    4.4.
    """
    animation = keys.animation_data
    if animation is None or animation.action is None:
        return None
    if not hasattr(animation.action, "slots"):
        return animation.action.fcurves
    if animation.action_slot is None:
        return None
    from bpy_extras import anim_utils

    bag = anim_utils.action_get_channelbag_for_slot(animation.action, animation.action_slot)
    return None if bag is None else bag.fcurves
