# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides in every layout that exports have, against ONNX Runtime from Python on the files as they are."""

import json

import boxmorph
import numpy as np
import onnxruntime
import pytest
import toy_guides
from toy_guides import TensorProto, TinyViT, Toy

PROMPT = "A bar stool"
IDS = [2, 4, 5]

LAYOUTS = {
    "two networks": {},
    "under onnx": {"place": "onnx"},
    "one network": {"combined": True, "place": "onnx"},
    "one network, two outputs": {"combined": True, "hidden": True},
    "weights in other files": {"external": True, "place": "onnx"},
    "one network, weights in another file": {"external": True, "combined": True},
    "16 bits": {"floats": TensorProto.FLOAT16, "ending": "_fp16"},
    "one network, 16 bits": {"floats": TensorProto.FLOAT16, "ending": "_fp16", "combined": True},
    "32-bit token ids": {"ids": TensorProto.INT32},
    "no mask": {"mask": False},
    "no mask, siglip": {"mask": False, "model_type": "siglip"},
    "mask, siglip": {"model_type": "siglip"},
    "texts of one length": {"tokens": 9},
    "texts of one length, no mask": {"tokens": 9, "mask": False},
    "positions": {"positions": True},
    "one image at a time": {"batch": 1},
    "pooled output behind a hidden state": {"image_output": "pooler_output", "hidden": True},
    "outputs of no known name": {"image_output": "y", "text_output": "z", "hidden": True},
    "other file names": {"names": ("visual", "textual")},
}


def expected(folder, toy, images):
    """Unit embeddings of images and of PROMPT, by the files as they are."""
    length = toy.tokens or (20 if not toy.mask or toy.model_type == "siglip" else len(IDS))
    ids = np.array([IDS + [0] * (length - len(IDS))])
    mask = (
        np.ones_like(ids)
        if toy.model_type == "siglip"
        else np.array([[1] * len(IDS) + [0] * (length - len(IDS))])
    )
    found = []
    for name, output in zip(toy.names, (toy.image_output, toy.text_output), strict=True):
        name = "model" if toy.combined else name
        session = onnxruntime.InferenceSession(folder / toy.place / f"{name}{toy.ending}.onnx")
        rows = []
        for image in images:
            known = {
                "pixel_values": toy_guides.pixels(image[None]).astype(toy_guides.FLOATS[toy.floats]),
                "input_ids": ids.astype(toy_guides.WHOLES[toy.ids]),
                "attention_mask": mask.astype(toy_guides.WHOLES[toy.ids]),
                "position_ids": np.arange(length)[None].astype(toy_guides.WHOLES[toy.ids]),
            }
            feeds = {value.name: known[value.name] for value in session.get_inputs()}
            rows.append(session.run([output], feeds)[0][0])
        found.append(toy_guides.unit(rows))
    return found[0], found[1][0]


def random_images(count, size=toy_guides.SIZE):
    return np.random.default_rng(0).integers(0, 256, (count, size, size, 3), np.uint8)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_layout_opens_and_embeds_as_onnx_runtime_does(tmp_path, layout):
    toy = Toy(**LAYOUTS[layout])
    toy.write(tmp_path)
    guide = boxmorph.Guide.open(tmp_path)
    images = random_images(14)
    vision, text = expected(tmp_path, toy, images)
    tolerance = 1e-3 if toy.floats == TensorProto.FLOAT16 else 1e-5
    np.testing.assert_allclose(guide.image_embeddings(images), vision, atol=tolerance)
    np.testing.assert_allclose(guide.text_embedding(PROMPT), text, atol=tolerance)


def test_the_most_exact_precision_is_taken_unless_another_is_named(tmp_path):
    Toy(seed=1).write(tmp_path)
    Toy(seed=2, ending="_fp16", floats=TensorProto.FLOAT16).write(tmp_path)
    exact = TinyViT(seed=3).write(tmp_path / "exact")
    made = boxmorph.Guide.quantize(exact)["file"]
    made.rename(tmp_path / "vision_model_quantized.onnx")
    (exact / "text_model.onnx").rename(tmp_path / "text_model_quantized.onnx")
    hashes = set()
    for asked, given in {"auto": "fp32", "fp32": "fp32", "fp16": "fp16", "int8": "int8"}.items():
        guide = boxmorph.Guide.open(tmp_path, precision=asked)
        assert guide.precision == given
        hashes.add(guide.sha256)
    assert len(hashes) == 3
    with pytest.raises(boxmorph.GuideError, match='has no networks in the precision "q4"; choose another'):
        boxmorph.Guide.open(tmp_path, precision="q4")
    with pytest.raises(ValueError, match='unknown precision "int7": choose "fp32"'):
        boxmorph.Guide.open(tmp_path, precision="int7")


def test_the_precision_that_is_told_is_that_of_the_weights(tmp_path):
    plain = Toy(floats=TensorProto.FLOAT16).write(tmp_path / "plain")
    assert boxmorph.Guide.open(plain).precision == "fp16"
    Toy(ending="_quantized").write(tmp_path / "misnamed")
    assert boxmorph.Guide.open(tmp_path / "misnamed", precision="int8").precision == "fp32"


def test_weights_in_another_file_belong_to_the_hash(tmp_path):
    Toy(external=True).write(tmp_path)
    before = boxmorph.Guide.open(tmp_path).sha256
    data = tmp_path / "vision_model.onnx_data"
    whole = bytearray(data.read_bytes())
    whole[5] ^= 1
    data.write_bytes(whole)
    assert boxmorph.Guide.open(tmp_path).sha256 != before


def test_a_download_cache_of_links_opens(tmp_path):
    """As huggingface_hub lays out its cache: names are links to files named by their hashes, elsewhere."""
    Toy(external=True, place="onnx").write(tmp_path / "real")
    (tmp_path / "blobs").mkdir()
    for number, path in enumerate(sorted((tmp_path / "real").rglob("*.*"))):
        link = tmp_path / "snapshots" / "main" / path.relative_to(tmp_path / "real")
        link.parent.mkdir(parents=True, exist_ok=True)
        path.rename(tmp_path / "blobs" / str(number))
        link.symlink_to(tmp_path / "blobs" / str(number))
    guide = boxmorph.Guide.open(tmp_path / "snapshots" / "main")
    assert guide.image_embeddings(random_images(1)).shape == (1, toy_guides.DIMENSION)


@pytest.mark.parametrize(
    "settings, mean, std",
    [
        ({"size": 32}, toy_guides.MEAN, toy_guides.STD),
        ({"size": {"height": 32, "width": 32}}, toy_guides.MEAN, toy_guides.STD),
        ({"size": {"shortest_edge": 40}, "crop_size": 32}, toy_guides.MEAN, toy_guides.STD),
        ({"size": 40, "crop_size": {"height": 32, "width": 32}}, toy_guides.MEAN, toy_guides.STD),
        ({"size": 32, "crop_size": 16, "do_center_crop": False}, toy_guides.MEAN, toy_guides.STD),
        ({"size": 32, "do_normalize": False}, [0, 0, 0], [1, 1, 1]),
        ({"size": 32, "rescale_factor": 1 / 127.5}, toy_guides.MEAN, toy_guides.STD),
        ({"size": 32, "do_rescale": False}, toy_guides.MEAN, toy_guides.STD),
    ],
    ids=lambda value: json.dumps(value) if isinstance(value, dict) else "",
)
@pytest.mark.parametrize("nested", [False, True])
def test_the_preprocessor_is_understood(tmp_path, settings, mean, std, nested):
    Toy().write(tmp_path)
    whole = {"image_mean": toy_guides.MEAN, "image_std": toy_guides.STD, **settings}
    if nested:
        (tmp_path / "preprocessor_config.json").unlink()
        (tmp_path / "processor_config.json").write_text(json.dumps({"image_processor": whole}))
    else:
        (tmp_path / "preprocessor_config.json").write_text(json.dumps(whole))
    images = random_images(2)
    scale = settings.get("rescale_factor", 1 / 255) if settings.get("do_rescale", True) else 1
    values = ((images * scale - mean) / std).transpose(0, 3, 1, 2).astype(np.float32)
    session = onnxruntime.InferenceSession(tmp_path / "vision_model.onnx")
    (rows,) = session.run(None, {"pixel_values": values})
    guide = boxmorph.Guide.open(tmp_path)
    np.testing.assert_allclose(guide.image_embeddings(images), toy_guides.unit(rows), atol=1e-5)


def test_tokens_are_seen_and_cut_at_the_longest_text(tmp_path):
    guide = boxmorph.Guide.open(Toy().write(tmp_path))
    assert guide.token_ids(PROMPT) == IDS
    assert guide.token_ids("") == []
    assert guide.token_ids("a chair " * 30) == [2, 6] * 10
    guide = boxmorph.Guide.open(Toy(tokens=6).write(tmp_path))
    assert guide.token_ids(PROMPT) == [*IDS, 0, 0, 0]


def test_siglip_reads_lower_case_of_one_length(tmp_path):
    guide = boxmorph.Guide.open(Toy(model_type="siglip").write(tmp_path))
    assert guide.token_ids("A BAR stool") == IDS + [0] * 17
