# SPDX-License-Identifier: GPL-3.0-or-later
"""The way to the Rust module `boxmorph`: imported at first use, with the preferences applied, guides kept
open.
"""

import os

import numpy as np

from ..errors import Refusal
from ..preferences import preferences
from . import compiled_module, guides, mesh_io

#: The variable that names a library of ONNX Runtime, and its value before a preference changed it.
_RUNTIME = "ORT_DYLIB_PATH"
_environment = {}

#: The last guide that was opened, by the preferences of then, and the Refusal where it could not be; one of
#: the two is None.
_guides = {}


def library():
    """Return the module `boxmorph`. Raises Refusal where it is not installed for this platform, or of another
    build than the extension.
    """
    prefs = preferences()
    path = prefs.runtime_library.strip()
    if path and not os.path.isfile(guides.absolute(path)):
        raise Refusal(
            "The ONNX Runtime library {path} is missing. Correct its path in Boxmorph's preferences, or "
            "clear it to use the one inside the extension",
            path=path,
        )
    # Both are read once, when the module first needs them.
    _name_runtime(guides.absolute(path) if path else None)
    if prefs.threads:
        os.environ.setdefault("RAYON_NUM_THREADS", str(prefs.threads))
    try:
        import boxmorph
    except ImportError as error:
        raise Refusal(
            "Boxmorph's compiled module cannot be loaded ({error}). Install the extension's zip for this "
            "operating system and processor",
            error=str(error),
        ) from error
    compiled_module.check(boxmorph)
    return boxmorph


def _name_runtime(path):
    """Tell the module which library of ONNX Runtime to open; None: what it would without us."""
    if path is not None:
        _environment.setdefault(_RUNTIME, os.environ.get(_RUNTIME))
        os.environ[_RUNTIME] = path
    elif _RUNTIME in _environment:
        before = _environment.pop(_RUNTIME)
        if before is None:
            os.environ.pop(_RUNTIME, None)
        else:
            os.environ[_RUNTIME] = before


def searched(obj, context, bare=False):
    """Return the ObjectArrays of `obj`, turned to its own axes, and their Mesh; with `bare`, as it is without
    modifiers. Raises Refusal.
    """
    boxmorph = library()
    arrays = mesh_io.object_arrays(obj, context, bare)
    try:
        mesh = boxmorph.Mesh(arrays.vertices, arrays.triangles)
        turn = boxmorph.own_turn(mesh)
        if turn == 0.0:
            return arrays, mesh
        arrays = arrays.turned(turn)
        return arrays, boxmorph.Mesh(np.ascontiguousarray(arrays.vertices), arrays.triangles)
    except ValueError as error:
        raise Refusal(sentence(error)) from error


def open_guide(again=False):
    """Return the guide named in the preferences, else the embedded one. Raises Refusal.

    With `again` it is read once more, even if it is open.
    """
    choice = _guide_choice()
    guide, _why = (None, None) if again else _guides.get(choice, (None, None))
    try:
        guide = _open(guide, *choice)
    except Refusal as refusal:
        _guides.clear()
        _guides[choice] = None, refusal
        raise
    _guides[choice] = guide, None
    return guide


def open_folder(folder, precision):
    """Return the guide in a folder, whatever the preferences name. Raises Refusal."""
    prefs = preferences()
    return _open(None, str(folder), prefs.runtime_library, prefs.threads, prefs.provider, precision)


def _open(guide, folder, _runtime_library, threads, provider, precision):
    boxmorph = library()
    if folder is not None and not os.path.isdir(folder):
        raise Refusal(
            "The guide folder {folder} does not exist. Correct it in Boxmorph's preferences, or choose "
            "the embedded guide there",
            folder=folder,
        )
    if guide is not None:
        return guide
    # Not two at once: they may be large.
    _guides.clear()
    try:
        return boxmorph.Guide.open(folder, threads=threads or None, provider=provider, precision=precision)
    except (boxmorph.GuideError, ValueError, OSError) as error:
        raise Refusal(capitalised(sentence(error))) from error


def close_guide():
    """Let go of the guide that is open, if any, for the memory that it takes."""
    _guides.clear()


def known_guide():
    """Return the guide of the present preferences if it is open, and the Refusal if it was tried and could
    not be opened; None for what is not known. Opens nothing.
    """
    return _guides.get(_guide_choice(), (None, None))


def guide_folder():
    """Return the absolute path of the guide folder in the preferences; None: the embedded guide."""
    folder = preferences().guide_folder.strip()
    return guides.absolute(folder) if folder else None


def guide_precision():
    """Return the precision that was chosen of a folder that may hold several; “auto”: the most exact."""
    precision, _, folder = preferences().guide_precision.partition(" ")
    return precision if folder and folder == guide_folder() else "auto"


def _guide_choice():
    prefs = preferences()
    return guide_folder(), prefs.runtime_library, prefs.threads, prefs.provider, guide_precision()


def capitalised(text):
    """Return `text` with a capital first letter."""
    return text[:1].upper() + text[1:]


def sentence(error):
    """Return the message of a library error as one sentence, never empty."""
    text = " ".join(str(error).split()) or type(error).__name__
    return text.rstrip(".")
