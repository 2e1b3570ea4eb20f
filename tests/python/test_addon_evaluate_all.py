# SPDX-License-Identifier: MIT OR Apache-2.0
"""Evaluate many: outcomes of selected objects, of a file, of a folder; as table, JSON and contact sheet."""

import csv
import hashlib
import json
import shutil

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy
from test_addon_command import pixels

MEASURES = blender.addon("evaluations").MEASURES


def chair(name, *prompts, half=False, **options):
    """Add a chair with these outcomes."""
    obj = blender.chair(half)
    obj.name = name
    for prompt in prompts:
        blender.deform(prompt, splits="1", **options)
    return obj


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """A folder of two files: one with two chairs and three outcomes, one with one and an object without."""
    folder = tmp_path_factory.mktemp("saved")
    blender.empty_scene()
    chair("Chair", "a bar stool", "a sofa")
    chair("Half", "a bar stool", half=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "two.blend"))
    blender.empty_scene()
    chair("Other", "a sofa", negative="a bench")
    blender.add("Plain", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "one.blend"))
    return folder


@pytest.fixture
def folder(saved, tmp_path):
    """A copy of that folder, the second file open."""
    folder = shutil.copytree(saved, tmp_path / "props")
    bpy.ops.wm.open_mainfile(filepath=str(folder / "one.blend"))
    return folder


def boxmorph(*arguments):
    return blender.addon("command").main([str(argument) for argument in arguments])


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_a_folder_is_evaluated_file_by_file(folder, tmp_path, capfd):
    (folder / "notes.txt").write_text("not a file of Blender's")
    before = {path: hashlib.sha256(path.read_bytes()).digest() for path in folder.iterdir()}
    out = {kind: tmp_path / f"out.{kind}" for kind in ("json", "csv", "png")}
    done = boxmorph("evaluate", folder, "--json", out["json"], "--csv", out["csv"], "--sheet", out["png"])
    assert done == 0
    printed = capfd.readouterr().out
    assert "two.blend: Half, “a bar stool”: score " in printed
    assert "average of 4 outcomes: score " in printed
    rows = table(out["csv"])
    assert [row["negative"] for row in rows] == ["a bench", "", "", ""]
    assert [(row["file"], row["object"], row["outcome"]) for row in rows] == [
        ("one.blend", "Other", "a sofa"),
        ("two.blend", "Chair", "a bar stool"),
        ("two.blend", "Chair", "a sofa"),
        ("two.blend", "Half", "a bar stool"),
    ]
    found = json.loads(out["json"].read_text(encoding="utf-8"))
    assert found["guide"]["name"] == "mini" == rows[0]["guide"]
    for row, outcome in zip(rows, found["outcomes"], strict=True):
        assert all(float(row[measure]) == outcome[measure] for measure in MEASURES)
        assert not row["refused"] and "refused" not in outcome
    sofas = [outcome for outcome in found["outcomes"] if outcome["prompt"] == "a sofa"]
    assert found["prompts"]["a sofa"]["outcomes"] == 2
    for measure in MEASURES:
        assert found["prompts"]["a sofa"][measure] == pytest.approx(np.mean([o[measure] for o in sofas]))
        assert found["average"][measure] == pytest.approx(np.mean([o[measure] for o in found["outcomes"]]))
    assert {path: hashlib.sha256(path.read_bytes()).digest() for path in folder.iterdir()} == before


def test_one_outcome_has_the_numbers_of_evaluate(folder, tmp_path):
    assert boxmorph("evaluate", "--json", tmp_path / "out.json") == 0
    outcome, *others = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))["outcomes"]
    obj = bpy.data.objects["Other"]
    blender.activate(obj)
    assert bpy.ops.boxmorph.evaluate() == {"FINISHED"}
    kept = json.loads(obj.data.shape_keys["boxmorph"])["a sofa"]["evaluation"]
    assert not others and {measure: outcome[measure] for measure in MEASURES} == {
        measure: kept[measure] for measure in MEASURES
    }


def test_all_are_held_against_a_prompt_that_is_given(folder, tmp_path, capfd):
    assert boxmorph("evaluate", folder, "--prompt", "a zzgribble bed", "--csv", tmp_path / "bed.csv") == 0
    assert "does not know “zzgribble”" in capfd.readouterr().err
    assert boxmorph("evaluate", folder, "--csv", tmp_path / "own.csv") == 0
    beds, own = table(tmp_path / "bed.csv"), table(tmp_path / "own.csv")
    assert {row["prompt"] for row in beds} == {"a zzgribble bed"}
    assert all(float(a["score_after"]) < float(b["score_after"]) for a, b in zip(beds, own, strict=True))
    for measure in ("curvature_change", "self_intersections_after"):
        assert [row[measure] for row in beds] == [row[measure] for row in own]


def test_the_sheet_shows_each_before_and_after_with_its_numbers(folder, tmp_path):
    assert boxmorph("evaluate", folder / "two.blend", "--sheet", tmp_path / "sheet.png") == 0
    sheet = blender.addon("evaluation_sheet")
    size, gap = sheet.PICTURE_SIZE, sheet._GAP
    picture = pixels(tmp_path / "sheet.png")
    assert len(picture) == 3 * (size + gap) + gap
    for row in range(3):
        top = row * (size + gap) + gap
        before, after = (picture[top : top + size, gap + i * size : gap + (i + 1) * size] for i in (0, 1))
        text = picture[top : top + size, 2 * gap + 2 * size :]
        assert (before.min(axis=2) < 200).mean() > 0.05 and (before != after).any()
        # Seven lines of text and a heading.
        dark = (text.min(axis=(1, 2)) < 100).astype(int)
        assert (np.diff(dark) == 1).sum() >= 6
    import boxmorph as library

    obj = bpy.data.objects["Chair"]
    arrays, _mesh, after = blender.addon("evaluation").shapes(
        obj, bpy.context, obj.data.shape_keys.key_blocks["a sofa"]
    )
    wanted = blender.addon("images").render_row(library, after, arrays.triangles, views="front right")
    top = size + gap + gap
    shown = picture[top : top + size, gap + size : gap + 2 * size].astype(int)
    assert np.abs(shown - wanted.astype(int)).max() <= 1


def test_many_rows_stand_in_columns(monkeypatch):
    blender.empty_scene()
    obj = chair("Chair", "a sofa")
    found = list(blender.addon("evaluations").evaluate_all([obj], bpy.context, pictures=True))
    sheet = blender.addon("evaluation_sheet")
    monkeypatch.setattr(sheet, "_ROWS", 2)
    one, five = sheet.sheet(found), sheet.sheet(found * 5)
    assert five.shape[1] == 3 * one.shape[1]
    assert np.array_equal(five[: one.shape[0], : one.shape[1]], one)


def test_what_cannot_be_evaluated_is_told_and_the_others_are_there(folder, tmp_path, capfd):
    bpy.ops.object.mode_set(mode="OBJECT")
    blender.activate(bpy.data.objects["Other"])
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "one.blend"))
    bpy.ops.object.mode_set(mode="OBJECT")
    (folder / "broken.blend").write_bytes(b"BLENDER no")
    options = ("--csv", tmp_path / "out.csv", "--json", tmp_path / "out.json", "--sheet", tmp_path / "s.png")
    assert boxmorph("evaluate", folder, *options) == 1
    told = capfd.readouterr()
    assert "broken.blend" in told.err and "is in Edit Mode" in told.err and "Traceback" not in told.err
    rows = table(tmp_path / "out.csv")
    assert [bool(row["refused"]) for row in rows] == [True, False, False, False]
    found = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
    assert found["average"]["outcomes"] == 3 and "Edit Mode" in found["outcomes"][0]["refused"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("{}/none",), "no file or folder"),
        (("{}/empty",), "holds no .blend files"),
        (("{}", "--object", "Nobody"), "no outcome to evaluate of “Nobody”"),
        (("{}", "--csv", "{}/none/out.csv"), "cannot be written"),
        (("{}", "--prompt", "zzgribble"), "knows no word"),
    ],
)
def test_refusals(folder, capfd, arguments, words):
    (folder / "empty").mkdir()
    assert boxmorph("evaluate", *(argument.format(folder) for argument in arguments)) == 1
    assert words in capfd.readouterr().err


def test_the_button_writes_files_for_the_selected_objects(folder, tmp_path):
    bpy.ops.wm.open_mainfile(filepath=str(folder / "two.blend"))
    fonts, meshes = len(bpy.data.fonts), len(bpy.data.meshes)
    for name in ("Chair", "Half"):
        bpy.data.objects[name].select_set(True)
    path = str(tmp_path / "judged.csv")
    assert bpy.ops.boxmorph.evaluate_all(filepath=path, details=True) == {"FINISHED"}
    assert len(table(path)) == 3
    assert len(json.loads((tmp_path / "judged.json").read_text(encoding="utf-8"))["outcomes"]) == 3
    assert (tmp_path / "judged.png").is_file()
    for name in ("Chair", "Half"):
        records = json.loads(bpy.data.objects[name].data.shape_keys["boxmorph"])
        assert all("evaluation" in record for record in records.values())
    assert (len(bpy.data.fonts), len(bpy.data.meshes)) == (fonts, meshes)
    blender.activate(bpy.data.objects["Half"])
    assert bpy.ops.boxmorph.evaluate_all(filepath=str(tmp_path / "half.v2"), pictures=False) == {"FINISHED"}
    assert len(table(tmp_path / "half.v2.csv")) == 1 and not (tmp_path / "half.v2.png").exists()
    for options, words in (
        ({"filepath": path, "table": False, "pictures": False}, "Nothing is to be written"),
        ({"filepath": str(tmp_path / "none" / "out.csv")}, "cannot be written"),
    ):
        with pytest.raises(RuntimeError, match=words):
            bpy.ops.boxmorph.evaluate_all(**options)


def test_long_lines_end_in_an_ellipsis_and_no_letter_is_lost():
    picture = blender.addon("lettering").text_picture
    short, long = picture("a sofa", 26, 400), picture("a sofa " * 40, 26, 400)
    assert short.shape == long.shape == (26, 400, 3)
    dark = [np.flatnonzero((shown < 128).any(axis=(0, 2))) for shown in (short, long)]
    assert dark[0].max() < 120 and 300 < dark[1].max() < 400
    assert (picture("", 20, 50) == 255).all()
