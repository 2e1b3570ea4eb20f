# SPDX-License-Identifier: MIT OR Apache-2.0
"""Opens guides whose networks were damaged at random, and says how each ended.

Usage: python mutated_networks.py FOLDER_OF_GUIDES WORK_FOLDER FIRST LAST SEED

Run in a process of its own, since ONNX Runtime may take it down. Prints the number of a guide when it begins
and a line of JSON when it ends: the outcome, and the memory used until then.
"""

import json
import pathlib
import random
import resource
import shutil
import sys

import boxmorph
import numpy as np
import onnx
from onnx import TensorProto

NETWORKS = ["vision_model.onnx", "text_model.onnx"]


def flipped(data, generator):
    """A few bytes changed."""
    data = bytearray(data)
    for _ in range(generator.choice([1, 2, 8, 64])):
        data[generator.randrange(len(data))] = generator.randrange(256)
    return bytes(data)


def flipped_in_structure(data, generator):
    """A few bytes changed near names and lengths: where text is."""
    data = bytearray(data)
    places = [place for place in range(len(data)) if chr(data[place]).isalpha()]
    for _ in range(generator.choice([1, 2, 4])):
        place = min(max(generator.choice(places) + generator.randrange(-3, 4), 0), len(data) - 1)
        data[place] ^= 1 << generator.randrange(8)
    return bytes(data)


def truncated(data, generator):
    return data[: generator.randrange(len(data))]


def spliced(data, generator):
    """A piece put elsewhere, or taken out."""
    start = generator.randrange(len(data))
    piece = data[start : start + generator.randrange(1, 400)]
    place = generator.randrange(len(data))
    cut = generator.choice([0, len(piece)])
    return data[:place] + piece + data[place + cut :]


def restructured(data, generator):
    """A valid file of a network that makes no sense: axes, kinds, names, settings and operators changed."""
    network = onnx.load_from_string(data)
    graph = network.graph
    for _ in range(generator.choice([1, 1, 2, 3])):
        kind = generator.randrange(9)
        node = generator.choice(graph.node)
        weight = generator.choice(graph.initializer)
        if kind == 0 and weight.dims:
            place = generator.randrange(len(weight.dims))
            weight.dims[place] = generator.choice([0, -1, 1, 3, 1 << 20, 1 << 40, (1 << 63) - 1])
        elif kind == 1:
            weight.data_type = generator.randrange(0, 24)
        elif kind == 2 and node.input:
            names = [name for other in graph.node for name in [*other.input, *other.output]]
            node.input[generator.randrange(len(node.input))] = generator.choice([*names, "", "nowhere"])
        elif kind == 3:
            node.op_type = generator.choice(graph.node).op_type
        elif kind == 4:
            for attribute in node.attribute:
                wild = [0, -1, 2, 7, 1 << 20, 1 << 40, -(1 << 63)]
                attribute.i = generator.choice(wild)
                for place in range(len(attribute.ints)):
                    attribute.ints[place] = generator.choice(wild)
        elif kind == 5:
            del graph.node[generator.randrange(len(graph.node))]
            if not graph.node:
                return data
        elif kind == 6:
            whole = [w for w in graph.initializer if w.data_type == TensorProto.INT64 and w.raw_data]
            if whole:
                weight = generator.choice(whole)
                values = np.frombuffer(weight.raw_data, np.int64).copy()
                if len(values):
                    values[generator.randrange(len(values))] = generator.choice([0, -1, -7, 1 << 20, 1 << 40])
                weight.raw_data = values.tobytes()
        elif kind == 7:
            value = generator.choice([*graph.input, *graph.output])
            value.type.tensor_type.elem_type = generator.randrange(0, 20)
        else:
            generator.choice([*graph.input, *graph.output]).name = generator.choice(["", "x", "input_ids"])
    return network.SerializeToString()


KINDS = [flipped, flipped_in_structure, truncated, spliced, restructured, restructured]


def mutate(guides, folder, number, seed):
    """Makes guide `number` in `folder`: one of `guides` with a network damaged in one way."""
    generator = random.Random(f"{seed} {number}")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(generator.choice(sorted(p for p in guides.iterdir() if p.is_dir())), folder)
    network = folder / generator.choice(NETWORKS)
    kind = KINDS[number % len(KINDS)]
    network.write_bytes(kind(network.read_bytes(), generator))
    return kind.__name__


def outcome(folder):
    """What opening and using a guide comes to, and copying it in eight bits: "used", or the sentence that
    refuses it.
    """
    try:
        boxmorph.Guide.quantize(folder, threads=1)
    except boxmorph.GuideError:
        pass
    try:
        guide = boxmorph.Guide.open(folder, threads=1, precision="fp32")
        size = guide.image_size
        guide.image_embeddings(np.zeros((13, size, size, 3), np.uint8))
        guide.text_embedding("a bar stool")
    except boxmorph.GuideError as error:
        return str(error)
    return "used"


def main():
    guides, work, first, last, seed = sys.argv[1:]
    folder = pathlib.Path(work) / "mutated"
    for number in range(int(first), int(last)):
        kind = mutate(pathlib.Path(guides), folder, number, seed)
        print(number, flush=True)
        said = outcome(folder)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        print(json.dumps({"number": number, "kind": kind, "said": said, "memory": memory}), flush=True)


if __name__ == "__main__":
    main()
