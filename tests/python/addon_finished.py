# SPDX-License-Identifier: MIT OR Apache-2.0
"""A chair that an artist is done with: three outcomes, one keyframed, one driven, one taken apart."""

import addon_blender as blender
import numpy as np
from addon_blender import bpy

#: Keyframed. Unicode, quotes, and more bytes than a name may have.
STOOL = 'a bar stool, "hoch" für 椅子 und Jürgens Großmutter, 2 m'
#: Driven by the object's property.
SOFA = "a sofa"
#: Taken apart; one of the pieces is keyframed.
TABLE = "a low table"

#: Frames and values of Keyframe Spectrum: below 0 and above 1.
FRAMES, VALUES = (1, 11), (-0.25, 1.05)


def build(timing="linear", chair=blender.chair):
    """Make the chair in an empty file. Returns the object and the names of its outcomes, STOOL's first."""
    blender.empty_scene()
    obj = chair()
    for prompt in (SOFA, TABLE, STOOL):
        blender.deform(prompt, splits="1")
    stool = blender.addon("shape_key").key_name(STOOL)
    keys = obj.data.shape_keys.key_blocks
    keys[TABLE].value = 0.5
    assert bpy.ops.boxmorph.take_apart(key=TABLE) == {"FINISHED"}
    piece = blender.addon("shape_key").pieces(obj.data, TABLE)[0]
    for frame, value in ((1, 0.0), (11, 0.5)):
        piece.value = value
        piece.keyframe_insert("value", frame=frame)
    assert bpy.ops.boxmorph.keyframe_spectrum(
        key=stool,
        frame_from=FRAMES[0],
        frame_to=FRAMES[1],
        alpha_from=VALUES[0],
        alpha_to=VALUES[1],
        timing=timing,
    ) == {"FINISHED"}
    obj["sofa"] = 0.75
    driver = keys[SOFA].driver_add("value").driver
    driver.type = "SUM"
    target = driver.variables.new().targets[0]
    target.id, target.data_path = obj, '["sofa"]'
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = FRAMES
    bpy.context.scene.frame_set(1)
    return obj, (stool, SOFA, TABLE)


def drivers(keys):
    """Return the drivers of a Key data-block, as comparable data; what they refer to, by name."""
    return [
        (
            curve.data_path,
            curve.driver.type,
            [(t.id.name, t.data_path) for v in curve.driver.variables for t in v.targets],
        )
        for curve in (keys.animation_data.drivers if keys.animation_data else ())
    ]


def curves(keys):
    """Return the keyframes of a Key data-block, as comparable data."""
    return [
        (
            curve.data_path,
            [(*p.co, p.interpolation, p.handle_left_type, *p.handle_left) for p in curve.keyframe_points],
        )
        for curve in blender.addon("animation_curves").curves(keys) or ()
    ]


def state(obj):
    """Return all of the outcomes of an object, as comparable data: keys, record, animation, what is seen."""
    keys = obj.data.shape_keys
    bpy.context.scene.frame_set(1)
    _pin, blocks, properties = blender.key_state(obj)
    return {
        "keys": blocks,
        "record": properties,
        "curves": curves(keys),
        "drivers": drivers(keys),
        "values": values(obj, *range(0, 13)),
        "seen": seen(obj, 7).tobytes(),
    }


def values(obj, *frames):
    """Return the values of the keys without Basis at these frames, (frames,keys)."""
    out = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        out.append([key.value for key in obj.data.shape_keys.key_blocks[1:]])
    return out


def seen(obj, frame):
    """Return the positions that are seen at a frame, (n,3)."""
    bpy.context.scene.frame_set(frame)
    return blender.evaluated_positions(obj)


def changes(obj):
    """Return what each key without Basis adds to the positions at 1, by name, (n,3) each."""
    keys = obj.data.shape_keys
    basis = blender.positions(keys.reference_key)
    return {key.name: blender.positions(key) - basis for key in keys.key_blocks[1:]}


def size(obj):
    """Return the diagonal of the object at rest."""
    return np.linalg.norm(np.ptp(blender.positions(obj.data.shape_keys.reference_key), axis=0))
