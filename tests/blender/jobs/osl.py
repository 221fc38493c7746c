# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""OSL compiled by Cycles and run in its renders; files go into the folder of the request."""

from __future__ import annotations

import hashlib
import math
import re
from pathlib import Path

import _cycles
import bpy
import numpy as np

SOCKETS = {
    "closure color": "NodeSocketShader",
    "color": "NodeSocketColor",
    "float": "NodeSocketFloat",
    "int": "NodeSocketInt",
    "string": "NodeSocketString",
    "normal": "NodeSocketVector",
    "vector": "NodeSocketVector",
}


def compile_osl(text: str, name: str) -> str:
    """The bytecode, as text."""
    source, target = Path(f"{name}.osl"), Path(f"{name}.oso")
    source.write_text(text, encoding="utf-8")
    if not _cycles.osl_compile(str(source), str(target)):
        raise ValueError(f"{name}: does not compile")
    return target.read_text(encoding="utf-8")


def script_node(tree, oso: str, values: dict):
    node = tree.nodes.new("ShaderNodeScript")
    node.mode = "INTERNAL"
    node.bytecode = oso
    node.bytecode_hash = hashlib.md5(oso.encode()).hexdigest()
    pattern = r"^(o?param)\t(closure color|\w+)\t(\w+)\t([^%\n]*)"
    for kind, osl_type, name, default in re.findall(pattern, oso, re.M):
        if osl_type not in SOCKETS:
            continue
        sockets = node.outputs if kind == "oparam" else node.inputs
        socket = sockets.new(type=SOCKETS[osl_type], name=name, identifier=name)
        if kind == "oparam" or osl_type == "normal":
            continue
        words = default.replace('"', "").split()
        if osl_type == "string":
            socket.default_value = values.get(name, words[0] if words else "")
        elif osl_type == "vector":
            socket.default_value = values.get(name, list(map(float, words[:3])))
        elif osl_type == "color":
            socket.default_value = [*values.get(name, map(float, words[:3])), 1.0]
        else:
            cast = int if osl_type == "int" else float
            socket.default_value = values.get(name, cast(words[0]))
    return node


def new_scene(width: int, height: int, samples: int):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.shading_system = True
    cycles.samples = samples
    cycles.seed = 7
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_indirect = 0.0
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = 64
    scene.render.resolution_x = width
    scene.render.resolution_y = height
    scene.render.threads_mode = "FIXED"
    scene.render.threads = 2
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    return scene


def camera_at(scene, location, rotation, ortho_scale):
    camera = bpy.data.cameras.new("Camera")
    camera.type = "ORTHO"
    camera.ortho_scale = ortho_scale
    scene.camera = bpy.data.objects.new("Camera", camera)
    scene.camera.location = location
    scene.camera.rotation_euler = rotation
    scene.collection.objects.link(scene.camera)


def material_from(osl: str, values: dict, coordinates: str = ""):
    """`coordinates`: the input that gets the mesh's UV."""
    material = bpy.data.materials.new("Probe")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    node = script_node(tree, compile_osl(osl, "probe"), values)
    tree.links.new(node.outputs[0], output.inputs["Surface"])
    if coordinates:
        source = tree.nodes.new("ShaderNodeTexCoord")
        tree.links.new(source.outputs["UV"], node.inputs[coordinates])
    return material


def pixels_of(scene) -> np.ndarray:
    path = Path("render.exr").absolute()
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    values = np.empty(width * height * 4, dtype=np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(height, width, 4)[::-1, :, :3]


def saved(pixels: np.ndarray) -> str:
    """A file with them."""
    path = Path("pixels.npy").absolute()
    np.save(path, pixels)
    return str(path)


def compile_all(shaders: dict[str, str]) -> dict[str, str]:
    """The bytecode of each text, by name."""
    return {name: compile_osl(text, name) for name, text in shaders.items()}


def values(osl: str, count: int) -> str:
    """One column for each value: unit squares along x, seen from above; 4 pixels is Blender's least."""
    columns = max(count, 4)
    scene = new_scene(columns, 4, samples=1)
    mesh = bpy.data.meshes.new("Strip")
    corners = [(0, -2, 0), (columns, -2, 0), (columns, 2, 0), (0, 2, 0)]
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    mesh.materials.append(material_from(osl, {}))
    scene.collection.objects.link(bpy.data.objects.new("Strip", mesh))
    camera_at(scene, (columns / 2, 0, 5), (0, 0, 0), ortho_scale=columns)
    return saved(pixels_of(scene)[0, :count])


def write_table(rows: list) -> str:
    """An EXR; row 0 of `rows` is the top. No two tables have one name: Cycles keeps textures."""
    rows = np.asarray(rows, dtype=np.float32)
    height, width, _ = rows.shape
    pixels = np.ones((height, width, 4), dtype=np.float32)
    pixels[..., :3] = rows[::-1]
    image = bpy.data.images.new("Table", width, height, float_buffer=True, is_data=True)
    image.pixels.foreach_set(pixels.ravel())
    image.file_format = "OPEN_EXR"
    name = hashlib.md5(pixels.tobytes()).hexdigest()
    image.filepath_raw = str(Path(f"{name}.exr").absolute())
    image.save()
    return image.filepath_raw


def add_sphere(scene, material, offset=(0, 0, 0), radius=1.0):
    bpy.ops.mesh.primitive_uv_sphere_add(
        segments=128, ring_count=64, radius=radius, location=offset
    )
    sphere = bpy.context.object
    sphere.data.polygons.foreach_set("use_smooth", [True] * len(sphere.data.polygons))
    sphere.data.materials.append(material)


def add_disc(scene, material):
    bpy.ops.mesh.primitive_circle_add(vertices=256, radius=1.0, fill_type="NGON")
    bpy.context.object.data.materials.append(material)


def add_sun(scene, energy: float, angle: float, polar: float, azimuth: float):
    data = bpy.data.lights.new("Lamp", "SUN")
    data.energy, data.angle = energy, angle
    sun = bpy.data.objects.new("Lamp", data)
    sun.rotation_euler = (polar, 0.0, azimuth)
    scene.collection.objects.link(sun)


def render(
    osl: str,
    object: str,
    width: int,
    height: int,
    samples: int,
    *,
    values: dict | None = None,
    coordinates: str = "",
    world: float = 1.0,
    motion_blur: bool = True,
    offsets: tuple | list = ((0, 0, 0),),
    radius: float = 1.0,
    ball: dict | None = None,
    lamps: tuple | list = (),
    tilt: float = 0.0,
    span: float = 2.0,
) -> str:
    """A disc or spheres under a white world, or under lamps in the dark, with a wavelength per path."""
    scene = new_scene(width, height, samples)
    scene.render.use_motion_blur = motion_blur
    scene.render.motion_blur_shutter = 0.0
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = world
    material = material_from(osl, values or {}, coordinates)
    if object == "disc":
        add_disc(scene, material)
    else:
        for offset in offsets:
            add_sphere(scene, material, offset, radius)
    if ball:
        add_sphere(
            scene, material_from(ball["osl"], ball["values"]), ball["offset"], ball["radius"]
        )
    for lamp in lamps:
        add_sun(scene, **lamp)
    location = (0.0, -5.0 * math.sin(tilt), 5.0 * math.cos(tilt))
    camera_at(scene, location, (tilt, 0.0, 0.0), ortho_scale=span)
    return saved(pixels_of(scene))
