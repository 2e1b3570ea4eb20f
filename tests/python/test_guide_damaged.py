# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides whose files are damaged, or another model's: each is refused in one sentence, nothing falls over."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

import boxmorph
import numpy as np
import onnx
import pytest
import toy_guides
from onnx import TensorProto, helper, numpy_helper
from toy_guides import TinyViT, Toy

HERE = pathlib.Path(__file__).parent
MINI = HERE.parents[1] / "guides" / "mini"
MUTATED = 200


def refusal(folder):
    """The sentence that refuses a guide, at opening or at its first use."""
    with pytest.raises(boxmorph.GuideError) as refused:
        guide = boxmorph.Guide.open(folder, threads=1)
        size = guide.image_size
        guide.image_embeddings(np.zeros((13, size, size, 3), np.uint8))
        guide.text_embedding("a bar stool")
    sentence = str(refused.value)
    assert "\n" not in sentence and 20 < len(sentence) < 700, sentence
    return sentence


def edit(path, change):
    network = onnx.load(path)
    change(network.graph)
    onnx.save(network, path)


def weight(graph, name):
    return next(w for w in graph.initializer if w.name == name)


def put(graph, name, values):
    weight(graph, name).CopyFrom(numpy_helper.from_array(values, name))


def test_another_version_of_onnx(tmp_path):
    Toy().write(tmp_path)
    network = onnx.load(tmp_path / "vision_model.onnx")
    network.opset_import[0].version = 99
    onnx.save(network, tmp_path / "vision_model.onnx")
    assert "vision_model.onnx is not a network that can be used" in refusal(tmp_path)


@pytest.mark.parametrize("name", ["vision_model.onnx", "text_model.onnx", "tokenizer.json", "config.json"])
def test_a_folder_in_the_place_of_a_file(tmp_path, name):
    Toy().write(tmp_path)
    (tmp_path / name).unlink()
    (tmp_path / name).mkdir()
    assert f'{name}" is a folder, not a file; copy' in refusal(tmp_path)


def test_a_pipe_in_the_place_of_a_file(tmp_path):
    Toy().write(tmp_path)
    (tmp_path / "vision_model.onnx").unlink()
    if not hasattr(os, "mkfifo"):
        pytest.skip("this system has no pipes among its files")
    os.mkfifo(tmp_path / "vision_model.onnx")
    assert "is a device or a pipe, not a file" in refusal(tmp_path)


def test_links_that_lead_nowhere_and_in_circles(tmp_path):
    Toy().write(tmp_path)
    path = tmp_path / "vision_model.onnx"
    path.unlink()
    path.symlink_to(tmp_path / "nowhere")
    assert "is a link to nothing, not a file" in refusal(tmp_path)
    path.unlink()
    path.symlink_to(path)
    assert "vision_model.onnx" in refusal(tmp_path) and "cannot be read" in refusal(tmp_path)


def test_a_file_that_may_not_be_read(tmp_path):
    Toy().write(tmp_path)
    (tmp_path / "text_model.onnx").chmod(0)
    if os.access(tmp_path / "text_model.onnx", os.R_OK):
        pytest.skip("this user may read everything")
    assert "cannot be read" in refusal(tmp_path)


def test_a_network_larger_than_any(tmp_path):
    Toy().write(tmp_path)
    with open(tmp_path / "vision_model.onnx", "r+b") as file:
        file.truncate((2 << 30) + 1)
    assert "is larger than 2048 MB; choose a smaller model" in refusal(tmp_path)


def test_networks_with_other_inputs(tmp_path):
    Toy().write(tmp_path)
    shutil.copy(tmp_path / "text_model.onnx", tmp_path / "vision_model.onnx")
    assert "vision_model.onnx is not a network" in refusal(tmp_path)
    Toy().write(tmp_path)
    shutil.copy(tmp_path / "vision_model.onnx", tmp_path / "text_model.onnx")
    assert "text_model.onnx is not a network" in refusal(tmp_path)


def test_patches_in_the_place_of_images(tmp_path):
    """As SigLIP 2 with a free aspect ratio reads them."""
    Toy().write(tmp_path)
    shape = helper.make_tensor_type_proto(TensorProto.FLOAT, ["batch", 256, 768])
    edit(tmp_path / "vision_model.onnx", lambda graph: graph.input[0].type.CopyFrom(shape))
    assert "its input pixel_values has 3 axes, not 4" in refusal(tmp_path)


@pytest.mark.parametrize("axes", [[], ["batch"], ["batch", "sequence", 16]])
def test_outputs_of_another_rank(tmp_path, axes):
    Toy().write(tmp_path)

    def change(graph):
        graph.output[0].type.CopyFrom(helper.make_tensor_type_proto(TensorProto.FLOAT, axes))

    edit(tmp_path / "vision_model.onnx", change)
    assert "vision_model.onnx is not a network that can be used (it has no embedding output)" in refusal(
        tmp_path
    )


@pytest.mark.parametrize("operator", ["Size", "ReduceSum"])
def test_an_output_that_is_one_number(tmp_path, operator):
    """And that does not say so."""
    Toy().write(tmp_path)

    def change(graph):
        graph.node[-1].output[0] = "embedding"
        if operator == "ReduceSum":
            graph.node.append(helper.make_node(operator, ["embedding"], ["image_embeds"], keepdims=0))
        else:
            graph.node.append(helper.make_node(operator, ["embedding"], ["count"]))
            graph.node.append(helper.make_node("Cast", ["count"], ["image_embeds"], to=TensorProto.FLOAT))
        graph.output[0].type.tensor_type.ClearField("shape")

    edit(tmp_path / "vision_model.onnx", change)
    assert "not one embedding a row" in refusal(tmp_path)


def test_words_in_the_place_of_numbers(tmp_path):
    Toy().write(tmp_path)
    kind = helper.make_tensor_type_proto(TensorProto.STRING, ["batch", 3, 32, 32])
    edit(tmp_path / "vision_model.onnx", lambda graph: graph.input[0].type.CopyFrom(kind))
    assert "its input pixel_values holds numbers of a kind that no guide reads" in refusal(tmp_path)


def test_another_size_of_images(tmp_path):
    Toy().write(tmp_path)
    settings = json.loads((tmp_path / "preprocessor_config.json").read_text())
    (tmp_path / "preprocessor_config.json").write_text(json.dumps(settings | {"size": 40}))
    said = refusal(tmp_path)
    assert "reads images of 32 × 32 pixels and its preprocessor_config.json makes 40 × 40; take both" in said


def test_another_size_of_images_that_only_running_shows(tmp_path):
    TinyViT().write(tmp_path)

    def change(graph):
        for axis in graph.input[0].type.tensor_type.shape.dim[2:]:
            axis.dim_param = "side"

    edit(tmp_path / "vision_model.onnx", change)
    settings = json.loads((tmp_path / "preprocessor_config.json").read_text())
    (tmp_path / "preprocessor_config.json").write_text(json.dumps(settings | {"size": 40}))
    assert "vision_model.onnx failed while running" in refusal(tmp_path)


@pytest.mark.parametrize(
    "settings, said",
    [
        ({"size": {"height": 32, "width": 48}}, "its images are not square"),
        ({"size": 1 << 40}, "its image size is not within 8 to 2048"),
        ({"size": "large"}, "it names no image size"),
        ({"image_mean": [1, 2]}, "image_mean is not three numbers"),
        ({"image_std": [0, 0, 0]}, "image_std is not positive"),
    ],
)
def test_a_preprocessor_that_makes_no_sense(tmp_path, settings, said):
    Toy().write(tmp_path)
    whole = json.loads((tmp_path / "preprocessor_config.json").read_text())
    (tmp_path / "preprocessor_config.json").write_text(json.dumps(whole | settings))
    assert said in refusal(tmp_path)


def test_images_in_batches_of_one_length(tmp_path):
    assert "reads 4 images at a time; export it for any number" in refusal(Toy(batch=4).write(tmp_path))


def test_embeddings_of_different_lengths(tmp_path):
    said = refusal(Toy(text_dimension=12).write(tmp_path))
    assert "text embeddings have 12 numbers and its image embeddings 16; take both networks" in said


@pytest.mark.parametrize("words", [4, 5000])
def test_a_tokenizer_of_another_model(tmp_path, words):
    said = refusal(Toy(words=words).write(tmp_path))
    assert f"tokenizer.json has 10 tokens and its text_model.onnx knows {words}; take both" in said


def test_a_longer_text_than_the_network_has_places_for(tmp_path):
    Toy(positions=True).write(tmp_path)
    config = {"model_type": "clip", "text_config": {"max_position_embeddings": 40}}
    (tmp_path / "config.json").write_text(json.dumps(config))
    guide = boxmorph.Guide.open(tmp_path)
    with pytest.raises(boxmorph.GuideError, match=r"text_model\.onnx failed while running"):
        guide.text_embedding("a chair " * 30)


@pytest.mark.parametrize("value", [np.nan, np.inf, 0])
def test_weights_that_are_no_numbers(tmp_path, value):
    Toy().write(tmp_path)
    shape = (toy_guides.CHANNELS, toy_guides.DIMENSION)
    edit(
        tmp_path / "vision_model.onnx",
        lambda graph: put(graph, "image_projection", np.full(shape, value, np.float32)),
    )
    assert "an embedding without a direction; its network is damaged" in refusal(tmp_path)


def test_weights_in_another_file_that_are_not_there(tmp_path):
    Toy(external=True).write(tmp_path)
    data = tmp_path / "vision_model.onnx_data"
    whole = data.read_bytes()
    data.unlink()
    assert 'vision_model.onnx lie in "vision_model.onnx_data", which is missing; copy' in refusal(tmp_path)
    data.write_bytes(whole[:-4])
    assert f"which has {len(whole) - 4} bytes of {len(whole)}" in refusal(tmp_path)
    data.unlink()
    data.mkdir()
    assert "is a folder, not a file" in refusal(tmp_path)


@pytest.mark.parametrize("place", ["../secret", "/etc/passwd", "", "C:\\secret"])
def test_weights_are_read_from_the_guides_folder_only(tmp_path, place):
    Toy(external=True).write(tmp_path / "guide")
    (tmp_path / "secret").write_bytes(b"x" * 100_000)
    network = onnx.load(tmp_path / "guide" / "vision_model.onnx", load_external_data=False)
    for tensor in network.graph.initializer:
        for entry in tensor.external_data:
            if entry.key == "location":
                entry.value = place
    (tmp_path / "guide" / "vision_model.onnx").write_bytes(network.SerializeToString())
    said = refusal(tmp_path / "guide")
    assert "which is not in its folder" in said or "which is missing" in said


@pytest.mark.parametrize("name", ["tokenizer.json", "preprocessor_config.json", "config.json"])
@pytest.mark.parametrize("content", [b"[]", b"{}", b"[" * 100_000, b'{"a": 1e999}', b"\xff\xfe"])
def test_other_json(tmp_path, name, content):
    """An empty configuration says nothing wrong; everything else is damage."""
    Toy().write(tmp_path)
    (tmp_path / name).write_bytes(content)
    if name == "config.json" and content in (b"[]", b"{}"):
        boxmorph.Guide.open(tmp_path)
    else:
        assert name in refusal(tmp_path)


def damaged_tokenizer(folder, **parts):
    whole = json.loads((folder / "tokenizer.json").read_text())
    (folder / "tokenizer.json").write_text(json.dumps(whole | parts))
    return folder


def test_a_tokenizer_that_its_library_cannot_make(tmp_path):
    """It panics at this one."""
    Toy().write(tmp_path)
    damaged_tokenizer(tmp_path, normalizer={"type": "Precompiled", "precompiled_charsmap": "AAAA"})
    assert "tokenizer.json is damaged" in refusal(tmp_path)


def test_a_tokenizer_that_would_fill_the_memory(tmp_path):
    Toy().write(tmp_path)
    padding = {"direction": "Right", "pad_id": 0, "pad_type_id": 0, "pad_token": "[PAD]"}
    for strategy, multiple in (({"Fixed": 1 << 40}, None), ("BatchLongest", 1 << 40)):
        damaged_tokenizer(tmp_path, padding={**padding, "strategy": strategy, "pad_to_multiple_of": multiple})
        assert "it fills texts up beyond 4096 tokens" in refusal(tmp_path)


def test_lengths_that_make_no_sense(tmp_path):
    Toy().write(tmp_path)
    for length in (0, 1, -3, 1 << 60, "many"):
        config = {"model_type": "clip", "text_config": {"max_position_embeddings": length}}
        (tmp_path / "config.json").write_text(json.dumps(config))
        boxmorph.Guide.open(tmp_path).text_embedding("a bar stool")


def test_mutated_networks(tmp_path):
    """200 networks with bytes flipped, cut off or moved about, or put together wrongly, each opened and used
    in a process whose end would be seen.
    """
    guides, work = tmp_path / "guides", tmp_path / "work"
    for name, toy in {"toy": Toy(), "vit": TinyViT()}.items():
        toy.write(guides / name)
    (guides / "mini").mkdir()
    for path in MINI.glob("*.*"):
        shutil.copy(path, guides / "mini")
    work.mkdir()
    command = [
        sys.executable,
        str(HERE / "mutated_networks.py"),
        str(guides),
        str(work),
        "0",
        str(MUTATED),
        "0",
    ]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=600)
    lines = ran.stdout.splitlines()
    assert ran.returncode == 0, (
        f"the process ended with {ran.returncode} at {lines[-1]}: {ran.stderr[-2000:]}"
    )
    outcomes = [json.loads(line) for line in lines if line.startswith("{")]
    assert len(outcomes) == MUTATED
    refused = [one["said"] for one in outcomes if one["said"] != "used"]
    assert MUTATED // 3 < len(refused) < MUTATED
    assert all("\n" not in said and len(said) < 700 for said in refused)
    assert max(one["memory"] for one in outcomes) < 1 << 20, "more than a GiB for networks of a few MB"
