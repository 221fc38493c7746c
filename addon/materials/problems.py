# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What keeps a material from showing its right colours, and the operator that mends it."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.form import OSL


@dataclass(frozen=True)
class SceneState:
    """What the scene and the file say, as far as it matters."""

    engine: str
    has_osl: bool
    osl_on: bool
    gpu_without_osl: bool  # device is a GPU whose back end cannot run OSL
    motion_blur: bool
    flat_shutter: bool
    missing_tables: tuple[str, ...] = ()


@dataclass(frozen=True)
class AssignedMaterial:
    """What an assigned material says about itself."""

    form: str
    wavelength_per_path: bool
    refusal: str = ""  # why it must not be changed


@dataclass(frozen=True)
class Problem:
    text: str
    operator: str | None  # bl_idname of the mend
    action: str = ""


def find_problems(material: AssignedMaterial, scene: SceneState) -> list[Problem]:
    problems = []
    if material.refusal:
        problems.append(Problem(material.refusal, None))
    if scene.missing_tables:
        names = ", ".join(scene.missing_tables)
        problems.append(
            Problem(
                f"Shown flat, as tables are missing: {names}",
                "nacre.rebuild_material",
                "Rebuild Material",
            )
        )
    if material.form == OSL:
        problems += _osl_problems(scene)
        if material.wavelength_per_path:
            problems += _wavelength_problems(scene)
    return problems


def _osl_problems(scene: SceneState) -> list[Problem]:
    if not scene.has_osl:
        return [Problem("This Blender has no Open Shading Language", None)]
    problems = []
    if scene.engine != "CYCLES":
        problems.append(
            Problem("The render engine is not Cycles", "nacre.use_cycles", "Use Cycles")
        )
    if scene.gpu_without_osl:
        problems.append(
            Problem(
                "This GPU cannot run Open Shading Language", "nacre.use_cpu", "Render on the CPU"
            )
        )
    if not scene.osl_on:
        problems.append(
            Problem(
                "Open Shading Language is off", "nacre.use_osl", "Turn On Open Shading Language"
            )
        )
    return problems


def _wavelength_problems(scene: SceneState) -> list[Problem]:
    if not scene.motion_blur:
        text = "Motion blur is off, so every path has the same wavelength"
        return [Problem(text, "nacre.use_wavelengths", "Turn On Wavelengths")]
    if not scene.flat_shutter:
        text = "The shutter curve is not flat, which tints the wavelengths"
        return [Problem(text, "nacre.use_wavelengths", "Flatten Shutter Curve")]
    return []
