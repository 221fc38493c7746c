# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Closed forms of one film, and slits."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ._native import NacreError, check, complexes, doubles, lib, polarisation, text


def _columns(**arguments: np.ndarray) -> np.ndarray:
    """Shape (..., arguments): what the C interface takes, item by item."""
    try:
        return np.stack(np.broadcast_arrays(*arguments.values()), axis=-1)
    except ValueError as error:
        raise NacreError(f"{', '.join(arguments)}: {error}") from error


def film_reflectance(
    model: str,
    n: ArrayLike,
    d_nm: ArrayLike,
    angle_deg: ArrayLike,
    wavelength_nm: ArrayLike,
    pol: str = "u",
    *,
    mirror_reflectance: ArrayLike | None = None,
) -> np.ndarray:
    """Reflectance of one film by a closed form from the literature on rendering.

    Parameters
    ----------
    model : "path_difference" (light in the mirror direction), "airy", "series", "opaque_base",
        "free_film", "etalon" or "recursion"
        Bands without physics; two beams in closed form; cut after two round trips; on a base that
        may absorb; the same medium on both sides; Airy's function; from the base up, total
        reflection included. All but the first and "series" are exact in their domain.
    n : complex, shape (..., 3)
        Indices of ambient, film and base; the film and the ambient are clear.
    d_nm, angle_deg, wavelength_nm : float, shape (...)
        Thickness, nm; angle in the ambient, [0, 90); wavelength in vacuum, nm.
    pol : "s", "p" or "u"
    mirror_reflectance : float, shape (...), optional
        Of "etalon" alone, [0, 1): its mirrors, instead of the faces of the film.

    Returns
    -------
    float64, broadcast shape

    Raises
    ------
    NacreError
        Outside the domain of the form, such as total reflection in the film: names field and item.

    Source: cpp_tools/doc/models.md; Durikovic, Kimura 2006; Sun, Wang 2008; Hirayama et al. 2001;
    Born, Wolf 1999.
    """
    media = complexes(n, "n")
    if media.ndim == 0 or media.shape[-1] != 3:
        raise NacreError(f"n: must list ambient, film and base (got shape {media.shape})")
    if np.any(media[..., :2].imag):
        raise NacreError("n: must be clear in ambient and film; nacre.stack takes absorbing films")
    if mirror_reflectance is not None and model != "etalon":
        raise NacreError("mirror_reflectance: belongs to the model 'etalon'")
    queries = _columns(
        n_ambient=media[..., 0].real,
        n_film=media[..., 1].real,
        n_base=media[..., 2].real,
        k_base=media[..., 2].imag,
        d_nm=doubles(d_nm, "d_nm"),
        angle_deg=doubles(angle_deg, "angle_deg"),
        wavelength_nm=doubles(wavelength_nm, "wavelength_nm"),
        mirror_reflectance=_mirrors(mirror_reflectance),
    )
    reflected = np.empty(queries.shape[:-1])
    which = polarisation(pol)
    check(
        lib.nacre_film_reflectance(
            text(model, "model"), reflected.size, queries.ctypes.data, which, reflected.ctypes.data
        )
    )
    return reflected


def _mirrors(reflectance: ArrayLike | None) -> np.ndarray:
    """Negative where the faces of the film are the mirrors."""
    if reflectance is None:
        return np.array(-1.0)
    given = doubles(reflectance, "mirror_reflectance")
    if not np.all((given >= 0) & (given < 1)):
        raise NacreError("mirror_reflectance: must be in [0, 1)")
    return given


def slit_intensity(
    width_nm: ArrayLike,
    angle_deg: ArrayLike,
    wavelength_nm: ArrayLike,
    spacing_nm: ArrayLike = 0.0,
) -> np.ndarray:
    """Intensity far behind one slit or two, 1 straight ahead.

    Parameters
    ----------
    width_nm, spacing_nm, wavelength_nm : float, shape (...)
        Width of a slit; distance between the centres of two, at least a width, 0 for one slit; nm.
    angle_deg : float, shape (...)
        Away from straight ahead, [-90, 90].

    Returns
    -------
    float64, broadcast shape

    Raises
    ------
    NacreError
        Names field and item.

    Source: Fraunhofer diffraction (Born, Wolf 1999, section 8.5).
    """
    slits = _columns(
        width_nm=doubles(width_nm, "width_nm"),
        spacing_nm=doubles(spacing_nm, "spacing_nm"),
        angle_deg=doubles(angle_deg, "angle_deg"),
        wavelength_nm=doubles(wavelength_nm, "wavelength_nm"),
    )
    intensity = np.empty(slits.shape[:-1])
    check(lib.nacre_slit_intensity(intensity.size, slits.ctypes.data, intensity.ctypes.data))
    return intensity
