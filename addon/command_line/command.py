# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: `blender [-b] file.blend --command boxmorph deform --prompt "a bar stool"`.

Each sub-command is a module of its own, with a function of its parsed arguments that returns the exit code.
"""

import argparse
import sys

from ..errors import Refusal
from . import command_deform, command_evaluate, command_guides, command_parts
from .command_checks import FAILED


def main(arguments):
    """Run `boxmorph` with these arguments (list of str); return the exit code."""
    options = _parser().parse_args(arguments)
    try:
        return options.run(options)
    except Refusal as refusal:
        print(f"boxmorph: {refusal}.", file=sys.stderr)
        return FAILED


def _parser():
    parser = argparse.ArgumentParser(
        prog="blender -b FILE.blend --command boxmorph",
        description="Deform objects toward a text prompt.",
    )
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    command_deform.add_to(commands)
    command_parts.add_to(commands)
    command_evaluate.add_to(commands)
    command_guides.add_to(commands)
    return parser
