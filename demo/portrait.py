# SPDX-License-Identifier: GPL-3.0-or-later
"""Portraits for the README: a saved result at one frame, in its own materials, by Cycles on the CPU."""

import bpy
import numpy as np
from mathutils import Vector

WIDTH, HEIGHT = 300, 250
PAGE = 240  # grey of the page that the object stands on
_VIEW = Vector((0.5, -0.8, 0.42)).normalized()
_SAMPLES = 48


def render(folder, frame):
    """The one object of the .blend in `folder` at `frame`, on the page with its shadow, (h, w, 3)."""
    (path,) = folder.glob("*.blend")
    bpy.ops.wm.open_mainfile(filepath=str(path))
    bpy.context.scene.frame_set(frame)
    return shoot(_positions(bpy.context.active_object), folder / f"portrait-{frame}.png")


def shoot(corners, path, size=(WIDTH, HEIGHT), samples=_SAMPLES):
    """The open scene, aimed at `corners`, (n, 3), on the page with its shadow, (h, w, 3); saved as `path`."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = size
    _stage(scene, float(np.linalg.norm(np.ptp(corners, axis=0))))
    _aim(scene, corners)
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.seed = samples, True, 0
    scene.render.film_transparent = True
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return _on_page(scene.render.filepath)


def _positions(obj):
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    out = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", out)
    return out.reshape(-1, 3)


def _stage(scene, size):
    """A floor that only catches the shadow, a soft sun and a bright sky."""
    bpy.ops.mesh.primitive_plane_add(size=20 * size)
    bpy.context.object.is_shadow_catcher = True
    bpy.ops.object.light_add(type="SUN", rotation=(0.65, 0.25, 0.5))
    bpy.context.object.data.energy, bpy.context.object.data.angle = 1.7, 0.35
    scene.world = bpy.data.worlds.new("Sky")
    if scene.world.node_tree is None:
        scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value, sky.inputs["Strength"].default_value = (0.9, 0.95, 1, 1), 0.7


def _aim(scene, points):
    """A camera in the direction of the view that holds all points, (n, 3), with a margin."""
    bpy.ops.object.camera_add(rotation=(-_VIEW).to_track_quat("-Z", "Y").to_euler())
    camera = scene.camera = bpy.context.object
    camera.data.clip_end = 1e4
    camera.data.lens = 75
    place, _ = camera.camera_fit_coords(bpy.context.evaluated_depsgraph_get(), points.ravel().tolist())
    camera.location = place
    camera.data.lens = 66


def _on_page(path):
    image = bpy.data.images.load(path)
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(height, width, 4)[::-1]
    mixed = 255 * pixels[..., :3] * pixels[..., 3:] + PAGE * (1 - pixels[..., 3:])
    # Every second shade is enough, and makes the file a third smaller.
    return (np.clip(np.rint(mixed / 2), 0, 127) * 2).astype(np.uint8)
