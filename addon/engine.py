# SPDX-License-Identifier: GPL-3.0-or-later
"""The way to the Rust module `boxmorph`: imported at first use, with the preferences applied, guides kept
open.
"""

import os
import re

from .errors import Refusal
from .preferences import preferences

#: Longest prompt accepted, in characters. A guide reads some tens of words at most.
PROMPT_LIMIT = 300

#: Words that name nothing by themselves; a prompt of these alone says nothing to a guide.
_FILLER = frozenset(
    "a an the of with and or in on at to for by from as is it its this that like very some".split()
)

#: The last guide that was opened, under the preferences that it was opened with.
_guides = {}


def library():
    """Return the module `boxmorph`. Raises Refusal where it is not installed for this platform."""
    prefs = preferences()
    path = prefs.runtime_library.strip()
    if path and not os.path.isfile(_absolute(path)):
        raise Refusal(
            f"The ONNX Runtime library {path} is missing. Correct its path in Boxmorph's preferences, "
            "or clear it to use the one inside the extension"
        )
    # Both are read once, when the module first needs them.
    if path:
        os.environ["ORT_DYLIB_PATH"] = _absolute(path)
    if prefs.threads:
        os.environ.setdefault("RAYON_NUM_THREADS", str(prefs.threads))
    try:
        import boxmorph
    except ImportError as error:
        raise Refusal(
            f"Boxmorph's compiled module cannot be loaded ({error}). Install the extension's zip for this "
            "operating system and processor"
        ) from error
    return boxmorph


def open_guide():
    """Return the guide named in the preferences, else the embedded one. Raises Refusal."""
    boxmorph = library()
    folder = preferences().guide_folder.strip()
    folder = _absolute(folder) if folder else None
    if folder is not None and not os.path.isdir(folder):
        raise Refusal(
            f"The guide folder {folder} does not exist. Correct it in Boxmorph's preferences, "
            "or clear it to use the embedded guide"
        )
    opened_with = (folder, preferences().runtime_library, preferences().threads)
    if opened_with not in _guides:
        _guides.clear()
        try:
            _guides[opened_with] = boxmorph.Guide.open(folder, threads=preferences().threads or None)
        except (boxmorph.GuideError, ValueError, OSError) as error:
            raise Refusal(sentence(error)) from error
    return _guides[opened_with]


def clean_prompt(text):
    """Return `text` on one line without outer blanks. Raises Refusal for an empty or endless prompt."""
    prompt = " ".join(text.split())
    if not prompt:
        raise Refusal("The prompt is empty. Type what the object should become, such as: a bar stool")
    if len(prompt) > PROMPT_LIMIT:
        raise Refusal(
            f"The prompt has {len(prompt)} characters, and {PROMPT_LIMIT} is the most a guide can use. "
            "Say it in a few words"
        )
    return prompt


def unknown_words(guide, prompt):
    """Return the words of `prompt` that the guide does not know. Raises Refusal if it knows none that
    counts.
    """
    unknown = list(guide.unknown_words(prompt))
    lowered = {word.casefold() for word in unknown}
    words = [word for word in re.findall(r"[^\W_]+", prompt.casefold()) if word not in _FILLER]
    if all(word in lowered for word in words):
        named = ", ".join(f"“{word}”" for word in unknown[:6]) or f"“{prompt[:40]}”"
        known = ", ".join(guide.classes[:8])
        hint = f"Among those it knows: {known}" if known else "Use other words"
        raise Refusal(f"The guide knows no word of this prompt that names a shape ({named}). {hint}")
    return unknown


def sentence(error):
    """Return the message of a library error as one sentence, never empty."""
    text = " ".join(str(error).split()) or type(error).__name__
    return text.rstrip(".")


def _absolute(path):
    import bpy

    return os.path.abspath(bpy.path.abspath(path))
