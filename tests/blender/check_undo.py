# SPDX-License-Identifier: MIT OR Apache-2.0
"""Undo and redo of what is done with an outcome; Blender as a Python module has none."""

import json

_UNDO = """
import bpy, json
obj = bpy.data.objects["Plain Chair"]
bpy.context.view_layer.objects.active = obj
seen = []
def look():
    keys = bpy.data.objects["Plain Chair"].data.shape_keys
    names = [] if keys is None else [key.name for key in keys.key_blocks]
    seen.append([names, len(bpy.data.actions), len(bpy.data.shape_keys)])
def step(operator=None, **options):
    if operator is not None: operator(**options)
    bpy.ops.ed.undo_push()
    look()
step()
step(bpy.ops.boxmorph.deform, prompt="a bar stool", splits="1")
step(bpy.ops.boxmorph.keyframe_spectrum)
step(bpy.ops.boxmorph.remove_outcome)
for operator in [bpy.ops.ed.undo] * 3 + [bpy.ops.ed.redo] * 3:
    operator()
    look()
print("UNDO" + json.dumps(seen))
"""


def check_undo(bench, counts):
    """Deform, keyframe, remove; and all of it backwards and forwards again."""
    (bench.outside / "undo.py").write_text(_UNDO, encoding="utf-8")
    run = bench.run(
        *("blender", "-b", bench.chair, "--python-exit-code", "1", "--python", f"{bench.inside}/undo.py")
    )
    lines = [line[4:] for line in run.stdout.splitlines() if line.startswith("UNDO")]
    seen = json.loads(lines[0]) if lines else None
    start, outcome = [[], 0, 0], [["Basis", "a bar stool"], 0, 1]
    keyed = [outcome[0], 1, 1]
    counts.check(
        seen == [start, outcome, keyed, start, keyed, outcome, start, outcome, keyed, start],
        "an outcome, its keyframes and its removal are undone and redone",
        f"{seen}\n{run.stdout}{run.stderr}",
    )
