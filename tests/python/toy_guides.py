# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides of a few kilobytes in the layouts that exports on the hub have.

Their networks do what little is needed to tell right feeds from wrong ones: a convolution over patches;
a table of tokens, averaged over those that the mask admits, or over all where there is no mask.
"""

import json

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

WORDS = ["[PAD]", "[UNK]", "a", "an", "bar", "stool", "chair", "table", "lamp", "jet"]
SIZE, PATCH, CHANNELS, WIDTH, DIMENSION = 32, 8, 8, 12, 16
MEAN, STD = [0.48, 0.46, 0.41], [0.27, 0.26, 0.28]
FLOATS = {TensorProto.FLOAT: np.float32, TensorProto.FLOAT16: np.float16}
WHOLES = {TensorProto.INT64: np.int64, TensorProto.INT32: np.int32}


class Toy:
    """What a toy guide is made of; see the defaults."""

    combined = False
    place = ""
    ending = ""
    floats = TensorProto.FLOAT
    ids = TensorProto.INT64
    mask = True
    positions = False
    tokens = None  # a fixed length of texts
    batch = "batch"
    external = False
    image_output, text_output = "image_embeds", "text_embeds"
    hidden = False  # the last hidden state as a first output
    model_type = "clip"
    size = SIZE
    dimension = text_dimension = DIMENSION
    words = len(WORDS)  # rows of the table
    names = ("vision_model", "text_model")
    seed = 0

    def __init__(self, **changes):
        for name, value in changes.items():
            assert hasattr(self, name), name
            setattr(self, name, value)

    def write(self, folder):
        """Writes all files; returns the folder."""
        (folder / self.place).mkdir(parents=True, exist_ok=True)
        parts = {"vision_model": self.vision(), "text_model": self.text()}
        if self.combined:
            self.save(folder, "model", list(parts.values()))
        else:
            for name, part in zip(self.names, parts.values(), strict=True):
                self.save(folder, name, [part])
        vocabulary = {word: number for number, word in enumerate(WORDS)}
        tokenizer = {"version": "1.0", "truncation": None, "padding": None, "added_tokens": []}
        tokenizer |= {"normalizer": {"type": "Lowercase"}, "pre_tokenizer": {"type": "Whitespace"}}
        tokenizer |= {"post_processor": None, "decoder": None}
        tokenizer["model"] = {"type": "WordLevel", "vocab": vocabulary, "unk_token": "[UNK]"}
        images = {"size": {"shortest_edge": self.size}, "image_mean": MEAN, "image_std": STD}
        config = {"model_type": self.model_type, "text_config": {"max_position_embeddings": 20}}
        for name, content in {
            "tokenizer": tokenizer,
            "preprocessor_config": images,
            "config": config,
            "tokenizer_config": {"pad_token": "[PAD]"},
        }.items():
            (folder / f"{name}.json").write_text(json.dumps(content))
        return folder

    def weight(self, name, *shape):
        values = np.random.default_rng([self.seed, len(name), *shape]).normal(size=shape)
        return numpy_helper.from_array(values.astype(FLOATS[self.floats]), name)

    def vision(self):
        """Nodes, weights, inputs and outputs of the image network."""
        nodes = [
            helper.make_node("Conv", ["pixel_values", "patch"], ["patches"], strides=[PATCH, PATCH]),
            helper.make_node("Relu", ["patches"], ["lit"]),
            helper.make_node("GlobalAveragePool", ["lit"], ["pooled"]),
            helper.make_node("Flatten", ["pooled"], ["flat"]),
            helper.make_node("MatMul", ["flat", "image_projection"], [self.image_output]),
        ]
        weights = [
            self.weight("patch", CHANNELS, 3, PATCH, PATCH),
            self.weight("image_projection", CHANNELS, self.dimension),
        ]
        image = [self.batch, 3, self.size, self.size]
        inputs = [helper.make_tensor_value_info("pixel_values", self.floats, image)]
        outputs = [
            helper.make_tensor_value_info(self.image_output, self.floats, [self.batch, self.dimension])
        ]
        if self.hidden:
            last = helper.make_tensor_value_info("lit", self.floats, [self.batch, CHANNELS, None, None])
            outputs.insert(0, last)
        return nodes, weights, inputs, outputs

    def text(self):
        """Nodes, weights, inputs and outputs of the text network."""
        axes = [self.batch, self.tokens or "sequence"]
        inputs = [helper.make_tensor_value_info("input_ids", self.ids, axes)]
        weights = [
            self.weight("table", self.words, WIDTH),
            self.weight("text_projection", WIDTH, self.text_dimension),
            numpy_helper.from_array(np.array([1]), "one"),
            numpy_helper.from_array(np.array([2]), "two"),
        ]
        nodes = [helper.make_node("Gather", ["table", "input_ids"], ["looked_up"])]
        looked_up = "looked_up"
        if self.positions:
            inputs.append(helper.make_tensor_value_info("position_ids", self.ids, axes))
            weights.append(self.weight("places", 20, WIDTH))
            nodes.append(helper.make_node("Gather", ["places", "position_ids"], ["place"]))
            nodes.append(helper.make_node("Add", [looked_up, "place"], ["placed"]))
            looked_up = "placed"
        if self.mask:
            inputs.append(helper.make_tensor_value_info("attention_mask", self.ids, axes))
            nodes += [
                helper.make_node("Cast", ["attention_mask"], ["admitted"], to=self.floats),
                helper.make_node("Unsqueeze", ["admitted", "two"], ["column"]),
                helper.make_node("Mul", [looked_up, "column"], ["masked"]),
                helper.make_node("ReduceSum", ["masked", "one"], ["sum"], keepdims=0),
                helper.make_node("ReduceSum", ["column", "one"], ["count"], keepdims=0),
                helper.make_node("Div", ["sum", "count"], ["mean"]),
            ]
        else:
            nodes.append(helper.make_node("ReduceMean", [looked_up], ["mean"], axes=[1], keepdims=0))
        nodes.append(helper.make_node("MatMul", ["mean", "text_projection"], [self.text_output]))
        shape = [self.batch, self.text_dimension]
        return nodes, weights, inputs, [helper.make_tensor_value_info(self.text_output, self.floats, shape)]

    def save(self, folder, name, parts):
        nodes, weights, inputs, outputs = ([x for part in parts for x in part[k]] for k in range(4))
        if self.combined:
            nodes += [
                helper.make_node("Transpose", [self.text_output], ["turned"]),
                helper.make_node("MatMul", [self.image_output, "turned"], ["logits_per_image"]),
            ]
            axes = ["images", "texts"]
            outputs.insert(0, helper.make_tensor_value_info("logits_per_image", self.floats, axes))
        graph = helper.make_graph(nodes, name, inputs, outputs, weights)
        network = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8)
        path = folder / self.place / f"{name}{self.ending}.onnx"
        if self.external:
            location = f"{path.name}_data"
            onnx.save(network, path, save_as_external_data=True, location=location, size_threshold=256)
        else:
            onnx.save(network, path)


def pixels(images):
    """What the preprocessor's settings make of RGB images (k, h, w, 3): (k, 3, h, w) float32."""
    scaled = (images / 255 - MEAN) / STD
    return np.ascontiguousarray(scaled.transpose(0, 3, 1, 2)).astype(np.float32)


def unit(rows):
    rows = np.asarray(rows, np.float64)
    return rows / np.linalg.norm(rows, axis=-1, keepdims=True)


class TinyViT(Toy):
    """The image network is a vision transformer of one layer, with the operators that exports have."""

    width = 16

    def vision(self):
        width, heads, side = self.width, 2, self.size // PATCH
        count = side * side + 1
        shape = numpy_helper.from_array
        weights = [
            self.weight("patch", width, 3, PATCH, PATCH),
            self.weight("class", 1, 1, width),
            self.weight("places", 1, count, width),
            *(self.weight(name, width, width) for name in ("query", "key", "value", "out")),
            self.weight("up", width, 2 * width),
            self.weight("up_bias", 2 * width),
            self.weight("down", 2 * width, width),
            self.weight("scale", width),
            self.weight("shift", width),
            self.weight("image_projection", width, self.dimension),
            shape(np.array([0, width, -1]), "rows"),
            shape(np.array([0, 0, heads, width // heads]), "split"),
            shape(np.array([0, 0, width]), "join"),
            shape(np.array(0), "first"),
            shape(np.array([0]), "zero"),
            shape(np.array([1]), "one_axis"),
            shape(np.array([1, 1]), "ones"),
            shape(np.array(np.sqrt(width / heads), np.float32), "root"),
            shape(np.array(np.sqrt(2), np.float32), "sqrt2"),
            shape(np.array(1, np.float32), "unity"),
            shape(np.array(0.5, np.float32), "half"),
        ]
        make = helper.make_node
        nodes = [
            make("Conv", ["pixel_values", "patch"], ["patches"], strides=[PATCH, PATCH]),
            make("Reshape", ["patches", "rows"], ["columns"]),
            make("Transpose", ["columns"], ["tokens"], perm=[0, 2, 1]),
            make("Shape", ["pixel_values"], ["image_shape"]),
            make("Slice", ["image_shape", "zero", "one_axis"], ["images"]),
            make("Concat", ["images", "ones"], ["many"], axis=0),
            make("Expand", ["class", "many"], ["classes"]),
            make("Concat", ["classes", "tokens"], ["sequence"], axis=1),
            make("Add", ["sequence", "places"], ["placed"]),
            make("LayerNormalization", ["placed", "scale", "shift"], ["normal"], axis=-1),
        ]
        for name, turn in (("query", [0, 2, 1, 3]), ("key", [0, 2, 3, 1]), ("value", [0, 2, 1, 3])):
            nodes += [
                make("MatMul", ["normal", name], [f"{name}s"]),
                make("Reshape", [f"{name}s", "split"], [f"{name}_split"]),
                make("Transpose", [f"{name}_split"], [f"{name}_heads"], perm=turn),
            ]
        nodes += [
            make("MatMul", ["query_heads", "key_heads"], ["alike"]),
            make("Div", ["alike", "root"], ["scaled"]),
            make("Softmax", ["scaled"], ["attention"], axis=-1),
            make("MatMul", ["attention", "value_heads"], ["attended"]),
            make("Transpose", ["attended"], ["turned_back"], perm=[0, 2, 1, 3]),
            make("Reshape", ["turned_back", "join"], ["joined"]),
            make("MatMul", ["joined", "out"], ["projected"]),
            make("Add", ["placed", "projected"], ["residual"]),
            make("MatMul", ["residual", "up"], ["raised"]),
            make("Add", ["raised", "up_bias"], ["biased"]),
            make("Div", ["biased", "sqrt2"], ["shrunk"]),
            make("Erf", ["shrunk"], ["erf"]),
            make("Add", ["erf", "unity"], ["gate"]),
            make("Mul", ["biased", "gate"], ["gated"]),
            make("Mul", ["gated", "half"], ["gelu"]),
            make("MatMul", ["gelu", "down"], ["lowered"]),
            make("Add", ["residual", "lowered"], ["lit"]),
            make("Gather", ["lit", "first"], ["pooled"], axis=1),
            make("MatMul", ["pooled", "image_projection"], [self.image_output]),
        ]
        image = [self.batch, 3, self.size, self.size]
        inputs = [helper.make_tensor_value_info("pixel_values", self.floats, image)]
        outputs = [
            helper.make_tensor_value_info(self.image_output, self.floats, [self.batch, self.dimension])
        ]
        return nodes, weights, inputs, outputs
