# SPDX-License-Identifier: MIT OR Apache-2.0
"""Outcomes in the glTF and FBX of real Blender, out and in again. Debian's has no USD and no Alembic."""

import json

#: Exports the first keyed chair of a file and reads it again: prints names and values of its keys, each time.
_EXCHANGE = """
import bpy, json, sys
folder = sys.argv[sys.argv.index("--") + 1]
frames = range(1, 12)
def seen(shift=0):
    obj = next(obj for obj in bpy.data.objects if obj.type == "MESH" and obj.data.shape_keys)
    keys = obj.data.shape_keys.key_blocks
    values = []
    for key in keys: key.slider_min, key.slider_max = -10, 10
    for frame in frames:
        bpy.context.scene.frame_set(frame + shift)
        values.append([round(key.value, 4) for key in keys[1:]])
    rest, turn = keys[0].points, obj.matrix_world.to_3x3()
    least = [min((turn @ (a.co - b.co))[axis] for a, b in zip(keys[-1].points, rest)) for axis in range(3)]
    return dict(names=[key.name for key in keys[1:]], values=values, least=[round(v, 5) for v in least])
for obj in list(bpy.data.objects):
    if obj.name != "Plain Chair": bpy.data.objects.remove(obj)
bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 11
out = dict(before=seen())
bpy.ops.export_scene.gltf(filepath=folder + "/out.glb")
bpy.ops.export_scene.fbx(filepath=folder + "/out.fbx", bake_anim_use_nla_strips=False,
                         bake_anim_use_all_actions=False)
loads = dict(glb=(bpy.ops.import_scene.gltf, 0), fbx=(bpy.ops.import_scene.fbx, 1))
if hasattr(bpy.types, "WM_OT_fbx_import"): loads["new fbx"] = (bpy.ops.wm.fbx_import, 1)
for name, (load, shift) in loads.items():
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    load(filepath=folder + "/out." + name[-3:])
    out[name] = seen(shift)
print("EXCHANGE" + json.dumps(out))
"""


def check_exchange(bench, counts):
    """Deform a chair, keyframe it, hand it on."""
    run = bench.run(
        *("blender", "-b", bench.chair, "--command", "boxmorph", "deform", "--object", "Plain Chair"),
        *("--prompt", "a bar stool", "--splits", "2", "--keyframes", "1:11:-0.25:1.05"),
        *("--output", f"{bench.inside}/keyed.blend"),
    )
    counts.check(run.returncode == 0, "a chair is deformed to be handed on", run.stdout + run.stderr)
    (bench.outside / "exchange.py").write_text(_EXCHANGE, encoding="utf-8")
    run = bench.run(
        *("blender", "-b", "--factory-startup", f"{bench.inside}/keyed.blend", "--python-exit-code", "1"),
        *("--python", f"{bench.inside}/exchange.py", "--", bench.inside),
    )
    lines = [line[8:] for line in run.stdout.splitlines() if line.startswith("EXCHANGE")]
    if not counts.check(bool(lines), "it is exported and imported", run.stdout + run.stderr):
        return
    seen = json.loads(lines[0])
    before = seen.pop("before")
    counts.check(
        before["names"] == ["a bar stool"] and [before["values"][i] for i in (0, -1)] == [[-0.25], [1.05]],
        "its keyframes are as they were asked for",
        before,
    )
    for name, after in seen.items():
        pairs = [
            (a, b)
            for old, new in zip(before["values"], after["values"], strict=True)
            for a, b in zip(old, new, strict=True)
        ] + list(zip(before["least"], after["least"], strict=True))
        counts.check(
            after["names"] == before["names"] and all(abs(a - b) < 2e-4 for a, b in pairs),
            f"{name} keeps name, shape and animation",
            f"{before}\n{after}",
        )
