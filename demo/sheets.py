# SPDX-License-Identifier: GPL-3.0-or-later
"""Layout of the demo's pictures. Pictures are (h, w, 3) uint8, first row on top."""

import struct
import zlib

import numpy as np

TILE = 240
BACKGROUND = 244
_FINE = 3  # samples of a pixel along each side
_MARGIN = 0.09  # of a view, cut off on each side: the unit sphere leaves that much


def contact_sheet(boxmorph, before, after, triangles):
    """The four views that the guide sees, before above after, (2·TILE, 4·TILE, 3)."""
    rows = [np.concatenate(_views(boxmorph, shape, triangles), axis=1) for shape in (before, after)]
    return np.concatenate(rows, axis=0)


def spectrum(boxmorph, shapes, triangles):
    """One view from the front and a little above of each shape, all in one frame, (TILE, k·TILE, 3)."""
    shapes = [_tilted(shape) for shape in shapes]
    low, high = np.min([s.min(0) for s in shapes], axis=0), np.max([s.max(0) for s in shapes], axis=0)
    center = (low + high) / 2
    radius = max(np.linalg.norm(s - center, axis=1).max() for s in shapes)
    # Six specks on a sphere about all shapes hold the frame still: the renderer fits it to what it is given.
    specks = center + radius * np.concatenate([np.eye(3), -np.eye(3)])
    more = len(shapes[0]) + np.repeat(np.arange(6), 3).reshape(6, 3)
    triangles = np.concatenate([triangles, more]).astype(np.int32)
    tiles = [_views(boxmorph, np.concatenate([shape, specks]), triangles)[3] for shape in shapes]
    return np.concatenate(tiles, axis=1)


def grid(rows, gap=10):
    """Rows of equal pictures, (h, w, 3) each, as one picture with white gaps."""
    padded = [[np.pad(p, ((0, gap), (0, gap), (0, 0)), constant_values=255) for p in row] for row in rows]
    return np.concatenate([np.concatenate(row, axis=1) for row in padded], axis=0)[:-gap, :-gap]


def save_png(picture, path):
    """Write a PNG file."""
    height, width, _ = picture.shape
    left = np.pad(picture, ((0, 0), (1, 0), (0, 0)))[:, :-1]
    lines = np.concatenate([np.ones((height, 1), np.uint8), (picture - left).reshape(height, -1)], axis=1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(lines.tobytes(), 9)), (b"IEND", b""))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in chunks:
            file.write(
                struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
            )


def _views(boxmorph, vertices, triangles):
    """The four views on the background, (TILE, TILE, 3) each, smoothed and cropped."""
    size = round(TILE / (1 - 2 * _MARGIN))
    images = boxmorph.render(np.ascontiguousarray(vertices, np.float32), triangles, size=size * _FINE)
    first = (size - TILE) // 2 * _FINE
    last = first + TILE * _FINE
    tiles = []
    for image in images[:, first:last, first:last].astype(np.float32):
        alpha = image[..., 3:] / 255
        mixed = image[..., :3] * alpha + BACKGROUND * (1 - alpha)
        smooth = mixed.reshape(TILE, _FINE, TILE, _FINE, 3).mean(axis=(1, 3))
        tiles.append(np.rint(smooth).astype(np.uint8))
    return tiles


def _tilted(vertices, degrees=18):
    """A shape tipped away from the fourth view's camera, as if that stood lower."""
    x, y, z = np.array((1, -1, 0)) / np.sqrt(2)
    a = -np.radians(degrees)
    cross = np.array(((0, -z, y), (z, 0, -x), (-y, x, 0)))
    turn = np.eye(3) + np.sin(a) * cross + (1 - np.cos(a)) * cross @ cross
    return vertices @ turn.T
