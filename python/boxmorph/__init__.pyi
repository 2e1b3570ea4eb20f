# SPDX-License-Identifier: MIT OR Apache-2.0
# Vertices are in object coordinates, any unit, z up.
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from . import metrics as metrics

__version__: str

Boundary = Literal["smooth", "paper"]
Symmetry = Literal["auto", "none", "x", "y", "z", "xy"]
Renderer = Literal["auto", "cpu", "gpu"]
Views = Literal["paper", "ring", "front right"]
Provider = Literal["auto", "cpu", "cuda", "directml", "coreml", "migraphx", "openvino"]
Precision = Literal["auto", "fp32", "fp16", "int8", "uint8", "q4", "q4f16", "bnb4"]

class GuideError(Exception): ...
class RenderError(Exception): ...
class Cancelled(Exception): ...  # noqa: N818 (not an error: the user asked for it)

class Mesh:
    """A triangle mesh; the arrays are copied."""

    def __init__(
        self,
        vertices: NDArray[np.float32],  # (n, 3), C-contiguous
        triangles: NDArray[np.uint32] | NDArray[np.int32],  # (m, 3), C-contiguous
    ) -> None: ...
    @property
    def vertices(self) -> NDArray[np.float32]: ...  # (n, 3)
    @property
    def triangles(self) -> NDArray[np.uint32]: ...  # (m, 3)

class BoxDefGraph:
    """Part boxes of a mesh and the constraints between them."""

    @staticmethod
    def build(
        mesh: Mesh, splits: int = 3, symmetry: Symmetry = "auto", boundary: Boundary = "smooth"
    ) -> BoxDefGraph: ...
    @staticmethod
    def from_boxes(
        mesh: Mesh,
        box_center: NDArray[np.float32],  # (b, 3)
        box_half_size: NDArray[np.float32],  # (b, 3)
        symmetry: Symmetry = "auto",
        boundary: Boundary = "smooth",
    ) -> BoxDefGraph:
        """Boxes of one's own; they may overlap, and vertices outside of all go to the nearest."""

    @staticmethod
    def from_parts(
        mesh: Mesh,
        box_center: NDArray[np.float32],  # (b, 3)
        box_half_size: NDArray[np.float32],  # (b, 3)
        box_side: NDArray[np.integer],  # (b,) 0 mid, 1 pos, 2 neg
        assignment: NDArray[np.integer],  # (n,) the box that owns each vertex
        tree_edges: NDArray[np.integer],  # (b - 1, 2) (parent, child), in the order of execution
        tree_parent_point: NDArray[np.float32],  # (b - 1, 3)
        tree_child_point: NDArray[np.float32],  # (b - 1, 3)
        edges: NDArray[np.integer],  # (e, 2) (leader, follower), in the order of execution
        boundary: Boundary = "paper",
        box_row: NDArray[np.integer]
        | None = None,  # (b,) parameter row; None: the j-th neg box has that of the j-th pos box
    ) -> BoxDefGraph: ...
    @property
    def box_center(self) -> NDArray[np.float32]: ...  # (b, 3)
    @property
    def box_half_size(self) -> NDArray[np.float32]: ...  # (b, 3)
    @property
    def box_side(self) -> NDArray[np.int8]: ...  # (b,) 0 mid, 1 pos, 2 neg
    @property
    def assignment(self) -> NDArray[np.int32]: ...  # (n,)
    @property
    def tree_edges(self) -> NDArray[np.int32]: ...  # (b - 1, 2)
    @property
    def edges(self) -> NDArray[np.int32]: ...  # (e, 2)
    @property
    def parameter_rows(self) -> int: ...  # P, the number of mid and pos boxes
    @property
    def parameter_row_of_box(self) -> NDArray[np.int32]: ...  # (b,)
    @property
    def symmetry(self) -> Literal["x", "y", "z", "xy"] | None: ...
    def deform(
        self, scales: NDArray[np.float32], shifts: NDArray[np.float32] | None = None
    ) -> NDArray[np.float32]:
        """Scale factors (P, 3), 1 = unchanged, and shifts (P, 3) in object units, to positions (n, 3).

        A shift moves a part and all that hangs on it; mirror images move the mirrored way.
        """

    def field(self, with_shifts: bool = False) -> NDArray[np.float32]:
        """The field B, (3, P, n): V_a(c) = V_a + sum over p of (c[p, a] - 1) B[a, p].

        With shifts (3, 2 P, n): sum over p of shift[p, a] B[a, P + p] is added, shifts in object units.
        """

    def field_at(
        self,
        points: NDArray[np.float32],  # (k, 3), such as a base mesh under its modifiers
        with_shifts: bool = False,
    ) -> NDArray[np.float32]:
        """The field at other points, (3, P, k); with shifts (3, 2 P, k).

        A point in a vertex's place moves as the vertex does.
        """

    def shift_room(self) -> NDArray[np.float32]:
        """Least and greatest shift of each parameter row along each axis, (P, 3, 2), in object units: as far
        as its parts do not overhang those they hang on. Both are 0 where there is no room.
        """

def own_turn(mesh: Mesh) -> float:
    """The angle about z, in radians, by which to turn a mesh so that its own axes lie along x and y, where
    boxes are cut: from -pi/4 to pi/4, 0 where they do. A Job takes its mesh as it lies.
    """

class Guide:
    """A text–image model. Embeddings are unit vectors."""

    @staticmethod
    def open(
        path: str | PathLike[str] | None = None,
        threads: int | None = None,
        provider: Provider = "auto",
        precision: Precision = "auto",
    ) -> Guide:
        """Opens a guide's folder; None: the embedded guide. Raises GuideError.

        `provider` encodes the images. "auto" is the processor, so that results are the same everywhere; but
        a large guide goes to the graphics card where an ONNX Runtime library of your own has one. A provider
        that cannot be used is replaced by the processor, and `provider_note` says why. `precision` is that of
        the image network; "auto" is the most exact that the folder has.
        """

    @staticmethod
    def quantize(
        folder: str | PathLike[str], output: str | PathLike[str] | None = None, threads: int | None = None
    ) -> dict[str, Any]:
        """Writes a copy of a guide's 32-bit image network in eight bits, to be opened with precision="int8".

        `output` is the folder for a complete guide; None puts the copy beside the exact network. Returns
        `file`, the sizes `exact_bytes` and `bytes`, and how far the two agree on `images` of candidates:
        `cosine_mean` and `cosine_min` between their embeddings, `rank_mean` and `rank_min`, Spearman's
        correlation of the orders in which prompts put the candidates, and both speeds. Raises GuideError.
        `EightBitCopy` does the same on a thread of its own.
        """

    def text_embedding(self, text: str) -> NDArray[np.float32]: ...  # (d,)
    def image_embeddings(
        self, images: NDArray[np.uint8]
    ) -> NDArray[np.float32]: ...  # (k, h, w, 3) to (k, d)
    def unknown_words(self, text: str) -> list[str]: ...
    def check_prompt(self, prompt: str) -> None:
        """Raises ValueError for a prompt that is empty, endless, or of unknown words alone."""

    def nearest_words(self, word: str, count: int = 3) -> list[str]:
        """Known words that are spelled like `word`, the most alike first."""

    def token_ids(self, text: str) -> list[int]:
        """What the text network reads, padding included."""

    @property
    def image_size(self) -> int: ...
    @property
    def classes(self) -> list[str]: ...
    @property
    def name(self) -> str: ...
    @property
    def sha256(self) -> str: ...
    @property
    def provider(self) -> str: ...
    @property
    def precision(self) -> str: ...
    @property
    def provider_note(self) -> str | None: ...

class EightBitCopy:
    """A copy of a guide in eight bits, made on a thread of its own; not started when made. See
    `Guide.quantize` for the arguments and the result.
    """

    def __init__(
        self,
        folder: str | PathLike[str],
        output: str | PathLike[str] | None = None,
        threads: int | None = None,
    ) -> None: ...
    def start(self) -> None: ...
    def progress(self) -> dict[str, Any]:
        """The copy as it stands now: phase, fraction (0 to 1), finished."""

    def cancel(self) -> None:
        """Asks it to stop, which it does after the step it is in, some seconds at most; nothing is left."""

    def join(self) -> None:
        """Waits for the end. Raises Cancelled, GuideError, ValueError or RuntimeError."""

    def result(self) -> dict[str, Any]: ...

class Wording:
    """What is asked for, where a prompt alone does not say it. A Job takes it in the prompt's place."""

    def __init__(
        self,
        prompt: str,
        negative: str | None = None,
        source: str | None = None,
        templates: Literal["auto", "on", "off"] = "auto",
    ) -> None:
        """`prompt` may have several parts with weights, "a stool:1, a throne:0.3", that are blended; without
        weights it is one, whatever its commas. `negative`: what the object should not look like; weights
        count against the prompt's 1, and one without counts a half. `source`: what the object is now; the
        target is then the direction from there to the prompt. `templates`: whether the guide reads the texts
        as "a photo of {}", "a 3d render of {}" … and takes the mean; "auto" is on for a guide of general
        knowledge, but not in a Job of the preset "paper".

        Scores are mean cosines of the images with normalise(p − Σ w·n − max(0, p·s)·s): p the prompts'
        embeddings blended, n those of the negatives, s that of the source, each of unit length.
        """

    @property
    def prompt(self) -> str: ...
    @property
    def parts(self) -> list[tuple[str, float]]:
        """The prompt's parts and their weights; one of weight 1 where none are given. Raises ValueError."""

    def check(self, guide: Guide) -> list[str]:
        """The words that the guide does not know. Raises ValueError for texts that are misshapen, empty,
        endless or of unknown words alone, and for a prompt that means the same as what is taken from it.
        """

def execution_providers() -> list[Provider]:
    """What the library of ONNX Runtime offers to run a guide on, the processor last. Raises GuideError where
    the library cannot be opened.
    """

def runtime_library() -> Path:
    """The file of ONNX Runtime's library, opened if need be. Raises GuideError."""

def runtime_version() -> str:
    """The version of ONNX Runtime's library, opened if need be. Raises GuideError."""

def graphics_adapter() -> str | None:
    """The name of the graphics card that renderer "auto" takes; None where there is no real one."""

def render(
    vertices: NDArray[np.float32],  # (n, 3)
    triangles: NDArray[np.uint32] | NDArray[np.int32],  # (m, 3)
    size: int = 224,
    views: Views = "paper",
    renderer: Renderer = "auto",
    colors: NDArray[np.uint8] | None = None,  # (m, 3), of triangles; not with "gpu"
) -> NDArray[np.uint8]:
    """RGBA images with straight alpha, (views, size, size, 4). Raises RenderError."""

def spectrum_scores(
    mesh: Mesh,
    vertices: NDArray[np.float32],  # (n, 3), the outcome: positions of the mesh's vertices
    prompt: str | Wording,
    guide: Guide,
    alphas: Sequence[float] | NDArray[np.float64],  # (k,), 0: the mesh, 1: the outcome
    renderer: Renderer = "auto",
    views: Views = "paper",
) -> NDArray[np.float64]:
    """Scores (k,) of the shapes mesh + alpha * (vertices - mesh): mean cosine of every view before each of
    three backgrounds with the prompt; of the paper's views as `Result.score_before` and `Result.score_after`.
    Dense meshes are scored by the light proxy that a Job takes. Templates are those of the wording; "auto"
    is on for a guide of general knowledge.

    Raises ValueError for a prompt the guide cannot read, for `vertices` of another number, and for numbers
    that are not finite; TypeError for another dtype; GuideError, RenderError.
    """

class Job:
    """A deformation on a thread of its own; not started when made."""

    def __init__(
        self,
        mesh: Mesh,
        prompt: str | Wording,
        guide: Guide | None = None,
        preset: Literal["draft", "standard", "best", "paper"] = "standard",
        seed: int = 0,
        *,
        splits: Literal["auto"] | int | None = None,
        symmetry: Symmetry | None = None,  # None: the preset's
        boundary: Boundary | None = None,  # None: the preset's
        graph: BoxDefGraph | None = None,  # parts that are known already; None finds them
        locked: NDArray[np.bool_] | None = None,  # (P, 3), what of the graph keeps its scale
        scale_range: tuple[float, float] = (0.3, 3.1),  # least and greatest scale factor
        shift_parts: bool = False,  # whether parts may also be shifted over those they hang on
        renderer: Renderer = "auto",
        keep_size: Literal["diagonal", "height", "footprint", "off"]
        | None = None,  # None: the diagonal; with locks "off", so that what is locked keeps its size
        keep_place: Literal["bottom", "off"] = "bottom",
        points: NDArray[np.float32] | None = None,  # (k, 3), moved by the same field
        variations: int = 1,  # outcomes wanted, 1 to 8
        images: int | None = None,  # images that may be encoded; None: as the preset says
        seconds: float | None = None,  # time that the search may take, in the place of images
        paper_loss: bool = False,  # whether the score and the normal error alone count
    ) -> None:
        """Presets "draft", "standard" and "best" search from few parts to many on a budget of 1,400, 4,400
        and 22,500 images; "paper" is the protocol of the paper, up to 100,000. With `seconds` the budget is
        what this machine encodes in that time; the record's `image_budget`, given as `images`, repeats the
        outcome, unless the time ran out before.

        With `variations` the job goes on, after its usual search, to outcomes that are nearly as good as
        its result and look different. Each takes about a third as long again.
        """

    def start(self) -> None: ...
    def progress(self) -> dict[str, Any]:
        """The job as it stands now.

        phase, generation, generations, evaluations, score_before, best_score, fraction, seconds,
        seconds_left, finished.
        """

    def best(self) -> tuple[float, NDArray[np.float32]] | None:
        """Score and positions of the best so far: of `points` where given, else of the mesh."""

    def best_view(self, size: int = 96) -> NDArray[np.uint8] | None:
        """A picture of the best so far from the front right, RGBA with straight alpha, (size, size, 4)."""

    def cancel(self) -> None: ...
    def join(self) -> None:
        """Waits for the end. Raises Cancelled, GuideError, RenderError, ValueError or RuntimeError."""

    def result(self) -> Result: ...

class Result:
    """What a job found."""

    @property
    def vertices(self) -> NDArray[np.float32]: ...  # (n, 3)
    @property
    def points(self) -> NDArray[np.float32] | None: ...  # (k, 3)
    @property
    def scales(self) -> NDArray[np.float32]: ...  # (P, 3)
    @property
    def shifts(self) -> NDArray[np.float32] | None: ...  # (P, 3), in object units; None without shift_parts
    @property
    def score_before(self) -> float: ...
    @property
    def score_after(self) -> float: ...
    @property
    def evaluations(self) -> int: ...
    @property
    def images_encoded(self) -> int: ...
    @property
    def seconds(self) -> float: ...
    @property
    def graph(self) -> BoxDefGraph: ...
    @property
    def slider_min(self) -> float: ...
    @property
    def slider_max(self) -> float: ...
    @property
    def variations(self) -> list[Result]:
        """The outcomes: this one, which a job without variations finds too, then the others, best first.

        As many as were asked for or, where fewer are good enough and differ, as there are. Those others list
        themselves alone.
        """
    def report(self) -> dict[str, Any]:
        """The record: parameters, seed, guide's hash, versions, scores, costs. JSON-ready."""
