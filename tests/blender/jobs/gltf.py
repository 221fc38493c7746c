# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""glTF read by Blender's own importer."""

from __future__ import annotations

import bpy


def read(file: str) -> dict:
    """Materials as their Principled shaders have them, and sizes of the meshes."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=file)
    materials = {}
    for material in bpy.data.materials:
        shader = next(
            (node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED"), None
        )
        if shader is None:
            continue
        value = {socket.name: socket.default_value for socket in shader.inputs}
        materials[material.name] = {
            "base_color": list(value["Base Color"]),
            "metallic": value["Metallic"],
            "roughness": value["Roughness"],
            "ior": value["IOR"],
            "transmission": value["Transmission Weight"],
            "extras": material.get("nacre").to_dict(),
        }
    meshes = {
        thing.name: {"vertices": len(thing.data.vertices), "size": list(thing.dimensions)}
        for thing in bpy.data.objects
        if thing.type == "MESH"
    }
    return {"materials": materials, "meshes": meshes}
