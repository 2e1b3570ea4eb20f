# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides of the architectures on the hub, with random weights, in every layout that exports have.

Needs torch, transformers, onnx, onnxruntime and sentencepiece.
"""

import json
import shutil
import warnings

import hub_tokenizers
import onnx
import onnxruntime.quantization
import torch
import transformers
from onnxruntime.transformers.float16 import convert_float_to_float16

CLIP_IMAGES = {
    "do_resize": True, "size": {"shortest_edge": 224}, "do_center_crop": True,
    "crop_size": {"height": 224, "width": 224}, "do_normalize": True, "resample": 3,
    "image_mean": [0.48145466, 0.4578275, 0.40821073], "image_std": [0.26862954, 0.26130258, 0.27577711],
}  # fmt: skip
SIGLIP_IMAGES = {
    "do_resize": True, "size": {"height": 224, "width": 224}, "do_rescale": True, "do_normalize": True,
    "rescale_factor": 1 / 255, "image_mean": [0.5, 0.5, 0.5], "image_std": [0.5, 0.5, 0.5], "resample": 3,
}  # fmt: skip


class Outputs(torch.nn.Module):
    """A model of transformers that takes its inputs in a fixed order and gives some of its outputs."""

    def __init__(self, model, inputs, outputs):
        super().__init__()
        self.model, self.inputs, self.outputs = model, inputs, outputs

    def forward(self, *values):
        found = self.model(**dict(zip(self.inputs, values, strict=True)))
        return tuple(getattr(found, name) for name in self.outputs)


def export(model, feeds, outputs, path):
    """Writes an ONNX file; all first axes are free, and the second of tokens."""
    axes = {
        name: {0: "batch"} | ({1: "sequence"} if value.ndim == 2 else {}) for name, value in feeds.items()
    }
    axes |= {name: {0: "batch"} for name in outputs}
    with torch.no_grad(), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        torch.onnx.export(
            Outputs(model.eval(), list(feeds), outputs), tuple(feeds.values()), str(path),
            input_names=list(feeds), output_names=outputs, dynamic_axes=axes, opset_version=17, dynamo=False,
        )  # fmt: skip


def model(kind, tokens, layers, seed=0):
    """CLIP ViT-B/32 or SigLIP base with fewer layers, and everything else as it is."""
    torch.manual_seed(seed)
    if kind == "clip":
        end = tokens - 1
        text = {
            "vocab_size": tokens,
            "bos_token_id": end - 1,
            "eos_token_id": end,
            "num_hidden_layers": layers,
        }
        config = transformers.CLIPConfig(
            text_config=text | {"pad_token_id": end}, vision_config={"num_hidden_layers": layers}
        )
        return transformers.CLIPModel(config)
    text = {"vocab_size": tokens, "num_hidden_layers": layers}
    config = transformers.SiglipConfig(text_config=text, vision_config={"num_hidden_layers": layers})
    return transformers.SiglipModel(config)


def example(kind, length):
    ids = torch.randint(3, 2000, (2, length))
    feeds = {"input_ids": ids}
    if kind == "clip":
        feeds["attention_mask"] = torch.ones_like(ids)
    return feeds, {"pixel_values": torch.rand(2, 3, 224, 224)}


def write(folder, kind, layers=2):
    """Writes a guide of two networks. Returns the model, its tokenizer and the folder."""
    (folder / "onnx").mkdir(parents=True)
    tokenizer, tokens = getattr(hub_tokenizers, kind)(folder)
    whole = model(kind, tokens, layers)
    text, images = example(kind, 7 if kind == "clip" else 64)
    if kind == "clip":
        config = whole.config
        vision = transformers.CLIPVisionModelWithProjection(config.vision_config)
        words = transformers.CLIPTextModelWithProjection(config.text_config)
        vision.load_state_dict(whole.state_dict(), strict=False)
        words.load_state_dict(whole.state_dict(), strict=False)
        outputs = ["image_embeds"], ["text_embeds"]
    else:
        vision, words = whole.vision_model, whole.text_model
        outputs = ["last_hidden_state", "pooler_output"], ["last_hidden_state", "pooler_output"]
    export(vision, images, outputs[0], folder / "onnx" / "vision_model.onnx")
    export(words, text, outputs[1], folder / "onnx" / "text_model.onnx")
    images = CLIP_IMAGES if kind == "clip" else SIGLIP_IMAGES
    (folder / "preprocessor_config.json").write_text(json.dumps(images))
    config = whole.config.to_dict()
    # The hub's own configurations leave the lengths out.
    config["text_config"].pop("max_position_embeddings", None)
    (folder / "config.json").write_text(json.dumps(config))
    return whole, tokenizer


def combined(source, folder, whole, kind):
    """The same guide as one network that holds both encoders, weights in a file of their own."""
    copy_texts(source, folder)
    text, images = example(kind, 7 if kind == "clip" else 64)
    outputs = ["logits_per_image", "logits_per_text", "text_embeds", "image_embeds"]
    feeds = {"input_ids": text.pop("input_ids"), **images, **text}
    export(whole, feeds, outputs, folder / "onnx" / "whole.onnx")
    onnx.save(
        onnx.load(folder / "onnx" / "whole.onnx"), folder / "onnx" / "model.onnx",
        save_as_external_data=True, location="model.onnx_data", size_threshold=1024,
    )  # fmt: skip
    (folder / "onnx" / "whole.onnx").unlink()


def half(source, folder, inputs_too):
    """The same guide in 16-bit floats."""
    copy_texts(source, folder)
    for name in ("vision_model", "text_model"):
        network = onnx.load(source / "onnx" / f"{name}.onnx")
        onnx.save(
            convert_float_to_float16(network, keep_io_types=not inputs_too),
            folder / "onnx" / f"{name}_fp16.onnx",
        )


def eight_bits(source, folder):
    """The same guide as `quantize_dynamic` makes it, which is what the hub has."""
    copy_texts(source, folder)
    for name in ("vision_model", "text_model"):
        onnxruntime.quantization.quantize_dynamic(
            source / "onnx" / f"{name}.onnx", folder / "onnx" / f"{name}_quantized.onnx",
            weight_type=onnxruntime.quantization.QuantType.QInt8, per_channel=True,
        )  # fmt: skip


def copy_texts(source, folder):
    (folder / "onnx").mkdir(parents=True)
    for path in source.glob("*.json"):
        shutil.copy(path, folder)
