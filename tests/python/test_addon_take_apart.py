# SPDX-License-Identifier: MIT OR Apache-2.0
"""Take Apart, Put Together and Apply as New Object."""

import json
from unittest.mock import Mock

import addon_blender as blender
import numpy as np
import pytest
from addon_blender import bpy

PROMPT = "a bar stool"

_AXIS = {"width": 0, "depth": 1, "height": 2, "sideways": 0, "forth": 1, "down": 2}


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()


def keys_of(obj):
    return obj.data.shape_keys.key_blocks


def apart(obj):
    """Return the keys of the pieces of `obj`, all but the rest, and the rest."""
    names = json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]["pieces"]
    return [keys_of(obj)[name] for name in names[:-1]], keys_of(obj)[names[-1]]


def change(key):
    return blender.positions(key) - blender.positions(key.id_data.reference_key)


def size(obj):
    return np.linalg.norm(np.ptp(blender.positions(obj.data.shape_keys.reference_key), axis=0))


def plain():
    return blender.chair()


def turned():
    obj = blender.chair()
    turn = np.array([(0.8, -0.6), (0.6, 0.8)])
    for vertex in obj.data.vertices:
        vertex.co.xy = turn @ vertex.co.xy
    return obj


def mirrored():
    return blender.chair(half=True)


def scaled():
    obj = blender.chair()
    obj.scale = (1.0, 2.0, 1.5)
    bpy.context.view_layer.update()
    return obj


def rounded():
    obj = blender.chair()
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    return obj


def bevelled():
    obj = blender.chair()
    obj.modifiers.new("Bevel", "BEVEL").width = 0.01
    return obj


MAKERS = [plain, turned, mirrored, scaled, rounded, bevelled]


@pytest.mark.parametrize("shift_parts", [False, True])
@pytest.mark.parametrize("make", MAKERS)
def test_pieces_equal_the_outcome(make, shift_parts):
    obj = make()
    blender.deform(PROMPT, shift_parts=shift_parts, splits="3")
    before, seen = blender.fingerprint(obj), blender.evaluated_positions(obj)
    outcome = keys_of(obj)[PROMPT]
    whole, rest = change(outcome), blender.positions(keys_of(obj)["Basis"])
    assert bpy.ops.boxmorph.take_apart() == {"FINISHED"}

    assert blender.fingerprint(obj) == before
    assert np.abs(blender.evaluated_positions(obj) - seen).max() <= 1e-5 * size(obj)
    outcome = keys_of(obj)[PROMPT]
    assert (outcome.value, outcome.mute) == (0.0, False)
    assert np.array_equal(change(outcome), whole)
    pieces, left = apart(obj)
    assert len(pieces) >= 3
    for key in pieces:
        axis = _AXIS[key.name.split()[-1]]
        moved = change(key)
        assert 1e-4 * size(obj) / 4 < np.abs(moved).max()
        assert key.relative_key.name == "Basis" and key.value == 1.0
        if make is not turned:
            assert not np.delete(moved, axis, axis=1).any(), key.name
        elif axis == 2:
            assert not moved[:, :2].any(), key.name
        else:
            assert np.linalg.matrix_rank(moved, tol=1e-5) == 1 and not moved[:, 2].any(), key.name
    for modifier in obj.modifiers:
        modifier.show_viewport = False
    least = max(key.slider_min for key in (*pieces, left))
    most = min(key.slider_max for key in (*pieces, left))
    for alpha in (least, 0.4, most):
        for key in (*pieces, left):
            key.value = alpha
        mix = rest + alpha * whole
        assert np.abs(blender.evaluated_positions(obj) - mix).max() <= 1e-5 * size(obj)


def test_pieces_are_mixed_freely():
    obj = plain()
    blender.deform(PROMPT)
    bpy.ops.boxmorph.take_apart()
    pieces, left = apart(obj)
    expected = blender.positions(keys_of(obj)["Basis"]).astype(np.float64)
    for key, value in zip((*pieces, left), np.linspace(0.9, 0.1, len(pieces) + 1), strict=True):
        key.value = value
        expected += key.value * change(key)
    assert np.abs(blender.evaluated_positions(obj) - expected).max() <= 1e-5 * size(obj)


def test_names_say_what_the_keys_do():
    obj = plain()
    blender.deform(PROMPT)
    bpy.context.scene.boxmorph.splits = "2"
    bpy.ops.boxmorph.find_parts()
    parts = [part.name for part in obj.boxmorph.items]
    report = json.loads(obj.data.shape_keys["boxmorph"])[PROMPT]
    bpy.ops.boxmorph.take_apart()
    pieces, left = apart(obj)
    assert left.name == f"{PROMPT}: size and place"
    graph = blender.addon("parts").kept_graph(obj, blender.addon("engine").searched(obj, bpy.context)[1])
    part_of_vertex = graph.parameter_row_of_box[graph.assignment]
    rest = blender.positions(keys_of(obj)["Basis"])
    for key in pieces:
        part, _, word = key.name.removeprefix(f"{PROMPT}: ").rpartition(" ")
        part, axis = parts.index(part), _AXIS[word]
        scale = report["scales"][part][axis]
        assert -10.0 <= key.slider_min <= 0.0 and 1.0 <= key.slider_max <= 10.0
        for value in (key.slider_min, key.slider_max):
            assert 1.0 + value * (scale - 1.0) >= 0.0499
        own = part_of_vertex == part
        before, after = np.ptp(rest[own, axis]), np.ptp((rest + change(key))[own, axis])
        # Where it meets other parts, it follows them.
        share = (after / before - 1.0) / (report["gauge_scale"] * (scale - 1.0))
        assert 0.4 <= share <= 1.3, key.name


def test_long_names_are_cut_at_the_outcome():
    name = blender.addon("shape_key").piece_name
    assert name("a stool", "Seat width") == "a stool: Seat width"
    long = name("ein sehr hoher Küchenhocker aus Öl", "Bottom Front Corners 2 slides back and forth")
    assert len(long.encode()) <= 63 and long.endswith(": Bottom Front Corners 2 slides back and forth")


def test_put_together_leaves_all_as_it_was():
    obj = plain()
    blender.deform(PROMPT)
    keys_of(obj)[PROMPT].value = 0.75
    before = blender.key_state(obj)
    bpy.ops.boxmorph.take_apart()
    pieces, _left = apart(obj)
    assert {round(key.value, 6) for key in pieces} == {0.75}
    pieces[0].value = 0.2
    pieces[1].keyframe_insert("value", frame=1)
    assert bpy.ops.boxmorph.put_together() == {"FINISHED"}
    assert blender.key_state(obj) == before
    with pytest.raises(RuntimeError, match="is not taken apart"):
        bpy.ops.boxmorph.put_together()


def test_a_piece_stands_for_its_outcome():
    """It may be the active key; what it belongs to is meant, also where another outcome is newer."""
    obj = plain()
    blender.deform(PROMPT)
    bpy.ops.boxmorph.take_apart()
    pieces, _left = apart(obj)
    names = [key.name for key in pieces]
    blender.deform("a sofa")
    # Outcomes are alternatives, and so are their pieces.
    assert all(keys_of(obj)[name].value == 0.0 for name in names)
    obj.active_shape_key_index = keys_of(obj).find(names[0])
    assert blender.addon("shape_key").meant_outcome(obj)[0] == PROMPT
    assert bpy.ops.boxmorph.remove_outcome() == {"FINISHED"}
    assert [key.name for key in keys_of(obj)] == ["Basis", "a sofa"]


def test_another_search_for_the_prompt_replaces_the_pieces():
    obj = plain()
    blender.deform(PROMPT)
    bpy.ops.boxmorph.take_apart()
    blender.deform(PROMPT, seed=1)
    assert [key.name for key in keys_of(obj)] == ["Basis", PROMPT]
    assert bpy.ops.boxmorph.take_apart() == {"FINISHED"}


def test_given_and_locked_parts_are_known_again():
    obj = plain()
    bpy.context.scene.boxmorph.splits = "2"
    bpy.ops.boxmorph.find_parts()
    obj.boxmorph.items[0].lock = (True, True, True)
    name = obj.boxmorph.items[0].name
    blender.deform(PROMPT)
    bpy.ops.boxmorph.take_apart()
    pieces, _left = apart(obj)
    assert pieces and not any(f": {name} " in key.name for key in pieces)
    bpy.ops.boxmorph.put_together()
    bpy.ops.boxmorph.forget_parts()
    with pytest.raises(RuntimeError, match="have been forgotten"):
        bpy.ops.boxmorph.take_apart()


def test_a_modifier_added_later_does_not_matter():
    obj = plain()
    blender.deform(PROMPT)
    obj.modifiers.new("Bevel", "BEVEL")
    assert bpy.ops.boxmorph.take_apart() == {"FINISHED"}


def sculpt(obj):
    keys_of(obj)[PROMPT].points[0].co.x += 0.05


def stretch(obj):
    for point in keys_of(obj)["Basis"].points:
        point.co.z *= 1.5


def animate(obj):
    keys_of(obj)[PROMPT].keyframe_insert("value", frame=1)


def drive(obj):
    keys_of(obj)[PROMPT].driver_add("value")


def take_apart(_obj):
    bpy.ops.boxmorph.take_apart()


def no_record(obj):
    obj.data.shape_keys["boxmorph"] = json.dumps({PROMPT: {"prompt": PROMPT}})


@pytest.mark.parametrize("make", [plain, rounded])
@pytest.mark.parametrize(
    ("meddle", "words"),
    [
        (sculpt, "have changed since"),
        (stretch, "changed since"),
        (animate, "is animated"),
        (drive, "is animated"),
        (take_apart, "taken apart already"),
        (no_record, "no record of its parts"),
    ],
)
def test_refusals_lose_nothing(make, meddle, words):
    obj = make()
    blender.deform(PROMPT)
    meddle(obj)
    before = blender.key_state(obj), blender.fingerprint(obj)
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.boxmorph.take_apart()
    assert (blender.key_state(obj), blender.fingerprint(obj)) == before


def test_without_an_outcome_there_is_nothing_to_do():
    plain()
    for operator in (bpy.ops.boxmorph.take_apart, bpy.ops.boxmorph.apply_as_new):
        with pytest.raises(RuntimeError, match="no outcome yet"):
            operator()


@pytest.mark.parametrize("make", [plain, mirrored])
@pytest.mark.parametrize("in_pieces", [False, True])
def test_apply_as_new_object(make, in_pieces):
    obj = make()
    obj.data.normals_split_custom_set([(0.6, 0.0, 0.8)] * len(obj.data.loops))
    blender.deform(PROMPT)
    blender.deform("a sofa")
    keys_of(obj)["a sofa"].value = 0.5
    keys_of(obj)[PROMPT].value = 0.8
    shown = blender.positions(keys_of(obj)["Basis"]) + 0.8 * change(keys_of(obj)[PROMPT])
    if in_pieces:
        bpy.ops.boxmorph.take_apart(key=PROMPT)
    before, keys = blender.fingerprint(obj), blender.key_state(obj)
    assert bpy.ops.boxmorph.apply_as_new(key=PROMPT) == {"FINISHED"}

    new = bpy.context.active_object
    assert new != obj and new.data != obj.data and new.name == f"Chair {PROMPT}"
    assert new.select_get() and not obj.select_get()
    assert (blender.fingerprint(obj), blender.key_state(obj)) == (before, keys)
    assert new.data.shape_keys is None and not new.boxmorph.items
    assert len(bpy.data.shape_keys) == 1
    positions = np.array([tuple(v.co) for v in new.data.vertices])
    assert np.abs(positions - shown).max() <= 1e-5 * size(obj)
    made = blender.fingerprint(new)
    for data in (before, made):
        del data["attributes"]["position"]
    assert made == before
    assert new.data.has_custom_normals
    # And it can be deformed in its turn.
    blender.deform("a sofa")


def test_the_menu_offers_what_fits():
    obj = plain()
    blender.deform(PROMPT)

    def offered():
        layout = Mock()
        context = Mock(boxmorph_outcome=keys_of(obj)[PROMPT])
        blender.addon("outcome_panel").BOXMORPH_MT_outcome.draw(Mock(layout=layout), context)
        return [call.args[0] for call in layout.operator.call_args_list]

    before = offered()
    assert {"boxmorph.take_apart", "boxmorph.apply_as_new", "boxmorph.remove_outcome"} <= set(before)
    bpy.ops.boxmorph.take_apart()
    after = ["boxmorph.put_together" if name == "boxmorph.take_apart" else name for name in before]
    assert offered() == after != before


def test_what_is_not_shown_is_not_applied():
    plain()
    blender.deform(PROMPT)
    bpy.context.active_object.data.shape_keys.key_blocks[PROMPT].value = 0.0
    count = len(bpy.data.objects), len(bpy.data.meshes)
    with pytest.raises(RuntimeError, match="is off"):
        bpy.ops.boxmorph.apply_as_new()
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == count


def test_command_line(tmp_path, capfd):
    plain()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    output = tmp_path / "out.blend"
    arguments = ["deform", "--prompt", PROMPT, "--splits", "2", "--take-apart", "--output", str(output)]
    assert blender.addon("command").main(arguments) == 0
    assert f"made the shape key “{PROMPT}: size and place”" in capfd.readouterr().out
    bpy.ops.wm.open_mainfile(filepath=str(output))
    obj = bpy.data.objects["Chair"]
    pieces, left = apart(obj)
    assert keys_of(obj)[PROMPT].value == 0.0 and {key.value for key in (*pieces, left)} == {1.0}
    with pytest.raises(SystemExit):
        blender.addon("command").main([*arguments, "--keyframes", "1:60"])
