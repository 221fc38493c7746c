# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The colours that a compiled surface of tables hands to its lobes, at many inputs at once.

Each pixel shows one face of its own, which has the inputs as attributes; the lobes are replaced by light
of their colours.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

from . import extension
from .osl import camera_at, new_scene, pixels_of, saved

# Colours may be negative, light may not.
OFFSET = 4.0
# Colours of the shader, and the nodes whose colours these are.
LOBES = {"R": "reflection", "T": "transmission", "base": "matt"}


def shown(osl: str, colour: str) -> str:
    """The shader, which in the end shines in one of its colours."""
    end = osl.rindex("}")
    return osl[:end] + f"    BSDF = ({colour} + {OFFSET}) * emission();\n" + osl[end:]


def _shine(group: bpy.types.NodeTree, colour: str) -> None:
    """The same of a group of nodes."""
    lobe = group.nodes[LOBES[colour]]
    (link,) = lobe.inputs["Color"].links
    add = group.nodes.new("ShaderNodeVectorMath")
    add.operation = "ADD"
    add.inputs[1].default_value = (OFFSET, OFFSET, OFFSET)
    group.links.new(link.from_socket, add.inputs[0])
    light = group.nodes.new("ShaderNodeEmission")
    group.links.new(add.outputs[0], light.inputs["Color"])
    output = next(node for node in group.nodes if node.type == "GROUP_OUTPUT")
    group.links.new(light.outputs[0], output.inputs["BSDF"])


def _material(folder: str, form: str, colour: str) -> bpy.types.Material:
    compiled = extension.module("core.manifest").load_folder(Path(folder))
    make = extension.module("materials.material").create_material
    if form == "osl":
        made = make(replace(compiled, osl=shown(compiled.osl, colour), bytecode=None), form)
        _read_files(made, folder)
        return made
    material = make(compiled, form)
    _shine(extension.module("materials.material").group_node(material).node_tree, colour)
    return material


def _read_files(material: bpy.types.Material, folder: str) -> None:
    """The shader looks its colours up by itself, in the files of its tables."""
    group = extension.module("materials.material").group_node(material).node_tree
    script = next(node for node in group.nodes if node.type == "SCRIPT")
    for socket in script.inputs:
        if socket.identifier.startswith("table_") and socket.type == "STRING":
            name = f"{Path(folder).name}_{socket.identifier.removeprefix('table_')}.exr"
            socket.default_value = str(Path(folder) / name)
        if socket.identifier == "table_origin_top":
            # Cycles changed the direction of t after 5.1.
            socket.default_value = int(bpy.app.version < (5, 2, 0))


def _faces(inputs: dict[str, np.ndarray], width: int, turned: np.ndarray) -> bpy.types.Mesh:
    """Unit squares, some with their back to the camera."""
    count = len(turned)
    corners, faces = [], []
    for i in range(count):
        x, y = i % width, i // width
        corners += [(x, y, 0), (x + 1, y, 0), (x + 1, y + 1, 0), (x, y + 1, 0)]
        order = range(4 * i, 4 * i + 4)
        faces.append(tuple(reversed(order)) if turned[i] else tuple(order))
    mesh = bpy.data.meshes.new("Faces")
    mesh.from_pydata(corners, [], faces)
    for name, values in inputs.items():
        if values.ndim == 1:
            mesh.attributes.new(name, "FLOAT", "FACE").data.foreach_set("value", values)
        else:
            mesh.attributes.new(name, "FLOAT_VECTOR", "FACE").data.foreach_set(
                "vector", values.ravel()
            )
    return mesh


def _link_inputs(material: bpy.types.Material, names: list[str]) -> None:
    tree = material.node_tree
    for name in names:
        socket = extension.module("materials.material").input_socket(material, name)
        node = tree.nodes.new("ShaderNodeAttribute")
        node.attribute_name = name
        output = "Fac" if socket.type in ("VALUE", "INT") else "Vector"
        tree.links.new(node.outputs[output], socket)


def colours(folder: str, form: str, colour: str, inputs: dict, turned: list, width: int) -> str:
    """A file with one row of three channels for each face."""
    scene = new_scene(width, len(turned) // width, samples=1)
    scene.cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    scene.cycles.filter_width = 0.01
    material = _material(folder, form, colour)
    given = {name: np.asarray(values, dtype=np.float32) for name, values in inputs.items()}
    _link_inputs(material, list(given))
    mesh = _faces(given, width, np.asarray(turned, dtype=bool))
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new("Faces", mesh))
    height = len(turned) // width
    camera_at(scene, (width / 2, height / 2, 5), (0, 0, 0), ortho_scale=max(width, height))
    return saved(pixels_of(scene)[::-1].reshape(-1, 3) - OFFSET)
