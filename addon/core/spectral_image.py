# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral pictures: a channel for each wavelength, and the colour that they are to the eye, in one EXR.

Channels are those of A. Fichet, R. Pacanowski, A. Wilkie, "An OpenEXR Layout for Spectral Images",
Journal of Computer Graphics Techniques 10(3), 2021, which other programs read; `nacre:bands` has besides
what the colour is summed with, so that it can be summed anew for another light or eye.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .exr import LINES_OF_ZIP, ExrError, Picture, read_picture
from .exr_write import ExrWriter
from .space import Matrix, conversion_from_xyz
from .versioned import parsed

VERSION = 1
"""Of `nacre:bands`."""
FILE = "nacre_spectral_file"
"""Custom property of a picture in Blender: the file that has its spectra."""
_BANDS, _LIGHTS = "nacre:bands", "nacre:lights"
_SAME_NM = 2e-3
"""Names have three decimals."""


@dataclass(frozen=True)
class BandTable:
    """Of N bands: N + 1 edges, what each is looked up at (nm), its colour, and whether it is a line."""

    observer: str
    edges_nm: Sequence[float]
    wavelength_nm: Sequence[float]
    xyz: Sequence[Sequence[float]]  # of an emission of 1 per nm; all together have Y = 1
    is_line: Sequence[bool]

    @classmethod
    def parse(cls, text: str) -> BandTable:
        """From what `text` wrote. Raises ExrError that says what is wrong."""
        said = parsed(text, VERSION, ExrError)
        try:
            return cls(**said)
        except TypeError as error:
            raise ExrError(f"cannot be read: {error!r}") from error

    @property
    def channels(self) -> list[str]:
        return [channel(nm) for nm in self.wavelength_nm]

    def text(self) -> str:
        return json.dumps(
            {
                "version": VERSION,
                "observer": self.observer,
                "edges_nm": [round(float(nm), 4) for nm in self.edges_nm],
                "wavelength_nm": [float(nm) for nm in self.wavelength_nm],
                "xyz": [[float(value) for value in row] for row in self.xyz],
                "is_line": [bool(line) for line in self.is_line],
            },
            separators=(",", ":"),
        )


def channel(nm: float) -> str:
    """Of unpolarised emission: `S0.589,294nm`."""
    return f"S0.{nm:.3f}nm".replace(".", ",").replace("S0,", "S0.", 1)


@dataclass(frozen=True)
class Lamps:
    """What the lamps of a layer are, where they are of one light, and its power in each band, of Y = 1."""

    light: str
    power: np.ndarray


@dataclass(frozen=True)
class SpectralImage:
    """layers: float32 (height, width, N) per nm in each band, row 0 on top, first that of all light under "",
    then those of light groups under their names; table: None where the file does not say where bands lie."""

    wavelength_nm: np.ndarray
    table: BandTable | None
    layers: dict[str, np.ndarray]
    lamps: dict[str, Lamps]
    alpha: np.ndarray | None

    @property
    def size(self) -> tuple[int, int]:
        height, width = self.layers[""].shape[:2]
        return width, height


def read(path: Path) -> SpectralImage:
    """A picture of any program, with channels of 32 bits. Raises ExrError that names the path, OSError."""
    picture = read_picture(path)
    try:
        return _read(picture)
    except ExrError as error:
        raise ExrError(f"{path}: {error}") from error


def _read(picture: Picture) -> SpectralImage:
    by_layer: dict[str, dict[float, str]] = {}
    for name in picture.channels:
        layer, nm = _parts_of(name)
        if nm is not None:
            by_layer.setdefault(layer, {})[nm] = name
    if "" not in by_layer:
        raise ExrError("has no spectra: channels must be called as S0.550,000nm is")
    table = None
    if _BANDS in picture.attributes:
        try:
            table = BandTable.parse(picture.attributes[_BANDS].decode())
        except (ExrError, UnicodeDecodeError) as error:
            raise ExrError(f"{_BANDS}: {error}") from error
    wavelengths = sorted(by_layer[""]) if table is None else table.wavelength_nm

    def of(names: list[str]) -> np.ndarray:
        values = np.stack([np.frombuffer(picture.channels[n], np.float32) for n in names], axis=-1)
        return values.reshape(picture.height, picture.width, len(names))

    layers = {
        layer: of([_nearest(channels, nm, layer) for nm in wavelengths])
        for layer, channels in sorted(by_layer.items())
    }
    alpha = of(["A"])[..., 0] if "A" in picture.channels else None
    lamps = _lamps_of(picture, layers, len(wavelengths))
    return SpectralImage(np.array(wavelengths, dtype=float), table, layers, lamps, alpha)


def _parts_of(name: str) -> tuple[str, float | None]:
    """Of a channel: its layer and wavelength; None of what is none of a spectrum."""
    layer, found, rest = name.rpartition("S0.")
    if not found or not rest.endswith("nm") or (layer and not layer.endswith(".")):
        return "", None
    try:
        return layer.removesuffix("."), float(rest.removesuffix("nm").replace(",", "."))
    except ValueError:
        return "", None


def _nearest(channels: Mapping[float, str], nm: float, layer: str) -> str:
    found = min(channels, key=lambda each: abs(each - nm))
    if abs(found - nm) > _SAME_NM:
        raise ExrError(f"{layer or 'the picture'} has no channel of {nm:.3f} nm")
    return channels[found]


def _lamps_of(picture: Picture, layers: Mapping[str, np.ndarray], bands: int) -> dict[str, Lamps]:
    if _LIGHTS not in picture.attributes:
        return {}
    found = {}
    try:
        for entry in json.loads(picture.attributes[_LIGHTS].decode()):
            power = np.array(entry["power"], dtype=float)
            if entry["layer"] not in layers or power.shape != (bands,):
                raise ValueError(f"{entry['layer']} with {power.size} powers")
            found[entry["layer"]] = Lamps(str(entry["light"]), power)
    except (ValueError, TypeError, KeyError) as error:
        raise ExrError(f"{_LIGHTS}: cannot be read: {error!r}") from error
    return found


def write(
    path: Path,
    bands: BandTable,
    space: Matrix,
    radiance: np.ndarray,
    *,
    rgb: np.ndarray | None = None,
    alpha: np.ndarray | None = None,
    groups: Mapping[str, np.ndarray] | None = None,
    lights: Sequence[Mapping[str, object]] = (),
) -> None:
    """A picture of `radiance`, float32 (height, width, N), per nm in each band, row 0 on top.

    groups: the same of some of the lamps, by the name of their light group; lights: for those layers whose
    lamps are of one light, `layer` (empty for the whole), `light`, its name, and its `power` in each band, of
    Y = 1.

    rgb: (height, width, 3), what the colour is to be instead of the sum over bands, as after
    denoising; alpha: (height, width). space: of the colour, the matrix to XYZ with white D65.
    Raises OSError that names the path.
    """
    height, width = radiance.shape[:2]
    attributes = {
        "spectralLayoutVersion": "1.0",
        "emissiveUnits": "relative",
        "chromaticities": chromaticities(space),
        _BANDS: bands.text(),
        **({_LIGHTS: json.dumps(list(lights), separators=(",", ":"))} if lights else {}),
    }
    layers = {} if groups is None else groups
    names = ["R", "G", "B", *([] if alpha is None else ["A"]), *bands.channels]
    names += [f"{group}.{name}" for group in layers for name in bands.channels]
    with ExrWriter(path, width, height, names, attributes) as writer:
        for row in range(0, height, LINES_OF_ZIP):
            lines = slice(row, row + LINES_OF_ZIP)
            seen = colour(radiance[lines], bands, space) if rgb is None else rgb[lines]
            parts = [seen, *([] if alpha is None else [alpha[lines, :, None]]), radiance[lines]]
            parts += [of_group[lines] for of_group in layers.values()]
            writer.append(np.concatenate(parts, axis=-1, dtype=np.float32))


def colour(radiance: np.ndarray, bands: BandTable, space: Matrix) -> np.ndarray:
    """(..., 3) in a space of (..., N)."""
    return radiance @ (np.asarray(bands.xyz) @ np.asarray(conversion_from_xyz(space)).T)


def chromaticities(space: Matrix) -> list[float]:
    """xy of red, green, blue and white."""
    primaries = np.asarray(space, dtype=float)
    columns = [*primaries.T, primaries.sum(axis=1)]
    return [float(value) for xyz in columns for value in (xyz / xyz.sum())[:2]]
