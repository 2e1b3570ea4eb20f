# SPDX-License-Identifier: MIT OR Apache-2.0
"""What is asked for besides a prompt: blends, negatives, a source, templates; and the job that is asked."""

import json
import pathlib
import shutil

import boxmorph
import numpy as np
import pytest
from boxmorph import Wording

MINI = pathlib.Path(__file__).resolve().parents[2] / "guides" / "mini"


@pytest.fixture(scope="module")
def mesh(chair):
    return boxmorph.Mesh(*chair)


def score(mesh, guide, asked):
    return boxmorph.spectrum_scores(mesh, mesh.vertices, asked, guide, [0.0], "cpu")[0]


def alike(mesh, guide, *parts):
    """The score that a weighted sum of texts should have: that sum of their scores, at length 1."""
    vectors = sum(weight * guide.text_embedding(text) for text, weight in parts)
    scores = sum(weight * score(mesh, guide, Wording(text, templates="off")) for text, weight in parts)
    return scores / np.linalg.norm(vectors)


def test_a_plain_wording_is_its_prompt(mesh, guide):
    assert score(mesh, guide, Wording("a sofa")) == score(mesh, guide, "a sofa")
    assert Wording("a tall, narrow chair").parts == [("a tall, narrow chair", 1.0)]


def test_parts_are_blended_by_their_weights(mesh, guide):
    asked = Wording("a bar stool:1, a throne:0.3")
    assert asked.parts == [("a bar stool", 1.0), ("a throne", 0.3)]
    expected = alike(mesh, guide, ("a bar stool", 1.0), ("a throne", 0.3))
    assert score(mesh, guide, asked) == pytest.approx(expected, abs=1e-6)
    # Only their proportion counts.
    assert score(mesh, guide, Wording("a bar stool:10, a throne:3")) == pytest.approx(expected, abs=1e-6)
    # A prompt is read alike as a str.
    assert score(mesh, guide, asked.prompt) == score(mesh, guide, asked)


def test_negatives_count_against_the_prompt(mesh, guide):
    for negative, weight in (("a bench", 0.5), ("a bench:0.8", 0.8)):
        expected = alike(mesh, guide, ("a sofa", 1.0), ("a bench", -weight))
        found = score(mesh, guide, Wording("a sofa", negative=negative))
        assert found == pytest.approx(expected, abs=1e-6)


def test_a_source_leaves_the_way_from_it_to_the_prompt(mesh, guide):
    for prompt, source in (("a wing chair", "an armchair"), ("a sofa", "a chair")):
        shared = max(0.0, guide.text_embedding(prompt) @ guide.text_embedding(source))
        expected = alike(mesh, guide, (prompt, 1.0), (source, -shared))
        assert score(mesh, guide, Wording(prompt, source=source)) == pytest.approx(expected, abs=1e-6)
    assert score(mesh, guide, Wording("a wing chair", source="an armchair")) != score(
        mesh, guide, "a wing chair"
    )


TEMPLATES = ["{}", "a photo of {}", "a rendering of {}", "a 3d render of {}", "a grey 3d model of {}"]


@pytest.fixture(scope="module")
def general(tmp_path_factory):
    """A guide that was taught no names, and to which the words of the templates mean something."""
    folder = tmp_path_factory.mktemp("general") / "guide"
    shutil.copytree(MINI, folder)
    tokenizer = json.loads((folder / "tokenizer.json").read_text())
    vocabulary = tokenizer["model"]["vocab"]
    meanings = {"photo": "round", "rendering": "tall", "render": "low", "3d": "wide", "model": "thin"}
    vocabulary |= {word: vocabulary[meaning] for word, meaning in meanings.items()}
    (folder / "tokenizer.json").write_text(json.dumps(tokenizer))
    config = json.loads((folder / "config.json").read_text())
    del config["boxmorph"]["classes"]
    (folder / "config.json").write_text(json.dumps(config))
    return boxmorph.Guide.open(folder)


def test_templates_are_the_mean_of_several_readings(mesh, general):
    parts = [(text.format("a sofa"), 1.0) for text in TEMPLATES]
    on, off = (score(mesh, general, Wording("a sofa", templates=choice)) for choice in ("on", "off"))
    assert on == pytest.approx(alike(mesh, general, *parts), abs=1e-6) and on != off
    # A guide of general knowledge is asked so unless one says otherwise.
    assert score(mesh, general, "a sofa") == on


def test_the_published_protocol_has_no_templates(mesh, general):
    for preset, expected in (("standard", True), ("paper", False)):
        job = boxmorph.Job(mesh, "a sofa", guide=general, preset=preset, splits=1, renderer="cpu")
        job.start()
        job.join()
        assert job.result().report()["templates"] is expected


def test_the_embedded_guide_reads_bare_names_and_is_not_put_off_by_templates(mesh, guide):
    assert score(mesh, guide, "a sofa") == score(mesh, guide, Wording("a sofa", templates="off"))
    # Words of the templates are none of the user's.
    assert Wording("a sofa", templates="on").check(guide) == []
    assert -1.0 < score(mesh, guide, Wording("a sofa", templates="on")) < 1.0


def test_unknown_words_of_all_texts_are_named_once(guide):
    asked = Wording("a zzgribble sofa:1, a bed:1", negative="a zzgribble xqwv bench", source="a chair")
    assert asked.check(guide) == ["zzgribble", "xqwv"]


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        (Wording("a stool, a throne:0.3"), '"a stool" has no weight'),
        (Wording("a stool:1, a bench:-1"), "must be above 0"),
        (Wording("a stool:1, a bench:0"), "must be above 0"),
        (Wording(","), "knows no word|prompt is empty"),
        (Wording(":1"), "prompt is empty"),
        (Wording("a sofa:1,  :2"), "prompt is empty"),
        (Wording("a sofa:1," * 9), "are the most"),
        (Wording("a sofa", negative="zzgribble"), "knows no word"),
        (Wording("a sofa", source="zzgribble"), "knows no word"),
        (Wording("chair " * 200), "characters"),
        (Wording("a sofa", source="a sofa"), "means nearly the same"),
        (Wording("a sofa", negative="a sofa:1"), "means nearly the same"),
    ],
)
def test_what_cannot_be_asked_is_refused_in_a_sentence(mesh, guide, asked, words):
    with pytest.raises(ValueError, match=words):
        asked.check(guide)
    with pytest.raises(ValueError, match=words):
        boxmorph.spectrum_scores(mesh, mesh.vertices, asked, guide, [0.0])
    with pytest.raises(ValueError, match=words):
        job = boxmorph.Job(mesh, asked, guide=guide)
        job.start()
        job.join()


def test_blank_texts_are_none_and_unknown_templates_refused(mesh, guide):
    assert score(mesh, guide, Wording("a sofa", negative=" ", source="")) == score(mesh, guide, "a sofa")
    with pytest.raises(ValueError, match="unknown templates"):
        Wording("a sofa", templates="maybe")
    with pytest.raises(TypeError):
        boxmorph.Job(mesh, 3, guide=guide)


def searched(mesh, guide, asked, **options):
    job = boxmorph.Job(mesh, asked, guide=guide, splits=3, renderer="cpu", **options)
    job.start()
    job.join()
    return job.result()


@pytest.mark.parametrize(
    "asked",
    [
        Wording("a bar stool:1, a throne:0.5"),
        Wording("a sofa", negative="a bench"),
        Wording("a sofa", source="a chair", templates="on"),
    ],
    ids=["blend", "negative", "source"],
)
def test_a_job_climbs_by_what_is_asked_and_records_it(mesh, guide, asked):
    found = searched(mesh, guide, asked)
    report = found.report()
    again = Wording(
        report["prompt"], report["negative"], report["source"], "on" if report["templates"] else "off"
    )
    scores = boxmorph.spectrum_scores(mesh, found.vertices, again, guide, [0, 1], "cpu")
    assert scores == pytest.approx([found.score_before, found.score_after], abs=1e-6)
    assert found.score_after > found.score_before + 0.05
    assert report["prompt"] == asked.prompt


def test_a_prompt_alone_is_searched_as_ever(mesh, guide):
    plain = searched(mesh, guide, "a bar stool")
    assert np.array_equal(searched(mesh, guide, Wording("a bar stool")).vertices, plain.vertices)
    report = plain.report()
    assert (report["negative"], report["source"], report["templates"]) == (None, None, False)


def test_a_comparative_of_the_heaviest_part_is_measured(mesh, guide):
    found = searched(mesh, guide, "a taller chair:1, a sofa:0.2")
    extents = [np.ptp(vertices, axis=0) for vertices in (mesh.vertices, found.vertices)]
    before, after = (extent[2] / np.sqrt(extent[0] * extent[1]) for extent in extents)
    assert after > 1.1 * before
