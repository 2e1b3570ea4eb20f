# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the parts that are found, each in a colour of its own; mirror twins share one.

`python demo/parts.py` draws the example objects at 2, 3, 4 and 6 splits into docs/images/part-boxes.png.
With `--reference FOLDER`, the authors' shapes at 2, 3 and 4 splits into demo/out/reference/, our parts above
theirs: to look at only, as their meshes are for research use.
"""

import argparse
import importlib
import json
import sys
from pathlib import Path

import boxmorph
import numpy as np
import sheets

ROOT = Path(__file__).resolve().parent.parent
OBJECTS = ("chair", "table", "desk_lamp", "aeroplane")
SIZE = 240
_COLORS = np.array(
    [
        (230, 80, 70), (70, 130, 230), (90, 180, 80), (240, 180, 50), (170, 90, 210), (60, 190, 190),
        (240, 130, 180), (140, 110, 80), (150, 200, 60), (90, 90, 120),
    ],
    float,
)  # fmt: skip
_AZIMUTH, _ELEVATION = np.radians(-58), np.radians(28)
_SAMPLES = 400_000


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--reference", type=Path, help="folder of the authors' data, with index.json")
    options = parser.parse_args()
    if options.reference:
        _reference(options.reference, ROOT / "demo" / "out" / "reference")
    else:
        rows = [[own_parts(*_example(name), splits) for splits in (2, 3, 4, 6)] for name in OBJECTS]
        sheets.save_png(sheets.grid(rows), ROOT / "docs" / "images" / "part-boxes.png")


def own_parts(vertices, triangles, splits, turned=lambda points: points):
    """The parts of a mesh as a picture; `turned` takes points to z up."""
    graph = boxmorph.BoxDefGraph.build(boxmorph.Mesh(vertices, triangles), splits=splits)
    boxes = turned(graph.box_center), np.abs(turned(graph.box_half_size))
    return draw(turned(vertices), triangles, graph.assignment, *boxes, graph.parameter_row_of_box)


def draw(vertices, triangles, owners, center, half_size, color_of_box):
    """Surface samples in the colour of their owner with the boxes' edges, (SIZE, SIZE, 3) uint8."""
    right, up, ahead = _view()
    rng = np.random.default_rng(0)
    corners = vertices[triangles].astype(float)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(normals, axis=1)
    chosen = rng.choice(len(triangles), _SAMPLES, p=areas / areas.sum())
    weights = rng.dirichlet([1, 1, 1], _SAMPLES)
    points = np.einsum("nc,nca->na", weights, corners[chosen])
    colors = _COLORS[color_of_box % len(_COLORS)]
    light = 0.5 * ahead + 0.3 * up + (0, 0, 0.5)
    shade = 0.45 + 0.52 * np.abs(normals[chosen] @ light) / areas[chosen]
    surface = colors[owners[triangles[chosen, weights.argmax(axis=1)]]] * shade[:, None]
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    radius = np.linalg.norm(vertices - middle, axis=1).max()
    edges = np.stack([_edges(c, h) for c, h in zip(center, half_size, strict=True)])
    lines = np.repeat(0.55 * colors, edges.shape[1], axis=0)
    points = np.concatenate([points, edges.reshape(-1, 3) + 0.02 * radius * ahead]) - middle
    column = ((points @ right / radius + 1) / 2 * SIZE).astype(int)
    row = ((1 - points @ up / radius) / 2 * SIZE).astype(int)
    seen = (column >= 0) & (column < SIZE) & (row >= 0) & (row < SIZE)
    nearest_last = np.argsort(points[seen] @ ahead, kind="stable")
    picture = np.full((SIZE, SIZE, 3), float(sheets.BACKGROUND))
    picture[row[seen][nearest_last], column[seen][nearest_last]] = np.concatenate([surface, lines])[seen][
        nearest_last
    ]
    return np.clip(picture, 0, 255).astype(np.uint8)


def _view():
    """Unit vectors to the right, up and towards the camera."""
    a, e = _AZIMUTH, _ELEVATION
    ahead = np.array((np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)))
    right = np.array((-np.sin(a), np.cos(a), 0.0))
    return right, np.cross(ahead, right), ahead


def _edges(center, half_size, steps=400):
    """Points along the twelve edges of a box, (12·steps, 3)."""
    edges = []
    for axis in range(3):
        for corner in np.ndindex(2, 2):
            edge = np.empty((steps, 3))
            edge[:, axis] = np.linspace(-1, 1, steps)
            edge[:, [(axis + 1) % 3, (axis + 2) % 3]] = 2 * np.array(corner) - 1
            edges.append(edge)
    return center + half_size * np.concatenate(edges)


def _example(name):
    """Vertices (n, 3) and triangles (m, 3) of an example object as Blender shows it."""
    import bpy

    sys.path.insert(0, str(ROOT))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    obj = importlib.import_module(f"examples.{name}").build()
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    mesh.calc_loop_triangles()
    vertices = np.array([v.co for v in mesh.vertices], np.float32)
    return vertices, np.array([t.vertices for t in mesh.loop_triangles], np.int32)


def _reference(folder, out):
    out.mkdir(parents=True, exist_ok=True)
    for shape in json.loads((folder / "index.json").read_text())["shapes"]:
        with np.load(folder / shape["npz"]) as data:
            vertices, triangles = data["vertices"], np.ascontiguousarray(data["faces"], np.int32)
            ours = [own_parts(vertices, triangles, splits, _z_up) for splits in (2, 3, 4)]
            theirs = [_their_parts(data, _z_up(vertices), triangles, f"L{k}_") for k in (2, 3, 4)]
        sheets.save_png(sheets.grid([ours, theirs]), out / f"{Path(shape['npz']).stem}.png")


def _their_parts(data, vertices, triangles, level):
    kind = data[f"{level}box_kind"]
    colors = np.arange(len(kind))
    colors[kind == 2] = np.flatnonzero(kind == 1)
    boxes = _z_up(data[f"{level}box_center"]), np.abs(_z_up(data[f"{level}box_half_size"]))
    return draw(vertices, triangles, data[f"{level}assignment"], *boxes, colors)


def _z_up(points):
    return np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)


if __name__ == "__main__":
    main()
