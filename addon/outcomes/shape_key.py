# SPDX-License-Identifier: GPL-3.0-or-later
"""Outcomes as shape keys: written relative to the Basis, named after the prompt, recorded on the Key
data-block.

A key that Boxmorph made is known by its record: JSON in the custom property `boxmorph` of the mesh's Key
data-block, from key name to report. Only such a key is ever replaced; a key of the artist's own that bears
the same name stays, and Blender numbers ours. A record follows its key where the user renames it.
"""

import hashlib
import json

import numpy as np

from ..core.mesh_io import key_positions, mesh_positions
from .animation_curves import drop_empty, is_animated, remove_curve

RECORDS = "boxmorph"

#: In the record of an outcome that was taken apart: the names of its pieces, and the value that it had.
PIECES = "pieces"
_VALUE = "value_before_pieces"

#: Custom property of a Key data-block whose Basis was made for the outcomes, and goes with the last of them.
OWN_BASIS = "boxmorph_basis"

#: In every record: a hash of the key's positions, by which a renamed key is known. A shape key has no
#: identity of its own besides its name.
_FINGERPRINT = "fingerprint"

#: Vertices that are hashed at most: records are read whenever the panel is drawn.
_HASHED = 4096

#: Shape key names are at most 63 bytes in Blender 4.2.
_NAME_BYTES = 60

#: Blender allows no slider outside of these.
_SLIDER_LIMIT = 10.0


def key_name(prompt):
    """Return the shape key name for a prompt: the prompt itself, cut at a character where it is too long."""
    return prompt.encode()[:_NAME_BYTES].decode(errors="ignore").rstrip()


def records(mesh):
    """Return the reports of the outcomes of `mesh` that still exist, by key name, oldest first.

    An outcome that was renamed in Blender's own list is there by its new name. Writes nothing, so that the
    panel may call it.
    """
    keys = mesh.shape_keys
    stored = _stored(keys)
    renamed = _renamed(keys, stored)
    # A key that was given the name of a deleted one brings its own record.
    kept = {name: report for name, report in stored.items() if name not in renamed.values()}
    present = ((renamed.get(name, name), report) for name, report in kept.items())
    return {name: report for name, report in present if name in keys.key_blocks}


def follow_renames(mesh):
    """Store the records of renamed outcomes by their new names, before a key takes an old one."""
    keys = mesh.shape_keys
    if _renamed(keys, _stored(keys)):
        _store(keys, records(mesh))


def _stored(keys):
    """Return the records as they were stored last, by the names that the keys had then."""
    try:
        return {} if keys is None else json.loads(keys.get(RECORDS, "{}"))
    except (TypeError, ValueError):
        return {}


def _renamed(keys, stored):
    """Return the new names, by the old, of keys that were renamed since they were stored: a record whose key
    is gone belongs to the one key that holds its positions, unless that has a record that fits it too.
    """
    gone = [name for name in stored if name not in keys.key_blocks]
    if not gone:
        return {}
    others = {keys.reference_key.name}.union(*(report.get(PIECES, ()) for report in stored.values()))
    strangers = {}
    for key in keys.key_blocks:
        if key.name not in others:
            fingerprint = _fingerprint(key)
            if stored.get(key.name, {}).get(_FINGERPRINT) != fingerprint:
                strangers.setdefault(fingerprint, []).append(key.name)
    found = {name: strangers.get(stored[name].get(_FINGERPRINT), ()) for name in gone}
    return {name: names[0] for name, names in found.items() if len(names) == 1}


def _fingerprint(key):
    """Return a hash of a shape key's positions; of dense meshes, of some of them."""
    positions = key_positions(key)
    sample = np.ascontiguousarray(positions[:: len(positions) // _HASHED + 1])
    return hashlib.blake2b(sample.tobytes(), digest_size=8, key=str(len(positions)).encode()).hexdigest()


def outcomes(mesh):
    """Return the shape keys of `mesh` that are outcomes, oldest first."""
    return [mesh.shape_keys.key_blocks[name] for name in records(mesh)]


def meant_outcome(obj):
    """Return the name and report of the outcome that is meant: that of the active key, else the newest;
    (None, {}) where there is none.
    """
    stored = records(obj.data)
    active = obj.active_shape_key.name if obj.active_shape_key else None
    of_active = (name for name, report in stored.items() if active in (name, *report.get(PIECES, ())))
    name = next(of_active, None) or next(reversed(stored), None)
    return name, stored.get(name, {})


def note(mesh, name, field, value):
    """Put `value`, JSON-ready, into the report of the outcome `name`."""
    stored = records(mesh)
    stored[name][field] = value
    _store(mesh.shape_keys, stored)


def keep_record(mesh, name, report):
    """Make `report` the record of the outcome `name`, which becomes the newest."""
    stored = records(mesh)
    stored.pop(name, None)
    stored[name] = report
    _store(mesh.shape_keys, stored)


def remove_outcome(obj, name):
    """Delete an outcome: its key, its pieces, its record and its animation; with the last one, the Basis, if
    it was made for it.
    """
    remove_pieces(obj, name)
    stored = records(obj.data)
    stored.pop(name, None)
    keys = obj.data.shape_keys
    _remove_key(obj, keys.key_blocks[name])
    _store(keys, stored)
    untouched = np.array_equal(key_positions(keys.reference_key), mesh_positions(obj.data))
    if keys.get(OWN_BASIS) and len(keys.key_blocks) == 1 and untouched:
        obj.shape_key_clear()


def set_limits(key, least, greatest):
    """Give a shape key these slider limits, as far as Blender has them; 0 and 1 are always among them."""
    key.slider_min = max(-_SLIDER_LIMIT, min(float(least), 0.0))
    key.slider_max = min(_SLIDER_LIMIT, max(float(greatest), 1.0))


def piece_name(name, label):
    """Return the key name of a piece of the outcome `name`; of the two, the outcome's name is cut."""
    return _with_tail(name, f": {label}")


def numbered_name(name, number):
    """Return the key name of the variation `number` of the outcome `name`."""
    return _with_tail(name, f" {number}")


def _with_tail(name, tail):
    return name.encode()[: _NAME_BYTES - len(tail.encode())].decode(errors="ignore").rstrip() + tail


def is_apart(mesh, name):
    """Whether the outcome `name` of `mesh` has been taken apart."""
    return PIECES in records(mesh)[name]


def pieces(mesh, name):
    """Return the shape keys that the outcome `name` of `mesh` was taken apart into, as far as they still
    exist.
    """
    blocks = mesh.shape_keys.key_blocks
    return [blocks[piece] for piece in records(mesh)[name].get(PIECES, ()) if piece in blocks]


def keep_pieces(mesh, name, names, value):
    """Note that the outcome `name` of `mesh` was taken apart into these keys when it had this value."""
    stored = records(mesh)
    stored[name] |= {PIECES: names, _VALUE: value}
    _store(mesh.shape_keys, stored)


def remove_pieces(obj, name):
    """Delete the keys that an outcome was taken apart into, if it was, and their animation; return how many
    are there no longer, and the value that the outcome had before.
    """
    blocks = obj.data.shape_keys.key_blocks
    active = obj.active_shape_key.name if obj.active_shape_key else None
    found = [key.name for key in pieces(obj.data, name)]
    for piece in found:
        _remove_key(obj, blocks[piece])
    if found and active is not None:
        obj.active_shape_key_index = blocks.find(name if active in found else active)
    stored = records(obj.data)
    missing = len(stored[name].pop(PIECES, ())) - len(found)
    value = stored[name].pop(_VALUE, 0.0)
    _store(obj.data.shape_keys, stored)
    return missing, value


def _remove_key(obj, key):
    keys = obj.data.shape_keys
    if is_animated(key):
        key.driver_remove("value")
        remove_curve(keys, key.path_from_id("value"))
        drop_empty(keys)
    obj.shape_key_remove(key)


def _store(keys, stored):
    if stored:
        blocks = keys.key_blocks
        marked = {
            name: report | {_FINGERPRINT: _fingerprint(blocks[name])} for name, report in stored.items()
        }
        keys[RECORDS] = json.dumps(marked, ensure_ascii=False)
    elif RECORDS in keys:
        del keys[RECORDS]
