# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures: the four views the guide sees, contact sheets and strips of the spectrum, as Blender images and
PNG files.

Arrays are (h,w,3) uint8, first row on top.
"""

import bpy
import numpy as np

#: Name of the image that "Show Views" fills.
VIEWS_IMAGE = "Boxmorph Views"

_BACKGROUND = np.array((255, 255, 255), np.float32)
_GAP = 4


def render_row(boxmorph, vertices, triangles, size=224, renderer="auto", views="paper"):
    """Return the views of a shape side by side on white, (size, k·size, 3) uint8: by default the four that
    the guide sees.
    """
    pictures = boxmorph.render(
        np.ascontiguousarray(vertices, np.float32), triangles, size=size, views=views, renderer=renderer
    )
    return np.concatenate([_on_background(picture) for picture in pictures], axis=1)


def colored_row(boxmorph, vertices, triangles, colors, size=224):
    """Return the four views with each triangle in its own color, (m,3) uint8, as `render_row` does."""
    views = boxmorph.render(
        np.ascontiguousarray(vertices, np.float32), triangles, size=size, views="paper", colors=colors
    )
    return np.concatenate([_on_background(view) for view in views], axis=1)


def swatches(colors, width, height=24):
    """Return fields of these colors, (k,3) uint8, from left to right, (height, width, 3) uint8."""
    field = np.arange(width) * len(colors) // width
    return np.broadcast_to(colors[field], (height, width, 3))


def stack(rows):
    """Return pictures of one width below each other, a thin white gap between."""
    gap = np.full((_GAP, rows[0].shape[1], 3), 255, np.uint8)
    parts = [part for row in rows for part in (gap, row)][1:]
    return np.concatenate(parts, axis=0)


def spectrum_strip(boxmorph, rest, vertices, triangles, alphas, size=224, renderer="auto"):
    """Return one view of rest + α·(vertices − rest) for each α, side by side, (size, len(alphas)·size, 3)
    uint8.
    """
    frames = []
    for alpha in alphas:
        shape = rest + np.float32(alpha) * (vertices - rest)
        frames.append(render_row(boxmorph, shape, triangles, size, renderer)[:, :size])
    return np.concatenate(frames, axis=1)


def show(picture, name=VIEWS_IMAGE):
    """Put a picture into the Blender image `name`, replacing what it held. Returns the image."""
    height, width = picture.shape[:2]
    image = bpy.data.images.get(name)
    if image is not None and (image.library is not None or tuple(image.size) != (width, height)):
        bpy.data.images.remove(image)
        image = None
    if image is None:
        image = bpy.data.images.new(name, width, height, alpha=False)
    _fill(image, picture)
    image.update()
    # Packed: Blender would else ask, at each saving of the file, whether to save the image too.
    image.pack()
    pixels = _rgba(picture)
    preview = image.preview_ensure()
    preview.image_size = (width, height)
    preview.image_pixels_float.foreach_set(pixels)
    return image


def save_png(picture, path):
    """Write a picture as a PNG file. Raises OSError where the file cannot be written."""
    height, width = picture.shape[:2]
    image = bpy.data.images.new("Boxmorph PNG", width, height, alpha=False)
    try:
        _fill(image, picture)
        image.file_format = "PNG"
        try:
            image.save(filepath=str(path))
        except RuntimeError as error:
            raise OSError(f"{path} cannot be written") from error
    finally:
        bpy.data.images.remove(image)


def _fill(image, picture):
    image.pixels.foreach_set(_rgba(picture))


def _rgba(picture):
    """Return a picture as Blender's flat float32 RGBA, first row at the bottom."""
    height, width = picture.shape[:2]
    out = np.ones((height, width, 4), np.float32)
    out[..., :3] = picture[::-1].astype(np.float32) / 255.0
    return out.ravel()


def _on_background(view):
    alpha = view[..., 3:].astype(np.float32) / 255.0
    mixed = view[..., :3].astype(np.float32) * alpha + _BACKGROUND * (1.0 - alpha)
    return np.rint(mixed).astype(np.uint8)
