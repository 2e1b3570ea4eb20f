# SPDX-License-Identifier: MIT OR Apache-2.0
"""Makes a guide of CLIP's exact architecture with random weights, in the layout that exports on the hub have.

Usage: python random_clip.py OUTPUT_FOLDER [--model vit-b-32] [--layers N] [--precision fp32] [--seed 0]

The real weights cannot be had everywhere, but speed, memory and the way through every layer do not depend on
them. The vocabulary is learnt from Python's own manual, so that words are cut as in a real one, only sooner.
Needs torch, transformers, onnx and onnxscript.
"""

import argparse
import json
import pathlib
import pydoc_data.topics

import onnx
import tokenizers
import torch
from onnx import numpy_helper
from transformers import CLIPConfig, CLIPTextModelWithProjection, CLIPVisionModelWithProjection

# Side of images, side of patches, vision width, layers, heads; text width, heads; length of an embedding.
MODELS = {
    "vit-b-32": (224, 32, 768, 12, 12, 512, 8, 512),
    "vit-b-16": (224, 16, 768, 12, 12, 512, 8, 512),
    "vit-l-14": (224, 14, 1024, 24, 16, 768, 12, 768),
    "tiny": (64, 16, 64, 2, 2, 64, 2, 32),
}
VOCABULARY, START, END, LENGTH = 49408, 49406, 49407, 77
WORDS = r"<\|startoftext\|>|<\|endoftext\|>|'s|'t|'re|'ve|'m|'ll|'d|[\p{L}]+|[\p{N}]|[^\s\p{L}\p{N}]+"
OPSET = 17


def config(model, layers):
    """The configuration of `model`, with another number of layers if `layers` says so."""
    side, patch, width, depth, heads, text_width, text_heads, length = MODELS[model]
    text = {"hidden_size": text_width, "num_attention_heads": text_heads, "intermediate_size": 4 * text_width}
    text |= {"num_hidden_layers": layers or min(depth, 12), "projection_dim": length}
    text |= {"vocab_size": VOCABULARY, "bos_token_id": START, "eos_token_id": END, "pad_token_id": END}
    vision = {"hidden_size": width, "num_attention_heads": heads, "intermediate_size": 4 * width}
    vision |= {"num_hidden_layers": layers or depth, "projection_dim": length}
    vision |= {"image_size": side, "patch_size": patch}
    return CLIPConfig(text_config=text, vision_config=vision, projection_dim=length)


class Embeds(torch.nn.Module):
    """A model of transformers whose only output is the embedding."""

    def __init__(self, model, output):
        super().__init__()
        self.model, self.output = model, output

    def forward(self, x):
        return getattr(self.model(x), self.output)


def export(model, output, example, name, axes, path, precision):
    """Writes one network, weights inside."""
    with torch.no_grad():
        torch.onnx.export(
            Embeds(model.eval(), output),
            (example,),
            path,
            input_names=[name],
            output_names=[output],
            dynamic_axes={name: axes, output: {0: axes[0]}},
            opset_version=OPSET,
            dynamo=False,
        )
    if precision == "fp16":
        onnx.save(halved(onnx.load(path)), path)


def halved(model):
    """The same network in 16-bit floats, inputs and outputs too."""
    graph = model.graph
    for weight in graph.initializer:
        if weight.data_type == onnx.TensorProto.FLOAT:
            half = numpy_helper.to_array(weight).astype("float16")
            weight.CopyFrom(numpy_helper.from_array(half, weight.name))
    for node in graph.node:
        for attribute in node.attribute:
            if attribute.name == "to" and attribute.i == onnx.TensorProto.FLOAT:
                attribute.i = onnx.TensorProto.FLOAT16
            if attribute.t.data_type == onnx.TensorProto.FLOAT:
                half = numpy_helper.to_array(attribute.t).astype("float16")
                attribute.t.CopyFrom(numpy_helper.from_array(half, attribute.t.name))
    del graph.value_info[:]
    for value in [*graph.input, *graph.output]:
        if value.type.tensor_type.elem_type == onnx.TensorProto.FLOAT:
            value.type.tensor_type.elem_type = onnx.TensorProto.FLOAT16
    return model


def tokenizer():
    """CLIP's byte-level BPE: lower case, `</w>` at the end of words, a start and an end token."""
    byte_level = tokenizers.pre_tokenizers.ByteLevel(add_prefix_space=False)
    split = tokenizers.pre_tokenizers.Split(tokenizers.Regex(WORDS), "removed", invert=True)
    normalizers = tokenizers.normalizers
    learner = tokenizers.Tokenizer(tokenizers.models.BPE(end_of_word_suffix="</w>"))
    learner.normalizer = normalizers.Lowercase()
    learner.pre_tokenizer = tokenizers.pre_tokenizers.Sequence([split, byte_level])
    trainer = tokenizers.trainers.BpeTrainer(
        vocab_size=8000, end_of_word_suffix="</w>", show_progress=False, special_tokens=[]
    )
    learner.train_from_iterator(pydoc_data.topics.topics.values(), trainer)
    merges = [tuple(pair) for pair in json.loads(learner.to_str())["model"]["merges"]]
    letters = sorted(byte_level.alphabet())
    tokens = [*letters, *(letter + "</w>" for letter in letters), *(a + b for a, b in merges)]
    vocabulary = {token: number for number, token in enumerate(dict.fromkeys(tokens))}
    vocabulary |= {"<|startoftext|>": START, "<|endoftext|>": END}
    whole = tokenizers.Tokenizer(
        tokenizers.models.BPE(
            vocabulary, merges, end_of_word_suffix="</w>", unk_token="<|endoftext|>", fuse_unk=False
        )
    )
    spaces = normalizers.Replace(tokenizers.Regex(r"\s+"), " ")
    whole.normalizer = normalizers.Sequence([normalizers.NFC(), spaces, normalizers.Lowercase()])
    whole.pre_tokenizer = learner.pre_tokenizer
    whole.post_processor = tokenizers.processors.RobertaProcessing(
        ("<|endoftext|>", END), ("<|startoftext|>", START), trim_offsets=False, add_prefix_space=False
    )
    whole.decoder = tokenizers.decoders.ByteLevel()
    whole.add_special_tokens(["<|startoftext|>", "<|endoftext|>"])
    return whole


def preprocessor(side):
    """What images go through before the network."""
    return {
        "crop_size": {"height": side, "width": side},
        "do_center_crop": True,
        "do_convert_rgb": True,
        "do_normalize": True,
        "do_rescale": True,
        "do_resize": True,
        "image_mean": [0.48145466, 0.4578275, 0.40821073],
        "image_processor_type": "CLIPImageProcessor",
        "image_std": [0.26862954, 0.26130258, 0.27577711],
        "resample": 3,
        "rescale_factor": 0.00392156862745098,
        "size": {"shortest_edge": side},
    }


def make(folder, model="vit-b-32", layers=None, precision="fp32", seed=0):
    """Writes the guide into `folder`, the networks under `onnx/`."""
    folder = pathlib.Path(folder)
    (folder / "onnx").mkdir(parents=True, exist_ok=True)
    torch.manual_seed(seed)
    settings = config(model, layers)
    side = settings.vision_config.image_size
    networks = [
        (
            CLIPVisionModelWithProjection(settings.vision_config),
            "image_embeds",
            torch.zeros(2, 3, side, side),
            "pixel_values",
            {0: "batch_size"},
            "vision_model.onnx",
        ),
        (
            CLIPTextModelWithProjection(settings.text_config),
            "text_embeds",
            torch.tensor([[START, 320, 1000, END]] * 2),
            "input_ids",
            {0: "batch_size", 1: "sequence_length"},
            "text_model.onnx",
        ),
    ]
    for network, output, example, name, axes, file in networks:
        export(network, output, example, name, axes, str(folder / "onnx" / file), precision)
    tokenizer().save(str(folder / "tokenizer.json"))
    (folder / "preprocessor_config.json").write_text(json.dumps(preprocessor(side), indent=2))
    (folder / "config.json").write_text(settings.to_json_string(use_diff=False))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--model", choices=MODELS, default="vit-b-32")
    parser.add_argument("--layers", type=int, help="of both networks, instead of the architecture's own")
    parser.add_argument("--precision", choices=["fp32", "fp16"], default="fp32")
    parser.add_argument("--seed", type=int, default=0)
    make(**vars(parser.parse_args()))


if __name__ == "__main__":
    main()
