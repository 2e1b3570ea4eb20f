# SPDX-License-Identifier: GPL-3.0-or-later
"""The animation of shape keys: curves and drivers on a Key data-block, in every version of Blender.

Curves of other data-blocks, such as objects, are found and deleted the same way.
"""

import bpy


def is_animated(key):
    """Whether keyframes or a driver set the value of shape key `key`."""
    return curve(key.id_data, key.path_from_id("value")) is not None or driver(key) is not None


def driver(key):
    """Return the driver's curve of the value of shape key `key`, or None."""
    animation = key.id_data.animation_data
    return None if animation is None else animation.drivers.find(key.path_from_id("value"))


def is_linked(keys):
    """Whether the keyframes of the data-block `keys` are another file's, where changes would be lost."""
    animation = keys.animation_data
    return animation is not None and animation.action is not None and not animation.action.is_editable


def remove_curve(keys, path):
    """Delete the animation curve of `path` on the Key data-block `keys`, if there is one and it is ours."""
    found = curve(keys, path)
    if found is not None and not is_linked(keys):
        curves(keys).remove(found)


def drop_empty(keys):
    """Delete what is empty of the animation of the data-block `keys` and used by nobody else: its slot in the
    action, the action, the animation data.
    """
    animation = keys.animation_data
    if animation is None or animation.use_tweak_mode:
        return
    # None without an action, or without a slot in it.
    found = curves(keys)
    if found is not None and not found and not is_linked(keys):
        action, slot = animation.action, getattr(animation, "action_slot", None)
        unshared = action.users == 1
        animation.action = None
        # The object's own keyframes may be in the same action, in another slot.
        if slot is not None and not slot.users():
            action.slots.remove(slot)
        if unshared and len(getattr(action, "slots", ())) == 0:
            bpy.data.actions.remove(action)
    if animation.action is None and not animation.drivers and not animation.nla_tracks:
        keys.animation_data_clear()


def curve(keys, path):
    """Return the animation curve of `path` on the Key data-block `keys`, or None."""
    found = curves(keys)
    return None if found is None else found.find(path)


def curves(keys):
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
