# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What EEVEE shows of a cut stone. It refracts once and looks through, where most of the light comes back
by total reflection; so an output of its own adds virtual facets, the pictures of the back in the front.

They are drawn, not traced: right on average, not each in its place. Cycles traces, and takes the other output.
"""

from __future__ import annotations

import bpy

from ..blender.formula import Formula, Operand
from ..core.form import NODES
from ..core.graph import Graph
from ..core.manifest import BANDS, CompiledMaterial
from ..materials import group as groups
from ..materials import material as materials

_GEM = "gem"
"""The tag of what stones are cut from."""

SHADER = "EEVEE"
"""The output of a group, and the material's output that it goes to."""

_GLOSSY, _REFRACTION, _GLASS = (
    "ShaderNodeBsdfAnisotropic",
    "ShaderNodeBsdfRefraction",
    "ShaderNodeBsdfGlass",
)

# Of the virtual facets, by eye: how deep in the stone they lie and how they run along its height and
# outwards, in parts of its bounds, and how many lie on a radian around its axis.
_DEPTH, _ALONG_AXIS, _OUTWARDS, _FINENESS = 0.5, 0.5, 0.8, 9.0
# Where light comes from that was reflected within: this part of the directions to the eye and along the
# normal, and an even direction of length 1. Of rays through a round brilliant of index 2.42 and 1.62, from 48
# sides in three rooms, such directions find 0.97 and 0.96 of the light that they find on their own ways (even
# ones alone 0.56 and 0.55), from side to side within a factor of 1.5 and 1.6 (rms).
_BACK = 0.5
# Neighbours are apart by turns of the azimuth, so that few facets make an even mean, and a bit of chance.
_TURNS, _CHANCE_RAD = 3.0, 1.6

_FLAT = "sharp_face"  # Blender's own attribute; there is none where all faces are smooth


def suits(material: CompiledMaterial, form: str) -> bool:
    """As nodes, which EEVEE runs, of what stones are cut from."""
    return (
        form in (NODES, BANDS)
        and _GEM in material.tags
        and _is_one_interface(material.graphs[form])
    )


def _is_one_interface(graph: Graph) -> bool:
    """Of a body, with layers on it or without."""
    closures = sorted(node.type for node in graph.nodes if node.type.startswith("ShaderNodeBsdf"))
    return closures in ([_GLASS], [_GLOSSY, _REFRACTION])


def is_in(group: bpy.types.ShaderNodeTree) -> bool:
    return SHADER in group.interface.items_tree


def add(group: bpy.types.ShaderNodeTree) -> None:
    """The second output of a group whose graph suits."""
    stone = _Stone(group)
    reflected, passed, outside = stone.surface()
    facet, chance = stone.facet()
    formula, ior = stone.formula, stone.ior
    # Of the even directions within, weighted by their cosine, sin² of the critical angle, 1 / n², meet the
    # surface below it: there a part passes, straight on, and the rest is reflected as it is outside. Of a
    # film that absorbs nothing R + T = 1, and no light is lost.
    share = formula.number("DIVIDE", 1.0, formula.number("MULTIPLY", ior, ior))
    window = formula.number("LESS_THAN", chance, share)
    wall = formula.number("SUBTRACT", 1.0, window)
    kept = formula.vector("ADD", formula.scaled(reflected, window), wall)
    straight = formula.scaled(formula.vector("MULTIPLY", passed, passed), window)
    inside = stone.closure(_GLOSSY, formula.vector("MULTIPLY", passed, kept), facet)
    through = stone.closure(_REFRACTION, straight, stone.normal)
    group.interface.new_socket(name=SHADER, in_out="OUTPUT", socket_type="NodeSocketShader")
    end = next(node for node in group.nodes if node.type == "GROUP_OUTPUT")
    shown = formula.node("ShaderNodeMixShader")
    formula.put(stone.is_flat(), shown.inputs[0])
    formula.put(end.inputs[0].links[0].from_socket, shown.inputs[1])
    formula.put(stone.sum(outside, stone.sum(inside, through)), shown.inputs[2])
    formula.put(shown.outputs[0], end.inputs[SHADER])


def show(material: bpy.types.Material, node: bpy.types.ShaderNodeGroup) -> None:
    """Puts the group's output for EEVEE in place where nothing lies between the group and the surface, and
    takes away one that has nothing to show."""
    tree = material.node_tree
    output = tree.nodes.get(SHADER)
    surface = tree.get_output_node("CYCLES")
    links = surface.inputs["Surface"].links if surface else ()
    if SHADER in node.outputs and links and links[0].from_node == node:
        if output is None:
            output = tree.nodes.new("ShaderNodeOutputMaterial")
            output.name = output.label = SHADER
            output.target = "EEVEE"
            output.location = (surface.location.x, surface.location.y - 180.0)
        tree.links.new(node.outputs[SHADER], output.inputs["Surface"])
    elif output is not None and not output.inputs["Surface"].is_linked:
        tree.nodes.remove(output)


def _fed(socket: bpy.types.NodeSocket) -> Operand:
    """What feeds it, or its own value."""
    return socket.links[0].from_socket if socket.is_linked else socket.default_value


class _Stone:
    """What is seen of a stone at a point of its surface, as nodes."""

    def __init__(self, group: bpy.types.ShaderNodeTree) -> None:
        self.formula = Formula(group)
        self.closures = {node.bl_idname: node for node in group.nodes}
        body = self.body = self.closures.get(_REFRACTION) or self.closures[_GLASS]
        self.normal, self.roughness, self.ior = (
            _fed(body.inputs[name]) for name in ("Normal", "Roughness", "IOR")
        )
        self.incoming = self.formula.node("ShaderNodeNewGeometry").outputs["Incoming"]

    def closure(self, kind: str, colour: Operand, normal: Operand) -> bpy.types.NodeSocket:
        node = self.formula.node(kind, distribution="GGX")
        values = {"Color": colour, "Roughness": self.roughness, "Normal": normal}
        if kind == _REFRACTION:
            values["IOR"] = self.ior
        for name, value in values.items():
            self.formula.put(value, node.inputs[name])
        return node.outputs[0]

    def sum(self, a: Operand, b: Operand) -> bpy.types.NodeSocket:
        node = self.formula.node("ShaderNodeAddShader")
        self.formula.put(a, node.inputs[0])
        self.formula.put(b, node.inputs[1])
        return node.outputs[0]

    def surface(self) -> tuple[Operand, Operand, bpy.types.NodeSocket]:
        """R and T from outside, and the closure of what is reflected there."""
        film = self.closures.get(_GLOSSY)
        if film is not None:
            return _fed(film.inputs["Color"]), _fed(self.body.inputs["Color"]), film.outputs[0]
        fresnel = self.formula.node("ShaderNodeFresnel")
        self.formula.put(self.ior, fresnel.inputs["IOR"])
        self.formula.put(self.normal, fresnel.inputs["Normal"])
        reflected = fresnel.outputs[0]
        passed = self.formula.vector("SUBTRACT", (1.0, 1.0, 1.0), reflected)
        return reflected, passed, self.closure(_GLOSSY, reflected, self.normal)

    def is_flat(self) -> bpy.types.NodeSocket:
        """1 on faces that are shaded flat. Most of the light passes through what is round, as EEVEE has it
        without any facets."""
        return self.formula.node("ShaderNodeAttribute", attribute_name=_FLAT).outputs["Fac"]

    def facet(self) -> tuple[bpy.types.NodeSocket, bpy.types.NodeSocket]:
        """The normal by which a mirror shows what is seen in the virtual facet, and a number by chance,
        0 to 1, that each facet has."""
        formula = self.formula
        colour, place = _cells(formula, self._in_depth())
        chances = formula.node("ShaderNodeSeparateColor")
        formula.put(colour, chances.inputs[0])
        even = _turned(formula, _even(formula, place, chances.outputs), "OBJECT", "WORLD")
        back = formula.scaled(formula.vector("ADD", self.incoming, self.normal), _BACK)
        towards = formula.vector("NORMALIZE", formula.vector("ADD", back, even))
        # A mirror shows a direction to the eye where its normal is half way between them.
        half = formula.vector("ADD", towards, self.incoming)
        return formula.vector("NORMALIZE", half), chances.outputs[2]

    def _in_depth(self) -> bpy.types.NodeSocket:
        """A place in the stone on the refracted ray, from the middle of its bounds, so that virtual facets
        break at the edges of real ones and shift behind them."""
        formula = self.formula
        refracted = formula.node("ShaderNodeVectorMath", operation="REFRACT")
        formula.put(formula.scaled(self.incoming, -1.0), refracted.inputs[0])
        formula.put(self.normal, refracted.inputs[1])
        formula.put(formula.number("DIVIDE", 1.0, self.ior), refracted.inputs["Scale"])
        within = _turned(formula, refracted.outputs[0], "WORLD", "OBJECT")
        bounds = formula.node("ShaderNodeTexCoord").outputs["Generated"]
        from_middle = formula.vector("SUBTRACT", bounds, (0.5, 0.5, 0.5))
        return formula.vector("MULTIPLY_ADD", within, (_DEPTH,) * 3, from_middle)


def _even(formula: Formula, place: bpy.types.NodeSocket, chances) -> bpy.types.NodeSocket:
    """A direction for each cell, together even on a sphere: its height is by chance (Archimedes)."""
    height = formula.number("MULTIPLY_ADD", chances[0], 2.0, -1.0)
    square = formula.number("MULTIPLY", height, height)
    radius = formula.number("SQRT", formula.number("SUBTRACT", 1.0, square))
    split = formula.node("ShaderNodeSeparateXYZ")
    formula.put(place, split.inputs[0])
    azimuth = formula.number("ARCTAN2", split.outputs["Y"], split.outputs["X"])
    turned = formula.number("MULTIPLY", chances[1], _CHANCE_RAD)
    azimuth = formula.number("MULTIPLY_ADD", azimuth, _TURNS, turned)
    direction = formula.node("ShaderNodeCombineXYZ")
    for name, operation in (("X", "COSINE"), ("Y", "SINE")):
        side = formula.number("MULTIPLY", radius, formula.number(operation, azimuth))
        formula.put(side, direction.inputs[name])
    formula.put(height, direction.inputs["Z"])
    return direction.outputs[0]


def _cells(
    formula: Formula, place: bpy.types.NodeSocket
) -> tuple[bpy.types.NodeSocket, bpy.types.NodeSocket]:
    """Chances and centre of the cell of a place. Cells are long towards the axis, as the pavilion's facets
    and their pictures are."""
    flat = formula.vector("MULTIPLY", place, (1.0, 1.0, 0.0))
    split = formula.node("ShaderNodeSeparateXYZ")
    formula.put(place, split.inputs[0])
    along = formula.node("ShaderNodeCombineXYZ")
    outwards = formula.number("MULTIPLY", formula.vector("LENGTH", flat), _OUTWARDS)
    height = formula.number("MULTIPLY_ADD", split.outputs["Z"], _ALONG_AXIS, outwards)
    formula.put(height, along.inputs["Z"])
    around = formula.vector("ADD", formula.vector("NORMALIZE", flat), along.outputs[0])
    cells = formula.node("ShaderNodeTexVoronoi", voronoi_dimensions="3D", feature="F1")
    formula.put(around, cells.inputs["Vector"])
    formula.put(_FINENESS, cells.inputs["Scale"])
    return cells.outputs["Color"], cells.outputs["Position"]


def _turned(
    formula: Formula, direction: bpy.types.NodeSocket, given: str, wanted: str
) -> bpy.types.NodeSocket:
    """A direction of one space in another, of length 1."""
    node = formula.node(
        "ShaderNodeVectorTransform", vector_type="VECTOR", convert_from=given, convert_to=wanted
    )
    formula.put(direction, node.inputs[0])
    return formula.vector("NORMALIZE", node.outputs[0])


# ---- Its part in materials that are made -----------------------------------------------------------


_FACETS = groups.Addition(suits, is_in, add)


def _show_of(material: bpy.types.Material) -> None:
    show(material, materials.group_node(material))


def register() -> None:
    """Once is enough: what makes materials without the extension being registered asks for it, too."""
    if _FACETS not in groups.ADDITIONS:
        groups.ADDITIONS.append(_FACETS)
        materials.WHEN_MADE.append(_show_of)


def unregister() -> None:
    groups.ADDITIONS.remove(_FACETS)
    materials.WHEN_MADE.remove(_show_of)
