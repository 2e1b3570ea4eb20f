# SPDX-License-Identifier: MIT OR Apache-2.0
"""Objects with everything on them that artists put on objects, and the examples: each builds itself into an
empty file, active.
"""

import importlib
import sys
from pathlib import Path

import addon_blender as blender
from addon_blender import bpy

sys.path.insert(0, str(Path(__file__).parents[2]))


def example(name):
    return lambda: importlib.import_module(f"examples.{name}").build()


def ngons():
    return blender.mushroom()


def loose_edges_and_vertices():
    obj = blender.chair()
    mesh = obj.data
    mesh.vertices.add(3)
    mesh.edges.add(1)
    mesh.edges[-1].vertices = (len(mesh.vertices) - 1, len(mesh.vertices) - 2)
    mesh.update()
    return obj


def open_shells():
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1)]
    corners = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0, 2)]
    return blender.add("Shell", corners, sides)


def faces_without_area():
    obj = blender.mushroom()
    faces = [tuple(polygon.vertices) for polygon in obj.data.polygons]
    vertices = [tuple(vertex.co) for vertex in obj.data.vertices]
    bpy.data.objects.remove(obj)
    n = len(vertices)
    vertices += [(0, 0, 1.2), (0.1, 0, 1.2), (0.2, 0, 1.2), (0, 0, 0), (0, 0, 0), (0, 0, 0)]
    return blender.add("Flat", vertices, [*faces, (n, n + 1, n + 2), (n + 3, n + 4, n + 5)])


def materials():
    """Several, one of them twice, one slot empty, two linked to the object."""
    obj = blender.chair()
    paint = bpy.data.materials.new("Paint")
    obj.data.materials.append(None)
    obj.data.materials.append(obj.data.materials[0])
    obj.material_slots[0].link = "OBJECT"
    obj.material_slots[0].material = paint
    obj.material_slots[2].link = "OBJECT"
    obj.active_material_index = 2
    return obj


def uv_maps():
    obj = blender.chair()
    layers = obj.data.uv_layers
    for name in ("Lightmap", "Détail"):
        layer = layers.new(name=name)
        for index, item in enumerate(layer.data):
            item.uv = (index % 11 / 3, -index % 13 / 7)
    layers.active_index = 1
    layers["Détail"].active_render = True
    return obj


def colors():
    obj = blender.chair()
    colors = obj.data.color_attributes
    for kind in ("BYTE_COLOR", "FLOAT_COLOR"):
        for domain in ("POINT", "CORNER"):
            layer = colors.new(f"{kind} {domain}", kind, domain)
            for index, item in enumerate(layer.data):
                item.color = (index % 7 / 6, index % 5 / 4, index % 3 / 2, 0.5)
    colors.active_color_index = 3
    colors.render_color_index = 2
    return obj


def custom_normals():
    obj = blender.chair()
    obj.data.normals_split_custom_set([(0.6, (i % 3 - 1) * 0.1, 0.8) for i in range(len(obj.data.loops))])
    return obj


def marks():
    """Sharp, seam, crease, bevel weight, freestyle."""
    obj = blender.chair()
    mesh = obj.data
    for edge in mesh.edges:
        edge.use_edge_sharp, edge.use_seam = edge.index % 2 == 0, edge.index % 3 == 0
        if hasattr(edge, "use_freestyle_mark"):
            edge.use_freestyle_mark = edge.index % 5 == 0
    for polygon in mesh.polygons:
        if hasattr(polygon, "use_freestyle_mark"):
            polygon.use_freestyle_mark = polygon.index % 2 == 0
    for name, domain in (
        ("crease_vert", "POINT"),
        ("bevel_weight_vert", "POINT"),
        ("bevel_weight_edge", "EDGE"),
    ):
        for index, item in enumerate(mesh.attributes.new(name, "FLOAT", domain).data):
            item.value = index % 4 / 3
    return obj


def vertex_groups():
    obj = blender.chair()
    for name, weight in (("Leg", 0.3), ("Sitz “oben”", 1.0), ("Empty", None), ("Null", 0.0)):
        group = obj.vertex_groups.new(name=name)
        if weight is not None:
            group.add(range(4, 40, 3), weight, "REPLACE")
    obj.vertex_groups["Leg"].lock_weight = True
    obj.vertex_groups.active_index = 2
    return obj


def attributes():
    """Of every type on every domain that Blender has for meshes."""
    obj = blender.chair()
    kinds = bpy.types.Attribute.bl_rna.properties["data_type"].enum_items.keys()
    for kind in kinds:
        for domain in ("POINT", "EDGE", "FACE", "CORNER"):
            try:
                layer = obj.data.attributes.new(f"{kind} {domain}", kind, domain)
            except (RuntimeError, TypeError):
                continue
            if layer is None:
                continue
            for index, item in enumerate(layer.data):
                if kind in ("FLOAT", "INT", "INT8"):
                    item.value = index % 100
                elif kind == "STRING":
                    item.value = f"{index}".encode()
                elif kind in ("FLOAT_VECTOR", "FLOAT2"):
                    item.vector = [index * 0.1] * len(item.vector)
    assert len(obj.data.attributes) > 40
    return obj


def shape_keys():
    """Values, limits, mute, groups, other relative keys, a driver, an action, a name like ours."""
    obj = blender.chair()
    obj.shape_key_add(name="Basis")
    for index, name in enumerate(("Wide", "Tall", "a bar stool", "Driven", 'Quo"ted')):
        key = obj.shape_key_add(name=name, from_mix=False)
        for point in key.points:
            point.co *= 1.0 + 0.1 * index
        key.slider_min, key.slider_max = -0.5 * index, 1.5 + index
        key.value = 0.25 * index
    keys = obj.data.shape_keys.key_blocks
    keys["Tall"].relative_key = keys["Wide"]
    keys["Tall"].mute = True
    keys["Wide"].vertex_group = "Seat"
    keys["Wide"].interpolation = "KEY_BSPLINE"
    obj["amount"] = 0.3
    variable = keys["Driven"].driver_add("value").driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = obj, '["amount"]'
    for frame, value in ((1, 0.2), (7, 1.2), (20, -0.3)):
        keys['Quo"ted'].value = value
        keys['Quo"ted'].keyframe_insert("value", frame=frame)
    obj.active_shape_key_index = 2
    return obj


def pinned_key():
    obj = blender.chair()
    obj.shape_key_add(name="Rest")
    obj.shape_key_add(name="Other").points[0].co.x += 0.1
    obj.active_shape_key_index, obj.show_only_shape_key = 1, True
    return obj


def only_basis():
    obj = blender.chair()
    obj.shape_key_add(name="Basis")
    return obj


def parent_and_constraints():
    obj = blender.chair()
    empty = bpy.data.objects.new("Empty", None)
    bpy.context.scene.collection.objects.link(empty)
    empty.location, empty.scale = (1, 2, 3), (2, 2, 2)
    bpy.context.view_layer.update()
    obj.parent = empty
    obj.matrix_parent_inverse = empty.matrix_world.inverted()
    child = bpy.data.objects.new("Child", bpy.data.meshes.new("Child"))
    bpy.context.scene.collection.objects.link(child)
    child.parent = obj
    constraint = obj.constraints.new("COPY_LOCATION")
    constraint.target, constraint.influence = empty, 0.3
    return obj


def armature():
    obj = blender.chair()
    rig = bpy.data.objects.new("Rig", bpy.data.armatures.new("Rig"))
    bpy.context.scene.collection.objects.link(rig)
    blender.activate(rig)
    bpy.ops.object.mode_set(mode="EDIT")
    bone = rig.data.edit_bones.new("Seat")
    bone.head, bone.tail = (0, 0, 0), (0, 0, 1)
    bpy.ops.object.mode_set(mode="OBJECT")
    rig.pose.bones["Seat"].rotation_mode = "XYZ"
    rig.pose.bones["Seat"].rotation_euler.x = 0.4
    modifier = obj.modifiers.new("Armature", "ARMATURE")
    modifier.object = rig
    return blender.activate(obj)


def modifiers():
    """Shown and hidden, one of them driven, one posing."""
    obj = blender.chair(half=True)
    obj.modifiers.new("Bend", "SIMPLE_DEFORM").angle = 0.3
    obj.modifiers.new("Hidden", "BEVEL").show_viewport = False
    obj["wide"] = 0.01
    solid = obj.modifiers.new("Solid", "SOLIDIFY")
    variable = solid.driver_add("thickness").driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = obj, '["wide"]'
    return obj


def hidden_and_selected():
    obj = blender.chair()
    for polygon in obj.data.polygons:
        polygon.hide, polygon.select = polygon.index % 4 == 0, polygon.index % 3 == 0
    for vertex in obj.data.vertices:
        vertex.hide, vertex.select = vertex.index % 5 == 0, vertex.index % 2 == 0
    for edge in obj.data.edges:
        edge.hide = edge.index % 7 == 0
    obj.data.polygons.active = 5
    return obj


def custom_properties():
    obj = blender.chair()
    for block in (obj, obj.data, obj.data.materials[0]):
        block["number"], block["list"], block["text"] = 3, [0.5, 1.5], "“é”"
        block["group"] = {"a": 1, "b": {"c": 2.5}}
    obj.id_properties_ui("number").update(min=0, max=7, description="how many")
    return obj


def several_users():
    obj = blender.chair()
    for index in range(2):
        other = bpy.data.objects.new("Other", obj.data)
        other.location.x = index + 1
        bpy.context.scene.collection.objects.link(other)
    obj.data.use_fake_user = True
    return obj


def mirrored_by_scale():
    obj = blender.chair()
    obj.scale, obj.rotation_euler = (-1.0, 1.5, 0.7), (0.1, 0.2, 2.0)
    obj.delta_scale.x = 2.0
    bpy.context.view_layer.update()
    return obj


def animated_object():
    obj = blender.chair()
    for frame, x in ((1, 0.0), (20, 3.0)):
        obj.location.x = x
        obj.keyframe_insert("location", frame=frame)
    track = obj.animation_data.nla_tracks.new()
    track.strips.new("Strip", 1, obj.animation_data.action)
    obj.keyframe_insert("hide_render", frame=1)
    bpy.context.scene.frame_set(7)
    return obj


def asset_in_collections():
    obj = blender.chair()
    obj.asset_mark()
    obj.asset_data.description, obj.asset_data.author = "A chair", "Someone"
    for name in ("Möbel", "Props"):
        collection = bpy.data.collections.new(name)
        bpy.context.scene.collection.children.link(collection)
        collection.objects.link(obj)
    obj.hide_render, obj.display_type, obj.color = True, "WIRE", (1, 0, 0, 1)
    return obj


def mesh_settings():
    obj = blender.chair()
    mesh = obj.data
    mesh.use_mirror_x = mesh.use_mirror_topology = True
    mesh.remesh_voxel_size, mesh.use_auto_texspace = 0.03, False
    mesh.texspace_size = (2, 3, 4)
    mesh.name, obj.name = "Stühle", 'A "chair"'
    return obj


def earlier_outcomes():
    """One of another prompt, keyframed, and its pieces; all at 0, as another search sets them."""
    obj = blender.chair()
    blender.deform("a sofa", splits="1")
    bpy.ops.boxmorph.take_apart()
    for key in obj.data.shape_keys.key_blocks[2:]:
        key.value = 0.0
    bpy.ops.boxmorph.keyframe_spectrum(key="a sofa", frame_to=9)
    return obj


OBJECTS = {name: example(name) for name in ("chair", "table", "aeroplane", "desk_lamp")} | {
    make.__name__: make
    for make in (
        ngons,
        loose_edges_and_vertices,
        open_shells,
        faces_without_area,
        materials,
        uv_maps,
        colors,
        custom_normals,
        marks,
        vertex_groups,
        attributes,
        shape_keys,
        pinned_key,
        only_basis,
        parent_and_constraints,
        armature,
        modifiers,
        hidden_and_selected,
        custom_properties,
        several_users,
        mirrored_by_scale,
        animated_object,
        asset_in_collections,
        mesh_settings,
        earlier_outcomes,
    )
}
