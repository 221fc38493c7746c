# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Icons of an edited stack: colours over angle and thickness, and a spectrum."""

from __future__ import annotations

from functools import lru_cache

import bpy
import bpy.utils.previews

from . import edited as stack

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []  # one at most
_shown: dict[str, tuple] = {}  # what each icon was drawn from

COLUMNS, ROWS = 48, 96
SMALL = 32  # pixels of what is shown in buttons
MOST_ICONS = 256  # more than any window shows; older ones are drawn again when they are wanted


def swatch(material: bpy.types.Material) -> int:
    """Icon of the colours over angle (right: grazing) and thickness (up: more)."""
    wanted = stack.recipe(material)
    rows = 1 if not _varies(wanted.template) else ROWS
    key = (stack.library_digest(wanted), wanted, rows)
    return _icon(f"{material.session_uid}:swatch", key, _draw_swatch)


def spectrum(material: bpy.types.Material, value: float, angle_deg: float) -> int:
    """Icon of R from 380 to 780 nm at a value of what varies."""
    wanted = stack.recipe(material)
    key = (stack.library_digest(wanted), wanted, round(value, 3), round(angle_deg, 1))
    return _icon(f"{material.session_uid}:spectrum", key, _draw_spectrum)


def curve(name: str, values: tuple[float, ...]) -> int:
    """Icon of a spectrum that is known already, 471 values from 360 nm."""
    return _icon(name, (values,), _draw_curve)


def chip(rgb: tuple[float, float, float]) -> int:
    """Icon of one colour, sRGB from 0 to 1."""
    code = "".join(f"{round(255.0 * channel):02x}" for channel in rgb)
    return _icon(f"#{code}", (rgb,), _draw_chip)


def drawn(name: str, key: tuple, draw) -> int:
    """Icon of the picture that `draw(*key)` gives, drawn again when the key is another."""
    return _icon(name, key, draw)


def unregister() -> None:
    while _collections:
        bpy.utils.previews.remove(_collections.pop())
    _shown.clear()


@lru_cache(maxsize=64)
def _varies(template: str) -> bool:
    made = stack.read_stack(template)
    return made.varying is not None or made.has_scale


def _icon(name: str, key: tuple, draw) -> int:
    if not _collections:
        _collections.append(bpy.utils.previews.new())
    icons = _collections[0]
    icon = icons.pop(name, None) or icons.new(name)
    icons[name] = icon  # at the end: the first one is that which was not wanted for longest
    if len(icons) > MOST_ICONS:
        oldest = next(iter(icons))
        del icons[oldest]
        _shown.pop(oldest, None)
    if _shown.get(name) != key:
        _shown[name] = key  # what cannot be drawn is not tried again at each redraw
        try:
            picture = draw(*key)
        except ValueError:  # of an unfinished edit; the panel says what is wrong
            return icon.icon_id
        icon.image_size = picture.shape[1], picture.shape[0]
        icon.image_pixels_float.foreach_set(picture.ravel())
        if max(picture.shape) <= SMALL:  # buttons show the icon, and not the image
            icon.icon_size = picture.shape[1], picture.shape[0]
            icon.icon_pixels_float.foreach_set(picture.ravel())
    return icon.icon_id


def _draw_swatch(_library: str, wanted: stack.Recipe, rows: int):
    import nacre

    from ..core import plot

    tables = nacre.preview_tables(
        wanted.template, {"R": (rows, COLUMNS)}, **wanted.conditions._asdict()
    )
    return plot.swatch(tables["R"])


def _draw_spectrum(_library: str, wanted: stack.Recipe, value: float, angle_deg: float):
    import nacre

    found = nacre.template_spectrum(
        wanted.template, value, angle_deg, **wanted.conditions._asdict()
    )
    return _draw_curve(tuple(found.reflectance))


def _draw_chip(rgb: tuple[float, float, float]):
    from ..core import plot

    return plot.chip(rgb)


def _draw_curve(values: tuple[float, ...]):
    from ..core import plot

    return plot.spectrum(values, _wavelength_colours())


@lru_cache(maxsize=1)
def _wavelength_colours():
    import numpy as np

    import nacre

    to_rec709 = np.array(
        [[3.2409699, -1.5373832, -0.4986108],
         [-0.9692436, 1.8759675, 0.0415551],
         [0.0556301, -0.2039770, 1.0569715]]
    )  # fmt: skip
    return np.asarray(nacre.colour_matching("cie1931")) @ to_rec709.T
