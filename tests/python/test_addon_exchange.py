# SPDX-License-Identifier: MIT OR Apache-2.0
"""Outcomes in other formats, out and in again: what docs/assets.md says of glTF, FBX, USD and Alembic."""

import json
import re
import subprocess
import sys

import addon_blender as blender
import addon_finished as finished
import numpy as np
import pytest
from addon_blender import bpy

_FRAMES = range(finished.FRAMES[0], finished.FRAMES[1] + 1)

#: What must be chosen in the exporters, beyond what they come with.
_FBX = {"bake_anim_use_nla_strips": False, "bake_anim_use_all_actions": False}
_USD = {"export_animation": True}


class Made:
    """A saved chair, and what of it must come out: names of the keys, changes, values at `_FRAMES`."""

    def __init__(self, obj, path):
        self.path = path
        self.size = finished.size(obj)
        self.names = [key.name for key in obj.data.shape_keys.key_blocks[1:]]
        self.points = points(obj)
        self.values = np.array(finished.values(obj, *_FRAMES))
        self.seen = [finished.seen(obj, frame) for frame in _FRAMES]
        self.stool = next(i for i, name in enumerate(self.names) if "stool" in name)
        bpy.context.scene.frame_set(1)
        bpy.ops.wm.save_as_mainfile(filepath=path)

    def open(self):
        bpy.ops.wm.open_mainfile(filepath=self.path)
        return blender.activate(bpy.data.objects["Chair"])


@pytest.fixture(scope="module", params=["linear", "semantic"])
def made(request, tmp_path_factory):
    obj, _names = finished.build(request.param)
    made = Made(obj, str(tmp_path_factory.mktemp("made") / "chair.blend"))
    # The formats are asked for values below 0 and above 1.
    assert made.values[0, made.stool] < 0 and made.values[-1, made.stool] > 1
    return made


@pytest.fixture(scope="module")
def mirrored(tmp_path_factory):
    """Half a chair and its Mirror modifier, with two outcomes."""
    blender.empty_scene()
    obj = blender.chair(half=True)
    obj.modifiers.remove(obj.modifiers["Subdivision"])
    blender.deform("a bar stool")
    bpy.ops.boxmorph.keyframe_spectrum(frame_from=1, frame_to=11)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 11
    return Made(obj, str(tmp_path_factory.mktemp("mirrored") / "chair.blend"))


def points(obj):
    """Return where each vertex is at rest, and what each key adds to that, (n,1+keys,3), in the world."""
    place = np.array(obj.matrix_world)
    turn, shift = place[:3, :3].T, place[:3, 3]
    rest = blender.positions(obj.data.shape_keys.reference_key)
    changes = finished.changes(obj).values()
    return np.stack([rest @ turn + shift, *(change @ turn for change in changes)], axis=1)


def assert_same_points(found, expected, size):
    """Assert that two sets of points are the same; formats change their order and split vertices."""
    apart = np.abs(found[:, None] - expected[None]).max(axis=(2, 3))
    assert apart.min(axis=1).max() <= 1e-5 * size
    assert apart.min(axis=0).max() <= 1e-5 * size


def only_mesh():
    """Return the only mesh object of the file."""
    (obj,) = (obj for obj in bpy.data.objects if obj.type == "MESH")
    return obj


def imported(load, **options):
    """Load a file into an empty scene; return its mesh object, with sliders as wide as its values."""
    blender.empty_scene()
    assert load(**options) == {"FINISHED"}
    obj = only_mesh()
    if obj.data.shape_keys is not None:
        for key in obj.data.shape_keys.key_blocks:
            key.slider_min, key.slider_max = -10.0, 10.0
    bpy.context.view_layer.update()
    return obj


def assert_comes_in(obj, made, name=str, first=None):
    """Assert that an imported object has all that went out, under the names that `name` makes of ours.

    `first`: the frame that the first of `_FRAMES` has become.
    """
    keys = obj.data.shape_keys.key_blocks
    assert [key.name for key in keys[1:]] == [name(key) for key in made.names]
    bpy.context.scene.frame_set(0)
    assert_same_points(points(obj), made.points, made.size)
    shift = 0 if first is None else first - _FRAMES[0]
    seen = finished.values(obj, *(frame + shift for frame in _FRAMES))
    np.testing.assert_allclose(seen, made.values, atol=1e-4)
    # The record stays behind: for Boxmorph, these are the artist's own keys.
    assert not blender.addon("shape_key").records(obj.data)


def export_gltf(made, path, **options):
    """Export by a process of its own: Blender 4.2 as a module crashes when it ends after that."""
    script = (
        f"import bpy, os; bpy.ops.wm.open_mainfile(filepath={made.path!r}); "
        f"done = bpy.ops.export_scene.gltf(filepath={path!r}, **{options!r}); "
        "os._exit(done != {'FINISHED'})"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


def gltf_array(document, folder, index):
    """Return an accessor's values, (n,) or (n,3) float32; sparse ones written out."""
    accessor = document["accessors"][index]

    def view(entry, dtype, count):
        view = document["bufferViews"][entry["bufferView"]]
        data = (folder / document["buffers"][view["buffer"]]["uri"]).read_bytes()
        start = view.get("byteOffset", 0) + entry.get("byteOffset", 0)
        return np.frombuffer(data, dtype, count, start)

    width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
    assert accessor["componentType"] == 5126
    values = np.zeros((accessor["count"], width), np.float32)
    if "bufferView" in accessor:
        values[:] = view(accessor, np.float32, values.size).reshape(values.shape)
    if "sparse" in accessor:
        sparse = accessor["sparse"]
        dtype = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32}[sparse["indices"]["componentType"]]
        where = view(sparse["indices"], dtype, sparse["count"])
        values[where] = view(sparse["values"], np.float32, sparse["count"] * width).reshape(-1, width)
    return values[:, 0] if width == 1 else values


def test_gltf_file(made, tmp_path):
    export_gltf(made, str(tmp_path / "chair.gltf"), export_format="GLTF_SEPARATE")
    document = json.loads((tmp_path / "chair.gltf").read_text(encoding="utf-8"))

    def array(index):
        return gltf_array(document, tmp_path, index)

    (mesh,) = document["meshes"]
    assert mesh["extras"]["targetNames"] == made.names
    np.testing.assert_allclose(mesh["weights"], made.values[0], atol=1e-6)
    found = np.concatenate(
        [
            np.stack(
                [
                    array(part["attributes"]["POSITION"]),
                    *(array(target["POSITION"]) for target in part["targets"]),
                ],
                axis=1,
            )
            for part in mesh["primitives"]
        ]
    )
    # There, y is up.
    x, y, z = np.moveaxis(found, 2, 0)
    assert_same_points(np.stack([x, -z, y], axis=2), made.points, made.size)
    (animation,) = document["animations"]
    (channel,) = animation["channels"]
    sampler = animation["samplers"][channel["sampler"]]
    assert channel["target"]["path"] == "weights"
    np.testing.assert_allclose(array(sampler["input"]) * 24, list(_FRAMES), atol=1e-4)
    weights = array(sampler["output"]).reshape(len(_FRAMES), len(made.names))
    np.testing.assert_allclose(weights, made.values, atol=1e-6)


@pytest.mark.parametrize("kind", ["GLB", "GLTF_SEPARATE"])
def test_gltf_out_and_in(made, tmp_path, kind):
    path = str(tmp_path / ("chair.glb" if kind == "GLB" else "chair.gltf"))
    export_gltf(made, path, export_format=kind)
    assert_comes_in(imported(bpy.ops.import_scene.gltf, filepath=path), made)


def fbx_importers():
    found = [bpy.ops.import_scene.fbx]
    return found + [bpy.ops.wm.fbx_import] * hasattr(bpy.types, "WM_OT_fbx_import")


@pytest.mark.parametrize("load", fbx_importers(), ids=lambda load: load.idname_py())
def test_fbx_out_and_in(made, tmp_path, load):
    made.open()
    path = str(tmp_path / "chair.fbx")
    bpy.ops.export_scene.fbx(filepath=path, **_FBX)
    # Its first frame is 0, and Blender moves all by one when it reads it.
    assert_comes_in(imported(load, filepath=path), made, first=2)


def test_fbx_as_it_comes_has_the_keys_without_their_animation(made, tmp_path):
    made.open()
    bpy.ops.export_scene.fbx(filepath=str(tmp_path / "chair.fbx"))
    obj = imported(bpy.ops.import_scene.fbx, filepath=str(tmp_path / "chair.fbx"))
    assert [key.name for key in obj.data.shape_keys.key_blocks[1:]] == made.names
    assert not finished.curves(obj.data.shape_keys)


def usd_name(name):
    """What USD makes of a name: letters, digits and underscores; each byte of others is an underscore."""
    return re.sub(rb"[^A-Za-z0-9_]", b"_", name.encode()).decode()


def test_usd_out_and_in(made, tmp_path):
    made.open()
    path = tmp_path / "chair.usda"
    options = {}
    if "allow_unicode" in bpy.ops.wm.usd_export.get_rna_type().properties:
        options["allow_unicode"] = False
    bpy.ops.wm.usd_export(filepath=str(path), **_USD, **options)
    text = path.read_text(encoding="utf-8")
    anim = text[text.index('def SkelAnimation "Anim"') :]
    names = re.findall(r'"([^"]+)"', re.search(r"token\[\] blendShapes = \[(.*)\]", anim)[1])
    assert names == [usd_name(name) for name in made.names]
    samples = re.findall(r"^\s+(\d+): \[(.*)\],$", anim, re.MULTILINE)
    assert [int(frame) for frame, _ in samples] == list(_FRAMES)
    weights = [[float(value) for value in row.split(",")] for _, row in samples]
    np.testing.assert_allclose(weights, made.values, atol=1e-5)

    assert_comes_in(imported(bpy.ops.wm.usd_import, filepath=str(path)), made, usd_name)


def test_usd_keeps_letters_of_every_script(made, tmp_path):
    if "allow_unicode" not in bpy.ops.wm.usd_export.get_rna_type().properties:
        pytest.skip("USD of this Blender knows ASCII only")
    made.open()
    bpy.ops.wm.usd_export(filepath=str(tmp_path / "chair.usda"), **_USD, allow_unicode=True)
    obj = imported(bpy.ops.wm.usd_import, filepath=str(tmp_path / "chair.usda"))
    assert_comes_in(obj, made, lambda name: re.sub(r"\W", "_", name))


def test_usd_as_it_comes_has_the_keys_without_their_values(made, tmp_path):
    made.open()
    bpy.ops.wm.usd_export(filepath=str(tmp_path / "chair.usda"))
    obj = imported(bpy.ops.wm.usd_import, filepath=str(tmp_path / "chair.usda"))
    assert len(obj.data.shape_keys.key_blocks) == 1 + len(made.names)
    assert not np.any(finished.values(obj, *_FRAMES))


def assert_moves(obj, made):
    """Assert that the same is seen at all frames, without shape keys."""
    assert obj.data.shape_keys is None
    for frame, expected in zip(_FRAMES, made.seen, strict=True):
        place = np.array(obj.matrix_world)
        found = finished.seen(obj, frame) @ place[:3, :3].T + place[:3, 3]
        assert_same_points(found[:, None], expected[:, None], made.size)


def test_alembic_bakes_what_is_seen(mirrored, tmp_path):
    mirrored.open()
    path = str(tmp_path / "chair.abc")
    bpy.ops.wm.alembic_export(filepath=path)
    assert_moves(imported(bpy.ops.wm.alembic_import, filepath=path), mirrored)


def test_usd_without_shape_keys_bakes_what_is_seen(mirrored, tmp_path):
    mirrored.open()
    path = str(tmp_path / "chair.usda")
    bpy.ops.wm.usd_export(filepath=path, **_USD, export_shapekeys=False)
    assert_moves(imported(bpy.ops.wm.usd_import, filepath=path), mirrored)


def gltf(made, path, **options):
    export_gltf(made, path, **options)
    return bpy.ops.import_scene.gltf


def fbx(made, path, **options):
    made.open()
    bpy.ops.export_scene.fbx(filepath=path, **_FBX, **options)
    return bpy.ops.import_scene.fbx


def usd(made, path):
    made.open()
    bpy.ops.wm.usd_export(filepath=path, **_USD)
    return bpy.ops.wm.usd_import


@pytest.mark.parametrize(
    ("write", "options", "suffix"),
    [(gltf, {}, "glb"), (fbx, {"use_mesh_modifiers": False}, "fbx"), (usd, {}, "usda")],
)
def test_modifiers_stay_behind(mirrored, tmp_path, write, options, suffix):
    """Half a chair goes out."""
    path = str(tmp_path / f"chair.{suffix}")
    obj = imported(write(mirrored, path, **options), filepath=path)
    bpy.context.scene.frame_set(0)
    assert_same_points(points(obj), mirrored.points, mirrored.size)
    assert "MIRROR" not in [modifier.type for modifier in obj.modifiers]


@pytest.mark.parametrize(
    ("write", "options", "suffix"),
    [(gltf, {"export_apply": True, "export_animations": False}, "glb"), (fbx, {}, "fbx")],
)
def test_applied_by_the_exporter_they_cost_the_keys(mirrored, tmp_path, write, options, suffix):
    path = str(tmp_path / f"chair.{suffix}")
    obj = imported(write(mirrored, path, **options), filepath=path)
    assert obj.data.shape_keys is None and len(obj.data.polygons) > 1.5 * 24


def test_with_modifiers_applied_first_the_search_finds_the_same(mirrored):
    obj = mirrored.open()
    bpy.ops.object.duplicate(linked=False)
    copy = bpy.context.active_object
    copy.shape_key_clear()
    bpy.ops.object.convert(target="MESH")
    assert not copy.modifiers
    blender.deform("a bar stool")
    copy.data.shape_keys.key_blocks["a bar stool"].value = 1.0
    bpy.context.scene.frame_set(11)
    expected, found = blender.evaluated_positions(obj), blender.evaluated_positions(copy)
    assert np.abs(found - expected).max() <= 1e-3 * mirrored.size
