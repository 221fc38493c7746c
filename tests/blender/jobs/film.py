# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""One film on the furnace sphere by several shaders, inside Blender.

A job: shader (`blender`, `live` or `table`), film_n, substrate ([n, k]), thickness_nm and file; `live`
has `osl`, the text of nacre_thin_film; `table` has `material` and `thickness_socket`. Where Blender's
shader for the substrate has no film, the picture is -1.
"""

from __future__ import annotations

from types import SimpleNamespace

import bpy

from . import extension
from .pictures import render_picture

SIZE = 24


def empty_material(node_type: str) -> tuple:
    """Material, a node of the type, the output node."""
    material = bpy.data.materials.new("Film")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    return material, tree.nodes.new(node_type), output


def connect(material: bpy.types.Material, node, output) -> bpy.types.Material:
    material.node_tree.links.new(node.outputs[0], output.inputs["Surface"])
    return material


def blender_film(job: dict) -> bpy.types.Material | None:
    """Principled on a black dielectric; Metallic with its physical conductor on a metal."""
    n, k = job["substrate"]
    metal = k > 0
    material, node, output = empty_material(
        "ShaderNodeBsdfMetallic" if metal else "ShaderNodeBsdfPrincipled"
    )
    if "Thin Film Thickness" not in node.inputs:
        return None
    if metal:
        node.fresnel_type = "PHYSICAL_CONDUCTOR"
        values = {"IOR": (n, n, n), "Extinction": (k, k, k)}
    else:
        values = {"Base Color": (0.0, 0.0, 0.0, 1.0), "IOR": n}
    values |= {
        "Roughness": 0.0,
        "Thin Film Thickness": job["thickness_nm"],
        "Thin Film IOR": job["film_n"],
    }
    for name, value in values.items():
        node.inputs[name].default_value = value
    return connect(material, node, output)


def live_film(job: dict, script) -> bpy.types.Material:
    material, node, output = empty_material("ShaderNodeScript")
    script.fill_script_node(
        node, SimpleNamespace(id="nacre_thin_film", osl=job["osl"], bytecode=None)
    )
    n, k = job["substrate"]
    values = {
        "thickness_nm": job["thickness_nm"],
        "film_n": job["film_n"],
        "substrate_n": n,
        "substrate_k": k,
    }
    for socket in node.inputs:
        if socket.identifier in values:
            socket.default_value = values.pop(socket.identifier)
    assert not values, values
    return connect(material, node, output)


def render(**job) -> None:
    stage = extension.module("background.scenes").build_stage("furnace")
    scene = stage.scene
    if job["shader"] == "blender":
        material = blender_film(job)
    elif job["shader"] == "live":
        material = live_film(job, extension.module("materials.script"))
        extension.module("materials.scene").use_osl(scene)
    else:
        compiled = extension.module("core.library").Library.default().load(job["material"])
        material = extension.module("materials.material").create_material(compiled, "nodes")
        values = {job["thickness_socket"]: job["thickness_nm"], "roughness": 0.0}
        extension.module("materials.material").set_values(material, values)
    if material is None:
        scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = -1.0
    else:
        stage.place(material)
    # One sample, at the centre of a pixel, where the truth is evaluated.
    render_picture(scene, SIZE, SIZE, 1, job["file"])
