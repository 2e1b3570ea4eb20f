# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the prompt's field suggests while one types."""

import addon_blender as blender
import pytest
from addon_blender import bpy

NAMES = ["a chair", "a bar stool", "an armchair", "a barn", "a bar table", "a footstool"]


@pytest.mark.parametrize(
    "typed, suggested",
    [
        ("", NAMES),
        ("a bar", ["a bar stool", "a barn", "a bar table"]),
        ("a bar ", ["a bar stool", "a bar table"]),
        ("Bar St", ["a bar stool"]),
        ("stool", ["a bar stool"]),
        ("a tall bar st", ["a tall bar stool"]),
        ("a tall ch", ["a tall chair"]),
        ("an ar", ["an armchair"]),
        ("zorb", []),
    ],
)
def test_what_is_typed_is_completed(typed, suggested):
    assert blender.addon("suggestions").completions(typed, NAMES) == suggested


def test_the_names_of_the_guide_are_suggested():
    found = blender.addon("suggestions").suggest(None, bpy.context, "a bar s")
    assert found == ["a bar stool"]


def test_a_missing_guide_stops_nobody_from_typing():
    blender.preferences().guide_folder = "/there/is/no/such/folder"
    try:
        assert blender.addon("suggestions").suggest(None, bpy.context, "a bar s") == []
    finally:
        blender.preferences().guide_folder = ""
