# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads one pixel: Cycles renders it alone, with the fields of all wave materials as passes.

So thickness, angle and normal are what a render of the picture would use there, whatever textures,
attributes, modifiers, displacement or geometry nodes they come from.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

import bpy

from ..core.exr import read_channels
from ..core.faults import RecipeError
from ..materials.material import kind
from ..materials.recipe import recipe
from ..materials.traits import traits
from . import field_nodes, opaque
from .camera import scene_aside, use_sharp_copy, use_view
from .probe import Probe, ProbeError, Reading, Sample, measure
from .viewport import Viewport

_AOVS = {
    name: f"nacre_probe_{name}"
    for name in ("normal", "uv", "thickness", "cos_theta", opaque.POINT, opaque.BACK, opaque.ID)
}
"""Names of the passes, by what they hold."""


def in_viewport(
    scene: bpy.types.Scene, layer: bpy.types.ViewLayer, pixel: tuple[int, int], view: Viewport
) -> Probe:
    """Of what the viewport shows."""
    with scene_aside(scene, layer) as aside:
        use_view(aside, view.frame(view.size), view.data.view_matrix)
        return probe_pixel(aside, pixel, view.size)


def in_picture(scene: bpy.types.Scene, layer: bpy.types.ViewLayer, pixel: tuple[int, int]) -> Probe:
    """Of what the scene's camera takes."""
    if scene.camera is None:
        raise ProbeError("the scene has no camera")
    render = scene.render
    share = render.resolution_percentage / 100.0
    size = int(render.resolution_x * share), int(render.resolution_y * share)
    with scene_aside(scene, layer) as aside:
        use_sharp_copy(aside)
        return probe_pixel(aside, pixel, size)


def probe_pixel(aside: bpy.types.Scene, pixel: tuple[int, int], size: tuple[int, int]) -> Probe:
    """Of a scene from `camera.scene_aside`, whose camera and settings are changed; pixels count from
    the top left.

    Raises ProbeError where there is no wave material at that pixel.
    """
    if not (0 <= pixel[0] < size[0] and 0 <= pixel[1] < size[1]):
        raise ProbeError(
            f"pixel {pixel[0]} {pixel[1]}: must be within 0 0 … {size[0] - 1} {size[1] - 1}"
        )
    with opaque.materials_as_passes(_AOVS) as materials:
        channels = _render(aside, pixel, size)
    return _probe(channels, pixel, materials)


def _render(
    aside: bpy.types.Scene, pixel: tuple[int, int], size: tuple[int, int]
) -> dict[str, Sequence[float]]:
    layer = next(layer for layer in aside.view_layers if layer.use)
    opaque.set_up(aside, layer, _AOVS)
    _one_sample(aside)
    _only(aside.render, pixel, size)
    with tempfile.TemporaryDirectory(prefix="nacre-") as folder:
        path = Path(folder, "probe.exr")
        aside.render.filepath = str(path)
        bpy.ops.render.render(scene=aside.name, write_still=True)
        return read_channels(path)


def _one_sample(aside: bpy.types.Scene) -> None:
    """In the middle of the pixel, sharp, on the CPU, which has no kernels to load."""
    cycles = aside.cycles
    aside.render.use_motion_blur = False
    cycles.device = "CPU"
    cycles.samples = 1
    cycles.use_animated_seed = False
    cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    cycles.filter_width = 0.01  # the least there is
    settings = aside.render.image_settings
    if hasattr(settings, "media_type"):  # Blender 5: the format has to belong to the medium
        settings.media_type = "MULTI_LAYER_IMAGE"
    settings.file_format = "OPEN_EXR_MULTILAYER"
    settings.color_depth, settings.exr_codec = "32", "NONE"


def _only(render: bpy.types.RenderSettings, pixel: tuple[int, int], size: tuple[int, int]) -> None:
    """A border around one pixel. Whether Blender rounds it or cuts it off: a quarter of a pixel
    further comes to the same."""
    (width, height), (x, from_top) = size, pixel
    y = height - 1 - from_top
    render.resolution_x, render.resolution_y = size
    render.use_border = render.use_crop_to_border = True
    render.border_min_x, render.border_max_x = (x + 0.25) / width, min(1.0, (x + 1.25) / width)
    render.border_min_y, render.border_max_y = (y + 0.25) / height, min(1.0, (y + 1.25) / height)


def _probe(
    channels: dict[str, Sequence[float]],
    pixel: tuple[int, int],
    materials: list[bpy.types.Material],
) -> Probe:
    if channels["Combined.A"][0] == 0.0:
        raise ProbeError(f"pixel {pixel[0]} {pixel[1]}: there is nothing")
    number = round(channels[f"{_AOVS[opaque.ID]}.X"][0])
    if number == 0:
        raise ProbeError(f"pixel {pixel[0]} {pixel[1]}: there is no wave material")
    material = materials[number - 1]
    found = (pixel, material.name, kind(material), _reading(channels))
    try:
        return measure(*found, _sample(material))
    except RecipeError as error:  # made by an older version: its layers are not known
        return Probe(*found, problem=str(error))


def _reading(channels: dict[str, Sequence[float]]) -> Reading:
    def value(name: str, letters: str = "X") -> tuple[float, ...]:
        return tuple(channels[f"{_AOVS[name]}.{letter}"][0] for letter in letters)

    return Reading(
        point=value(opaque.POINT, "RGB"),
        normal=value("normal", "RGB"),
        uv=value("uv", "RGB"),
        cos_theta=value("cos_theta")[0],
        is_back=value(opaque.BACK)[0] > 0.5,
        thickness_nm=value("thickness")[0],
    )


def _sample(material: bpy.types.Material) -> Sample | None:
    if not traits(material).probe:
        return None
    made_from = recipe(material)
    thickness = field_nodes.thickness_of(material)
    return Sample(
        made_from.template,
        made_from.conditions,
        thickness.unit_nm,
        varies=thickness.socket is not None,
    )
