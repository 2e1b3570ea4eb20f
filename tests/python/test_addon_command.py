# SPDX-License-Identifier: MIT OR Apache-2.0
"""The command line's sub-commands, called as Blender calls them; real Blender's own way is tried in
tests/blender.
"""

import json

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy


@pytest.fixture
def file(tmp_path):
    """A file with the chair, open."""
    blender.empty_scene()
    blender.chair()
    path = tmp_path / "chair.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def boxmorph(*arguments):
    return blender.addon("command").main([str(argument) for argument in arguments])


def pixels(path):
    """Return the pixels of a PNG, (h,w,3) uint8, first row on top."""
    image = bpy.data.images.load(str(path))
    width, height = image.size
    out = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(out)
    bpy.data.images.remove(image)
    return np.rint(255 * out.reshape(height, width, 4)[::-1, :, :3]).astype(np.uint8)


def test_parts_are_listed_with_their_colors(file, capfd):
    assert boxmorph("parts", "--splits", "2") == 0
    lines = capfd.readouterr().out.splitlines()
    assert any(line.startswith("boxmorph: 2 splits, ") for line in lines), lines
    listed = [line for line in lines if " × " in line]
    parts = bpy.context.active_object.boxmorph.items
    assert [line.partition(":")[0] for line in listed] == [part.name for part in parts]
    for line, part in zip(listed, parts, strict=True):
        assert line.endswith("#" + "".join(f"{round(255 * channel):02x}" for channel in part.color))


@pytest.mark.parametrize("splits", ["1", "3"])
def test_the_sheet_shows_every_part_in_its_color(file, tmp_path, splits):
    sheet = tmp_path / "parts.png"
    assert boxmorph("parts", "--splits", splits, "--sheet", sheet) == 0
    colors = [np.rint(255 * np.array(part.color)) for part in bpy.context.active_object.boxmorph.items]
    picture = pixels(sheet).astype(int)
    band = picture[-1]
    fields = band[[0, *(1 + np.flatnonzero((np.diff(band, axis=0) != 0).any(axis=1)))]]
    assert np.abs(fields - colors).max() <= 1
    # Each color is seen in the views, lighter or darker.
    views = picture[:224].reshape(-1, 3)
    views = views[views.min(axis=1) < 250]
    for color in colors:
        shade = views.max(axis=1) / color.max()
        same = np.abs(views - shade[:, None] * color).max(axis=1) < 4
        assert (same & (shade > 0.2)).sum() > 50, color


def test_a_sheet_that_cannot_be_written_is_refused(file, tmp_path, capfd):
    assert boxmorph("parts", "--sheet", tmp_path / "none" / "parts.png") == 1
    assert "cannot be written" in capfd.readouterr().err


def test_hues_have_names():
    name = blender.addon("command_parts").color_name
    assert name((255, 0, 0)) == "red #ff0000" and name((60, 60, 250)) == "blue #3c3cfa"
    assert name((250, 10, 20)).startswith("red ")


def test_deform_saves_the_file_with_its_key(file, tmp_path, capfd):
    output = tmp_path / "out.blend"
    assert boxmorph("deform", "--prompt", "a bar stool", "--splits", "2", "--output", output) == 0
    assert "score" in capfd.readouterr().out
    bpy.ops.wm.open_mainfile(filepath=str(output))
    assert "a bar stool" in bpy.data.objects["Chair"].data.shape_keys.key_blocks


def test_a_search_takes_the_seconds_of_the_command_line(file, tmp_path):
    report, output = tmp_path / "report.json", tmp_path / "stool.blend"
    options = ("--prompt", "a bar stool", "--output", output, "--report", report)
    assert boxmorph("deform", "--seconds", "2", *options) == 0
    assert json.loads(report.read_text())["seconds_budget"] == 2.0


@pytest.mark.parametrize("options", [("--seconds", "0"), ("--seconds", "5", "--preset", "best")])
def test_seconds_that_cannot_be_are_wrong_usage(file, options):
    with pytest.raises(SystemExit) as refused:
        boxmorph("deform", "--prompt", "a bar stool", *options)
    assert refused.value.code == 2
