# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Bands: spectra as a few numbers, three of which a renderer takes at a time."""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Iterable, Sequence
from ctypes import c_void_p
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi
from ._native import NacreError, check, doubles, lib, number, text
from .library import Spectrum


class Lines(NamedTuple):
    """A light of lines without width: where they are (nm) and the power of each."""

    wavelength_nm: ArrayLike
    power: ArrayLike


class LightSamples(NamedTuple):
    """A light by its power per nm at ascending wavelengths, linear in between and the nearest one
    outside; `lines` come on top of it."""

    wavelength_nm: ArrayLike
    power: ArrayLike
    lines: Lines | None = None


Light = str | Spectrum | Lines | LightSamples
"""A name (`nacre.illuminant` lists them), a spectrum of a library or a file, lines, samples."""


class BandError(NamedTuple):
    """CIEDE2000 between the sum over bands and that over 0.1 nm, relative to the light's white."""

    mean: float
    max: float


class BandChoice(NamedTuple):
    """How many bands a scene asks for, and why.

    passes: of three bands; error: of reflectances under the light that is
    worst off; film_error: mean CIEDE2000 of films, likewise; step_px: the widest step of what
    disperses, between wavelengths of one channel, where it is bright enough to be seen; held: what
    is nearest to its limit: "lights", "lines", "films" or "spreads"; met: whether all are within
    their limits.
    """

    passes: int
    error: BandError
    film_error: float
    step_px: float
    held: str
    met: bool


class LightRecords:
    """What the library reads of some lights, and the arrays behind it, as long as this lives."""

    def __init__(self, lights: Sequence[Light]) -> None:
        self.records = (_capi.Light * max(1, len(lights)))()
        self.count = len(lights)
        self._kept: list[Any] = []
        for record, light in zip(self.records, lights):  # noqa: B905 one record where there is none
            self._fill(record, light)

    def _fill(self, record: _capi.Light, light: Light) -> None:
        if isinstance(light, str):
            record.name = text(light, "light")
            return
        lines: Lines | None = None
        if isinstance(light, Lines):
            lines = light
        elif isinstance(light, LightSamples):
            lines = light.lines
            self._samples(record, light.wavelength_nm, light.power)
        elif isinstance(light, Spectrum):
            if light.kind == "reflectance":
                raise NacreError(f"light: {light.name} is a reflectance")
            self._samples(record, light.wavelength_nm, light.values)
        else:
            raise NacreError(
                f"light: must be a name, a Spectrum, Lines or LightSamples (got {light!r})"
            )
        if lines is not None:
            nm, power = self._pair(lines.wavelength_nm, lines.power, "lines")
            record.lines, record.line_nm, record.line_power = (
                nm.size,
                nm.ctypes.data,
                power.ctypes.data,
            )
            if nm.size == 0 and record.count == 0:
                raise NacreError("lines: must be one or more")

    def _samples(self, record: _capi.Light, wavelength_nm: ArrayLike, power: ArrayLike) -> None:
        nm, values = self._pair(wavelength_nm, power, "power")
        record.count, record.wavelength_nm, record.power = (
            nm.size,
            nm.ctypes.data,
            values.ctypes.data,
        )
        if nm.size == 0:
            raise NacreError("power: must have two or more samples")

    def _pair(
        self, wavelength_nm: ArrayLike, values: ArrayLike, name: str
    ) -> tuple[np.ndarray, np.ndarray]:
        nm = np.atleast_1d(doubles(wavelength_nm, "wavelength_nm"))
        if nm.ndim != 1:
            raise NacreError(f"wavelength_nm: must have one axis (got shape {nm.shape})")
        of_them = doubles(np.atleast_1d(doubles(values, name)), name, nm.shape)
        self._kept += [nm, of_them]
        return nm, of_them


class Bands:
    """Bands that cover 360-830 nm, each with one wavelength at which surfaces are looked up.

    Made by `bands` and `choose_bands`. With R a reflectance read at `wavelength_nm`, the colour of a
    surface under a light is `xyz(R * light)`, `light` being `in_bands` of it.

    Attributes
    ----------
    edges_nm : float64 (N + 1,)
    wavelength_nm : float64 (N,)
        The band's middle to the eye, or its line.
    XYZ : float64 (N, 3)
        Colour of an emission of 1 per nm in each band; all together have Y = 1.
    is_line : bool (N,)
        Whether a band was made for a line of a light.
    observer : str
    """

    def __init__(self, handle: c_void_p, observer: str) -> None:
        self.handle = handle
        weakref.finalize(self, lib.nacre_bands_free, handle)
        count = lib.nacre_bands_count(handle)
        self.observer = observer
        self.edges_nm = np.empty(count + 1)
        self.wavelength_nm = np.empty(count)
        self.XYZ = np.empty((count, 3))
        is_line = np.empty(count, dtype=np.uint8)
        arrays = (self.edges_nm, self.wavelength_nm, self.XYZ, is_line)
        check(lib.nacre_bands_get(handle, *(array.ctypes.data for array in arrays)))
        self.is_line = is_line.astype(bool)

    def __len__(self) -> int:
        return int(self.wavelength_nm.size)

    def in_bands(self, light: Light) -> np.ndarray:
        """Power of a light per nm in each band, float64 (N,), >= 0.

        Near its mean over the band, and such that colours of smooth reflectances come out right: a
        least-squares fit over cosines of the wavelength. A line that has a band is in that alone.

        Raises
        ------
        NacreError
            An unknown name, negative power, none at all, a line outside 360-830 nm.
        """
        given = LightRecords([light])
        power = np.empty(len(self))
        check(
            lib.nacre_light_in_bands(self.handle, ctypes.byref(given.records[0]), power.ctypes.data)
        )
        return power

    def xyz(self, values: ArrayLike) -> np.ndarray:
        """XYZ, float64 (..., 3), of radiances per nm (..., N).

        k = 1 / integral of y over wavelengths: an emission of 1 everywhere has Y = 1.
        """
        radiance = doubles(values, "values")
        if radiance.shape[-1:] != (len(self),):
            raise NacreError(f"values: must have shape (..., {len(self)}) (got {radiance.shape})")
        return radiance @ self.XYZ

    def error(self, light: Light, wavelength_nm: ArrayLike, reflectances: ArrayLike) -> BandError:
        """How far colours of reflectances are from the sum over every 0.1 nm.

        Parameters
        ----------
        light : str, Spectrum, Lines or LightSamples
        wavelength_nm : float, shape (M,), ascending
        reflectances : float, shape (..., M)
        """
        nm, rows = _rows(wavelength_nm, reflectances, "reflectances")
        given = LightRecords([light])
        mean, largest = ctypes.c_double(), ctypes.c_double()
        check(
            lib.nacre_band_error(
                self.handle,
                ctypes.byref(given.records[0]),
                nm.size,
                nm.ctypes.data,
                len(rows),
                rows.ctypes.data,
                ctypes.byref(mean),
                ctypes.byref(largest),
            )
        )
        return BandError(mean.value, largest.value)


def _rows(wavelength_nm: ArrayLike, values: ArrayLike, name: str) -> tuple[np.ndarray, np.ndarray]:
    nm, rows = doubles(wavelength_nm, "wavelength_nm"), doubles(values, name)
    if nm.ndim != 1 or rows.shape[-1:] != nm.shape:
        raise NacreError(
            f"{name}: must have shape (..., {nm.size}) for {nm.size} wavelengths (got {rows.shape})"
        )
    return nm, np.ascontiguousarray(rows.reshape(-1, nm.size))


def bands(count: int, lights: Iterable[Light] = (), observer: str = "cie1931") -> Bands:
    """Bands for some lights together.

    Half of their spacing follows the eye, the root of x + y + z, the other half the lights: bands
    are narrow where a lamp has peaks, and a line has one of its own.

    Parameters
    ----------
    count : int
        3 to 300, and at least one for each line and for what is between two lines.
    lights : iterable of str, Spectrum, Lines or LightSamples
        None: for the eye alone.
    observer : "cie1931" or "cie1964"

    Returns
    -------
    Bands

    Raises
    ------
    NacreError
        A count out of range; what `Bands.in_bands` refuses.
    """
    if not isinstance(count, (int, np.integer)) or isinstance(count, bool) or count < 0:
        raise NacreError(f"count: must be a whole number (got {count!r})")
    given = LightRecords(list(lights))
    handle = c_void_p()
    check(
        lib.nacre_bands_make(
            int(count),
            given.count,
            given.records,
            text(observer, "observer"),
            ctypes.byref(handle),
        )
    )
    return Bands(handle, observer)


def choose_bands(
    lights: Iterable[Light],
    *,
    wavelength_nm: ArrayLike = (),
    reflectances: ArrayLike | None = None,
    films_nm: Iterable[float] = (),
    film_reflectances: ArrayLike | None = None,
    spreads_px: ArrayLike | None = None,
    mean_error: float = 0.1,
    max_error: float = 0.3,
    observer: str = "cie1931",
) -> tuple[Bands, BandChoice]:
    """The fewest bands that show a scene as it is, within errors.

    Parameters
    ----------
    lights : iterable of str, Spectrum, Lines or LightSamples, one or more
    wavelength_nm : float, shape (M,), ascending
        Of `reflectances`, `film_reflectances` and `spreads_px`.
    reflectances : float, shape (..., M), optional
        Of surfaces; by default all that the library has.
    films_nm : iterable of float
        Optical thickness of films, index times thickness, whose fringes have to be told apart.
    film_reflectances : float, shape (F, M), optional
        Of each of `films_nm`, of which equal ones are one film at several thicknesses, as
        `film_fringes` has them; by default fringes of full contrast.
    spreads_px : float, shape (..., M), optional
        For what disperses: where in an image light of each wavelength comes to lie, in pixels. Steps
        of 1.3 pixels do not show.
    mean_error, max_error : float
        CIEDE2000 allowed for reflectances; the mean also for films.
    observer : "cie1931" or "cie1964"

    Returns
    -------
    (Bands, BandChoice)

    Raises
    ------
    NacreError
        No light, more lines than the most passes can hold, an error that is not > 0.
    """
    given = LightRecords(list(lights))
    empty = np.empty((0, 1))
    nm, rows = (doubles(wavelength_nm, "wavelength_nm"), empty)
    if reflectances is not None:
        nm, rows = _rows(wavelength_nm, reflectances, "reflectances")
    spreads = empty if spreads_px is None else _rows(wavelength_nm, spreads_px, "spreads_px")[1]
    films = doubles([number(film, "films_nm") for film in films_nm], "films_nm")
    of_films = None
    if film_reflectances is not None:
        of_films = _rows(wavelength_nm, film_reflectances, "film_reflectances")[1]
        if len(of_films) != films.size:
            raise NacreError(
                f"film_reflectances: must be one for each of films_nm, {films.size} "
                f"(got {len(of_films)})"
            )
    needs = _capi.BandNeeds(
        lights=given.count,
        light=given.records,
        samples=nm.size,
        wavelength_nm=nm.ctypes.data,
        reflectances=len(rows),
        reflectance=rows.ctypes.data,
        films=films.size,
        film_nm=films.ctypes.data,
        film_reflectance=None if of_films is None else of_films.ctypes.data,
        spreads=len(spreads),
        spread_px=spreads.ctypes.data,
        mean_error=number(mean_error, "mean_error"),
        max_error=number(max_error, "max_error"),
    )
    handle, choice = c_void_p(), _capi.BandChoice()
    check(
        lib.nacre_bands_choose(
            ctypes.byref(needs),
            text(observer, "observer"),
            ctypes.byref(handle),
            ctypes.byref(choice),
        )
    )
    return Bands(handle, observer), BandChoice(
        choice.passes,
        BandError(choice.mean_error, choice.max_error),
        choice.film_error,
        choice.step_px,
        choice.held.decode(),
        bool(choice.met),
    )
