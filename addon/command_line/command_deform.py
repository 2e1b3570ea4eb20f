# SPDX-License-Identifier: GPL-3.0-or-later
"""`deform`: search on one object, save the file with the new shape key, write report and pictures."""

import argparse
import json
import os
import re
import sys

import bpy

from ..core import engine, guides, images
from ..errors import Refusal
from ..operators.properties import KEEP_SIZE, PRESETS, SPLITS, SYMMETRY, TEMPLATES
from ..outcomes import evaluation, keyframes, take_apart, wordings
from ..part_boxes import parts
from ..preferences import RENDERERS
from ..searching.progress import progress_text
from ..searching.search import Search
from .command_checks import DONE, FAILED, named_collection, named_object, opened_file, require_writable

#: Slider values of the `--spectrum` picture.
_STRIP = (-1.0, -0.5, 0.0, 0.5, 1.0, 1.5)


def add_to(commands):
    """Add the sub-command to the parser."""
    deform = commands.add_parser(
        "deform",
        help="deform one object to a prompt and save the file with its new shape key",
        description="Deform one object of FILE.blend to a prompt and save the file with its new shape key.",
    )
    deform.add_argument(
        "--prompt",
        required=True,
        help="what the object should become; something between several: “a bar stool:1, a throne:0.3”",
    )
    deform.add_argument(
        "--negative",
        default="",
        metavar="PROMPT",
        help="what it should not look like; counts half as much as the prompt, or as in “a bench:0.8”",
    )
    deform.add_argument(
        "--from",
        dest="source",
        default="",
        metavar="PROMPT",
        help="what it is now: only the way from there to the prompt counts",
    )
    deform.add_argument(
        "--templates",
        choices=[item[0] for item in TEMPLATES],
        default="auto",
        help="whether texts are read as captions of pictures (default: for guides that know any words)",
    )
    deform.add_argument("--object", metavar="NAME", help="the object to deform (default: the active one)")
    deform.add_argument(
        "--guide",
        metavar="GUIDE",
        help="who judges: “embedded”, a guide of the guides folder, or a folder (default: as in the "
        "preferences; see guides)",
    )
    pace = deform.add_mutually_exclusive_group()
    presets = [item[0] for item in PRESETS if item[0] != "time"]
    pace.add_argument("--preset", choices=presets, default="standard")
    pace.add_argument(
        "--seconds", type=_seconds, help="find the best that can be found in so many seconds, 1 to 3600"
    )
    deform.add_argument(
        "--seed", type=_seed, default=0, help="another seed gives another result (default: 0)"
    )
    deform.add_argument("--splits", choices=[item[0] for item in SPLITS], default="auto")
    deform.add_argument("--symmetry", choices=[item[0] for item in SYMMETRY], default="auto")
    deform.add_argument(
        "--lock",
        action="append",
        default=[],
        metavar="PART[:AXES]",
        help="keep the size of a part, such as “Top” or “Top:xy”; may be given more than once (see parts)",
    )
    deform.add_argument("--boxes", metavar="COLLECTION", help="take the parts from cubes in this collection")
    deform.add_argument("--keep-size", choices=[item[0] for item in KEEP_SIZE], default="auto")
    deform.add_argument(
        "--scales",
        type=_scales,
        default=(0.3, 3.1),
        metavar="LEAST:GREATEST",
        help="how far parts may be scaled (default: 0.3:3.1)",
    )
    deform.add_argument(
        "--shift-parts", action="store_true", help="let parts also slide over those they hang on"
    )
    deform.add_argument(
        "--variations",
        type=int,
        choices=range(1, 9),
        default=1,
        metavar="N",
        help="make N outcomes, 1 to 8: the best, and others that are nearly as good and look different",
    )
    deform.add_argument(
        "--renderer", choices=[item[0] for item in RENDERERS], help="default: as in the preferences"
    )
    after = deform.add_mutually_exclusive_group()
    after.add_argument(
        "--take-apart",
        action="store_true",
        help="make a shape key of each part's width, depth and height; together they equal the outcome",
    )
    after.add_argument(
        "--keyframes",
        type=_keyframes,
        metavar="FROM:TO[:VALUE:VALUE]",
        help="keyframe the spectrum over these frames, from value 0 to 1 or those given",
    )
    deform.add_argument(
        "--timing",
        choices=[item[0] for item in keyframes.TIMINGS],
        default="linear",
        help="how the keyframed value changes: evenly, eased, or so that the score rises evenly",
    )
    deform.add_argument(
        "--evaluate",
        action="store_true",
        help="judge the outcome by likeness, curvature and crossing faces; the report holds the numbers",
    )
    deform.add_argument(
        "--output", metavar="FILE.blend", help="default: FILE-<prompt>.blend beside FILE.blend"
    )
    deform.add_argument("--report", metavar="FILE.json", help="write a report of the search")
    deform.add_argument(
        "--sheet", metavar="FILE.png", help="write the four views before and, below, after, a row an outcome"
    )
    deform.add_argument(
        "--spectrum",
        metavar="FILE.png",
        help="write one view at slider values from -1 to 1.5, a row an outcome",
    )
    deform.set_defaults(run=_deform)


def _deform(options):
    with guides.chosen(options.guide):
        return _deform_and_save(options)


def _deform_and_save(options):
    source = opened_file()
    obj = named_object(options.object)
    guide = engine.open_guide()
    words = {name: getattr(options, name) for name in wordings.DEFAULTS}
    wording = wordings.wording(options.prompt, **words)
    wordings.checked(guide, wording)
    output = os.path.abspath(options.output) if options.output else _default_output(source, wording.prompt)
    for path in (output, options.report, options.sheet, options.spectrum):
        if path is not None:
            require_writable(path)

    if options.lock or options.boxes:
        parts.find(obj, bpy.context, options.splits, options.symmetry, named_collection(options.boxes))
        _lock(obj, options.lock)
    search = Search(
        bpy.context,
        obj,
        wording.prompt,
        preset=options.preset if options.seconds is None else "time",
        seconds=options.seconds or 20.0,
        seed=options.seed,
        splits=options.splits,
        symmetry=options.symmetry,
        keep_size=options.keep_size,
        least_scale=options.scales[0],
        greatest_scale=options.scales[1],
        shift_parts=options.shift_parts,
        variations=options.variations,
        **words,
        renderer=options.renderer,
    )
    for note in search.notes():
        print(f"boxmorph: {note}.", file=sys.stderr)
    try:
        search.run(_Printer())
    except KeyboardInterrupt:
        search.cancel(wait=True)
        raise Refusal("Interrupted; nothing was saved") from None
    search.keep(obj, bpy.context)
    for note in search.departures(obj) + search.shear():
        print(f"boxmorph: {note}.", file=sys.stderr)
    # The outcome is worth saving even where one of these is refused.
    refused = _evaluate(obj, search, options)
    refused += [refusal for step in (_take_apart, _keyframe) for refusal in step(obj, search.name, options)]
    for refusal in refused:
        print(f"boxmorph: {refusal}.", file=sys.stderr)

    _save(output)
    _write_pictures(search, options)
    if options.report is not None:
        report = dict(search.report, file=source, output=output)
        if options.variations > 1:
            report["variations"] = search.reports[1:]
        with open(options.report, "w", encoding="utf-8") as file:
            json.dump(report, file, indent=2, ensure_ascii=False)
            file.write("\n")
    print(f"boxmorph: {search.summary()}, saved in {output}", flush=True)
    return FAILED if refused else DONE


def _lock(obj, wanted):
    """Lock parts of `obj` by name: “Top” wholly, “Top:xz” on these axes."""
    items = obj.boxmorph.items
    for text in wanted:
        name, _, axes = text.partition(":")
        part = next((part for part in items if part.name.lower() == name.strip().lower()), None)
        if part is None:
            known = ", ".join(f"“{part.name}”" for part in items)
            raise Refusal(f"“{obj.name}” has no part named “{name}”. Its parts are {known}")
        if not set(axes.lower()) <= set("xyz"):
            raise Refusal(f"“{axes}” names no axes. Write x, y or z, or several, such as xy")
        part.lock = [axis in (axes.lower() or "xyz") for axis in "xyz"]


def _evaluate(obj, search, options):
    """Evaluate the outcome if that is asked for, into its record and the report; return what was refused."""
    if not options.evaluate:
        return []
    key = obj.data.shape_keys.key_blocks[search.name]
    try:
        evaluated = evaluation.evaluate(obj, bpy.context, key, options.renderer)
    except Refusal as refusal:
        return [refusal]
    evaluation.keep(obj, key, evaluated)
    search.report[evaluation.FIELD] = evaluated
    for line in evaluation.lines(evaluated):
        print(f"boxmorph: {line}.")
    return []


def _take_apart(obj, name, options):
    """Take the outcome apart if that is asked for; return what was refused."""
    if not options.take_apart:
        return []
    try:
        for piece in take_apart.take_apart(obj, bpy.context, name):
            print(f"boxmorph: made the shape key “{piece}”.")
    except Refusal as refusal:
        return [refusal]
    return []


def _keyframe(obj, name, options):
    """Keyframe the outcome if that is asked for; return what was refused."""
    if options.keyframes is None:
        return []
    key = obj.data.shape_keys.key_blocks[name]
    choices = {"timing": options.timing, "renderer": options.renderer}
    try:
        keyframes.keyframe_spectrum(obj, bpy.context, key, *options.keyframes, **choices)
    except Refusal as refusal:
        return [refusal]
    return []


def _default_output(source, prompt):
    slug = re.sub(r"\W+", "-", prompt.lower()).strip("-")[:60]
    return f"{os.path.splitext(source)[0]}-{slug}.blend"


def _save(output):
    try:
        bpy.ops.wm.save_as_mainfile(filepath=output, copy=True, check_existing=False)
    except RuntimeError as error:
        raise Refusal(f"Blender could not save {output} ({engine.sentence(error)})") from error


def _write_pictures(search, options):
    if options.sheet is None and options.spectrum is None:
        return
    boxmorph = engine.library()
    rest, triangles = search.arrays.vertices, search.arrays.triangles
    outcomes = [result.vertices for result in search.results]
    if options.sheet is not None:
        rows = [images.render_row(boxmorph, shape, triangles) for shape in (rest, *outcomes)]
        images.save_png(images.stack(rows), os.path.abspath(options.sheet))
    if options.spectrum is not None:
        strips = [images.spectrum_strip(boxmorph, rest, after, triangles, _STRIP) for after in outcomes]
        images.save_png(images.stack(strips), os.path.abspath(options.spectrum))


class _Printer:
    """Prints progress, a line whenever the phase changes or another tenth is done."""

    def __init__(self):
        self._last = None

    def __call__(self, progress):
        step = (progress["phase"], int(progress["fraction"] * 10))
        if step != self._last:
            self._last = step
            print(f"boxmorph: {progress['fraction']:4.0%}  {progress_text(progress)}", flush=True)


def _seed(text):
    value = int(text)
    if value < 0:
        raise argparse.ArgumentTypeError("a seed is 0 or more")
    return value


def _seconds(text):
    value = float(text)
    if not 1.0 <= value <= 3600.0:
        raise argparse.ArgumentTypeError("a search takes 1 to 3600 seconds")
    return value


def _scales(text):
    """Parse LEAST:GREATEST."""
    try:
        least, greatest = (float(field) for field in text.split(":"))
    except ValueError:
        raise argparse.ArgumentTypeError(f"“{text}” is not LEAST:GREATEST, such as 0.5:2") from None
    return least, greatest


def _keyframes(text):
    """Parse FROM:TO or FROM:TO:VALUE:VALUE."""
    fields = text.split(":")
    try:
        if len(fields) not in (2, 4):
            raise ValueError
        frames = [int(field) for field in fields[:2]]
        values = [float(field) for field in fields[2:]]
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"“{text}” is not FROM:TO, such as 1:60, or FROM:TO:VALUE:VALUE"
        ) from None
    if frames[0] == frames[1]:
        raise argparse.ArgumentTypeError("the two frames are one and the same")
    return (*frames, *values)
