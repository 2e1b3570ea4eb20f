# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides: embeddings, words they do not know, folders that are damaged."""

import pathlib
import re
import shutil
import subprocess
import sys

import boxmorph
import numpy as np
import pytest

MINI = pathlib.Path(__file__).resolve().parents[2] / "guides" / "mini"
FILES = ["vision_model.onnx", "text_model.onnx", "tokenizer.json", "preprocessor_config.json", "config.json"]


@pytest.fixture
def folder(tmp_path):
    """A copy of the embedded guide."""
    for name in FILES:
        shutil.copy(MINI / name, tmp_path / name)
    return tmp_path


def images(guide, count, seed=0):
    size = guide.image_size
    return np.random.default_rng(seed).integers(0, 256, (count, size, size, 3), np.uint8)


def test_embeddings_are_unit_vectors(guide):
    text = guide.text_embedding("a bar stool")
    assert np.linalg.norm(text) == pytest.approx(1, abs=1e-5)
    embedded = guide.image_embeddings(images(guide, 5))
    assert embedded.shape == (5, len(text))
    np.testing.assert_allclose(np.linalg.norm(embedded, axis=1), 1, atol=1e-5)


def test_no_images_give_no_embeddings(guide):
    assert guide.image_embeddings(images(guide, 0)).shape == (0, len(guide.text_embedding("a chair")))


def test_an_image_embeds_the_same_alone_and_in_company(guide):
    batch = images(guide, 30)
    together = guide.image_embeddings(batch)
    alone = np.concatenate([guide.image_embeddings(batch[k : k + 1]) for k in range(30)])
    np.testing.assert_allclose(together, alone, atol=1e-5)


def test_onnx_runtime_from_python_agrees(guide):
    onnxruntime = pytest.importorskip("onnxruntime", reason="an independent ONNX Runtime is not installed")
    import json

    config = json.loads((MINI / "preprocessor_config.json").read_text())
    batch = images(guide, 4)
    pixels = (batch.astype(np.float32) / 255 - config["image_mean"]) / config["image_std"]
    session = onnxruntime.InferenceSession(str(MINI / "vision_model.onnx"))
    (expected,) = session.run(
        ["image_embeds"], {"pixel_values": pixels.transpose(0, 3, 1, 2).astype(np.float32)}
    )
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(guide.image_embeddings(batch), expected, atol=1e-5)


def test_articles_and_case_matter_little(guide):
    stool = guide.text_embedding("a bar stool")
    assert stool @ guide.text_embedding("A Bar Stool") > 0.95
    assert stool @ guide.text_embedding("a bar stool") > stool @ guide.text_embedding("an airship")


def test_unknown_words_are_named(guide):
    assert guide.unknown_words("a bar stool") == []
    assert guide.unknown_words("a zorblax stool of quux") == ["zorblax", "quux"] or set(
        guide.unknown_words("a zorblax stool of quux")
    ) >= {"zorblax", "quux"}


def test_a_prompt_of_unknown_words_alone_is_refused(chair, guide):
    with pytest.raises(ValueError, match=r"no word of this prompt.*\(zorblax\)\. It knows, for example: a "):
        boxmorph.Job(boxmorph.Mesh(*chair), "a zorblax", guide=guide)


@pytest.mark.parametrize(
    "prompt, meant", [("a chiar", "chair"), ("glidre", "glider"), ("a zepelin", "zeppelin")]
)
def test_a_misspelt_prompt_is_refused_with_the_nearest_known_word(guide, prompt, meant):
    with pytest.raises(ValueError, match=f"The nearest it knows: {meant}"):
        guide.check_prompt(prompt)


def test_a_misspelt_word_among_known_ones_has_a_nearest(guide):
    guide.check_prompt("a tall chiar")
    assert guide.unknown_words("a tall chiar") == ["chiar"]
    assert guide.nearest_words("chiar", 1) == ["chair"]
    assert guide.nearest_words("zorblax") == []


def test_a_refusal_names_a_few_words_only(guide):
    with pytest.raises(ValueError) as refused:
        guide.check_prompt(" ".join(f"zorblax{i}q" for i in range(90)))
    assert len(str(refused.value)) < 400


@pytest.mark.parametrize("prompt", ["the of a", "!?", "with a"])
def test_a_prompt_that_names_nothing_is_refused(guide, prompt):
    with pytest.raises(ValueError, match="no word of this prompt that names a shape"):
        guide.check_prompt(prompt)


@pytest.mark.parametrize("prompt", ["", "   ", "\n"])
def test_an_empty_prompt_is_refused(chair, guide, prompt):
    with pytest.raises(ValueError, match="the prompt is empty; type"):
        boxmorph.Job(boxmorph.Mesh(*chair), prompt, guide=guide)


def test_an_endless_prompt_is_refused(chair, guide):
    with pytest.raises(ValueError, match="10000 characters; say it in at most 1000"):
        boxmorph.Job(boxmorph.Mesh(*chair), "x" * 10_000, guide=guide)
    with pytest.raises(ValueError, match="10000 characters"):
        guide.text_embedding("x" * 10_000)


def test_images_of_another_size_or_type_are_refused(guide):
    size = guide.image_size
    with pytest.raises(ValueError, match=r"render at guide\.image_size"):
        guide.image_embeddings(np.zeros((1, size + 1, size, 3), np.uint8))
    with pytest.raises(TypeError, match="uint8"):
        guide.image_embeddings(np.zeros((1, size, size, 3), np.float32))


def test_a_folder_holds_the_same_guide(folder, guide):
    other = boxmorph.Guide.open(folder)
    assert other.sha256 == guide.sha256
    assert np.array_equal(other.text_embedding("a sofa"), guide.text_embedding("a sofa"))


def test_the_networks_may_lie_under_onnx(folder, guide):
    (folder / "onnx").mkdir()
    for name in FILES[:2]:
        (folder / name).rename(folder / "onnx" / name)
    assert boxmorph.Guide.open(folder).sha256 == guide.sha256


def test_a_missing_folder_is_a_sentence(tmp_path):
    with pytest.raises(boxmorph.GuideError, match="there is no guide folder at"):
        boxmorph.Guide.open(tmp_path / "nowhere")


@pytest.mark.parametrize("name", FILES)
def test_a_missing_file_is_named(folder, name):
    (folder / name).unlink()
    with pytest.raises(boxmorph.GuideError, match=f"has no {name}; copy the whole folder"):
        boxmorph.Guide.open(folder)


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("damage", [b"", b"not what it was", None], ids=["empty", "text", "truncated"])
def test_a_damaged_file_is_named(folder, name, damage):
    whole = (folder / name).read_bytes()
    (folder / name).write_bytes(whole[: len(whole) // 2] if damage is None else damage)
    with pytest.raises(boxmorph.GuideError, match=name):
        boxmorph.Guide.open(folder)


def test_networks_that_do_not_fit_are_refused(folder):
    shutil.copy(folder / "text_model.onnx", folder / "vision_model.onnx")
    with pytest.raises(boxmorph.GuideError):
        boxmorph.Guide.open(folder)


def test_the_runtime_says_what_it_is():
    assert boxmorph.execution_providers()[-1] == "cpu"
    library = boxmorph.runtime_library()
    assert library.is_file() and "onnxruntime" in library.name
    assert re.fullmatch(r"1\.\d+\.\d+", boxmorph.runtime_version())


def test_the_processor_is_automatic_for_the_embedded_guide(guide):
    assert (guide.provider, guide.provider_note) == ("cpu", None)
    named = boxmorph.Guide.open(provider="cpu")
    batch = images(guide, 15)
    assert np.array_equal(named.image_embeddings(batch), guide.image_embeddings(batch))


@pytest.mark.parametrize("name", ["cuda", "directml", "coreml", "migraphx", "openvino"])
def test_a_provider_that_the_library_lacks_is_replaced_with_a_sentence(guide, name):
    if name in boxmorph.execution_providers():
        pytest.skip("the library has it")
    other = boxmorph.Guide.open(provider=name)
    assert other.provider == "cpu"
    assert name in other.provider_note.lower().replace(" ", "") and "so the processor" in other.provider_note
    batch = images(guide, 15)
    assert np.array_equal(other.image_embeddings(batch), guide.image_embeddings(batch))


def test_an_unknown_provider_is_refused():
    with pytest.raises(ValueError, match='unknown execution provider "abacus": choose "auto", "cuda"'):
        boxmorph.Guide.open(provider="abacus")


def test_a_missing_library_is_a_sentence():
    code = (
        "import boxmorph\n"
        "try:\n    boxmorph.Guide.open()\n"
        "except boxmorph.GuideError as error:\n    print(error)\n"
    )
    environment = {"ORT_DYLIB_PATH": "/nowhere/libonnxruntime.so"}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert 'ONNX Runtime\'s library cannot be opened at "/nowhere/libonnxruntime.so"' in done.stdout
    assert "reinstall Boxmorph, or set ORT_DYLIB_PATH" in done.stdout
