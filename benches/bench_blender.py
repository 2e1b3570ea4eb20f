# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what the extension takes to read a mesh and write a shape key, beside what Blender itself needs.

Usage: python benches/bench_blender.py [--vertices N] [--rounds N]   (in .venv, where bpy and the wheel are)
"""

import argparse
import os
import sys
import time
import types

import bpy
import numpy as np

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def extension():
    """Return the extension's modules that read and write, without registering it."""
    package = types.ModuleType("addon")
    package.__path__ = [os.path.join(ROOT, "addon")]
    sys.modules["addon"] = package
    from addon.core import mesh_io
    from addon.outcomes.trial import Trial

    return mesh_io, Trial


def grid(vertices_wanted):
    """Return a new object: a square of quads with about that many vertices."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    side = round(vertices_wanted**0.5)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=side - 1, y_subdivisions=side - 1)
    return bpy.context.object


def least(rounds, prepare, work):
    """Return the least seconds of `work(prepare())` over some rounds."""
    times = []
    for _ in range(rounds):
        prepared = prepare()
        start = time.perf_counter()
        work(prepared)
        times.append(time.perf_counter() - start)
    return min(times)


def main():
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--vertices", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    mesh_io, trial_of = extension()
    obj = grid(arguments.vertices)
    mesh = obj.data
    rest = mesh_io.mesh_positions(mesh)
    moved = rest * np.float32(1.1)
    report = {"prompt": "a bar stool", "scales": [[1.0, 1.1, 1.2]] * 15}

    def without_keys():
        obj.shape_key_clear()
        return trial_of(obj, "a bar stool")

    def with_key():
        trial = without_keys()
        trial.write(obj, rest)
        return trial

    def blender_keeps(_):
        obj.shape_key_add(name="Basis", from_mix=False)
        key = obj.shape_key_add(name="a bar stool", from_mix=False)
        key.points.foreach_set("co", moved.ravel())
        mesh.update()
        key.value = 1.0

    def blender_rewrites(_):
        mesh.shape_keys.key_blocks[1].points.foreach_set("co", moved.ravel())
        mesh.update()

    def kept(trial):
        place = mesh_io.ObjectArrays(rest, None, None, np.eye(3, dtype=np.float32), ())
        trial.keep(obj, place.to_object(moved), -1.0, 2.0, report)

    rows = [
        ("new key", blender_keeps, kept, without_keys),
        ("the same key again", blender_rewrites, lambda trial: trial.write(obj, moved), with_key),
    ]
    print(f"Blender {bpy.app.version_string}, {len(mesh.vertices):,} vertices, {len(mesh.polygons):,} quads")
    print("| writing | Blender alone | the extension | more |\n|---|---|---|---|")
    for name, alone, ours, prepare in rows:
        a, b = (least(arguments.rounds, prepare, work) for work in (alone, ours))
        print(f"| {name} | {1e3 * a:.0f} ms | {1e3 * b:.0f} ms | {1e3 * (b - a):.0f} ms |")
    obj.shape_key_clear()
    arrays = least(arguments.rounds, lambda: None, lambda _: mesh_io.object_arrays(obj, bpy.context))
    print(f"\nReading positions and triangles, with all checks: {1e3 * arrays:.0f} ms")


if __name__ == "__main__":
    main()
