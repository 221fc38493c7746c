# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectra as files keep them: by samples of their own, so that a file shows the same on a machine whose
library lacks them, or by what can be computed anywhere."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..core.faults import ForeseenError
from ..core.light import FIRST_NM
from ..core.versioned import parsed
from .attributes import PREFIX

if TYPE_CHECKING:
    import numpy as np

    import nacre

VERSION = 1
EMISSION, REFLECTANCE = "emission", "reflectance"
CONSTANT = "optical constant"
"""n or k of a metal."""
KINDS = (EMISSION, REFLECTANCE, CONSTANT)
RGB_NM = (612.0, 549.0, 465.0)
"""Where channels have their values of optical constants: where the primaries of Rec.709 are."""

_LEAST_K = 0.5
_STEP_NM = 2
"""Of optical constants in files."""


class SpectrumError(ForeseenError):
    """What a file says is no spectrum."""


@dataclass(frozen=True)
class Described:
    """One spectrum. `light`: a light that needs no samples, as `nacre.illuminant` has it."""

    kind: str
    name: str
    light: str = ""
    wavelength_nm: tuple[float, ...] = ()
    values: tuple[float, ...] = ()

    @classmethod
    def named(cls, name: str, kind: str = "") -> Described:
        """A key of the library, a light by its name, or a file, `paints.csv#red` where it has several; kind:
        what its values are where it does not say. Raises SpectrumError."""
        import nacre

        file, _, column = name.partition("#")
        if Path(file).suffix.lower() in FILES:
            return cls._one_of(read(file, kind), file, column)
        try:
            if "/" in name:
                return cls.of_spectrum(nacre.library.spectrum(name))
            nacre.illuminant(name)
        except nacre.NacreError as error:
            raise SpectrumError(str(error)) from error
        return cls(EMISSION, name, light=name)

    @classmethod
    def _one_of(cls, spectra: list[nacre.library.Spectrum], file: str, column: str) -> Described:
        names = [spectrum.name for spectrum in spectra]
        if column in names:
            return cls.of_spectrum(spectra[names.index(column)])
        if column or len(spectra) > 1:
            raise SpectrumError(f"{file}: has {', '.join(names)}: say {file}#NAME")
        return cls.of_spectrum(spectra[0])

    @classmethod
    def of_spectrum(cls, spectrum: nacre.library.Spectrum) -> Described:
        if spectrum.kind not in KINDS:
            raise SpectrumError(f"{spectrum.name}: is neither an emission nor a reflectance")
        nm, values = (
            tuple(float(number) for number in numbers)
            for numbers in (spectrum.wavelength_nm, spectrum.values)
        )
        return cls(spectrum.kind, spectrum.name, wavelength_nm=nm, values=values)

    @classmethod
    def of_metal(cls, key: str) -> tuple[Described, Described]:
        """n and k of a medium of the library. Raises SpectrumError where it is unknown or lets light through."""
        import nacre

        try:
            index = nacre.library.medium(key).index_on_grid()[::_STEP_NM]
        except nacre.NacreError as error:
            raise SpectrumError(str(error)) from error
        if max(index.imag) < _LEAST_K:
            raise SpectrumError(f"{key} is no metal: it takes up hardly any visible light")
        nm = tuple(float(FIRST_NM) + _STEP_NM * step for step in range(len(index)))
        return tuple(
            cls(CONSTANT, f"{key}, {name}", wavelength_nm=nm, values=tuple(values.tolist()))
            for name, values in (("n", index.real), ("k", index.imag))
        )

    def at(self, wavelength_nm: np.ndarray) -> np.ndarray:
        """Of an optical constant: straight between samples, the nearest one beyond."""
        import numpy as np

        return np.interp(wavelength_nm, self.wavelength_nm, self.values)

    @classmethod
    def parse(cls, text: str) -> Described:
        """From what `text` wrote. Raises SpectrumError that says what is wrong."""
        said = parsed(text, VERSION, SpectrumError)
        try:
            found = cls(**{name: _plain(value) for name, value in said.items()})
        except TypeError as error:
            raise SpectrumError(f"cannot be read: {error!r}") from error
        if found.kind not in KINDS or not (found.light or found.wavelength_nm):
            raise SpectrumError("has no kind, or neither a name nor samples")
        return found

    @property
    def text(self) -> str:
        said = {name: value for name, value in asdict(self).items() if value}
        return json.dumps({"version": VERSION, **said}, separators=(",", ":"))

    @property
    def attribute(self) -> str:
        """The name of its property: the same for the same spectrum in every file."""
        digest = hashlib.sha256(self.text.encode()).hexdigest()
        return PREFIX + digest[:16]

    @property
    def as_light(self) -> str | nacre.LightSamples:
        import nacre

        return self.light or nacre.LightSamples(self.wavelength_nm, self.values)

    @property
    def as_spectrum(self) -> nacre.library.Spectrum:
        import nacre

        return nacre.library.Spectrum(
            "", self.name, self.kind, "", "", "", self.wavelength_nm, self.values
        )


FILES = (".csv", ".spd", ".spdx", ".cgats", ".ti3", ".sp", ".txt")
"""Endings of files of spectra."""


def read(file: str, kind: str = "") -> list[nacre.library.Spectrum]:
    """At least one, and each with a name: that of the file where it says none. Raises SpectrumError that names
    the file and what is wrong in it."""
    import nacre

    try:
        spectra = nacre.library.read(file, kind=kind)
    except (nacre.NacreError, OSError) as error:
        raise SpectrumError(str(error)) from error
    if not spectra:
        raise SpectrumError(f"{file}: has no spectrum")
    stem = Path(file).stem
    return [spectrum._replace(name=spectrum.name or stem) for spectrum in spectra]


def _plain(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


DAYLIGHT = Described(EMISSION, "D65", light="D65")
"""What lights are made of whose spectrum nobody states."""
