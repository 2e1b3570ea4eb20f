# SPDX-License-Identifier: MIT OR Apache-2.0
"""What is in a saved file, as the Blender of a chroot sees it."""

import json

#: Saved files are looked at by Blender itself: prints the shape keys of each mesh object as JSON.
_LOOK = """
import bpy, json
def curves(keys):
    animation = keys.animation_data
    if animation is None or animation.action is None: return []
    if not hasattr(animation.action, 'slots'): return animation.action.fcurves
    from bpy_extras import anim_utils
    return anim_utils.action_get_channelbag_for_slot(animation.action, animation.action_slot).fcurves
out = {}
for obj in bpy.data.objects:
    if obj.type == 'MESH':
        keys = obj.data.shape_keys
        out[obj.name] = dict(vertices=len(obj.data.vertices), modifiers=[m.name for m in obj.modifiers],
            materials=[m.name for m in obj.data.materials],
            keys={} if keys is None else {k.name: [k.value, k.slider_min, k.slider_max]
                                          for k in keys.key_blocks},
            moved=0 if keys is None else max((a.co - b.co).length for k in keys.key_blocks
                                             for a, b in zip(k.points, keys.reference_key.points)),
            curves=[] if keys is None else [[list(p.co) for p in c.keyframe_points] for c in curves(keys)])
print('LOOK' + json.dumps(out))
"""


def look(bench, file):
    """Return what `_LOOK` sees in a saved file, or {} if it cannot be opened."""
    run = bench.run("blender", "-b", "--factory-startup", file, "--python-expr", _LOOK)
    lines = [line[4:] for line in run.stdout.splitlines() if line.startswith("LOOK")]
    return json.loads(lines[0]) if lines else {}
