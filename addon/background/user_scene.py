# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of users: what keeps a picture of one from being made, and what would show something else.

Nothing here is saved: a .blend is opened, changed in memory and rendered.
"""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from ..core.form import OSL
from ..materials import scene as scene_setup
from ..materials.material import describe, group_node, missing_tables

_WITH_SURFACE = ("MESH", "CURVE", "SURFACE", "FONT", "META", "CURVES", "POINTCLOUD")


def refusals(scene: bpy.types.Scene, *, assigned: bool) -> list[str]:
    """Why no picture of the scene can be made, or not the right one; with what to do about it."""
    found = []
    render = scene.render
    if scene.camera is None and not any(marker.camera for marker in scene.timeline_markers):
        found.append("has no camera: add one, and make it the scene's (Ctrl+Numpad 0)")
    if render.use_multiview:
        views = ", ".join(view.name for view in render.views if view.use)
        found.append(
            f"is stereoscopic (views: {views}), and a picture holds one view: turn off Stereoscopy in "
            "the Output properties"
        )
    layers = rendered_layers(scene)
    if not layers:
        names = ", ".join(layer.name for layer in scene.view_layers)
        found.append(f"has no view layer in use ({names}): turn on Use for Rendering for one")
    for layer in layers:
        if assigned and layer.material_override is not None:
            found.append(
                f"has a material for all surfaces in the view layer {layer.name} "
                f"({layer.material_override.name}): clear its Material Override"
            )
    return found


def rendered_layers(scene: bpy.types.Scene) -> list[bpy.types.ViewLayer]:
    layers = [layer for layer in scene.view_layers if layer.use]
    if scene.render.use_single_layer and scene == bpy.context.scene:
        return [bpy.context.view_layer]
    return layers


def show_alone(scene: bpy.types.Scene) -> list[str]:
    """Lets the picture be the whole one of this scene, and of nothing else; returns notes on what was
    left out for that."""
    notes = []
    render = scene.render
    if render.use_sequencer and _strips(scene):
        notes.append(
            f"{scene.name}: the sequencer's strips are left out; the picture is the scene's"
        )
    render.use_sequencer = False
    if render.use_border:
        notes.append(f"{scene.name}: the render border is left out; the picture is a whole one")
        render.use_border = render.use_crop_to_border = False
    files = [node for node in _compositor_nodes(scene) if node.type == "OUTPUT_FILE"]
    for node in files:
        if not node.mute:
            node.mute = True
            notes.append(
                f"{scene.name}: the compositor's node {node.name} is left out; it would write other files"
            )
    return notes


def use_samples(scene: bpy.types.Scene, samples: int) -> None:
    """Of the view layers too, which may have a number of their own."""
    scene.cycles.samples = samples
    for layer in scene.view_layers:
        layer.samples = 0


def age_note() -> str:
    """On a file that is newer than this Blender, or nothing."""
    saved, here = tuple(bpy.data.version[:2]), bpy.app.version[:2]
    if saved <= here:
        return ""
    return (
        f"saved by Blender {saved[0]}.{saved[1]}, rendered by {here[0]}.{here[1]}, which leaves out what "
        "it does not know"
    )


def surfaces(scene: bpy.types.Scene) -> dict[str, bpy.types.Object]:
    """What can have a material, by name: the scene's objects, and those of collections that they
    instance, linked ones among them."""
    found: dict[str, bpy.types.Object] = {}
    for obj in _shown(scene.objects, set()):
        if obj.type in _WITH_SURFACE:
            found.setdefault(obj.name, obj)
    return found


def wave_materials(scene: bpy.types.Scene) -> list[bpy.types.Material]:
    """Ours, of what is shown."""
    slots = [slot for obj in surfaces(scene).values() for slot in obj.material_slots]
    used = dict.fromkeys(slot.material for slot in slots)
    return [material for material in used if group_node(material) is not None]


def without_tables(scene: bpy.types.Scene) -> list[str]:
    """Materials of ours that would be shown magenta, and why."""
    return [
        f"the material {material.name} lacks its tables {', '.join(missing_tables(material))}: assign it "
        "again, or rebuild it in Blender"
        for material in wave_materials(scene)
        if missing_tables(material)
    ]


def serve_wave_materials(scene: bpy.types.Scene) -> list[str]:
    """Turns on what they need, without which they would be black, or of one wavelength."""
    needs = [(material.name, describe(material)) for material in wave_materials(scene)]
    notes = []
    scripted = [name for name, found in needs if found.form == OSL]
    if scripted and scene_setup.use_osl(scene):
        notes.append(f"{', '.join(scripted)}: Open Shading Language is on, which it needs")
    dispersed = [name for name, found in needs if found.wavelength_per_path]
    if dispersed and scene_setup.use_wavelengths(scene):
        notes.append(f"{', '.join(dispersed)}: motion blur is on, it carries the wavelengths")
    return notes


def put_on(obj: bpy.types.Object, material: bpy.types.Material) -> str:
    """In every slot, and on no other object that has the same mesh; the problem, or nothing."""
    if not obj.is_editable:
        return _put_on_linked(obj, material)
    if not obj.material_slots:
        obj.data.materials.append(None)
    for slot in obj.material_slots:
        slot.link = "OBJECT"
        slot.material = material
    return ""


def _put_on_linked(obj: bpy.types.Object, material: bpy.types.Material) -> str:
    """Blender lets its mesh be changed for as long as the file is open, the object's slots not."""
    sharing = [other.name for other in bpy.data.objects if other.data == obj.data and other != obj]
    where = f"is linked from {obj.library.name if obj.library else 'another file'}"
    if sharing:
        return (
            f"{where} and has the same data as {', '.join(sharing)}: make it local, with its data"
        )
    if any(slot.link == "OBJECT" for slot in obj.material_slots):
        return f"{where} and has materials of its own: make it local"
    obj.data.materials.clear()
    obj.data.materials.append(material)
    return ""


def _shown(objects, seen: set[bpy.types.Collection]) -> Iterator[bpy.types.Object]:
    yield from objects
    for obj in objects:
        collection = obj.instance_collection if obj.instance_type == "COLLECTION" else None
        if collection is not None and collection not in seen:
            seen.add(collection)
            yield from _shown(collection.all_objects, seen)


def _strips(scene: bpy.types.Scene) -> bool:
    editor = scene.sequence_editor
    if editor is None:
        return False
    return bool(editor.strips if hasattr(editor, "strips") else editor.sequences)


def _compositor_nodes(scene: bpy.types.Scene) -> Iterator[bpy.types.Node]:
    """Those of groups too."""
    if hasattr(scene, "compositing_node_group"):  # Blender 5
        tree = scene.compositing_node_group
    else:
        tree = scene.node_tree if scene.use_nodes else None
    pending, seen = [tree] if tree is not None else [], set()
    while pending:
        tree = pending.pop()
        seen.add(tree)
        for node in tree.nodes:
            yield node
            inner = getattr(node, "node_tree", None) if node.type == "GROUP" else None
            if inner is not None and inner not in seen:
                pending.append(inner)
