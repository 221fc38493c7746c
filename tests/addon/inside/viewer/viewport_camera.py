# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The camera made for a view projects every point to where the view has it. Cameras stand in for
viewports here: Blender gives the projection of either."""

from __future__ import annotations

import itertools
import sys
from pathlib import Path
from types import SimpleNamespace

import bpy
from mathutils import Euler, Matrix, Vector

from jobs.extension import load, module
from jobs.steps import new_file

load()
aside = module("viewer.camera")
view = module("viewer.view")
viewport = module("viewer.viewport")
picture = module("viewer.picture")
output = module("blender.output")
folder = Path(sys.argv[1])

POINTS = [Vector(p) for p in itertools.product((-1.5, 0.2, 2.0), (-1.0, 0.7), (-0.5, 1.1))]


def projection(camera: bpy.types.Object, size: tuple[int, int]) -> Matrix:
    graph = bpy.context.evaluated_depsgraph_get()
    return camera.calc_matrix_camera(graph, x=size[0], y=size[1])


def pixel(matrix: Matrix, point: Vector, size: tuple[int, int]) -> Vector:
    """From the middle of a picture."""
    clip = matrix @ point.to_4d()
    return Vector((clip.x / clip.w * size[0] / 2, clip.y / clip.w * size[1] / 2))


def viewed(size, **settings) -> SimpleNamespace:
    data = bpy.data.cameras.new("View")
    for name, value in settings.items():
        setattr(data, name, value)
    camera = bpy.data.objects.new("View", data)
    rotation = Euler((1.1, 0.3, 0.7)).to_matrix().to_4x4()
    camera.matrix_world = Matrix.Translation(rotation @ Vector((0.1, 0.2, 9.0))) @ rotation
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.view_layer.update()
    return SimpleNamespace(
        window_matrix=projection(camera, size),
        view_matrix=camera.matrix_world.inverted(),
        region=SimpleNamespace(width=size[0], height=size[1]),
    )


def check(region, size, **settings) -> None:
    """A picture of `size` shows the same, evenly larger or smaller, about its middle."""
    seen = viewed(region, **settings)
    scene = bpy.context.scene
    before = (scene.camera, scene.render.resolution_x, set(bpy.data.objects), len(bpy.data.scenes))
    with aside.scene_aside(scene, bpy.context.view_layer) as other:
        made = viewport.Viewport(seen.region, seen).frame(size)
        aside.use_view(other, made, seen.view_matrix)
        camera = other.camera
        bpy.context.view_layer.update()
        theirs = seen.window_matrix @ seen.view_matrix
        ours = projection(camera, size) @ camera.matrix_world.inverted()
        larger = min(size[0] / region[0], size[1] / region[1])
        for point in POINTS:
            wanted = pixel(theirs, point, region) * larger
            got = pixel(ours, point, size)
            assert (wanted - got).length < 0.02, (settings, region, size, wanted, got)
    after = (scene.camera, scene.render.resolution_x, set(bpy.data.objects), len(bpy.data.scenes))
    assert after == before
    assert not [camera for camera in bpy.data.cameras if camera.name.startswith(aside.NAME)]


new_file()
for region, size in (
    ((800, 600), (800, 600)),
    ((800, 600), (1600, 1200)),
    ((500, 700), (250, 350)),
    ((800, 600), (900, 300)),
    ((800, 600), (300, 900)),
):
    check(region, size, lens=50.0)
    check(region, size, lens=28.0, shift_x=0.13, shift_y=-0.21)
    check(region, size, lens=60.0, sensor_fit="VERTICAL", sensor_height=20.0, shift_x=0.1)
    check(region, size, type="ORTHO", ortho_scale=7.0)
    check(region, size, type="ORTHO", ortho_scale=9.0, shift_x=-0.3, shift_y=0.4)
    check(region, size, lens=1.0, sensor_width=80.0)

# A picture: the file, and nothing else.
seen = viewed((64, 48), lens=40.0)
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.samples, scene.render.resolution_x = 77, 123
scene.render.filepath = "kept"


def state() -> tuple:
    return (
        [len(getattr(bpy.data, name)) for name in ("scenes", "objects", "cameras", "worlds")],
        (scene.camera, scene.cycles.samples, scene.render.resolution_x, scene.render.filepath),
        [len(getattr(bpy.app.handlers, name)) for name in ("render_complete", "render_cancel")],
        scene.render.image_settings.file_format,
    )


def take(path: Path, save: bool = True) -> None:
    shot = picture.Shot(bpy.context, viewport.Viewport(seen.region, seen), path, (32, 24))
    try:
        shot.use_samples(1)
        shot.render()
        if save:
            shot.save()
    finally:
        shot.end()
        shot.end()


before = state()
take(folder / "view é.png")
assert state() == before
image = bpy.data.images.load(str(folder / "view é.png"))
assert tuple(image.size) == (32, 24)
bpy.data.images.remove(image)


def problem_of(path: Path) -> str:
    try:
        take(path)
    except (output.OutputError, RuntimeError) as error:
        return str(error)
    return ""


# Cancelled; refused before the work; failing in the middle.
take(folder / "not.png", save=False)
assert state() == before
for path in (folder / "nowhere" / "view.png", folder / "view.jpg"):
    assert str(path) in problem_of(path)
    assert state() == before


def fail(_shot) -> None:
    raise RuntimeError("out of memory")


picture.Shot.render = fail
assert problem_of(folder / "not.png") == "out of memory"
assert state() == before
assert sorted(path.name for path in folder.iterdir() if path.suffix) == ["view é.png"]
