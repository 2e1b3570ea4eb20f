# SPDX-License-Identifier: MIT OR Apache-2.0
"""Modifiers: what is seen after the search is what was scored, or the user is told."""

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def whole(kind, **settings):
    def make():
        obj = blender.chair()
        modifier = obj.modifiers.new("Tested", kind)
        for name, value in settings.items():
            setattr(modifier, name, value)
        return obj

    return make


def half(**settings):
    def make():
        obj = blender.chair(half=True)
        for name, value in settings.items():
            setattr(obj.modifiers["Mirror"], name, value)
        return obj

    return make


def armature():
    obj = blender.chair()
    rig = bpy.data.objects.new("Rig", bpy.data.armatures.new("Rig"))
    bpy.context.scene.collection.objects.link(rig)
    obj.modifiers.new("Armature", "ARMATURE").object = rig
    return obj


def told(capfd):
    return "differs from what was scored" in "".join(capfd.readouterr())


@pytest.mark.parametrize(
    "make",
    [
        half(),
        half(use_clip=True),
        whole("ARRAY", count=2, relative_offset_displace=(1.5, 0.0, 0.0)),
        whole("SUBSURF", levels=1),
        whole("SOLIDIFY", thickness=0.005),
        whole("BEVEL", width=0.003),
        armature,
    ],
    ids=["mirror", "mirror with clipping", "array", "subdivision", "solidify", "bevel", "armature"],
)
def test_what_is_seen_is_what_was_scored_or_the_user_is_told(make):
    obj = make()
    rest = blender.evaluated_positions(obj)
    search = blender.addon("search").Search(bpy.context, obj, PROMPT, splits="2")
    search.run()
    search.keep(obj)
    notes = search.departures(obj, bpy.context)
    scored = search.result.vertices
    assert np.abs(scored - rest).max() > 0.01
    seen = blender.evaluated_positions(obj)
    away = np.linalg.norm(seen - scored, axis=1).max() / np.linalg.norm(np.ptp(scored, axis=0))
    assert (away <= 0.01) == (notes == []), (away, notes)


def test_a_modifier_that_does_not_follow_is_named(capfd):
    obj = whole("ARRAY", count=2, use_relative_offset=False, use_constant_offset=True)()
    obj.modifiers["Tested"].constant_offset_displace = (3.0, 0.0, 0.0)
    blender.deform(PROMPT)
    text = "".join(capfd.readouterr())
    assert "differs from what was scored" in text and "Tested" in text


def test_a_plain_object_is_not_commented_on(capfd):
    blender.chair()
    blender.deform(PROMPT)
    assert not told(capfd)
