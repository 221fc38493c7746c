# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What *Make Spectral* did, and what it left."""

from __future__ import annotations

from dataclasses import dataclass, field

LINKED = "is linked from another file; stays RGB"


@dataclass(frozen=True)
class Remark:
    """Something that stays RGB: of which block of data, and what."""

    kind: str  # "material", "lamp", "world", "node group", "object"
    name: str
    text: str

    @property
    def where(self) -> str:
        return f"{self.kind} {self.name}"


@dataclass
class Report:
    spectra: int = 0
    remarks: list[Remark] = field(default_factory=list)
