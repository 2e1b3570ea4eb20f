# SPDX-License-Identifier: MIT OR Apache-2.0
"""Trained weights to the guide folder: two ONNX files (opset 17, weights stored as float16), tokenizer,
configs.

Several trained pairs become one guide: their unit embeddings side by side, divided by the root of their
number, so that the cosine of the whole is the mean of their cosines.
"""

import json
from pathlib import Path

import numpy as np
import onnx
import torch
from families import FAMILIES
from generate import SIZE
from model import EMBEDDING, LAYERS, MARGIN, SEEN, ImageEncoder, TextEncoder
from onnx import TensorProto, helper, numpy_helper
from text import LENGTH, class_prompts, tokenizer_json


class Graph:
    """Collects nodes and weights; weights are stored as float16 and cast once when the model is loaded."""

    def __init__(self):
        self.nodes, self.weights, self.count = [], [], 0

    def constant(self, array, name):
        array = np.asarray(array)
        if array.dtype == np.float32 and array.size > 64:
            self.weights.append(numpy_helper.from_array(array.astype(np.float16), name + "_half"))
            self.nodes.append(helper.make_node("Cast", [name + "_half"], [name], to=TensorProto.FLOAT))
        else:
            self.weights.append(numpy_helper.from_array(array, name))
        return name

    def op(self, kind, inputs, **attributes):
        self.count += 1
        out = f"{kind.lower()}_{self.count}"
        self.nodes.append(helper.make_node(kind, inputs, [out], **attributes))
        return out

    def save(self, path, inputs, output, width):
        self.nodes[-1].output[0] = output
        out = helper.make_tensor_value_info(output, TensorProto.FLOAT, ["batch", width])
        graph = helper.make_graph(self.nodes, Path(path).stem, inputs, [out], self.weights)
        model = helper.make_model(
            graph, opset_imports=[helper.make_opsetid("", 17)], producer_name="boxmorph"
        )
        model.ir_version = 8
        onnx.checker.check_model(model)
        onnx.save(model, path)


def _unit(graph, x, share):
    """x scaled to the length `share` along its last axis."""
    length = graph.op("ReduceL2", [x], axes=[-1], keepdims=1)
    safe = graph.op("Max", [length, graph.constant(np.float32(1e-12), f"tiny_{graph.count}")])
    return graph.op(
        "Mul", [graph.op("Div", [x, safe]), graph.constant(np.float32(share), f"share_{graph.count}")]
    )


def _folded(conv, norm):
    """Weights of a convolution with its batch normalisation folded in."""
    factor = norm.weight / torch.sqrt(norm.running_var + norm.eps)
    weight = conv.weight * factor[:, None, None, None]
    return weight.detach().numpy(), (norm.bias - norm.running_mean * factor).detach().numpy()


def image_model(encoders, path):
    """pixel_values (batch, 3, SIZE, SIZE) to image_embeds."""
    graph, parts = Graph(), []
    place = {"starts": [MARGIN] * 2, "ends": [MARGIN + SEEN] * 2, "axes": [2, 3]}
    middle = graph.op(
        "Slice", ["pixel_values", *(graph.constant(np.array(v, np.int64), k) for k, v in place.items())]
    )
    for n, encoder in enumerate(encoders):
        x = middle
        for i, (_, stride) in enumerate(LAYERS):
            weight, bias = _folded(encoder.features[3 * i], encoder.features[3 * i + 1])
            names = [graph.constant(weight, f"net{n}_conv{i}"), graph.constant(bias, f"net{n}_bias{i}")]
            x = graph.op("Conv", [x, *names], kernel_shape=[3, 3], strides=[stride] * 2, pads=[1, 1, 1, 1])
            x = graph.op("Relu", [x])
        head = encoder.head
        names = [
            graph.constant(head.weight.detach().numpy(), f"net{n}_head"),
            graph.constant(head.bias.detach().numpy(), f"net{n}_head_bias"),
        ]
        x = graph.op("Gemm", [graph.op("Flatten", [x]), *names], transB=1)
        parts.append(_unit(graph, x, len(encoders) ** -0.5))
    graph.op("Concat", parts, axis=1)
    shape = helper.make_tensor_value_info("pixel_values", TensorProto.FLOAT, ["batch", 3, SIZE, SIZE])
    graph.save(path, [shape], "image_embeds", EMBEDDING * len(encoders))


def text_model(encoders, path):
    """input_ids and attention_mask (batch, sequence) to text_embeds."""
    graph, parts = Graph(), []
    axis = graph.constant(np.array([1], np.int64), "axis")
    last = graph.constant(np.array([2], np.int64), "last")
    weight = graph.constant(encoders[0].weight[:, 0].numpy(), "word_weight")
    mask = graph.op("Cast", ["attention_mask"], to=TensorProto.FLOAT)
    weight = graph.op("Mul", [graph.op("Gather", [weight, "input_ids"]), mask])
    total = graph.op("ReduceSum", [weight, axis], keepdims=1)
    total = graph.op("Sqrt", [graph.op("Max", [total, graph.constant(np.float32(1), "one")])])
    weight = graph.op("Unsqueeze", [weight, last])
    for n, encoder in enumerate(encoders):
        words = graph.op(
            "Gather", [graph.constant(encoder.table().detach().numpy(), f"net{n}_words"), "input_ids"]
        )
        mean = graph.op(
            "Div", [graph.op("ReduceSum", [graph.op("Mul", [words, weight]), axis], keepdims=0), total]
        )
        for layer, linear in (("hidden", encoder.hidden), ("out", encoder.out)):
            names = [
                graph.constant(linear.weight.detach().numpy(), f"net{n}_{layer}"),
                graph.constant(linear.bias.detach().numpy(), f"net{n}_{layer}_bias"),
            ]
            mean = graph.op("Gemm", [mean, *names], transB=1)
            mean = graph.op("Relu", [mean]) if layer == "hidden" else mean
        parts.append(_unit(graph, mean, len(encoders) ** -0.5))
    graph.op("Concat", parts, axis=1)
    inputs = [
        helper.make_tensor_value_info(n, TensorProto.INT64, ["batch", "sequence"])
        for n in ("input_ids", "attention_mask")
    ]
    graph.save(path, inputs, "text_embeds", EMBEDDING * len(encoders))


def export(weights, folder):
    """Write the guide folder from one or more weight files of fit.py."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    eyes, texts = [], []
    for path in weights:
        state = torch.load(path)
        eye, text = ImageEncoder().eval(), TextEncoder().eval()
        eye.load_state_dict(state["image"])
        text.load_state_dict(state["text"])
        eyes.append(eye)
        texts.append(text)
    image_model(eyes, folder / "vision_model.onnx")
    text_model(texts, folder / "text_model.onnx")
    (folder / "tokenizer.json").write_text(tokenizer_json() + "\n")
    width = EMBEDDING * len(weights)
    preprocessor = {
        "image_processor_type": "CLIPImageProcessor",
        "do_resize": True,
        "size": {"height": SIZE, "width": SIZE},
        "do_center_crop": False,
        "do_rescale": True,
        "rescale_factor": 1 / 255,
        "do_normalize": True,
        "image_mean": [0.5, 0.5, 0.5],
        "image_std": [0.5, 0.5, 0.5],
        "resample": 3,
    }
    config = {
        "model_type": "boxmorph-mini",
        "projection_dim": width,
        "text_config": {"max_position_embeddings": LENGTH},
        "vision_config": {"image_size": SIZE, "num_channels": 3},
        "boxmorph": {
            "classes": [p for prompts in class_prompts().values() for p in prompts],
            "families": class_prompts(),
            "adjectives": {f.word: list(f.adjectives) for f in FAMILIES.values()},
            "networks": len(weights),
        },
    }
    for name, data in (("preprocessor_config.json", preprocessor), ("config.json", config)):
        (folder / name).write_text(json.dumps(data, indent=2) + "\n")
