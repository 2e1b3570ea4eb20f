# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the embedded guide learns from: truth is measured, and no name means two things."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "training"))

from draw import draw
from families import FAMILIES, NAMES
from generate import make
from grading import quantities
from kinds.adjectives import forms
from shapes.attributes import attributes
from shapes.shape import scale_parts
from text import bag, class_prompts, phrases
from truth import truth

DRAWS = 8


def drawn(family, kind, number):
    rng = np.random.default_rng((99, number))
    return family.build(*draw(family, rng, kind), rng), rng


def test_there_are_families_and_names_enough():
    assert len(FAMILIES) >= 16
    assert all(len(family.kinds) >= 8 for family in FAMILIES.values())
    assert sum(len(family.kinds) for family in FAMILIES.values()) >= 150


def test_no_phrase_names_two_things():
    meant = {}
    for name in NAMES:
        for phrase in phrases(name):
            assert meant.setdefault(bag(phrase), name) == name, phrase


def test_the_embedded_guide_knows_every_word(guide):
    for name in NAMES:
        assert [p for p in phrases(name) if guide.unknown_words(p)] == []
    adjectives = {a for family in FAMILIES.values() for a in family.adjectives}
    assert [f for a in adjectives for f in forms(a) if guide.unknown_words(f)] == []


def test_the_embedded_guide_was_taught_these_kinds(guide):
    assert guide.classes == [prompt for prompts in class_prompts().values() for prompt in prompts]


@pytest.mark.parametrize("module", FAMILIES)
def test_a_shape_drawn_as_a_kind_measures_as_that_kind(module):
    family = FAMILIES[module]
    names = [(module, kind) for kind in family.kinds]
    own, nearest = [], []
    for i, kind in enumerate(family.kinds):
        for number in range(DRAWS):
            shape, _ = drawn(family, kind, number)
            gaps, _ = truth(shape, FAMILIES, names)
            own.append(gaps[i])
            nearest.append(gaps[i] <= gaps.min() + 0.3)
    assert np.mean(np.exp(-np.array(own))) > 0.8
    assert np.mean(nearest) > 0.85


@pytest.mark.parametrize("module", FAMILIES)
def test_scaling_parts_at_random_costs_truth(module):
    family = FAMILIES[module]
    names = [(module, kind) for kind in family.kinds]
    before, after = [], []
    for kind in family.kinds:
        for number in range(DRAWS):
            shape, rng = drawn(family, kind, number)
            before.append(np.exp(-truth(shape, FAMILIES, names)[0].min()))
            scale_parts(shape, rng, 1.0)
            after.append(np.exp(-truth(shape, FAMILIES, names)[0].min()))
    assert np.mean(after) < 0.6 * np.mean(before)


@pytest.mark.parametrize("module", FAMILIES)
def test_every_adjective_grades_something_that_varies(module):
    family = FAMILIES[module]
    rows = []
    for kind in family.kinds:
        for number in range(DRAWS):
            shape, _ = drawn(family, kind, number)
            rows.append(quantities(shape, family.measure(shape)[0])[: len(family.quantities)])
    assert np.isfinite(rows).all()
    assert (np.std(rows, 0) > 0.01).all(), family.quantities


def test_a_stretched_shape_is_measured_as_taller_and_wider():
    shape, _ = drawn(FAMILIES["seats"], "chair", 1)
    plain = attributes(shape)
    for part in shape.parts:
        part.vertices = part.vertices * (1, 1, 2)
    assert attributes(shape)["tall"] == pytest.approx(plain["tall"] + np.log(2))
    for part in shape.parts:
        part.vertices = part.vertices * (3, 1, 1)
    assert attributes(shape)["wide"] == pytest.approx(plain["wide"] - np.log(2) / 2 + np.log(3))


def test_the_same_seed_draws_the_same_shapes():
    one, other = (make(np.random.default_rng(5)) for _ in range(2))
    assert one[0] == other[0]
    assert np.array_equal(one[1].mesh()[0], other[1].mesh()[0])
