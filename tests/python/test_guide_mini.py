# SPDX-License-Identifier: MIT OR Apache-2.0
"""The embedded guide: the words it takes, what it calls plain furniture, and the slope it gives a search."""

import pathlib

import boxmorph
import numpy as np
import pytest
from conftest import cuboid, joined

MINI = pathlib.Path(__file__).resolve().parents[2] / "guides" / "mini"
BACKGROUNDS = ((0, 0, 0), (255, 255, 255), (255, 128, 0))


def embedding(guide, vertices, triangles):
    """Mean embedding over the four views and the three backgrounds."""
    image = boxmorph.render(vertices, triangles, size=guide.image_size, views="paper", renderer="cpu")
    alpha = image[..., 3:].astype(np.float32) / 255
    grounds = [image[..., :3] * alpha + np.array(c, np.float32) * (1 - alpha) for c in BACKGROUNDS]
    return guide.image_embeddings(np.concatenate(grounds).round().astype(np.uint8)).mean(0)


def score(guide, mesh, prompt):
    return float(embedding(guide, *mesh) @ guide.text_embedding(prompt))


def best(guide, mesh, prompts):
    """The prompts, best first, for a mesh."""
    seen = embedding(guide, *mesh)
    return sorted(prompts, key=lambda p: -float(seen @ guide.text_embedding(p)))


def classes(*unwanted):
    import json

    families = json.loads((MINI / "config.json").read_text())["boxmorph"]["families"]
    return [p for family, prompts in families.items() for p in prompts if family not in unwanted]


def on_legs(width, depth, height, thickness, leg, back=0.0, spread=1.0):
    """A slab on four legs, with a back when `back` is above 0; `spread` moves the legs outwards."""
    x, y = width / 2, depth / 2
    parts = [cuboid((-x, -y, height - thickness), (x, y, height))]
    for sx in (-1, 1):
        for sy in (-1, 1):
            at = np.array([sx * (x - leg) * spread, sy * (y - leg) * spread, 0])
            parts.append(cuboid(at - (leg, leg, 0), at + np.array([leg, leg, height - thickness])))
    if back:
        parts.append(cuboid((-x, y - 0.05, height - thickness), (x, y, height + back)))
    return joined(parts)


def test_files_are_small():
    assert sum(f.stat().st_size for f in MINI.iterdir()) <= 8_000_000


@pytest.mark.parametrize(
    "one, other",
    [
        ("a bar stool", "Bar Stools!"),
        ("a bar stool", "a photo of the bar stool"),
        ("an airship", "airships"),
        ("a sofa", "sofa"),
    ],
)
def test_articles_fillers_case_and_plurals_change_nothing(guide, one, other):
    assert np.allclose(guide.text_embedding(one), guide.text_embedding(other), atol=1e-5)


@pytest.mark.parametrize(
    "one, other",
    [
        ("a couch", "a sofa"),
        ("a zeppelin", "an airship"),
        ("an airplane", "an aeroplane"),
        ("a plane", "an aeroplane"),
        ("an automobile", "a car"),
        ("an estate car", "a station wagon"),
        ("a bedside lamp", "a table lamp"),
        ("a bedside table", "a nightstand"),
    ],
)
def test_synonyms_are_closer_than_any_other_class(guide, one, other):
    said, meant = guide.text_embedding(one), guide.text_embedding(other)
    others = [float(said @ guide.text_embedding(c)) for c in classes() if c != other]
    assert float(said @ meant) > max(others)


def test_every_class_is_of_known_words(guide):
    assert len(classes()) >= 150
    assert [c for c in classes() if guide.unknown_words(c)] == []


def test_word_order_changes_nothing(guide):
    one, other = (
        guide.text_embedding(t) for t in ("a tall narrow coffee table", "coffee table, narrow and tall")
    )
    assert np.allclose(one, other, atol=1e-5)


@pytest.mark.parametrize(
    "adjective, scale", [("taller", (1, 1, 1.5)), ("wider", (1.5, 1, 1)), ("narrower", (0.65, 1, 1))]
)
@pytest.mark.parametrize("noun", ["chair", "kitchen chair"])
def test_an_adjective_prefers_the_shape_that_has_it(guide, adjective, noun, scale):
    vertices, triangles = on_legs(0.46, 0.46, 0.46, 0.05, 0.02, back=0.5)
    stretched = (vertices * np.float32(scale)).astype(np.float32), triangles

    def gain(prompt):
        return score(guide, stretched, prompt) - score(guide, (vertices, triangles), prompt)

    assert gain(f"a {adjective} {noun}") > gain(f"a {noun}")


def test_two_adjectives_ask_for_both(guide):
    plain = on_legs(1.1, 0.65, 0.38, 0.05, 0.03)
    tall_narrow = on_legs(1.1, 0.4, 0.5, 0.05, 0.03)
    prompt = "a tall narrow coffee table"
    gain = score(guide, tall_narrow, prompt) - score(guide, plain, prompt)
    assert gain > score(guide, tall_narrow, "a coffee table") - score(guide, plain, "a coffee table")


def test_unknown_words_are_named(guide):
    assert guide.unknown_words("a flurgled bar stool") == ["flurgled"]


@pytest.mark.parametrize(
    "prompt, mesh",
    [
        ("a chair", on_legs(0.46, 0.46, 0.46, 0.05, 0.02, back=0.5)),
        ("a bar stool", on_legs(0.36, 0.36, 0.75, 0.05, 0.02, back=0.1)),
        ("a coffee table", on_legs(1.1, 0.65, 0.3, 0.05, 0.03)),
        ("a dining table", on_legs(1.7, 0.9, 0.75, 0.04, 0.035)),
        ("a console table", on_legs(1.2, 0.32, 0.75, 0.04, 0.02)),
    ],
)
def test_plain_furniture_is_named(guide, prompt, mesh):
    assert prompt in best(guide, mesh, classes())[:2]


def test_longer_legs_climb_towards_a_bar_stool(guide):
    """The score rises from chair to bar stool, and no step undoes a tenth of the way."""
    steps = [
        on_legs(0.46 - 0.1 * t, 0.46 - 0.1 * t, 0.46 + 0.32 * t, 0.05, 0.02, back=0.45 - 0.38 * t)
        for t in np.linspace(0, 1, 9)
    ]
    scores = np.array([score(guide, mesh, "a bar stool") for mesh in steps])
    rise = scores[-1] - scores[0]
    assert rise > 0.2
    assert np.diff(scores).min() > -0.1 * rise


def test_a_broken_chair_scores_lower(guide):
    whole = on_legs(0.46, 0.46, 0.46, 0.05, 0.02, back=0.5)
    apart = on_legs(0.46, 0.46, 0.46, 0.05, 0.02, back=0.5, spread=2.5)
    assert score(guide, apart, "a chair") < score(guide, whole, "a chair") - 0.1
