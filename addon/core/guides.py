# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of guides on the user's disk, and what lies in it."""

import os
from contextlib import contextmanager

import bpy

from ..errors import Refusal
from ..preferences import PACKAGE, preferences

#: Guides listed at most: the user may have named any folder.
_MOST = 100


def absolute(path):
    """Return a path of the user's as an absolute one."""
    return os.path.abspath(bpy.path.abspath(path))


def root():
    """Return the guides folder, whether it exists or not: the one named in the preferences, else one beside
    Blender's own settings.
    """
    named = preferences().guides_folder.strip()
    return absolute(named) if named else bpy.utils.extension_path_user(PACKAGE, path="guides")


def found():
    """Return the folders in the guides folder, sorted by name; they may or may not hold guides that open."""
    try:
        with os.scandir(root()) as entries:
            names = sorted(e.name for e in entries if e.is_dir() and not e.name.startswith("."))
    except OSError:
        return []
    return [os.path.join(root(), name) for name in names[:_MOST]]


def size(folder):
    """Return the bytes of a guide's files: those of its folder and of `onnx/` in it."""
    total = 0
    for place in (folder, os.path.join(folder, "onnx")):
        try:
            with os.scandir(place) as entries:
                total += sum(entry.stat().st_size for entry in entries if entry.is_file())
        except OSError:
            continue
    return total


def name(folder):
    """Return what the guide in a folder is called: in the hub's cache, by its repository."""
    snapshots, name = os.path.split(folder)
    repository = os.path.basename(os.path.dirname(snapshots))
    if os.path.basename(snapshots) == "snapshots" and repository.startswith("models--"):
        return repository.rpartition("--")[2]
    return name


def megabytes(count):
    """Return a number of bytes in words."""
    return f"{count / 1e6:.1f} MB" if count < 1e8 else f"{count / 1e6:.0f} MB"


@contextmanager
def chosen(name):
    """Let another guide judge for a while: “embedded”, one of the guides folder by its name, or that in a
    folder; None: the one of the preferences. Raises Refusal.
    """
    prefs = preferences()
    before = prefs.guide_folder
    if name is not None:
        prefs.guide_folder = _named(name)
    try:
        yield
    finally:
        if name is not None:
            prefs.guide_folder = before


def _named(name):
    if name == "embedded":
        return ""
    for folder in (os.path.join(root(), name), absolute(name)):
        if os.path.isdir(folder):
            return folder
    known = ", ".join(["embedded", *map(os.path.basename, found())])
    raise Refusal("There is no guide “{name}”. Choose {known}, or name a folder", name=name, known=known)
