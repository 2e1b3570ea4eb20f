# SPDX-License-Identifier: MIT OR Apache-2.0
"""All that a file holds, as comparable data, to see what an operator changed."""

import numpy as np
from addon_blender import bpy

#: Collections of bpy.data whose data-blocks are looked into; of the others, names and users count.
_LOOKED_INTO = ("objects", "meshes", "shape_keys", "actions", "armatures", "materials", "collections")

#: Properties that say nothing of what is kept: back references, the mesh's geometry, which is read from its
#: attributes, and what Blender computes when it is asked.
_LEFT_OUT = frozenset(
    "rna_type id_data bl_rna original library_weak_reference preview node_tree use_nodes users session_uid "
    "vertices edges loops polygons loop_triangles loop_triangle_polygons vertex_normals polygon_normals "
    "corner_normals attributes color_attributes uv_layers vertex_colors uv_layer_stencil uv_layer_clone "
    "points data execution_time is_evaluated is_updated is_updated_data tag "
    "dimensions bound_box total_vert_sel total_edge_sel total_face_sel".split()
)

_ATTRIBUTE_FIELD = {
    "FLOAT_VECTOR": "vector",
    "FLOAT2": "vector",
    "FLOAT_COLOR": "color",
    "BYTE_COLOR": "color",
}


def snapshot():
    """Return all of the file, as a flat dict from path to value."""
    bpy.context.view_layer.update()
    found = {}
    for collection in bpy.data.bl_rna.properties:
        if collection.type != "COLLECTION":
            continue
        name = collection.identifier
        for block in getattr(bpy.data, name):
            path = f"{name}[{block.name_full}]"
            found[f"{path}.users"] = block.users
            if name in _LOOKED_INTO:
                _walk(block, path, found, set())
            if name == "meshes":
                found.update(_geometry(block, path))
            if name == "shape_keys":
                for key in block.key_blocks:
                    points = np.empty(3 * len(key.points), np.float32)
                    key.points.foreach_get("co", points)
                    found[f"{path}.key_blocks[{key.name}].points"] = points.tobytes()
    for name in dir(bpy.app.handlers):
        if isinstance(getattr(bpy.app.handlers, name), list):
            found[f"handlers.{name}"] = [id(handler) for handler in getattr(bpy.app.handlers, name)]
    return found


def differences(before, after):
    """Return the paths whose values differ, sorted, whether changed, new or gone."""
    return sorted(path for path in before | after if before.get(path, Ellipsis) != after.get(path, Ellipsis))


def _walk(struct, path, found, above):
    """Note all properties of a struct and of what it owns."""
    above = above | {struct.as_pointer()}
    for prop in struct.bl_rna.properties:
        name = prop.identifier
        if name in _LEFT_OUT:
            continue
        value, here = getattr(struct, name), f"{path}.{name}"
        if prop.type == "COLLECTION":
            found[f"{here}.count"] = len(value)
            for index, item in enumerate(value):
                if item is None:
                    found[f"{here}[{index}]"] = None
                    continue
                item_path = f"{here}[{getattr(item, 'name', '') or index}]"
                if isinstance(item, bpy.types.ID):
                    found[item_path] = item.name_full
                elif item.as_pointer() not in above:
                    found[f"{item_path}.index"] = index
                    _walk(item, item_path, found, above)
        elif prop.type == "POINTER":
            if value is None or isinstance(value, bpy.types.ID):
                found[here] = value and value.name_full
            elif name.startswith("active") or name in ("reference_key", "relative_key"):
                found[here] = getattr(value, "name", None)
            elif value.as_pointer() not in above:
                _walk(value, here, found, above)
        elif getattr(prop, "is_array", False):
            found[here] = repr([tuple(row) if hasattr(row, "__len__") else row for row in value])
        else:
            found[here] = repr(value)
    if isinstance(struct, bpy.types.ID):
        for name, value in struct.items():
            found[f"{path}[{name!r}]"] = repr(value.to_dict() if hasattr(value, "to_dict") else value)


def _geometry(mesh, path):
    """Return all of a mesh's attributes, byte for byte, and what is no attribute in every Blender."""
    found = {}
    for attribute in mesh.attributes:
        field = _ATTRIBUTE_FIELD.get(attribute.data_type, "value")
        key = f"{path}.attributes[{attribute.name}]"
        found[key] = (attribute.domain, attribute.data_type, *_bulk(attribute.data, field))
    found[f"{path}.polygons"] = _bulk(mesh.polygons, "loop_start") + _bulk(mesh.polygons, "loop_total")
    for collection, fields in (
        (mesh.vertices, ("co", "hide", "select")),
        (mesh.edges, ("use_seam", "use_edge_sharp", "use_freestyle_mark", "hide", "select")),
        (mesh.polygons, ("use_smooth", "use_freestyle_mark", "material_index", "hide", "select")),
        (mesh.corner_normals, ("vector",)),
    ):
        for field in fields:
            if hasattr(collection[0], field) if len(collection) else False:
                found[f"{path}.{collection[0].bl_rna.identifier}.{field}"] = _bulk(collection, field)
    for layers in (mesh.uv_layers, mesh.color_attributes):
        kind = layers.bl_rna.identifier
        found[f"{path}.{kind}"] = [(layer.name, getattr(layer, "active_render", None)) for layer in layers]
        found[f"{path}.{kind}.active"] = layers.active and layers.active.name
    found[f"{path}.weights"] = [[(g.group, g.weight) for g in v.groups] for v in mesh.vertices]
    return found


def _bulk(collection, field):
    """Return one field of all items, as a tuple of its values, exact as they are."""
    if len(collection) == 0:
        return ()
    first = getattr(collection[0], field)
    if isinstance(first, str | bytes):
        return tuple(getattr(item, field) for item in collection)
    if hasattr(first, "__len__") and hasattr(first[0], "__len__"):
        return tuple(repr([tuple(row) for row in getattr(item, field)]) for item in collection)
    width = len(first) if hasattr(first, "__len__") else 1
    first = first[0] if hasattr(first, "__len__") else first
    dtype = bool if isinstance(first, bool) else np.int32 if isinstance(first, int) else np.float32
    values = np.empty(len(collection) * width, dtype)
    try:
        collection.foreach_get(field, values)
    except (RuntimeError, TypeError):
        return tuple(repr(getattr(item, field)) for item in collection)
    return (values.tobytes(),)
