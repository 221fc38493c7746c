# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""From pictures in bands to colours: for other eyes, for cameras, under other lamps."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi
from ._bands import Bands, Light, LightRecords
from ._native import NacreError, check, doubles, lib, number, text


class Sensitivities(NamedTuple):
    """A camera of one's own: relative sensitivities of red, green and blue, >= 0, shape (3, N), at ascending
    wavelengths in nm, (N,); nothing beyond them."""

    wavelength_nm: ArrayLike
    values: ArrayLike


class Metamerism(NamedTuple):
    """How far two places fall apart, in CIEDE2000.

    index: where the second is first multiplied, channel by channel of XYZ, so that both are alike as they are
    lit (special index of metamerism for a change in illuminant, CIE 015:2018).
    """

    difference: float
    index: float  # type: ignore[assignment]


def cameras() -> list[str]:
    """Keys of measured cameras: `nikon-d5100`."""
    return [lib.nacre_camera_key(index).decode() for index in range(lib.nacre_camera_count())]


def bands_of(
    wavelength_nm: ArrayLike,
    edges_nm: ArrayLike | None = None,
    is_line: ArrayLike | None = None,
    observer: str = "cie1931",
) -> Bands:
    """Bands as a spectral picture has them.

    Parameters
    ----------
    wavelength_nm : float, shape (N,)
        Ascending, 300 at most.
    edges_nm : float, shape (N + 1,), optional
        Ascending from 360 to 830; without them bands meet half way between wavelengths.
    is_line : bool, shape (N,), optional
        Whether a band was made for a line.
    observer : "cie1931" or "cie1964"

    Returns
    -------
    Bands

    Raises
    ------
    NacreError
        Edges that do not ascend or do not cover 360-830 nm, a wavelength outside its band.
    """
    nm = doubles(wavelength_nm, "wavelength_nm")
    if nm.ndim != 1:
        raise NacreError(f"wavelength_nm: must have one axis (got shape {nm.shape})")
    edges = None if edges_nm is None else doubles(edges_nm, "edges_nm", (nm.size + 1,))
    lines = None if is_line is None else np.ascontiguousarray(is_line, dtype=np.uint8)
    if lines is not None and lines.shape != nm.shape:
        raise NacreError(f"is_line: must have shape {nm.shape} (got {lines.shape})")
    handle = ctypes.c_void_p()
    check(
        lib.nacre_bands_of(
            nm.size,
            _address(edges),
            nm.ctypes.data,
            _address(lines),
            text(observer, "observer"),
            ctypes.byref(handle),
        )
    )
    return Bands(handle, observer)


def colours(
    bands: Bands,
    *,
    observer: str | None = None,
    camera: str | Sensitivities | None = None,
    raw: bool = False,
    white: ArrayLike | None = None,
    adaptation: str = "bradford",
    exposure: float = 0.0,
) -> np.ndarray:
    """The colour of an emission of 1 per nm in each band: radiances (..., N) are `radiance @ colours`.

    Parameters
    ----------
    bands : Bands
    observer : "cie1931" or "cie1964", optional
        Default: that of the bands.
    camera : str or Sensitivities, optional
        One of `cameras`, or one's own, in place of an eye. Its channels are balanced by its white and taken to
        XYZ by the matrix that fits the reflectances of the library under that white best.
    raw : bool
        The camera's channels, balanced and in no space.
    white : float, shape (N,), optional
        A light per nm in each band, as `Bands.in_bands` gives it: what is white. Without it an eye adapts to
        nothing, and a camera to D65.
    adaptation : "bradford", "cat16" or "none"
    exposure : float
        In stops.

    Returns
    -------
    float64, shape (N, 3): XYZ relative to D65, of which white has Y = 1 where it has that to the eye; of a raw
    camera its channels.

    Raises
    ------
    NacreError
        A white that is black, or has nothing that a channel of the camera sees; an unknown name.
    """
    viewer = _capi.Viewer()
    kept: list[np.ndarray] = []
    if observer is not None:
        viewer.observer = text(observer, "observer")
    if isinstance(camera, Sensitivities):
        nm = doubles(camera.wavelength_nm, "wavelength_nm")
        values = doubles(camera.values, "sensitivity", (3, nm.size))
        kept += [nm, values]
        viewer.samples, viewer.wavelength_nm = nm.size, nm.ctypes.data
        viewer.sensitivity = values.ctypes.data
    elif camera is not None:
        viewer.camera = text(camera, "camera")
    viewer.raw = int(raw)
    if white is not None:
        kept.append(doubles(white, "white", (len(bands),)))
        viewer.white = kept[-1].ctypes.data
    viewer.adaptation = text(adaptation, "adaptation")
    viewer.exposure = number(exposure, "exposure")
    found = np.empty((len(bands), 3))
    check(lib.nacre_colours_of_bands(bands.handle, ctypes.byref(viewer), found.ctypes.data))
    return found


def exchange(bands: Bands, power: ArrayLike, light: Light, name: str = "") -> np.ndarray:
    """By how much light in each band changes when another lamp takes the place of one, as bright.

    Parameters
    ----------
    bands : Bands
    power : float, shape (N,)
        Of the lamp before, per nm in each band.
    light : str, Spectrum, Lines or LightSamples
        The new one.
    name : str
        Of the lamp before, for messages.

    Returns
    -------
    float64, shape (N,); 0 where neither shines.

    Raises
    ------
    NacreError
        A new lamp that shines where the old one does not.
    """
    before = doubles(power, "power", (len(bands),))
    given = LightRecords([light])
    factors = np.empty(len(bands))
    check(
        lib.nacre_exchange_light(
            bands.handle,
            before.ctypes.data,
            text(name, "name"),
            ctypes.byref(given.records[0]),
            factors.ctypes.data,
        )
    )
    return factors


def metamerism(
    bands: Bands,
    first: ArrayLike,
    second: ArrayLike,
    power: ArrayLike,
    light: Light,
    name: str = "",
) -> Metamerism:
    """How far two places of a picture fall apart under another light.

    Parameters
    ----------
    bands : Bands
    first, second : float, shape (N,)
        Radiance per nm in each band.
    power : float, shape (N,)
        Of the lamp that both are lit by, and `name`, what messages call it.
    light : str, Spectrum, Lines or LightSamples
        The other one.
    name : str

    Returns
    -------
    Metamerism

    Raises
    ------
    NacreError
        A light that shines where the lamp does not.
    """
    shape = (len(bands),)
    given = LightRecords([light])
    arrays = [
        doubles(values, label, shape)
        for values, label in ((first, "first"), (second, "second"), (power, "power"))
    ]
    difference, index = ctypes.c_double(), ctypes.c_double()
    check(
        lib.nacre_metamerism(
            bands.handle,
            *(values.ctypes.data for values in arrays),
            text(name, "name"),
            ctypes.byref(given.records[0]),
            ctypes.byref(difference),
            ctypes.byref(index),
        )
    )
    return Metamerism(difference.value, index.value)


def _address(values: np.ndarray | None) -> int | None:
    return None if values is None else values.ctypes.data
