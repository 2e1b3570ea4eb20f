# SPDX-License-Identifier: MIT OR Apache-2.0
"""What a search may cost: presets, budgets in images and in seconds."""

import boxmorph
import numpy as np
import pytest
from toy_guides import Toy


def searched(chair, guide, prompt="a bar stool", **options):
    job = boxmorph.Job(boxmorph.Mesh(*chair), prompt, guide=guide, renderer="cpu", **options)
    job.start()
    job.join()
    return job.result()


@pytest.mark.parametrize("preset, images", [("draft", 1400), ("standard", 4400)])
def test_a_preset_keeps_to_its_budget(chair, guide, preset, images):
    result = searched(chair, guide, preset=preset)
    assert result.report()["image_budget"] == images
    # What is judged in the end, by all images, comes on top.
    assert 0.8 * images < result.images_encoded < 1.1 * images
    assert result.score_after > result.score_before


@pytest.mark.parametrize("images", [100, 500, 3000])
def test_a_budget_of_images_is_kept_to(chair, guide, images):
    result = searched(chair, guide, images=images)
    assert result.report()["image_budget"] == images
    # Each search has one generation at least, and is judged before and after it; one more if none finds any.
    assert result.images_encoded < 1.1 * images + 600


def test_more_images_find_more(chair, guide):
    prompts = ("a bar stool", "a throne", "a sofa", "a bench")
    gains = [
        sum(searched(chair, guide, prompt, images=images).score_after for prompt in prompts)
        for images in (200, 4400)
    ]
    assert gains[1] > gains[0] + 0.05


def test_what_was_found_in_some_seconds_is_found_again_by_its_record(chair, guide):
    timed = searched(chair, guide, seconds=4.0)
    report = timed.report()
    assert report["seconds_budget"] == 4.0 and timed.seconds < 12.0
    again = searched(chair, guide, images=report["image_budget"])
    if timed.seconds < 0.95 * 4.0:  # else time ran out before the budget did
        np.testing.assert_array_equal(again.vertices, timed.vertices)


def test_with_a_slow_guide_and_little_time_few_shapes_are_looked_at(chair, tmp_path):
    # Large pictures take long: not every start can be tried in the time.
    slow = boxmorph.Guide.open(Toy(size=1536).write(tmp_path), threads=1)
    result = searched(chair, slow, "a bar stool", seconds=1.0)
    assert result.images_encoded < 250
    assert result.score_after >= result.score_before


def test_the_loss_of_the_paper_is_told_in_the_record(chair, guide):
    usual, paper = (searched(chair, guide, images=500, paper_loss=loss) for loss in (False, True))
    assert not usual.report()["paper_loss"] and paper.report()["paper_loss"]
    assert not np.array_equal(usual.vertices, paper.vertices)


@pytest.mark.parametrize(
    "options, words",
    [
        ({"images": 5}, "a budget of images is from 100"),
        ({"images": -1}, "a budget of images is from 100"),
        ({"seconds": 0.0}, "a budget of seconds is from 0.5"),
        ({"seconds": float("nan")}, "a budget of seconds is from 0.5"),
        ({"seconds": 5.0, "images": 500}, "not both"),
        ({"preset": "paper", "seconds": 5.0}, "takes no budget"),
        ({"preset": "fast"}, "draft"),
    ],
)
def test_a_budget_that_cannot_be_is_refused_in_words(chair, guide, options, words):
    with pytest.raises(ValueError, match=words):
        boxmorph.Job(boxmorph.Mesh(*chair), "a sofa", guide=guide, **options)
