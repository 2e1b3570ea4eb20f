# SPDX-License-Identifier: MIT OR Apache-2.0
"""Images a second: our guide beside the bare ONNX Runtime on the same network, which is the limit.

The bare one is given images that are normalised already; ours takes bytes, as all of the search does.
"""

import json
import os

import boxmorph
import numpy as np
from timing import interleaved

MINI = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "guides", "mini")


def images(count, size):
    """Noise of `size` pixels, (count, size, size, 3) uint8."""
    return np.random.default_rng(0).integers(0, 256, (count, size, size, 3), np.uint8)


def normalised(folder, pixels):
    """Bytes (k, h, w, 3) as a network takes them, (k, 3, h, w) float32."""
    with open(os.path.join(folder, "preprocessor_config.json"), encoding="utf-8") as file:
        config = json.load(file)
    scaled = (pixels / np.float32(255) - np.float32(config["image_mean"])) / np.float32(config["image_std"])
    return np.ascontiguousarray(scaled.transpose(0, 3, 1, 2), np.float32)


def bare_session(folder):
    """The vision network in ONNX Runtime from Python, on all cores; None where that is not installed."""
    try:
        import onnxruntime
    except ImportError:
        return None
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = os.cpu_count()
    paths = [os.path.join(folder, *place, "vision_model.onnx") for place in ((), ("onnx",))]
    network = next(path for path in paths if os.path.exists(path))
    return onnxruntime.InferenceSession(network, options, providers=["CPUExecutionProvider"])


def rates(folder, count, rounds, **others):
    """Images a second of batches of `count`: {"ours": …, "bare": …} and of `others`, which take the bytes.

    No folder: the embedded guide.
    """
    guide = boxmorph.Guide.open(folder)
    folder = folder or MINI
    pixels = images(count, guide.image_size)
    works = {"ours": lambda: guide.image_embeddings(pixels)}
    session = bare_session(folder)
    if session:
        ready = normalised(folder, pixels)
        works["bare"] = lambda: session.run(["image_embeds"], {"pixel_values": ready})
    works |= {name: lambda other=other: other(pixels) for name, other in others.items()}
    return {name: count / seconds for name, seconds in interleaved(rounds, works).items()}


def row(name, found):
    """A row of the table from what `rates` found."""
    bare = found.get("bare")
    beside = f"bare ONNX Runtime {rate(bare)}" if bare else "bare ONNX Runtime is not installed"
    return (name, rate(found["ours"]), beside, f"{found['ours'] / bare:.2f} ×" if bare else "")


def rate(value):
    """Images a second in words."""
    return f"{value:,.0f} images/s" if value >= 100 else f"{value:.1f} images/s"
