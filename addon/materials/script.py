# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Script nodes that carry their compiled shader and need neither a file nor `oslquery`."""

from __future__ import annotations

import tempfile
from functools import lru_cache
from pathlib import Path

import bpy

from ..blender import space
from ..core.manifest import CompiledMaterial
from ..core.oso import (
    OsoError,
    Parameter,
    bytecode_hash,
    convert_colours,
    parse_parameters,
    strip_provenance,
)
from ..core.space import Matrix

_SOCKETS = {
    "closure color": "NodeSocketShader",
    "color": "NodeSocketColor",
    "float": "NodeSocketFloat",
    "int": "NodeSocketInt",
    "string": "NodeSocketString",
    "vector": "NodeSocketVector",
    "normal": "NodeSocketVector",
    "point": "NodeSocketVector",
}


def has_osl() -> bool:
    return bpy.app.build_options.cycles_osl


def fill_script_node(node: bpy.types.ShaderNodeScript, material: CompiledMaterial) -> None:
    """Embeds the shader as bytecode and makes the sockets from its parameters."""
    given = material.bytecode
    text = strip_provenance(given) if given else _compile(material.id, material.osl)
    text = convert_colours(text, space.to_file(material.to_xyz_d65))
    _fill(node, text)


def fill_with_source(node: bpy.types.ShaderNodeScript, name: str, source: str) -> None:
    """Likewise, of a shader that is compiled here. Raises OsoError."""
    _fill(node, _compile(name, source))


def _fill(node: bpy.types.ShaderNodeScript, text: str) -> None:
    node.mode = "INTERNAL"
    _set_bytecode(node, text)
    for parameter in parse_parameters(text):
        _add_socket(node, parameter)


def convert_script(node: bpy.types.ShaderNodeScript, matrix: Matrix) -> None:
    """The colours that are the shader's own, in another space."""
    text = convert_colours(node.bytecode, matrix)
    _set_bytecode(node, text)
    for parameter in parse_parameters(text):
        socket = node.inputs.get(parameter.label)
        if parameter.type == "color" and socket is not None and parameter.default:
            socket.default_value = (*parameter.default, 1.0)


def _set_bytecode(node: bpy.types.ShaderNodeScript, text: str) -> None:
    node.bytecode = text
    node.bytecode_hash = bytecode_hash(text)


def _add_socket(node: bpy.types.ShaderNodeScript, parameter: Parameter) -> None:
    kind = _SOCKETS.get(parameter.type)
    if kind is None:  # arrays and structures have no socket; the shader keeps their default
        return
    sockets = node.outputs if parameter.is_output else node.inputs
    socket = sockets.new(type=kind, name=parameter.label, identifier=parameter.name)
    default = parameter.default
    if parameter.is_output or default is None:
        return
    if kind == "NodeSocketString":
        socket.default_value = default
    elif kind == "NodeSocketFloat":
        socket.default_value = default[0]
    elif kind == "NodeSocketInt":
        socket.default_value = int(default[0])
    elif kind == "NodeSocketColor":
        socket.default_value = (*default, 1.0)
    else:
        socket.default_value = default


@lru_cache(maxsize=64)
def _compile(material_id: str, source: str) -> str:
    import _cycles

    with tempfile.TemporaryDirectory(prefix="nacre-") as folder:
        osl = Path(folder, f"{material_id}.osl")
        oso = osl.with_suffix(".oso")
        osl.write_text(source, "utf-8")
        if not _cycles.osl_compile(str(osl), str(oso)):
            raise OsoError(f"{material_id}.osl does not compile; the console tells why")
        return strip_provenance(oso.read_text("utf-8"), folder)
