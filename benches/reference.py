# SPDX-License-Identifier: MIT OR Apache-2.0
"""The reference meshes, which lie beside the project and are no part of it, and the prompts tried on them."""

import json
import pathlib

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parents[1] / ".." / "shared" / "reference"
PROMPTS = {
    "airplane": [
        "a fighter jet",
        "a glider plane",
        "an airship",
        "a propeller plane",
        "a jumbo jet",
        "a space shuttle",
    ],
    "chair": ["a bar stool", "a throne", "a sofa", "a bench", "an office chair", "a lounge chair"],
    "table": [
        "a coffee table",
        "a desk",
        "a console table",
        "a bar table",
        "a nightstand",
        "a kitchen island",
    ],
}


def shapes():
    """Each shape's category, vertices (n, 3) float32, z up, and triangles (m, 3) int32."""
    if not (FOLDER / "index.json").is_file():
        raise SystemExit("The reference meshes (../shared/reference) are not beside the project.")
    for shape in json.loads((FOLDER / "index.json").read_text())["shapes"]:
        if not (FOLDER / str(shape.get("npz"))).is_file():
            continue
        data = np.load(FOLDER / shape["npz"])
        x, y, z = data["vertices"].T
        vertices = np.ascontiguousarray(np.stack([x, -z, y], 1), np.float32)
        yield shape["category"], vertices, data["faces"].astype(np.int32)
