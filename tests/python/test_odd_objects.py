# SPDX-License-Identifier: MIT OR Apache-2.0
"""The objects of docs/meshes.md have what they are shown for, and the page shows all of them."""

import sys
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs the module bpy")

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "demo")]

import meshes  # noqa: E402
import odd_objects  # noqa: E402


def build(kind):
    """Build an object. Returns its vertices (n, 3) and polygons."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    mesh = getattr(odd_objects, kind)().data
    assert not mesh.validate(), "Blender has to repair the mesh"
    return np.array([v.co for v in mesh.vertices]), [tuple(p.vertices) for p in mesh.polygons]


def edge_uses(faces):
    """Numbers of faces of all edges, and whether each runs both ways."""
    uses = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1], strict=True):
            uses.setdefault((min(a, b), max(a, b)), []).append(a < b)
    return [len(ways) for ways in uses.values()], [len(set(ways)) > 1 for ways in uses.values()]


@pytest.mark.parametrize(
    ("kind", "faces_of_edges"), [("open_shells", {1, 2}), ("planes", {1}), ("non_manifold", {1, 2, 3, 4})]
)
def test_edges_have_as_many_faces_as_the_kind_says(kind, faces_of_edges):
    assert set(edge_uses(build(kind)[1])[0]) == faces_of_edges


def test_vertices_are_duplicate_and_unused():
    vertices, faces = build("duplicate_vertices")
    used = np.unique(np.concatenate(faces))
    assert len(used) == 3 * len(faces) < len(vertices)
    assert len(np.unique(vertices[used].round(6), axis=0)) < len(used) / 3


def test_normals_are_mixed():
    assert np.mean(edge_uses(build("flipped_normals")[1])[1]) < 0.8
    assert all(edge_uses(build("coarse")[1])[1])


def test_the_hole_is_in_ngons():
    assert max(len(face) for face in build("ngons")[1]) > 24


def test_pieces_are_loose_and_coarse():
    assert len(build("loose_parts")[0]) == 8 * 49
    assert len(build("coarse")[0]) == 8 * 10


@pytest.mark.parametrize(("kind", "size"), [("very_small", 4.5e-6), ("very_large", 2.01e6), ("sphere", 0.4)])
def test_sizes_are_extreme(kind, size):
    assert np.ptp(build(kind)[0], axis=0).max() == pytest.approx(size, rel=0.05)


def test_shapes_are_extreme():
    thin = np.ptp(build("very_flat")[0], axis=0)
    assert thin[2] < thin[:2].min() / 1000
    assert np.ptp(build("plain_box")[0], axis=0).min() > 0 and len(build("plain_box")[0]) == 8


def test_the_page_has_every_kind_with_its_prompt():
    page = (ROOT / "docs" / "meshes.md").read_text(encoding="utf-8")
    rows = {
        line.split("images/meshes/")[1].split(".png")[0]: line for line in page.splitlines() if ".png" in line
    }
    assert set(rows) == {kind.replace("_", "-") for kind in meshes.PROMPTS}
    for kind, prompt in meshes.PROMPTS.items():
        name = kind.replace("_", "-")
        assert f"“{prompt}”" in rows[name] and (meshes.OUT / f"{name}.png").exists()
