# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Parallel rays through a wedge of glass, inside Blender.

A job: material, apex_deg, incidence_deg, line_nm, samples, file and `world`, an OSL shader that says
what each direction of the world is worth; its parameter `line_nm` is set. `space`: of the file, if not
what it has; returned is the matrix to XYZ.
"""

from __future__ import annotations

import hashlib
import math
import tempfile
from pathlib import Path

import _cycles
import bpy
from mathutils import Matrix, Vector

from . import extension
from .furnace import film
from .pictures import empty_scene, render_picture

THICKNESS = 2.0  # along the middle ray


def face(scene: bpy.types.Scene, middle: Vector, tilt: float, up: bool) -> bpy.types.Object:
    """A square, turned about the y axis, whose outer side is up or down."""
    corners = [(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)]
    data = bpy.data.meshes.new("Face")
    data.from_pydata(corners, [], [(0, 1, 2, 3) if up else (3, 2, 1, 0)])
    item = bpy.data.objects.new("Face", data)
    item.matrix_world = Matrix.Translation(middle) @ Matrix.Rotation(tilt, 4, "Y")
    scene.collection.objects.link(item)
    return item


def add_camera(scene: bpy.types.Scene) -> None:
    data = bpy.data.cameras.new("Camera")
    data.type, data.ortho_scale = "ORTHO", 0.1
    scene.camera = bpy.data.objects.new("Camera", data)
    scene.camera.location = (0.0, 0.0, 4.0)
    scene.collection.objects.link(scene.camera)


def bytecode(source: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        osl, oso = Path(folder, "world.osl"), Path(folder, "world.oso")
        osl.write_text(source, "utf-8")
        assert _cycles.osl_compile(str(osl), str(oso)), "the world does not compile"
        return oso.read_text("utf-8")


def light(scene: bpy.types.Scene, source: str, line_nm: float) -> None:
    """A script's colour as the background; a script's own background closure stays black."""
    world = scene.world = bpy.data.worlds.new("World")
    world.use_nodes = True
    # Nothing samples it; a map of where it is bright would take seconds.
    world.cycles.sampling_method = "NONE"
    background = next(node for node in world.node_tree.nodes if node.type == "BACKGROUND")
    node = world.node_tree.nodes.new("ShaderNodeScript")
    node.mode = "INTERNAL"
    node.bytecode = bytecode(source)
    node.bytecode_hash = hashlib.md5(node.bytecode.encode()).hexdigest()
    node.inputs.new(type="NodeSocketFloat", name="line_nm", identifier="line_nm")
    node.inputs[0].default_value = line_nm
    node.outputs.new(type="NodeSocketColor", name="value", identifier="value")
    world.node_tree.links.new(node.outputs[0], background.inputs["Color"])


def wedge_of(
    scene: bpy.types.Scene, material: bpy.types.Material, apex_deg: float, incidence_deg: float
) -> None:
    """Its upper face meets light that falls along -z at that angle."""
    incidence, apex = math.radians(incidence_deg), math.radians(apex_deg)
    for item in (
        face(scene, Vector((0, 0, 0)), incidence, up=True),
        face(scene, Vector((0, 0, -THICKNESS)), incidence - apex, up=False),
    ):
        item.data.materials.append(material)


def render(**job) -> list[list[float]]:
    scene = empty_scene(job.get("space", ""))
    material = film(scene, {"material": job["material"], "form": "osl", "values": {}})
    wedge_of(scene, material, job["apex_deg"], job["incidence_deg"])
    light(scene, job["world"], job["line_nm"])
    add_camera(scene)
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    render_picture(scene, 4, 4, job["samples"], job["file"])
    return extension.space_to_xyz()
