# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Imports a glTF with Blender's own importer: python read_gltf.py FILE; prints JSON."""

import json
import sys

import bpy


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=sys.argv[1])
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
    print("JSON" + json.dumps({"materials": materials, "meshes": meshes}))


main()
