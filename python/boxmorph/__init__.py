# SPDX-License-Identifier: MIT OR Apache-2.0
"""Boxmorph: text-driven deformation of manufactured objects.

A mesh is split into part boxes (:class:`BoxDefGraph`), the boxes' scales are searched by a :class:`Job` for
the shape that looks most like a prompt to a :class:`Guide`, and vertex positions come back.
Vertices are in object coordinates, any unit, z up.
"""

from pathlib import Path as _Path

from . import _boxmorph
from ._boxmorph import (
    BoxDefGraph,
    Cancelled,
    EightBitCopy,
    Guide,
    GuideError,
    Job,
    Mesh,
    RenderError,
    Result,
    Wording,
    __version__,
    execution_providers,
    graphics_adapter,
    guides,
    metrics,
    own_turn,
    render,
    runtime_library,
    runtime_version,
    spectrum_scores,
)

__all__ = [
    "BoxDefGraph",
    "Cancelled",
    "EightBitCopy",
    "Guide",
    "GuideError",
    "Job",
    "Mesh",
    "RenderError",
    "Result",
    "Wording",
    "__version__",
    "execution_providers",
    "graphics_adapter",
    "guides",
    "metrics",
    "own_turn",
    "render",
    "runtime_library",
    "runtime_version",
    "spectrum_scores",
]

for _library in sorted((_Path(__file__).parent / "onnxruntime").glob("*onnxruntime*")):
    if not _library.name.endswith(".txt"):
        _boxmorph.set_default_library(str(_library))
