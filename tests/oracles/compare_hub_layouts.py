# SPDX-License-Identifier: MIT OR Apache-2.0
"""Holds guides of the hub's layouts against `transformers`, PyTorch and ONNX Runtime called from Python.

Usage: python compare_hub_layouts.py WORK_FOLDER [--layers 2]

Run by hand: torch and transformers are too much for the gate. Prints one line a layout; the numbers must stay
below 1e-5 against ONNX Runtime and 1e-3 against PyTorch, in every number of a unit embedding.
Needs boxmorph's wheel besides what `hub_models.py` needs.
"""

import argparse
import pathlib
import shutil

import boxmorph
import hub_models
import hub_tokenizers
import numpy as np
import onnxruntime
import torch

PROMPTS = ["a bar stool", "An Armchair, with 4 legs!", "une chaise élégante", "a chair " * 50]


def unit(rows):
    rows = np.asarray(rows, np.float64)
    return rows / np.linalg.norm(rows, axis=-1, keepdims=True)


def ids_of(tokenizer, kind, text):
    length = {"clip": 77}.get(kind, 64)
    padding = False if kind == "clip" else "max_length"
    return tokenizer(text, padding=padding, truncation=True, max_length=length)["input_ids"]


def compare_tokens(folder, tokenizer, kind):
    guide = boxmorph.Guide.open(folder)
    wrong = []
    for text in hub_tokenizers.strings():
        ours, theirs = guide.token_ids(text), ids_of(tokenizer, kind, text)
        if ours != theirs:
            wrong.append((text, ours, theirs))
    print(f"{kind}: {len(wrong)} of 1000 texts are cut differently", flush=True)
    for text, ours, theirs in wrong[:8]:
        print("   ", repr(text[:60]), ours[:12], theirs[:12])


def pixels(images, kind):
    settings = hub_models.CLIP_IMAGES if kind == "clip" else hub_models.SIGLIP_IMAGES
    scaled = (images.astype(np.float64) / 255 - settings["image_mean"]) / settings["image_std"]
    return np.ascontiguousarray(scaled.transpose(0, 3, 1, 2)).astype(np.float32)


def by_torch(whole, tokenizer, kind, images):
    def pick(found):
        return found if torch.is_tensor(found) else found.pooler_output

    with torch.no_grad():
        vision = pick(whole.get_image_features(pixel_values=torch.from_numpy(pixels(images, kind))))
        text = [
            pick(whole.get_text_features(input_ids=torch.tensor([ids_of(tokenizer, kind, prompt)])))[0]
            for prompt in PROMPTS
        ]
    return unit(vision.numpy()), unit(torch.stack(text).numpy())


def by_onnxruntime(folder, tokenizer, kind, images):
    """Every network run as it is, on its own types, in the guide's own batches of twelve."""
    files = {path.stem: path for path in (folder / "onnx").glob("*.onnx")}
    found = []
    for role in ("vision", "text"):
        path = next(p for stem, p in files.items() if role in stem or stem.startswith("model"))
        # The level of Boxmorph's sessions; the one above rounds 16-bit networks elsewhere.
        options = onnxruntime.SessionOptions()
        options.graph_optimization_level = onnxruntime.GraphOptimizationLevel.ORT_ENABLE_EXTENDED
        session = onnxruntime.InferenceSession(path, options)
        outputs = [output.name for output in session.get_outputs()]
        own = {"vision": "image_embeds", "text": "text_embeds"}[role]
        output = own if own in outputs else "pooler_output"
        rows = []
        for number in range(len(images) if role == "vision" else len(PROMPTS)):
            ids = np.array([ids_of(tokenizer, kind, PROMPTS[number % len(PROMPTS)])])
            known = {"input_ids": ids, "attention_mask": np.ones_like(ids)}
            known["pixel_values"] = pixels(images[[number % len(images)]], kind)
            feeds = {}
            for value in session.get_inputs():
                dtype = {"tensor(float16)": np.float16}.get(value.type)
                fed = known[value.name]
                feeds[value.name] = fed.astype(dtype) if dtype else fed
            rows.append(session.run([output], feeds)[0][0])
        found.append(unit(np.array(rows)))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--layers", type=int, default=2)
    arguments = parser.parse_args()
    images = np.random.default_rng(0).integers(0, 256, (3, 224, 224, 3), np.uint8)
    for kind in ("clip", "siglip", "siglip2"):
        source = arguments.folder / kind
        shutil.rmtree(source, ignore_errors=True)
        whole, tokenizer = hub_models.write(source / "separate", kind, arguments.layers)
        compare_tokens(source / "separate", tokenizer, kind)
        hub_models.combined(source / "separate", source / "combined", whole, kind)
        hub_models.half(source / "separate", source / "fp16", inputs_too=True)
        hub_models.half(source / "separate", source / "fp16_inside", inputs_too=False)
        hub_models.eight_bits(source / "separate", source / "int8")
        torch_vision, torch_text = by_torch(whole, tokenizer, kind, images)
        for layout in ("separate", "combined", "fp16", "fp16_inside", "int8"):
            folder = source / layout
            guide = boxmorph.Guide.open(folder)
            vision = np.concatenate([guide.image_embeddings(image[None]) for image in images])
            text = np.array([guide.text_embedding(prompt) for prompt in PROMPTS])
            ort_vision, ort_text = by_onnxruntime(folder, tokenizer, kind, images)
            print(f"{kind:8} {layout:12} {guide.precision}", end="  ")
            for name, images_by, text_by in (
                ("ONNX Runtime", ort_vision, ort_text),
                ("PyTorch", torch_vision, torch_text),
            ):
                apart = abs(vision - images_by).max(), abs(text - text_by).max()
                print(f"{name}: images {apart[0]:.1e} texts {apart[1]:.1e}", end="  ")
            print(flush=True)


if __name__ == "__main__":
    main()
