# SPDX-License-Identifier: GPL-3.0-or-later
"""Text as pictures, set in Blender's own font: without a window Blender 4.2 draws no text, but makes meshes
of it.
"""

import bpy
import numpy as np

#: The font's lowest and highest points, in units of its size.
_BOTTOM, _TOP = -0.25, 0.9

#: Samples of a pixel along each side.
_FINE = 4


def text_picture(text, height, width):
    """Return a line of text, black on white, (height, width, 3) uint8; one that is too long ends in “…”."""
    scale = height / (_TOP - _BOTTOM)
    corners = _triangles(text)
    while len(text) > 1 and corners.size and corners[..., 0].max() * scale > width:
        keep = int(len(text) * width / (corners[..., 0].max() * scale))
        text = text[: min(keep, len(text)) - 1].rstrip("… ") + "…"
        corners = _triangles(text)
    covered = _coverage((corners - (0.0, _BOTTOM)) * scale, height, width)
    return np.repeat(np.rint(255 * (1 - covered))[::-1, :, None].astype(np.uint8), 3, axis=2)


def _triangles(text):
    """Return the triangles of a text's letters, (k,3,2) float64, in units of the font's size."""
    fonts = set(bpy.data.fonts)
    curve = bpy.data.curves.new("Boxmorph Text", "FONT")
    obj = bpy.data.objects.new("Boxmorph Text", curve)
    try:
        curve.body, curve.resolution_u = text, 2
        mesh = bpy.data.meshes.new_from_object(obj)
        try:
            mesh.calc_loop_triangles()
            indices = np.empty(3 * len(mesh.loop_triangles), np.int32)
            mesh.loop_triangles.foreach_get("vertices", indices)
            points = np.empty(3 * len(mesh.vertices), np.float32)
            mesh.vertices.foreach_get("co", points)
        finally:
            bpy.data.meshes.remove(mesh)
    finally:
        bpy.data.objects.remove(obj)
        bpy.data.curves.remove(curve)
        # The file keeps no font that it did not use.
        for font in set(bpy.data.fonts) - fonts:
            bpy.data.fonts.remove(font)
    return points.reshape(-1, 3)[indices, :2].reshape(-1, 3, 2).astype(np.float64)


def _coverage(corners, height, width):
    """Return how much of each pixel these triangles, (k,3,2) in pixels, cover, (height, width), lowest row
    first.
    """
    samples = np.zeros((height * _FINE, width * _FINE), bool)
    for triangle in corners * _FINE - 0.5:
        low = np.maximum(np.ceil(triangle.min(axis=0)), 0).astype(int)
        high = np.minimum(np.floor(triangle.max(axis=0)) + 1, samples.shape[::-1]).astype(int)
        if (low >= high).any():
            continue
        x, y = np.arange(low[0], high[0]), np.arange(low[1], high[1])[:, None]
        # On which side of each edge: inside, it is the same for all three.
        sides = [
            (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
            for a, b in zip(triangle, np.roll(triangle, -1, axis=0), strict=True)
        ]
        inside = np.logical_and.reduce([side >= 0 for side in sides])
        inside |= np.logical_and.reduce([side <= 0 for side in sides])
        samples[low[1] : high[1], low[0] : high[0]] |= inside
    return samples.reshape(height, _FINE, width, _FINE).mean(axis=(1, 3))
