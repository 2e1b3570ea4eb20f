# SPDX-License-Identifier: MIT OR Apache-2.0
"""Image networks in eight bits, made here, against `onnxruntime.quantization`."""

import shutil

import boxmorph
import numpy as np
import onnx
import pytest
from onnx import helper, numpy_helper
from onnxruntime.quantization import QuantType, quantize_dynamic
from test_guide_layouts import random_images
from toy_guides import TensorProto, TinyViT, Toy, unit


def operators(path):
    """How many nodes of each kind a network has."""
    kinds = [node.op_type for node in onnx.load(path).graph.node]
    return {kind: kinds.count(kind) for kind in set(kinds)}


def by_python(folder, work):
    """The same guide with its image network as `quantize_dynamic` makes it."""
    shutil.copytree(folder, work)
    path = work / "vision_model.onnx"
    quantize_dynamic(
        path,
        work / "vision_model_int8.onnx",
        weight_type=QuantType.QInt8,
        per_channel=True,
        op_types_to_quantize=["MatMul"],
    )
    return work


def test_the_network_is_what_onnx_runtime_makes(tmp_path):
    folder = TinyViT().write(tmp_path / "exact")
    theirs = by_python(folder, tmp_path / "theirs")
    figures = boxmorph.Guide.quantize(folder)
    ours = folder / "vision_model_int8.onnx"
    assert figures["file"] == ours and figures["products"] == 7
    assert operators(ours) == operators(theirs / "vision_model_int8.onnx")
    weights = [
        {
            w.name: numpy_helper.to_array(w)
            for w in onnx.load(path).graph.initializer
            if w.data_type == TensorProto.INT8 and len(w.dims) == 2
        }
        for path in (ours, theirs / "vision_model_int8.onnx")
    ]
    assert weights[0].keys() == weights[1].keys()
    for name, values in weights[0].items():
        # Halves may fall either way where a scale is rounded otherwise.
        assert abs(values.astype(int) - weights[1][name]).max() <= 1
        assert (values != weights[1][name]).mean() < 0.01
    images = random_images(12)
    by_ours, by_theirs = (
        boxmorph.Guide.open(place, precision="int8").image_embeddings(images) for place in (folder, theirs)
    )
    np.testing.assert_allclose(by_ours, by_theirs, atol=5e-3)


def test_the_figures_are_those_of_the_two_guides(tmp_path):
    folder = TinyViT().write(tmp_path)
    figures = boxmorph.Guide.quantize(folder)
    exact, fast = (boxmorph.Guide.open(folder, precision=name) for name in ("fp32", "int8"))
    assert (exact.precision, fast.precision) == ("fp32", "int8")
    assert figures["exact_bytes"] == (folder / "vision_model.onnx").stat().st_size
    assert figures["bytes"] == (folder / "vision_model_int8.onnx").stat().st_size
    assert figures["images"] == 96
    assert 0.9 < figures["cosine_min"] <= figures["cosine_mean"] < 1
    assert 0.5 < figures["rank_min"] <= figures["rank_mean"] <= 1
    assert figures["images_per_second"] > 0 and figures["exact_images_per_second"] > 0
    images = random_images(12)
    cosines = np.sum(unit(exact.image_embeddings(images)) * unit(fast.image_embeddings(images)), axis=1)
    assert 0.9 < cosines.mean() < 1
    # Text stays exact.
    assert np.array_equal(exact.text_embedding("a bar stool"), fast.text_embedding("a bar stool"))


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"combined": True, "place": "onnx"},
        {"external": True},
        {"external": True, "combined": True, "place": "onnx"},
    ],
    ids=["two networks", "one network", "weights in other files", "one network, weights in another file"],
)
@pytest.mark.parametrize("beside", [True, False])
def test_every_layout_is_copied(tmp_path, changes, beside):
    folder = TinyViT(**changes).write(tmp_path / "exact")
    before = sorted(path.name for path in folder.rglob("*"))
    output = None if beside else tmp_path / "small"
    figures = boxmorph.Guide.quantize(folder, output)
    assert figures["cosine_min"] > 0.9
    made = boxmorph.Guide.open(output or folder, precision="int8")
    exact = boxmorph.Guide.open(folder)
    assert exact.precision == "fp32"
    assert np.array_equal(exact.text_embedding("a bar stool"), made.text_embedding("a bar stool"))
    after = sorted(path.name for path in folder.rglob("*"))
    assert after == (sorted([*before, "vision_model_int8.onnx"]) if beside else before)
    if not beside:
        assert boxmorph.Guide.open(output).precision == "int8"


def test_a_gemm_with_turned_weights_and_a_bias(tmp_path):
    """As PyTorch's newer exporter writes a linear layer."""
    folder = Toy().write(tmp_path)
    network = onnx.load(folder / "vision_model.onnx")
    graph = network.graph
    last = next(w for w in graph.initializer if w.name == "image_projection")
    values = numpy_helper.to_array(last)
    last.CopyFrom(numpy_helper.from_array(np.ascontiguousarray(values.T), last.name))
    bias = np.linspace(-1, 1, values.shape[1]).astype(np.float32)
    graph.initializer.append(numpy_helper.from_array(bias, "bias"))
    gemm = helper.make_node("Gemm", ["flat", last.name, "bias"], ["image_embeds"], transB=1)
    graph.node[-1].CopyFrom(gemm)
    onnx.save(network, folder / "vision_model.onnx")
    figures = boxmorph.Guide.quantize(folder)
    # Less on processors without VNNI, where sums of eight bits can overflow.
    assert figures["products"] == 1 and figures["cosine_min"] > 0.99


def test_what_has_nothing_to_make_smaller_is_refused_and_left_alone(tmp_path):
    folder = Toy().write(tmp_path)
    network = onnx.load(folder / "vision_model.onnx")
    del network.graph.node[-1]
    del network.graph.initializer[1]
    network.graph.node[-1].output[0] = "image_embeds"
    network.graph.output[0].type.tensor_type.shape.dim[1].dim_value = 8
    onnx.save(network, folder / "vision_model.onnx")
    before = sorted(path.name for path in folder.iterdir())
    with pytest.raises(boxmorph.GuideError, match="cannot be made smaller"):
        boxmorph.Guide.quantize(folder)
    assert sorted(path.name for path in folder.iterdir()) == before


def test_a_copy_that_cannot_be_used_is_taken_away(tmp_path):
    folder = Toy(dimension=12).write(tmp_path / "exact")
    with pytest.raises(boxmorph.GuideError, match="text embeddings have 16 numbers"):
        boxmorph.Guide.quantize(folder, tmp_path / "small")
    assert not (tmp_path / "small").exists()
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(boxmorph.GuideError, match="cannot be written"):
        boxmorph.Guide.quantize(TinyViT().write(folder), tmp_path / "file")
    assert (tmp_path / "file").read_text() == "in the way"


def test_only_a_32_bit_guide_is_made_smaller(tmp_path):
    Toy(floats=TensorProto.FLOAT16, ending="_fp16").write(tmp_path)
    with pytest.raises(boxmorph.GuideError, match='no networks in the precision "fp32"'):
        boxmorph.Guide.quantize(tmp_path)


def test_a_copy_on_a_thread_of_its_own(tmp_path):
    folder = TinyViT().write(tmp_path / "exact")
    work = boxmorph.EightBitCopy(folder, tmp_path / "small")
    assert work.progress() == {"phase": "Waiting", "fraction": 0.0, "finished": False}
    with pytest.raises(RuntimeError, match="has not finished"):
        work.result()
    work.start()
    work.join()
    figures = work.result()
    assert work.progress()["finished"] and work.progress()["phase"] == "Comparing them"
    assert figures["images"] == 96 and figures["file"].is_relative_to(tmp_path / "small")
    assert boxmorph.Guide.open(tmp_path / "small").precision == "int8"
    with pytest.raises(RuntimeError, match="started before"):
        work.start()


def test_a_cancelled_copy_leaves_nothing(tmp_path):
    folder = TinyViT().write(tmp_path / "exact")
    work = boxmorph.EightBitCopy(folder, tmp_path / "small")
    work.cancel()
    work.start()
    with pytest.raises(boxmorph.Cancelled, match="nothing of it is left"):
        work.join()
    assert not (tmp_path / "small").exists()
    (folder / "text_model.onnx").write_bytes(b"no network")
    work = boxmorph.EightBitCopy(folder, tmp_path / "small")
    work.start()
    with pytest.raises(boxmorph.GuideError, match="is not a network"):
        work.join()
    assert not (tmp_path / "small").exists()
