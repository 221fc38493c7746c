# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Worlds that films can mirror. Each is one group with a strength and a rotation, and remembers which
world it took the place of."""

from __future__ import annotations

import math
from pathlib import Path

import bpy

from ..blender.formula import Formula
from ..blender.space import here, to_file
from ..materials.image import convert_pixels, hold_as_data
from .rooms import GAINS, ROOMS, Room, Softbox, name_of, picture_of

LIGHT, BEFORE = "nacre_light", "nacre_world_before"
"""Custom properties of a world: which light it is, and the world that was there."""

_SUN_ELEVATION_DEG = 32.0
_SKY_STRENGTH = 0.14  # of Blender's sky, whose values are those of full daylight
_GROUND, _HAZE = (0.08, 0.07, 0.055), (0.2, 0.22, 0.24)
_MAP_TEXELS = 1024  # for Cycles: none of what is made here is smaller than a hundredth of the view


def is_plain(world: bpy.types.World | None) -> bool:
    """Whether it is of one colour all around, which is all that a mirror shows of it."""
    if world is None or not world.use_nodes or world.node_tree is None:
        return True
    output = next(
        (n for n in world.node_tree.nodes if n.type == "OUTPUT_WORLD" and n.is_active_output), None
    )
    if output is None or not output.inputs["Surface"].is_linked:
        return True
    source = output.inputs["Surface"].links[0].from_node
    return source.type == "BACKGROUND" and not any(socket.is_linked for socket in source.inputs)


def light_of(world: bpy.types.World | None) -> bpy.types.Node | None:
    """The node with the sliders of a world that was made here."""
    if world is None or LIGHT not in world or world.node_tree is None:
        return None
    return next((n for n in world.node_tree.nodes if n.type == "GROUP" and n.name == LIGHT), None)


def light_scene(scene: bpy.types.Scene, light: str, strength: float, rotation: float) -> None:
    """In place of the scene's world, which is kept."""
    before = scene.world if light_of(scene.world) is None else _take_away(scene)
    world = bpy.data.worlds.new(f"{name_of(light)} Light")
    world.use_nodes = True
    world[LIGHT] = light
    if before is not None:
        world[BEFORE] = before
    tree = world.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputWorld")
    node = tree.nodes.new("ShaderNodeGroup")
    node.name, node.label, node.width = LIGHT, f"{name_of(light)} Light", 200.0
    node.location = (-260.0, 0.0)
    node.node_tree = _group(light)
    node.inputs["Strength"].default_value = strength
    node.inputs["Rotation"].default_value = rotation
    tree.links.new(node.outputs[0], output.inputs["Surface"])
    # Left to itself, Cycles looks in sixteen times as many directions as a picture has texels.
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = _MAP_TEXELS
    # EEVEE would cut what is bright out of the mirrored world and make a sun of it.
    if hasattr(world, "sun_threshold"):
        world.sun_threshold = 0.0
        world.probe_resolution = "2048"
    world.color = here((0.2, 0.2, 0.2))
    scene.world = world


def remove_light(scene: bpy.types.Scene) -> None:
    """The world that was there before comes back."""
    scene.world = _take_away(scene)


def _take_away(scene: bpy.types.Scene) -> bpy.types.World | None:
    """Where no other scene uses it, the light's data go too. Returns the world before."""
    world = scene.world
    before = world.get(BEFORE)
    group = light_of(world).node_tree
    scene.world = None
    if world.users == 0:
        bpy.data.worlds.remove(world)
    if group.users == 0:
        images = {node.image for node in group.nodes if node.type == "TEX_ENVIRONMENT"}
        inner = {node.node_tree for node in group.nodes if node.type == "GROUP"}
        bpy.data.node_groups.remove(group)
        for image in images:
            if image is not None and image.users == 0:
                bpy.data.images.remove(image)
        for tree in inner:
            if tree.users == 0:
                bpy.data.node_groups.remove(tree)
    return before if isinstance(before, bpy.types.World) else None


def _group(light: str) -> bpy.types.ShaderNodeTree:
    tree = bpy.data.node_groups.new(f"{name_of(light)} Light", "ShaderNodeTree")
    interface = tree.interface
    interface.new_socket("Background", in_out="OUTPUT", socket_type="NodeSocketShader")
    strength = interface.new_socket("Strength", in_out="INPUT", socket_type="NodeSocketFloat")
    strength.default_value, strength.min_value, strength.max_value = 1.0, 0.0, 100.0
    strength.description = "How bright the light is"
    rotation = interface.new_socket("Rotation", in_out="INPUT", socket_type="NodeSocketFloat")
    rotation.subtype, rotation.description = "ANGLE", "Turns the light around the vertical"
    formula = Formula(tree)
    given = formula.node("NodeGroupInput")
    coordinates = formula.node("ShaderNodeTexCoord")
    turned = formula.node("ShaderNodeVectorRotate", rotation_type="Z_AXIS", invert=True)
    formula.put(coordinates.outputs["Generated"], turned.inputs["Vector"])
    formula.put(given.outputs["Rotation"], turned.inputs["Angle"])
    direction = turned.outputs["Vector"]
    background = formula.node("ShaderNodeBackground")
    power = given.outputs["Strength"]
    if light in ROOMS:
        colour = _room(formula, direction, ROOMS[light])
    elif light == "SKY":
        colour = _sky(formula, direction)
        power = formula.number("MULTIPLY", power, _SKY_STRENGTH)
    else:
        colour = _environment(formula, direction, picture_of(light))
        power = formula.number("MULTIPLY", power, GAINS.get(light, 1.0))
    formula.put(colour, background.inputs["Color"])
    formula.put(power, background.inputs["Strength"])
    formula.put(background.outputs[0], formula.node("NodeGroupOutput").inputs[0])
    return tree


def _room(formula: Formula, direction, room: Room):
    split = formula.node("ShaderNodeSeparateXYZ")
    formula.put(direction, split.inputs[0])
    height = split.outputs["Z"]
    up = formula.smooth_step(height, 0.0, 1.0)
    down = formula.smooth_step(formula.number("MULTIPLY", height, -1.0), 0.0, 0.6)
    grey = formula.mix(down, formula.mix(up, room.horizon, room.zenith), room.nadir)
    combined = formula.node("ShaderNodeCombineXYZ")
    for socket in combined.inputs:
        formula.put(grey, socket)
    colour = combined.outputs[0]
    tree = _softbox_group()
    is_seen = formula.node("ShaderNodeLightPath").outputs["Is Camera Ray"]
    is_mirrored = formula.number("SUBTRACT", 1.0, is_seen)
    for softbox in room.softboxes:
        node = formula.node("ShaderNodeGroup")
        node.node_tree = tree
        formula.put(direction, node.inputs["Direction"])
        for name, value in _values(softbox).items():
            node.inputs[name].default_value = value
        part = node.outputs[0]
        if softbox.is_hidden:
            part = formula.number("MULTIPLY", part, is_mirrored)
        added = formula.scaled(here(softbox.radiance), part)
        colour = formula.vector("ADD", colour, added)
    return colour


def _values(softbox: Softbox) -> dict[str, object]:
    return {
        # Its Z axis looks at the softbox, its Y axis up.
        "Orientation": (
            math.radians(90.0 - softbox.elevation_deg),
            0.0,
            math.radians(softbox.azimuth_deg + 90.0),
        ),
        "Half Width": softbox.half_size[0],
        "Half Height": softbox.half_size[1],
        "Columns": float(softbox.panes[0]),
        "Rows": float(softbox.panes[1]),
        "Edge": softbox.edge,
        "Falloff": softbox.falloff,
    }


def _softbox_group() -> bpy.types.ShaderNodeTree:
    """How much of a softbox is in a direction: 0 to 1."""
    name = "Nacre Softbox"
    tree = bpy.data.node_groups.get(name)
    if tree is not None and tree.get(LIGHT) == "softbox" and tree.library is None:
        return tree
    tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
    tree[LIGHT] = "softbox"
    tree.interface.new_socket("Part", in_out="OUTPUT", socket_type="NodeSocketFloat")
    for socket in ("Direction", "Orientation"):
        tree.interface.new_socket(socket, in_out="INPUT", socket_type="NodeSocketVector")
    for socket in ("Half Width", "Half Height", "Columns", "Rows", "Edge", "Falloff"):
        tree.interface.new_socket(socket, in_out="INPUT", socket_type="NodeSocketFloat")
    formula = Formula(tree)
    given = formula.node("NodeGroupInput").outputs
    local = formula.node("ShaderNodeVectorRotate", rotation_type="EULER_XYZ", invert=True)
    formula.put(given["Direction"], local.inputs["Vector"])
    formula.put(given["Orientation"], local.inputs["Rotation"])
    split = formula.node("ShaderNodeSeparateXYZ")
    formula.put(local.outputs[0], split.inputs[0])
    ahead = formula.number("MAXIMUM", split.outputs["Z"], 1e-4)
    part = formula.number("GREATER_THAN", split.outputs["Z"], 0.0)
    squares = []
    for axis, half, panes in (("X", "Half Width", "Columns"), ("Y", "Half Height", "Rows")):
        at = formula.number("DIVIDE", split.outputs[axis], ahead)
        at = formula.number("DIVIDE", at, given[half])  # -1 to 1 within
        inside = formula.number("LESS_THAN", formula.number("ABSOLUTE", at), 1.0)
        part = formula.number("MULTIPLY", part, inside)
        # Within its pane, -1 to 1.
        count = formula.number(
            "MULTIPLY", formula.number("MULTIPLY_ADD", at, 0.5, 0.5), given[panes]
        )
        within = formula.number("MULTIPLY_ADD", formula.number("FRACT", count), 2.0, -1.0)
        edge = formula.number("SUBTRACT", 1.0, formula.number("ABSOLUTE", within))
        width = formula.number("MULTIPLY", given["Edge"], given[panes])
        start = formula.number("SUBTRACT", given[panes], 1.0)
        bar = formula.number("MULTIPLY", formula.number("MINIMUM", start, 1.0), 0.09)
        lit = formula.smooth_step(edge, bar, formula.number("ADD", bar, width))
        part = formula.number("MULTIPLY", part, lit)
        squares.append(formula.number("MULTIPLY", at, at))
    corner = formula.number("MULTIPLY", formula.number("ADD", *squares), given["Falloff"])
    dim = formula.number("MULTIPLY_ADD", corner, -0.5, 1.0, clamp=True)
    result = formula.number("MULTIPLY", part, dim)
    formula.put(result, formula.node("NodeGroupOutput").inputs[0])
    return tree


def _sky(formula: Formula, direction):
    sky = formula.node("ShaderNodeTexSky")
    kinds = sky.bl_rna.properties["sky_type"].enum_items.keys()
    sky.sky_type = next(k for k in ("MULTIPLE_SCATTERING", "NISHITA") if k in kinds)
    sky.sun_disc = False  # EEVEE has none, and mirrored it is noise
    sky.sun_elevation = math.radians(_SUN_ELEVATION_DEG)
    sky.sun_rotation = math.radians(200.0)
    formula.put(direction, sky.inputs["Vector"])
    # Below the horizon Blender's sky is black. Near it the ground is in haze.
    split = formula.node("ShaderNodeSeparateXYZ")
    formula.put(direction, split.inputs[0])
    height = split.outputs["Z"]
    near = formula.smooth_step(height, -0.35, 0.0)
    ground = formula.vector(
        "ADD",
        formula.scaled(here(_GROUND), 1.0 / _SKY_STRENGTH),
        formula.scaled(here(_HAZE), formula.number("MULTIPLY", near, 1.0 / _SKY_STRENGTH)),
    )
    below = formula.smooth_step(formula.number("MULTIPLY", height, -1.0), -0.01, 0.02)
    above = formula.number("SUBTRACT", 1.0, below)
    return formula.vector(
        "ADD", formula.scaled(sky.outputs[0], above), formula.scaled(ground, below)
    )


def _environment(formula: Formula, direction, file: str):
    node = formula.node("ShaderNodeTexEnvironment")
    node.image = environment_picture(file)
    formula.put(direction, node.inputs["Vector"])
    return node.outputs["Color"]


def environment_picture(file: str) -> bpy.types.Image:
    """One of those that come with Blender (CC0), of Rec.709, in the file's space: what a colour config
    makes of an .exr is its own affair."""
    folder = Path(bpy.utils.system_resource("DATAFILES"), "studiolights", "world")
    image = bpy.data.images.load(str(folder / file))
    hold_as_data(image)
    matrix = to_file()
    if matrix is not None:
        convert_pixels(image, matrix)
        image.pack()
    return image
