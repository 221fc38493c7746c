# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Puts pictures side by side into one .png: an .exr without its noise and through a view transform, a .png
as it is.

usage: side_by_side.py [--view NAME] [--rows N] FILE.png PICTURE…
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import bpy
from PIL import Image

GAP = 8  # pixels


def shown(path: Path, view: str, folder: Path) -> Image.Image:
    """By Blender's compositor, which denoises and knows the view transforms.

    Blender 4.5 does not survive it with the channels of a spectral .exr: develop one first.
    """
    if path.suffix == ".png":
        return Image.open(path).convert("RGB")
    picture = bpy.data.images.load(str(path.resolve()))
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = picture.size
    scene.view_settings.view_transform = view
    if view == "AgX":
        scene.view_settings.look = "AgX - Medium High Contrast"
    scene.use_nodes = True
    tree = scene.node_tree
    tree.nodes.clear()
    source = tree.nodes.new("CompositorNodeImage")
    source.image = picture
    denoise = tree.nodes.new("CompositorNodeDenoise")
    tree.links.new(source.outputs["Image"], denoise.inputs["Image"])
    target = tree.nodes.new("CompositorNodeComposite")
    tree.links.new(denoise.outputs["Image"], target.inputs["Image"])
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(folder / f"{path.stem}.png")
    bpy.ops.render.render(write_still=True)
    return Image.open(scene.render.filepath).convert("RGB")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--view", default="AgX")
    parser.add_argument("--rows", type=int, default=1)
    parser.add_argument("target", type=Path)
    parser.add_argument("pictures", type=Path, nargs="+")
    options = parser.parse_args()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with tempfile.TemporaryDirectory() as folder:
        tiles = [shown(path, options.view, Path(folder)) for path in options.pictures]
    columns = -(-len(tiles) // options.rows)
    width, height = tiles[0].size
    sheet = Image.new(
        "RGB",
        (columns * (width + GAP) - GAP, options.rows * (height + GAP) - GAP),
        "white",
    )
    for number, tile in enumerate(tiles):
        row, column = divmod(number, columns)
        sheet.paste(tile, (column * (width + GAP), row * (height + GAP)))
    sheet.save(options.target)


main()
