# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Files as users have them: Blender's first scene, each with one thing that a picture can stumble over."""

from __future__ import annotations

from pathlib import Path

import bpy

from . import extension


def make(kind: str, file: str) -> None:
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = 16
    scene.view_settings.view_transform = "Standard"
    _KINDS[kind](scene, Path(file))
    bpy.ops.wm.save_as_mainfile(filepath=file)


def _cube() -> bpy.types.Object:
    return bpy.data.objects["Cube"]


def plain(_scene, _file) -> None:
    pass


def stereo(scene, _file) -> None:
    scene.render.use_multiview = True


def anaglyph(scene, _file) -> None:
    scene.render.use_multiview = True
    scene.render.image_settings.views_format = "STEREO_3D"


def strip(scene, _file) -> None:
    editor = scene.sequence_editor_create()
    editor.strips.new_effect("red", "COLOR", 1, 1, **_LENGTH).color = (1.0, 0.0, 0.0)


_LENGTH = {"length": 9} if bpy.app.version >= (5, 0) else {"frame_end": 10}


def _compositor(scene) -> tuple[bpy.types.NodeTree, bpy.types.Node]:
    if hasattr(scene, "compositing_node_group"):
        tree = scene.compositing_node_group = bpy.data.node_groups.new("C", "CompositorNodeTree")
    else:
        scene.use_nodes = True
        tree = scene.node_tree
        tree.nodes.clear()
    return tree, tree.nodes.new("CompositorNodeRLayers")


def compositor_without_output(scene, _file) -> None:
    _compositor(scene)


def compositor(scene, _file) -> None:
    _compositor_with_output(scene)


def _compositor_with_output(scene) -> tuple[bpy.types.NodeTree, bpy.types.Node]:
    tree, layers = _compositor(scene)
    if hasattr(scene, "compositing_node_group"):
        tree.interface.new_socket(name="Image", in_out="OUTPUT", socket_type="NodeSocketColor")
        output = tree.nodes.new("NodeGroupOutput")
    else:
        output = tree.nodes.new("CompositorNodeComposite")
    tree.links.new(layers.outputs["Image"], output.inputs[0])
    return tree, layers


def file_output(scene, file) -> None:
    tree, layers = _compositor_with_output(scene)
    _write_files(tree, layers, file)


def file_output_alone(scene, file) -> None:
    tree, layers = _compositor(scene)
    _write_files(tree, layers, file)


def _write_files(tree: bpy.types.NodeTree, layers: bpy.types.Node, file: Path) -> None:
    node = tree.nodes.new("CompositorNodeOutputFile")
    if hasattr(node, "directory"):
        node.directory = str(file.parent / "others")
        node.file_output_items.new("RGBA", "Image")
    else:
        node.base_path = str(file.parent / "others")
    tree.links.new(layers.outputs["Image"], node.inputs[0])


def border(scene, _file) -> None:
    render = scene.render
    render.use_border = render.use_crop_to_border = True
    render.border_min_x, render.border_max_x, render.border_max_y = 0.25, 0.75, 0.5


def no_layer(scene, _file) -> None:
    scene.view_layers[0].use = False


def second_layer(scene, _file) -> None:
    scene.view_layers.new("Second")
    scene.view_layers[0].use = False


def layer_samples(scene, _file) -> None:
    scene.view_layers[0].samples = 50


def override(scene, _file) -> None:
    scene.view_layers[0].material_override = bpy.data.materials.new("Clay")


def no_camera(scene, _file) -> None:
    bpy.data.objects.remove(scene.camera)


def scenes(scene, _file) -> None:
    other = bpy.data.scenes.new("Other")
    far = bpy.data.objects.new("Far", bpy.data.meshes.new("Far"))
    other.collection.objects.link(far)
    # The same picture is in a scene that the file does not open with.
    copy = scene.copy()
    copy.name = "Shot"
    copy.use_fake_user = True


def no_slots(_scene, _file) -> None:
    _cube().data.materials.clear()


def slot_of_object(_scene, _file) -> None:
    _cube().material_slots[0].link = "OBJECT"


def two_slots(_scene, _file) -> None:
    _cube().data.materials.append(bpy.data.materials.new("Lid"))
    for face in list(_cube().data.polygons)[:3]:
        face.material_index = 1


def _twin(scene, *, shared: bool) -> None:
    """A second cube, black; it has to stay so where it shares the mesh."""
    black = bpy.data.materials.new("Black")
    black.use_nodes = True
    black.node_tree.nodes.clear()
    black.node_tree.nodes.new("ShaderNodeOutputMaterial")
    second = _cube().copy()
    if not shared:
        second.data = _cube().data.copy()
    second.data.materials.clear()
    second.data.materials.append(black)
    second.name = "Twin"
    second.location.x = 2.5
    scene.collection.objects.link(second)


def shared(scene, _file) -> None:
    _twin(scene, shared=True)


def not_shared(scene, _file) -> None:
    _twin(scene, shared=False)


def _instance(scene, file: Path) -> None:
    """Nothing of its own but camera and light."""
    bpy.data.objects.remove(_cube())
    with bpy.data.libraries.load(str(file), link=True) as (_, wanted):
        wanted.collections = ["Collection"]
    linked = next(item for item in bpy.data.collections if item.library)
    for obj in linked.all_objects:
        if obj.type == "LIGHT":  # one is enough
            bpy.data.objects.remove(bpy.data.objects["Light", None])
    empty = bpy.data.objects.new("Instance", None)
    empty.instance_type, empty.instance_collection = "COLLECTION", linked
    scene.collection.objects.link(empty)


def linked(scene, file) -> None:
    _instance(scene, file.with_name("plain.blend"))


def linked_twins(scene, file) -> None:
    source = file.with_name("shared.blend")
    bpy.data.objects.remove(_cube())
    with bpy.data.libraries.load(str(source), link=True) as (_, wanted):
        wanted.objects = ["Cube", "Twin"]
    for obj in bpy.data.objects:
        if obj.library:
            scene.collection.objects.link(obj)


def ring(_scene, _file) -> None:
    _cube().name = "Ring"


def ball(scene, _file) -> None:
    """Under a white sky, fine enough that its faces are not seen."""
    _under_a_white_sky(scene)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128)
    bpy.ops.object.shade_smooth()
    bpy.context.object.name = "Ball"


def point(scene, _file) -> None:
    """The same as one point of a cloud, whose others are too small to be seen."""
    _under_a_white_sky(scene)
    bpy.ops.object.pointcloud_random_add()
    cloud = bpy.context.object
    cloud.name = "Ball"
    count = len(cloud.data.points)
    cloud.data.attributes["position"].data.foreach_set("vector", [0.0] * 3 * count)
    cloud.data.attributes["radius"].data.foreach_set("value", [1.0] + [1e-4] * (count - 1))


def _under_a_white_sky(scene) -> None:
    bpy.data.objects.remove(_cube())
    background = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)


def _wave_material(form: str, name: str = "test_film") -> bpy.types.NodeTree:
    """Its group; the material is on the cube."""
    compiled = extension.module("core.library").Library.default().load(name)
    materials = extension.module("materials.material")
    material = materials.create_material(compiled, form)
    _cube().material_slots[0].material = material
    return materials.group_node(material).node_tree


def broken_shader(_scene, _file) -> None:
    tree = _wave_material("osl")
    script = next(node for node in tree.nodes if node.type == "SCRIPT")
    script.bytecode = script.bytecode.replace("code ___main___", 'code ___main___ "', 1)
    script.bytecode_hash = "0123456789abcdef0123456789abcdef"


def off(_scene, _file) -> None:
    _wave_material("osl")


def dispersed(_scene, _file) -> None:
    _wave_material("osl", "test_grating")


def no_table(_scene, _file) -> None:
    tree = _wave_material("nodes")
    next(node for node in tree.nodes if node.type == "TEX_IMAGE").image = None


_KINDS = {
    kind.__name__: kind
    for kind in (
        plain, stereo, anaglyph, strip, compositor_without_output, compositor, file_output,
        file_output_alone, border, no_layer, second_layer, layer_samples, override, no_camera, scenes,
        no_slots, slot_of_object, two_slots, shared, not_shared, linked, linked_twins, broken_shader,
        no_table, off, dispersed, ring, ball, point,
    )
}  # fmt: skip
