# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the example scenes share: light, backdrop, camera, and the extension's own operator.

A scene script builds its objects, dresses them with `wave_material`, and saves a .blend that needs
nothing else: the shader's bytecode is embedded and the tables are packed.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy
from mathutils import Vector

EXTENSION = "bl_ext.user_default.nacre"
LABELS = {"thickness_nm": "Film Thickness (nm)", "roughness": "Roughness"}


def new_scene(
    environment: str,
    *,
    strength: float = 1.0,
    turn_deg: float = 0.0,
    exposure: float = 0.0,
    bounces: int = 6,
) -> bpy.types.Scene:
    """An empty scene lit by one of the environments that come with Blender (CC0).

    Six `bounces` do for opaque things; cut glass wants more.
    """
    import addon_utils  # in reach once bpy is imported

    bpy.ops.wm.read_factory_settings(use_empty=True)
    if addon_utils.enable(EXTENSION) is None:
        sys.exit(f"{EXTENSION} is not installed; `./dev demo` installs it")
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.max_bounces = scene.cycles.transmission_bounces = bounces
    scene.cycles.diffuse_bounces = 2
    scene.view_settings.view_transform = "AgX"
    scene.view_settings.look = "AgX - Medium High Contrast"
    scene.view_settings.exposure = exposure
    world = bpy.data.worlds.new("World")
    scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    image = nodes.new("ShaderNodeTexEnvironment")
    folder = Path(bpy.utils.system_resource("DATAFILES")) / "studiolights" / "world"
    image.image = bpy.data.images.load(str(folder / f"{environment}.exr"))
    mapping = nodes.new("ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value[2] = math.radians(turn_deg)
    coordinates = nodes.new("ShaderNodeTexCoord")
    links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], image.inputs["Vector"])
    links.new(image.outputs["Color"], nodes["Background"].inputs["Color"])
    nodes["Background"].inputs["Strength"].default_value = strength
    return scene


def camera(
    eye: tuple[float, float, float],
    target: tuple[float, float, float],
    *,
    lens_mm: float = 85.0,
    f_stop: float | None = None,
) -> None:
    """A camera at `eye` that looks at `target` and, with `f_stop`, is focused on it."""
    data = bpy.data.cameras.new("Camera")
    data.lens = lens_mm
    if f_stop is not None:
        data.dof.use_dof = True
        data.dof.aperture_fstop = f_stop
        data.dof.focus_distance = (Vector(target) - Vector(eye)).length
    obj = bpy.data.objects.new("Camera", data)
    aim(obj, eye, target)
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.scene.camera = obj


def lamp(
    location: tuple[float, float, float],
    target: tuple[float, float, float],
    *,
    size: float,
    watts: float,
    colour: tuple[float, float, float] = (1.0, 1.0, 1.0),
    name: str = "Lamp",
) -> bpy.types.Object:
    """A round area lamp."""
    data = bpy.data.lights.new(name, "AREA")
    data.shape = "DISK"
    data.size, data.energy, data.color = size, watts, colour
    obj = bpy.data.objects.new(name, data)
    aim(obj, location, target)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def aim(
    obj: bpy.types.Object,
    location: tuple[float, float, float],
    target: tuple[float, float, float],
) -> None:
    obj.location = location
    direction = Vector(target) - Vector(location)
    obj.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()


def backdrop(colour: tuple[float, float, float], *, roughness: float = 0.5, depth: float = 6.0):
    """A floor that bends up into a wall behind the scene."""
    bend, height, half_width = 2.0, 8.0, 14.0
    profile = [(-8.0, 0.0), (depth - bend, 0.0)]
    for step in range(1, 16):
        angle = math.pi / 2.0 * step / 16
        profile.append((depth - bend + bend * math.sin(angle), bend - bend * math.cos(angle)))
    profile += [(depth, bend), (depth, height)]
    vertices = [(x, y, z) for y, z in profile for x in (-half_width, half_width)]
    faces = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(len(profile) - 1)]
    obj = mesh_object("Backdrop", vertices, faces)
    obj.data.materials.append(plain_material("Backdrop", colour, roughness=roughness))
    return obj


def ring_faces(rings: int, segments: int) -> list[tuple[int, ...]]:
    """Of a point in the middle, the first vertex, and rings around it."""
    faces: list[tuple[int, ...]] = [(0, 1 + i, 1 + (i + 1) % segments) for i in range(segments)]
    for ring in range(rings - 1):
        a, b = 1 + ring * segments, 1 + (ring + 1) * segments
        for i in range(segments):
            j = (i + 1) % segments
            faces.append((a + i, b + i, b + j, a + j))
    return faces


def mesh_object(name: str, vertices, faces, *, smooth: bool = True) -> bpy.types.Object:
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    if smooth:
        mesh.shade_smooth()
    mesh.validate()
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def lathe(name: str, profile, *, segments: int = 128, closed: bool = False) -> bpy.types.Object:
    """The surface that `profile`, points (radius, z), sweeps around the z axis."""
    vertices, faces = [], []
    for turn in range(segments):
        angle = math.tau * turn / segments
        vertices += [(r * math.cos(angle), r * math.sin(angle), z) for r, z in profile]
    count = len(profile)
    for turn in range(segments):
        here, there = turn * count, (turn + 1) % segments * count
        for i in range(count if closed else count - 1):
            j = (i + 1) % count
            faces.append((here + i, there + i, there + j, here + j))
    return mesh_object(name, vertices, faces)


def plain_material(
    name: str, colour: tuple[float, float, float], *, roughness: float = 0.5, metallic: float = 0.0
) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    return material


def bump(material: bpy.types.Material, *, scale: float, strength: float, distance_m: float) -> None:
    """Noise in the shading normal of a plain material."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    noise = nodes.new("ShaderNodeTexNoise")
    noise.inputs["Scale"].default_value = scale
    noise.inputs["Detail"].default_value = 6.0
    node = nodes.new("ShaderNodeBump")
    node.inputs["Strength"].default_value = strength
    node.inputs["Distance"].default_value = distance_m
    coordinates = nodes.new("ShaderNodeTexCoord")
    links.new(coordinates.outputs["Object"], noise.inputs["Vector"])
    links.new(noise.outputs["Fac"], node.inputs["Height"])
    links.new(node.outputs["Normal"], nodes["Principled BSDF"].inputs["Normal"])


def wave_material(obj: bpy.types.Object, material_id: str, **values: float) -> bpy.types.Node:
    """The extension's operator on `obj`; returns the group node that carries the sockets.

    Values go by name: `roughness`, `thickness_nm`.
    """
    with bpy.context.temp_override(object=obj, active_object=obj, selected_objects=[obj]):
        bpy.ops.nacre.assign_material(material=material_id)
    nodes = obj.active_material.node_tree.nodes
    node = next(node for node in nodes if node.type == "GROUP")
    for name, value in values.items():
        node.inputs[LABELS[name]].default_value = value
    return node


def thickness_field(
    obj: bpy.types.Object,
    node: bpy.types.Node,
    *,
    low_nm: float,
    high_nm: float,
    axis: str,
    swirl: float,
    swirl_scale: float,
) -> None:
    """Drives the thickness by position: a ramp along the object's `axis` (through its
    bounding box; none for "") plus `swirl` times warped noise of mean zero, both as parts of the
    range.
    """
    tree = obj.active_material.node_tree
    nodes, links = tree.nodes, tree.links
    coordinates = nodes.new("ShaderNodeTexCoord")
    warp = nodes.new("ShaderNodeTexNoise")
    warp.inputs["Scale"].default_value = swirl_scale
    warp.inputs["Detail"].default_value = 4.0
    warp.inputs["Distortion"].default_value = 1.8
    links.new(coordinates.outputs["Object"], warp.inputs["Vector"])
    share = nodes.new("ShaderNodeMath")
    share.operation = "MULTIPLY_ADD"
    links.new(warp.outputs["Fac"], share.inputs[0])
    # Noise lies around 0.5: without a ramp it is spread over the range, with one it is added.
    share.inputs[1].default_value = 2.0 * swirl
    share.inputs[2].default_value = -swirl + (0.0 if axis else 0.5)
    result = share.outputs[0]
    if axis:
        separate = nodes.new("ShaderNodeSeparateXYZ")
        links.new(coordinates.outputs["Generated"], separate.inputs[0])
        ramp = nodes.new("ShaderNodeMath")
        ramp.operation = "ADD"
        links.new(separate.outputs[axis], ramp.inputs[0])
        links.new(result, ramp.inputs[1])
        result = ramp.outputs[0]
    to_nm = nodes.new("ShaderNodeMapRange")
    to_nm.inputs["To Min"].default_value = low_nm
    to_nm.inputs["To Max"].default_value = high_nm
    links.new(result, to_nm.inputs["Value"])
    links.new(to_nm.outputs["Result"], node.inputs[LABELS["thickness_nm"]])


def save(path: str) -> None:
    """Everything that the scene needs travels inside the file."""
    bpy.ops.file.pack_all()
    bpy.ops.wm.save_as_mainfile(filepath=str(Path(path).resolve()), compress=True)
