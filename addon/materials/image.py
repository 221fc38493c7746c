# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as packed images, so that a .blend carries everything that it needs."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import bpy

from ..blender import space
from ..core.manifest import CompiledMaterial, ManifestError, Table
from ..core.space import Matrix

DIGEST, TABLE, FALLBACK, SIZE = "nacre_digest", "nacre_table", "nacre_fallback", "nacre_size"
TABLE_CONTENT = "nacre_table_content"  # of a node: what its image is a table of


def tables_of(tree: bpy.types.NodeTree) -> Iterator[bpy.types.ShaderNodeTexImage]:
    """Nodes that read tables."""
    for node in tree.nodes:
        if node.type == "TEX_IMAGE" and node.image is not None and TABLE in node.image:
            yield node


def table_image(material: CompiledMaterial, table: Table) -> bpy.types.Image:
    """The table's image; one that is in the file already is used again."""
    for image in bpy.data.images:
        of_this_table = image.library is None and image.get(DIGEST) == _key(material, table)
        if of_this_table and not is_missing(image) and space.is_right(image):
            return image
    image = (
        _from_texels(material, table) if material.directory is None else _from_file(material, table)
    )
    try:
        _carry(image, material, table)
    except Exception:
        bpy.data.images.remove(image)
        raise
    image[DIGEST] = _key(material, table)
    image[TABLE] = table.name
    image[SIZE] = (table.width, table.height)
    return image


def _carry(image: bpy.types.Image, material: CompiledMaterial, table: Table) -> None:
    """Packs the texels as numbers, which no configuration changes, in the file's space."""
    hold_as_data(image)
    matrix = space.to_file(material.to_xyz_d65)
    if matrix is not None:
        convert_pixels(image, matrix)
    image.pack()
    space.state(image)
    # The path of the machine that made the material says nothing to the one that opens the file.
    image.filepath_raw = f"//{table.file}"
    size = tuple(image.size)
    if size != (table.width, table.height):
        raise ManifestError(
            f"{table.file}: must be {table.width} x {table.height} texels (got {size[0]} x {size[1]})"
        )


def hold_as_data(image: bpy.types.Image) -> None:
    """By the role, since each colour config has a name of its own for it. What is held so already is
    left alone: setting it again would drop pixels that are not packed yet."""
    if not image.colorspace_settings.is_data:
        image.colorspace_settings.is_data = True


def drop_unused(material: CompiledMaterial) -> None:
    """Tables of a material that could not be made whole."""
    for image in list(bpy.data.images):
        of_this = str(image.get(DIGEST, "")).rpartition(":")[0] == material.digest
        if of_this and image.users == 0 and image.library is None:
            bpy.data.images.remove(image)


def mend_spaces() -> list[str]:
    """Tables whose file was saved under a config that calls data otherwise, where Blender has put a
    colour space in place: data again, those of linked files too, for as long as this one is open.
    Returns their names."""
    mended = []
    for image in bpy.data.images:
        ours = DIGEST in image or image.get(FALLBACK)
        if ours and not image.colorspace_settings.is_data:
            hold_as_data(image)
            mended.append(image.name)
    return mended


def is_missing(image: bpy.types.Image | None) -> bool:
    """Neither packed into the file nor readable from where it lies, of another size than the table,
    or a stand-in for such a one."""
    if image is None or image.get(FALLBACK):
        return True
    if not image.has_data:
        if image.packed_file is not None:
            return (
                image.packed_file.size == 0
            )  # not read now: opening a file would read every table
        if not _lies_there(image):
            return True
    size = tuple(image.size)  # reads the file
    return 0 in size or size != tuple(image.get(SIZE, size))


def _lies_there(image: bpy.types.Image) -> bool:
    path = bpy.path.abspath(image.filepath_raw, library=image.library)
    try:
        return bool(path) and Path(path).is_file()
    except (OSError, ValueError):  # too long a path, or one with a null character
        return False


def _key(material: CompiledMaterial, table: Table) -> str:
    return f"{material.digest}:{table.name}"


def _from_file(material: CompiledMaterial, table: Table) -> bpy.types.Image:
    try:
        image = bpy.data.images.load(str(material.directory / table.file))
    except RuntimeError as error:
        raise ManifestError(f"{table.file}: {error}") from error
    image.name = f"{material.id}_{table.name}"
    image.alpha_mode = "NONE"
    return image


def _from_texels(material: CompiledMaterial, table: Table) -> bpy.types.Image:
    import numpy as np  # some distributions' Blender comes without it; tables in files do not need it

    texels = np.asarray(material.texels[table.name], dtype=np.float32)
    if texels.shape != (table.height, table.width, 3):
        raise ManifestError(
            f"table {table.name}: must have shape {(table.height, table.width, 3)} (got {texels.shape})"
        )
    return image_of_texels(f"{material.id}_{table.name}", texels)


def image_of_texels(name: str, texels) -> bpy.types.Image:
    """A new one, of float32 (H, W, 3) with row 0 on top."""
    height, width = texels.shape[:2]
    image = bpy.data.images.new(name, width, height, float_buffer=True, is_data=True)
    image.alpha_mode = "NONE"  # now: setting it later, or a colour space, would drop the pixels
    fill(image, texels)
    return image


def fill(image: bpy.types.Image, texels, matrix: Matrix | None = None) -> None:
    """With other texels of its size, as `table_pixels` takes them."""
    image.pixels.foreach_set(table_pixels(texels, matrix))
    image.update()


def table_pixels(texels, matrix: Matrix | None = None):
    """What `Image.pixels` takes for float32 (H, W, 3) texels with row 0 on top, in another space where a matrix
    is given."""
    import numpy as np

    rgba = np.ones((*texels.shape[:2], 4), dtype=np.float32)
    rgba[..., :3] = texels[::-1]  # Blender's first row is the bottom one
    return _converted(rgba.reshape(-1, 4), matrix).ravel()


def convert_pixels(image: bpy.types.Image, matrix: Matrix) -> None:
    """Into another space; `pack` keeps it."""
    try:
        import numpy as np
    except ImportError as error:
        raise ManifestError(
            f"{image.name}: tables are in Rec.709, and other working spaces need NumPy: {error}"
        ) from error

    rgba = np.empty(len(image.pixels), dtype=np.float32)
    image.pixels.foreach_get(rgba)
    image.pixels.foreach_set(_converted(rgba.reshape(-1, 4), matrix).ravel())
    image.update()


def _converted(rgba, matrix: Matrix | None):
    import numpy as np

    if matrix is not None:
        rgba[:, :3] = rgba[:, :3].astype(np.float64) @ np.array(matrix).T
    return rgba


def save_png(path: Path, picture) -> None:
    """`picture`: an array (height, width, 4), display-referred, bottom row first. Raises RuntimeError
    where it cannot be written."""
    height, width = picture.shape[:2]
    image = bpy.data.images.new(path.stem, width, height)
    try:
        image.pixels.foreach_set(picture.ravel())
        image.filepath_raw = str(path)
        image.file_format = "PNG"
        image.save()
    finally:
        bpy.data.images.remove(image)
