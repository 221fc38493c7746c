# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be looked at instead of the shaded surface: debug views and passes of a render.

The places in the list are the modes of osl/shaders/nacre_debug.osl.
"""

from __future__ import annotations

from dataclasses import dataclass

SHADED = "shaded"


@dataclass(frozen=True)
class Field:
    """`is_vector`: three numbers in world space, else one."""

    id: str
    name: str
    description: str
    is_vector: bool

    @property
    def aov(self) -> str:
        """Name of the pass; no one else's."""
        return f"nacre_{self.id}"


FIELDS = (
    Field("normal", "Normals", "Shading normal, turned to the viewer, with bump and maps", True),
    Field("uv", "UV", "Texture coordinates", True),
    Field("to_camera", "To Camera", "Direction from the point to the camera", True),
    Field("to_light", "To Light", "Direction from the point to the chosen or nearest lamp", True),
    Field(
        "thickness", "Thickness", "Thickness of the film in nm, held to the tables' range", False
    ),
    Field("cos_theta", "Cosθ", "Cosine of the angle of incidence", False),
)


def field(field_id: str) -> Field:
    return next(item for item in FIELDS if item.id == field_id)
