# SPDX-License-Identifier: GPL-3.0-or-later
"""`evaluate`: judge all outcomes of a file or of a folder of files by the measures of the paper's Table 1."""

import os
import sys

import bpy

from ..core import engine, images
from ..errors import Refusal
from ..outcomes import evaluation_sheet, evaluations, wordings
from ..preferences import RENDERERS
from .command_checks import DONE, FAILED, opened_file, require_writable


def add_to(commands):
    """Add the sub-command to the parser."""
    command = commands.add_parser(
        "evaluate",
        help="judge all outcomes of a file or a folder: likeness, curvature change, crossing faces",
        description="Judge every outcome by the measures of the paper's Table 1, before and after: likeness "
        "of the front-right view, change of Gaussian curvature, share of self-intersecting triangles. No "
        "file is changed.",
    )
    command.add_argument(
        "path",
        nargs="?",
        metavar="FILE_OR_FOLDER",
        help="a .blend file, or a folder of them (default: the file that is open)",
    )
    command.add_argument("--object", metavar="NAME", help="the outcomes of this object alone")
    command.add_argument(
        "--prompt", help="hold all against this prompt (default: each against its own, as it was searched)"
    )
    command.add_argument("--json", metavar="FILE.json", help="write all numbers, and averages by prompt")
    command.add_argument("--csv", metavar="FILE.csv", help="write a table, a line for each outcome")
    command.add_argument(
        "--sheet", metavar="FILE.png", help="write each outcome before and after, with its numbers"
    )
    command.add_argument(
        "--renderer", choices=[item[0] for item in RENDERERS], help="default: as in the preferences"
    )
    command.set_defaults(run=_evaluate)


def _evaluate(options):
    files = [opened_file()] if options.path is None else _files(options.path)
    guide = engine.open_guide()
    if options.prompt is not None:
        wording = wordings.wording(options.prompt)
        options.prompt = wording.prompt
        for word in wordings.checked(guide, wording):
            print(f"boxmorph: The guide does not know “{word}” and goes by the other words.", file=sys.stderr)
    for path in (options.json, options.csv, options.sheet):
        if path is not None:
            require_writable(path)
    found, failed = [], False
    for file in files:
        try:
            if options.path is not None:
                _open(file)
            found += _of_open_file(os.path.basename(file), options)
        except Refusal as refusal:
            print(f"boxmorph: {refusal}.", file=sys.stderr)
            failed = True
    if not found:
        raise Refusal("There is no outcome to evaluate" + (f" of “{options.object}”" * bool(options.object)))
    means = evaluations.average(found)
    if means["outcomes"] > 1:
        print(f"boxmorph: average of {means['outcomes']} outcomes: {_numbers(means)}", flush=True)
    if options.csv is not None:
        evaluations.write_csv(found, options.csv)
    if options.json is not None:
        evaluations.write_json(found, options.json)
    if options.sheet is not None:
        images.save_png(evaluation_sheet.sheet(found), os.path.abspath(options.sheet))
    return FAILED if failed or means["outcomes"] < len(found) else DONE


def _files(path):
    """Return the .blend files that a path names, as absolute paths. Raises Refusal where there is none."""
    path = os.path.abspath(path)
    if os.path.isfile(path):
        return [path]
    if not os.path.isdir(path):
        raise Refusal(f"There is no file or folder {path}")
    names = sorted(name for name in os.listdir(path) if name.lower().endswith(".blend"))
    if not names:
        raise Refusal(f"The folder {path} holds no .blend files")
    return [os.path.join(path, name) for name in names]


def _open(file):
    """Open a file without running its scripts. Raises Refusal where Blender cannot read it."""
    try:
        done = bpy.ops.wm.open_mainfile(filepath=file, load_ui=False, use_scripts=False)
    except RuntimeError as error:
        raise Refusal(f"Blender could not open {file} ({engine.sentence(error)})") from error
    if done != {"FINISHED"}:
        raise Refusal(f"Blender could not open {file}")


def _of_open_file(file, options):
    """Evaluate the outcomes of the open file, a printed line for each; return the list of Evaluated."""
    objects = [obj for obj in bpy.data.objects if options.object in (None, obj.name)]
    found = evaluations.evaluate_all(
        objects, bpy.context, file, options.renderer, options.prompt, pictures=options.sheet is not None
    )
    kept = []
    for evaluated in found:
        kept.append(evaluated)
        name = f"{file}: {evaluated.object}, “{evaluated.outcome}”"
        if evaluated.refusal is None:
            print(f"boxmorph: {name}: {_numbers(evaluated.evaluation)}", flush=True)
        else:
            print(f"boxmorph: {name} cannot be evaluated: {evaluated.refusal}.", file=sys.stderr)
    return kept


def _numbers(measured):
    """Return the measures of the paper's table in one line."""
    m = measured
    if m["self_intersections_after"] is None:
        crossing = "crossing faces not counted"
    else:
        before, after = m["self_intersections_before"], m["self_intersections_after"]
        crossing = f"crossing faces {before:.2%} → {after:.2%}"
    return (
        f"score {m['score_before']:.3f} → {m['score_after']:.3f}, "
        f"front right {m['front_right_before']:.3f} → {m['front_right_after']:.3f}, "
        f"curvature {m['curvature_change']:.3f}, {crossing}"
    )
