# SPDX-License-Identifier: GPL-3.0-or-later
"""A control of an outcome: a custom property of the object whose driver sets the outcome's value.

The property belongs to the object, not to its mesh: it is found beside the object's others, and drivers of
other things read it. The driver is a plain sum, so that no Python runs. It knows its control by the name of
its variable, whatever is renamed.
"""

import bpy

from ..errors import Refusal
from . import animation_curves

_VARIABLE = "boxmorph_control"

#: Names of custom properties are at most 63 bytes.
_NAME_BYTES = 59


def add(obj, key):
    """Make a custom property of `obj` that drives the value of its outcome `key`; return the property's name.

    It begins at the outcome's value and has the limits of its slider. Raises Refusal where the value is
    driven or keyframed.
    """
    if animation_curves.driver(key) is not None:
        raise Refusal("“{name}” is driven already", name=key.name)
    if animation_curves.is_animated(key):
        raise Refusal(
            "“{name}” has keyframes, which a driver would hide. Delete them first, and key the control "
            "instead",
            name=key.name,
        )
    name = _free_name(obj, key.name)
    obj[name] = key.value
    _set_limits(obj, name, key)
    driver = key.driver_add("value").driver
    driver.type = "SUM"
    variable = driver.variables.new()
    variable.name = _VARIABLE
    variable.targets[0].id = obj
    variable.targets[0].data_path = _path(name)
    return name


def update_limits(key):
    """Give the control of an outcome, if it has one, the limits of its slider, which a new search changes."""
    obj, name = _find(key)
    if name is not None:
        _set_limits(obj, name, key)


def remove(key):
    """Delete the control of an outcome, its keyframes and its driver, if it has one. Other drivers stay."""
    obj, name = _find(key)
    if name is not None:
        key.driver_remove("value")
        animation_curves.drop_empty(key.id_data)
        if animation_curves.curve(obj, _path(name)) is not None:
            animation_curves.remove_curve(obj, _path(name))
            animation_curves.drop_empty(obj)
        del obj[name]


def _find(key):
    """Return the object and the custom property that are the control of an outcome; (None, None) without
    one.
    """
    driver = animation_curves.driver(key)
    variable = None if driver is None else driver.driver.variables.get(_VARIABLE)
    target = None if variable is None else variable.targets[0]
    if target is None or target.id is None:
        return None, None
    name = next((name for name in target.id.keys() if target.data_path == _path(name)), None)
    return target.id, name


def _set_limits(obj, name, key):
    """Set limits, default and tooltip of a control."""
    least, greatest = key.slider_min, key.slider_max
    obj.id_properties_ui(name).update(
        min=least,
        max=greatest,
        soft_min=least,
        soft_max=greatest,
        default=0.0,
        description=f"How far the object is “{key.name}”: 0 as it was, 1 the prompt",
    )


def _free_name(obj, wanted):
    """Return a name that no custom property of `obj` has yet."""
    wanted = wanted.encode()[:_NAME_BYTES].decode(errors="ignore")
    number, name = 0, wanted
    while name in obj:
        number += 1
        name = f"{wanted}.{number:03}"
    return name


def _path(name):
    return f'["{bpy.utils.escape_identifier(name)}"]'
