# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the extension refuses: each with one sentence, and nothing lost."""

import addon_blender as blender
import pytest
from addon_blender import bpy

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


@pytest.fixture(autouse=True)
def _scene():
    blender.empty_scene()
    yield
    prefs = blender.preferences()
    prefs.guide_folder = prefs.runtime_library = ""


def refused(words, prompt="a bar stool", obj=None, **options):
    """Assert that deforming is refused in a sentence with these words, and that `obj` is untouched."""
    before = None if obj is None else (blender.fingerprint(obj), blender.key_state(obj))
    with pytest.raises(RuntimeError) as failure:
        bpy.ops.boxmorph.deform(prompt=prompt, **options)
    message = str(failure.value).strip().removeprefix("Error: ")
    assert words in message
    assert "\n" not in message and "Traceback" not in message and len(message) > 20
    if obj is not None:
        assert (blender.fingerprint(obj), blender.key_state(obj)) == before


def test_no_active_object():
    refused("no active object")
    for operator in (bpy.ops.boxmorph.find_parts, bpy.ops.boxmorph.forget_parts, bpy.ops.boxmorph.lock_part):
        with pytest.raises(RuntimeError, match="no active object"):
            operator()


def test_not_a_mesh():
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.scene.collection.objects.link(camera)
    blender.activate(camera)
    refused("“Camera” is a camera, not a mesh")


@pytest.mark.parametrize(
    ("vertices", "faces", "words"),
    [
        ([], [], "is empty"),
        (SQUARE, [], "has no faces"),
        ([(0, 0, 0)], [], "has no faces"),
        ([(0, 0, 0)] * 3, [(0, 1, 2)], "have no area"),
        ([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)], "have no area"),
        ([*SQUARE[:3], (float("nan"), 0, 0)], [(0, 1, 2)], "1 of the 4 vertices"),
        ([*SQUARE[:3], (float("inf"), 0, 0)], [(0, 1, 2, 3)], "1 of the 4 vertices"),
    ],
)
def test_meshes_without_a_surface(vertices, faces, words):
    obj = blender.add("Odd", vertices, faces)
    with pytest.raises(RuntimeError) as failure:
        bpy.ops.boxmorph.deform(prompt="a bar stool")
    assert words in str(failure.value)
    assert obj.data.shape_keys is None and len(obj.data.vertices) == len(vertices)


def test_three_faces_work_or_are_refused_in_a_sentence():
    obj = blender.add(
        "Corner", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2), (0, 1, 3), (0, 2, 3)]
    )
    try:
        bpy.ops.boxmorph.deform(prompt="a bar stool")
    except RuntimeError as failure:
        assert "Traceback" not in str(failure) and len(str(failure)) > 20
        assert obj.data.shape_keys is None
    else:
        assert obj.data.shape_keys.key_blocks["a bar stool"].value == 1.0


@pytest.mark.parametrize("mode", ["EDIT", "SCULPT", "WEIGHT_PAINT"])
def test_other_modes(mode):
    blender.chair()
    bpy.ops.object.mode_set(mode=mode)
    try:
        refused("Go to Object Mode first")
    finally:
        bpy.ops.object.mode_set(mode="OBJECT")


def test_linked_data(tmp_path):
    blender.chair()
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    blender.empty_scene()
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.objects = ["Chair"]
    obj = wanted.objects[0]
    bpy.context.scene.collection.objects.link(obj)
    blender.activate(obj)
    refused("linked from another file", obj=obj)

    override = obj.override_create(remap_local_usages=True)
    blender.activate(override)
    refused("linked from another file", obj=override)

    local = bpy.data.objects.new("Local", obj.data)
    bpy.context.scene.collection.objects.link(local)
    blender.activate(local)
    refused("linked from another file", obj=local)


def test_absolute_keys():
    obj = blender.chair()
    obj.shape_key_add(name="Basis")
    obj.data.shape_keys.use_relative = False
    refused("absolute shape keys", obj=obj)


def test_prompts():
    obj = blender.chair()
    refused("prompt is empty", "", obj=obj)
    refused("prompt is empty", " \t ", obj=obj)
    refused("10000 characters", "x" * 10_000, obj=obj)
    refused("knows no word", "zzgribble xqwvk", obj=obj)
    refused("knows no word", "the of a", obj=obj)
    refused("knows no word", "!?", obj=obj)


def test_unknown_words_are_named_before_the_search(capfd):
    blender.chair()
    blender.deform("a zzgribble sofa")
    out = "".join(capfd.readouterr())
    assert "does not know “zzgribble”" in out
    assert out.index("zzgribble") < out.index("score")


def test_guide_folders(tmp_path):
    obj = blender.chair()
    prefs = blender.preferences()
    prefs.guide_folder = str(tmp_path / "nowhere")
    refused("does not exist", obj=obj)
    prefs.guide_folder = str(tmp_path)
    refused(str(tmp_path), obj=obj)
    for name in ("config.json", "preprocessor_config.json", "tokenizer.json"):
        (tmp_path / name).write_text("{ damaged")
    for name in ("vision_model.onnx", "text_model.onnx"):
        (tmp_path / name).write_bytes(b"damaged")
    refused("vision_model.onnx", obj=obj)


def test_runtime_library(tmp_path):
    obj = blender.chair()
    blender.preferences().runtime_library = str(tmp_path / "libonnxruntime.so")
    refused("ONNX Runtime", obj=obj)


def test_missing_module(monkeypatch):
    import sys

    obj = blender.chair()
    monkeypatch.setitem(sys.modules, "boxmorph", None)
    refused("operating system", obj=obj)


def test_other_modifiers_need_the_view_layer():
    obj = blender.chair(half=True)
    collection = bpy.data.collections.new("Aside")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(obj)
    bpy.context.scene.collection.objects.unlink(obj)
    bpy.context.view_layer.layer_collection.children["Aside"].exclude = True
    bpy.context.view_layer.update()
    search = blender.addon("search")
    with pytest.raises(blender.addon("errors").Refusal, match="view layer"):
        search.Search(bpy.context, obj, "a bar stool")
    assert obj.data.shape_keys is None


def test_hidden_objects_work():
    obj = blender.chair(half=True)
    obj.hide_viewport = True
    search = blender.addon("search").Search(bpy.context, obj, "a bar stool", splits="2")
    try:
        assert obj.hide_viewport
        # Mirrored and subdivided, not the bare half.
        assert len(search.arrays.vertices) > 2 * len(obj.data.vertices)
    finally:
        search.cancel(wait=True)
