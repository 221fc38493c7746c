# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Icons that are drawn: colours, spectra, and pictures of what a panel shows."""

from __future__ import annotations

from functools import lru_cache

import bpy
import bpy.utils.previews

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []  # one at most
_shown: dict[str, tuple] = {}  # what each icon was drawn from

SMALL = 32  # pixels of what is shown in buttons
MOST_ICONS = 256  # more than any window shows; older ones are drawn again when they are wanted


def curve(name: str, values: tuple[float, ...]) -> int:
    """Icon of a spectrum that is known already, 471 values from 360 nm."""
    return drawn(name, (values,), draw_curve)


def chip(rgb: tuple[float, float, float]) -> int:
    """Icon of one colour, sRGB from 0 to 1."""
    code = "".join(f"{round(255.0 * channel):02x}" for channel in rgb)
    return drawn(f"#{code}", (rgb,), _draw_chip)


def drawn(name: str, key: tuple, draw) -> int:
    """Icon of the picture that `draw(*key)` gives, drawn again when the key is another."""
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


def unregister() -> None:
    while _collections:
        bpy.utils.previews.remove(_collections.pop())
    _shown.clear()


def _draw_chip(rgb: tuple[float, float, float]):
    from ..core import plot

    return plot.chip(rgb)


def draw_curve(values: tuple[float, ...]):
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
