# SPDX-License-Identifier: GPL-3.0-or-later
"""`guides`: list the guides that can be downloaded and those that are here; download one, remove one, or copy
one in eight bits.
"""

import os

from ..core import engine, guide_downloads, guides
from ..core.guide_downloads import PRECISIONS
from ..errors import Refusal
from . import guide_copy
from .command_checks import DONE

#: What is said of a guide that is here, wholly or in part.
_STATES = {"present": "downloaded", "cached": "in the hub's cache", "partial": "{:.0%} downloaded"}


def add_to(commands):
    """Add the sub-command to the parser."""
    command = commands.add_parser(
        "guides",
        help="list the guides there are; download one, or remove it",
        description="List the guides that can be downloaded and those that are here. To download one, start "
        "Blender with --online-mode.",
    )
    action = command.add_mutually_exclusive_group()
    action.add_argument("--get", metavar="GUIDE", help="download this guide, or go on with its download")
    action.add_argument("--remove", metavar="GUIDE", help="delete this guide, or what is here of it")
    action.add_argument("--quantize", metavar="GUIDE", help="make a copy of this guide in eight bits")
    command.add_argument("--precision", choices=list(PRECISIONS), default="fp32")
    command.add_argument(
        "--endpoint", metavar="URL", help="the address of a mirror (default: as in the preferences)"
    )
    command.set_defaults(run=_guides)


def _guides(options):
    if options.get is not None:
        return _get(options)
    if options.remove is not None:
        guide_downloads.remove(options.remove, _precision(options.remove, options.precision))
        return DONE
    if options.quantize is not None:
        with guides.chosen(options.quantize):
            return guide_copy.make(engine.guide_folder())
    for entry in guide_downloads.entries():
        print(f"{entry['id']}: {entry['title']}, {entry['licence']}. {entry['good_for']}")
        for name, details in entry["precisions"].items():
            there = guide_downloads.presence(entry["id"], name)
            share = there["bytes"] / max(there["total"], 1)
            clauses = [
                _STATES.get(there["state"], "").format(share),
                "" if details["verified"] else "unverified",
            ]
            said = "".join(f", {clause}" for clause in clauses if clause)
            print(f"    {name}: about {guides.megabytes(details['bytes'])}{said}")
    for folder in guides.found():
        print(f"{os.path.basename(folder)}: in {guides.root()}, {guides.megabytes(guides.size(folder))}")
    return DONE


def _get(options):
    precision = _precision(options.get, options.precision)
    entry = guide_downloads.entry(options.get)
    print(f"boxmorph: {entry['title']} from {entry['repository']}, licence {entry['licence']}", flush=True)
    guide_downloads.start(options.get, precision, options.endpoint)
    try:
        folder = guide_downloads.wait(_Printer())
    except KeyboardInterrupt:
        guide_downloads.stop()
        raise Refusal("Interrupted; what has come is kept, and the same command goes on from there") from None
    guide = engine.open_folder(folder, precision)
    print(
        f"boxmorph: {folder} is whole; {guide.precision}, it sees images of {guide.image_size} pixels",
        flush=True,
    )
    return DONE


def _precision(guide, precision):
    known = guide_downloads.entry(guide)["precisions"]
    if precision not in known:
        raise Refusal(
            f"“{guide}” does not come in {precision}. Name one with --precision: {', '.join(known)}"
        )
    return precision


class _Printer:
    """Prints progress, a line whenever another twentieth has come, or there is trouble."""

    def __init__(self):
        self._last = None

    def __call__(self, progress):
        total = progress["total"]
        share = progress["bytes"] / total if total else 0.0
        step = (int(share * 20), progress["trouble"])
        if not total or step == self._last:
            return
        self._last = step
        here = f"{guides.megabytes(progress['bytes'])} of {guides.megabytes(total)}"
        said = progress["trouble"] or progress["file"]
        print(f"boxmorph: {share:4.0%}  {here}   {said}", flush=True)
