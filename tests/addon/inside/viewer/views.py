# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Debug views and passes: what they show, and that they go away without a trace."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()
materials = module("materials.material")
thickness = module("thickness.nodes")
views = module("viewer.views")
FIELDS = module("viewer.fields").FIELDS
exr = module("core.exr")
folder = Path(sys.argv[1])

SIZE, TILT = 16, 0.6


def set_up() -> bpy.types.Object:
    new_file()
    bpy.data.objects.remove(bpy.context.object)
    bpy.ops.mesh.primitive_plane_add(size=2.0)
    obj = bpy.context.object
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.cycles.samples, scene.cycles.filter_width = 1, 0.01
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = (0.0, -5.0 * math.sin(TILT), 5.0 * math.cos(TILT))
    camera.rotation_euler = (TILT, 0.0, 0.0)
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = 1.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    # A clear film is seen through; what lies behind is not to be added to its own passes.
    behind = bpy.data.objects.new("Behind", obj.data)
    behind.location.z = -0.3
    scene.collection.objects.link(behind)
    return obj


def add_lamp(name: str, kind: str, place: tuple[float, float, float]) -> bpy.types.Object:
    lamp = bpy.data.objects.new(name, bpy.data.lights.new(name, kind))
    lamp.location = place
    bpy.context.scene.collection.objects.link(lamp)
    return lamp


def render() -> dict[str, np.ndarray]:
    """All layers, row 0 on top."""
    scene = bpy.context.scene
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "MULTI_LAYER_IMAGE"
    settings.file_format = "OPEN_EXR_MULTILAYER"
    settings.color_depth, settings.exr_codec = "32", "NONE"
    scene.render.filepath = str(folder / "layers.exr")
    scene.render.use_file_extension = False
    bpy.ops.render.render(write_still=True)
    read = exr.read_channels(Path(scene.render.filepath))
    return {name: np.array(values).reshape(SIZE, SIZE) for name, values in read.items()}


def vector(layers: dict[str, np.ndarray], name: str) -> np.ndarray:
    return np.stack([layers[f"{name}.{letter}"] for letter in "RGB"], axis=-1)


def places() -> np.ndarray:
    row, column = np.mgrid[0:SIZE, 0:SIZE]
    across = (column + 0.5) / SIZE - 0.5
    up = (0.5 - (row + 0.5) / SIZE) / math.cos(TILT)
    return np.stack([across, up, np.zeros_like(across)], axis=-1)


def towards(lamps: np.ndarray) -> np.ndarray:
    """Unit vectors to the nearest of them from each place."""
    away = lamps[:, None, None, :] - places()[None]
    length = np.linalg.norm(away, axis=-1)
    nearest = np.argmin(length, axis=0)
    rows, columns = np.mgrid[0:SIZE, 0:SIZE]
    return away[nearest, rows, columns] / length[nearest, rows, columns][..., None]


def state(material) -> tuple:
    tree = material.node_tree
    return (
        sorted((n.name, getattr(n, "is_active_output", None)) for n in tree.nodes),
        sorted(
            (link.from_node.name, link.to_node.name, link.to_socket.name) for link in tree.links
        ),
        tree.animation_data is not None and len(tree.animation_data.drivers),
        sorted(g.name for g in bpy.data.node_groups if "nacre_thickness_source" not in g),
        [len(g.interface.items_tree) for g in bpy.data.node_groups if "nacre_material" in g],
        [len(layer.aovs) for layer in bpy.context.scene.view_layers],
        [layer.pass_alpha_threshold for layer in bpy.context.scene.view_layers],
    )


# Passes of a plane under a tilt, with two lamps: each place has its nearest one.
obj = set_up()
lamps = [add_lamp("Left", "POINT", (-0.5, 0.0, 0.8)), add_lamp("Right", "AREA", (0.6, 0.1, 0.7))]
bpy.ops.nacre.assign_material(material="test_film", form="nodes")
material = obj.active_material
thickness.thickness_socket(material).default_value = 432.5
before = state(material)
assert bpy.ops.nacre.add_aovs() == {"FINISHED"}
found = render()
assert {f"{item.aov}.{'R' if item.is_vector else 'X'}" for item in FIELDS} <= set(found)
np.testing.assert_allclose(found["nacre_cos_theta.X"], math.cos(TILT), atol=1e-6)
np.testing.assert_allclose(found["nacre_thickness.X"], 432.5, rtol=1e-6)
np.testing.assert_allclose(
    vector(found, "nacre_normal"), np.broadcast_to([0, 0, 1], (SIZE, SIZE, 3))
)
camera = np.array([0.0, -math.sin(TILT), math.cos(TILT)])
np.testing.assert_allclose(
    vector(found, "nacre_to_camera"), np.broadcast_to(camera, (SIZE, SIZE, 3)), atol=1e-6
)
uv = 0.5 + 0.5 * places() * [1, 1, 0] - [0, 0, 0.5]
np.testing.assert_allclose(vector(found, "nacre_uv"), uv, atol=1e-3)
both = np.array([tuple(lamp.location) for lamp in lamps])
middle = slice(2, -2)  # near the border between the lamps a sample may go to either
to_light = vector(found, "nacre_to_light")
far_apart = (
    np.abs(np.diff(np.linalg.norm(both[:, None, None] - places(), axis=-1), axis=0)[0]) > 0.05
)
np.testing.assert_allclose(to_light[far_apart], towards(both)[far_apart], atol=3e-3)
assert far_apart.sum() > 200

# The slider and a lamp that moves are followed without a further step.
thickness.thickness_socket(material).default_value = 777.0
lamps[0].location.z = 0.3
bpy.context.view_layer.update()
found = render()
np.testing.assert_allclose(found["nacre_thickness.X"], 777.0, rtol=1e-6)
lamps[0].location.z = 0.8

# So is a source that is put in.
bpy.ops.nacre.add_thickness(source="drop")
drop = thickness.sources_of(material)[0]
drop.inputs["Base"].default_value, drop.inputs["Height"].default_value = 100.0, 700.0
drop.inputs["Radius"].default_value = 0.3
found = render()
r = np.linalg.norm(uv[..., :2] - 0.5, axis=-1) / 0.3
wanted = 100.0 + 700.0 * np.maximum(1.0 - r * r, 0.0)
np.testing.assert_allclose(found["nacre_thickness.X"], wanted, atol=3.0)
assert np.ptp(wanted) > 500.0
bpy.ops.nacre.remove_thickness()

# One lamp that is chosen; a sun.
scene = bpy.context.scene
scene.nacre.view_lamp = lamps[1]
np.testing.assert_allclose(vector(render(), "nacre_to_light"), towards(both[1:]), atol=3e-3)
sun = add_lamp("Sun", "SUN", (0.0, 0.0, 0.0))
sun.rotation_euler = (0.0, 0.5, 0.0)
bpy.context.view_layer.update()
scene.nacre.view_lamp = sun
wanted = np.broadcast_to([math.sin(0.5), 0.0, math.cos(0.5)], (SIZE, SIZE, 3))
np.testing.assert_allclose(vector(render(), "nacre_to_light"), wanted, atol=1e-6)
scene.nacre.view_lamp = None
bpy.data.objects.remove(sun)

# A user's own pass of another name is left alone.
own = bpy.context.view_layer.aovs.add()
own.name = "thickness"
assert bpy.ops.nacre.remove_aovs() == {"FINISHED"}
assert [aov.name for aov in bpy.context.view_layer.aovs] == ["thickness"]
bpy.context.view_layer.aovs.remove(own)
thickness.thickness_socket(material).default_value = 432.5
assert state(material) == before, (state(material), before)

# Only some passes; twice is once.
for _ in range(2):
    bpy.ops.nacre.add_aovs(fields={"thickness"})
assert [aov.name for aov in bpy.context.view_layer.aovs] == ["nacre_thickness"]
bpy.ops.nacre.remove_aovs()
assert state(material) == before

# Views: the colours of the same fields, and back.
scene.render.film_transparent = True
scene.world = None
shown = {
    "normal": lambda: np.broadcast_to([0.5, 0.5, 1.0], (SIZE, SIZE, 3)),
    "uv": lambda: uv,
    "to_camera": lambda: np.broadcast_to(0.5 * camera + 0.5, (SIZE, SIZE, 3)),
    "thickness": lambda: np.full((SIZE, SIZE, 3), 432.5 / 1200.0),
    "cos_theta": lambda: np.full((SIZE, SIZE, 3), math.cos(TILT)),
}
for view, expected in shown.items():
    scene.nacre.view = view
    assert scene.nacre.view == view == views.shown()
    np.testing.assert_allclose(vector(render(), "Combined"), expected(), atol=1e-3)
scene.nacre.view = "shaded"
assert state(material) == before

# The form can be switched while one is on, in either direction.
scene.nacre.view = "thickness"
bpy.ops.nacre.rebuild_material(form="osl")
np.testing.assert_allclose(vector(render(), "Combined"), 432.5 / 1200.0, atol=1e-3)
bpy.ops.nacre.rebuild_material(form="nodes")
scene.nacre.view = "shaded"
assert [n for n in material.node_tree.nodes if n.name.startswith("Nacre")] == []
assert next(n for n in material.node_tree.nodes if n.type == "OUTPUT_MATERIAL").is_active_output

# An output of the user's own stays the one that renders.
second = material.node_tree.nodes.new("ShaderNodeOutputMaterial")
second.name = "Second"
second.is_active_output = True
for view in ("uv", "normal", "shaded"):
    scene.nacre.view = view
assert second.is_active_output
material.node_tree.nodes.remove(second)
next(n for n in material.node_tree.nodes if n.type == "OUTPUT_MATERIAL").is_active_output = True

# Undo takes a view back like any other step.
bpy.ops.ed.undo_push(message="shaded")
scene.nacre.view = "uv"
bpy.ops.ed.undo_push(message="uv")
bpy.ops.ed.undo()
scene = bpy.context.scene
assert scene.nacre.view == "shaded"
bpy.ops.ed.redo()
scene = bpy.context.scene
assert scene.nacre.view == "uv"

# Files are saved with what the materials are; the view goes on.
path = folder / "saved.blend"
bpy.ops.wm.save_as_mainfile(filepath=str(path))
assert bpy.context.scene.nacre.view == "uv"
bpy.ops.wm.open_mainfile(filepath=str(path))
assert bpy.context.scene.nacre.view == "shaded"
material = bpy.context.object.active_material
assert [n.name for n in material.node_tree.nodes if n.name.startswith("Nacre")] == []

# Turned off with the extension.
bpy.context.scene.nacre.view = "normal"
extension.unregister()
assert [n.name for n in material.node_tree.nodes if n.name.startswith("Nacre")] == []
