# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which of its two forms a material takes: OSL is exact, nodes work everywhere."""

from __future__ import annotations

from dataclasses import dataclass

from .faults import ForeseenError
from .manifest import CompiledMaterial

AUTO, OSL, NODES = "auto", "osl", "nodes"


class FormError(ForeseenError):
    """The material has no form that works here."""


@dataclass(frozen=True)
class Renderer:
    """What decides between the forms."""

    has_osl: bool  # this Blender was built with Open Shading Language
    engine: str = "CYCLES"
    device: str = "CPU"
    backend: str = "NONE"  # of a GPU: OPTIX runs OSL, the others do not

    @property
    def runs_osl(self) -> bool:
        if not self.has_osl or self.engine != "CYCLES":
            return False
        return self.device != "GPU" or self.backend in ("NONE", "OPTIX")


def choose_form(material: CompiledMaterial, requested: str, renderer: Renderer) -> str:
    """`osl` or `nodes`.

    Automatic: OSL where the renderer runs it, else nodes; a material that only exists in OSL stays in
    OSL as long as this Blender has it, since the panel offers to change engine and device.
    """
    if requested in (OSL, NODES):
        _require(material, requested, renderer)
        return requested
    if renderer.runs_osl and OSL in material.forms:
        return OSL
    if NODES in material.forms:
        return NODES
    _require(material, OSL, renderer)
    return OSL


def _require(material: CompiledMaterial, form: str, renderer: Renderer) -> None:
    if form not in material.forms:
        detail = "; OSL is needed for it" if form == NODES else ""
        raise FormError(f"{material.name} has no form as {form}{detail}")
    if form == OSL and not renderer.has_osl:
        raise FormError(
            f"OSL needed: {material.name} needs a Blender built with Open Shading Language"
        )
