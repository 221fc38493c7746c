# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What *Render Spectral* would take, and how near it would come: asked when something changes, since panels
are drawn too often to ask."""

from __future__ import annotations

import bpy

from ..core.faults import ForeseenError

_said: list[str] = []


def lines() -> list[str]:
    """Empty where nobody has asked yet."""
    return _said


def forget() -> None:
    _said.clear()


def look(scene: bpy.types.Scene) -> None:
    from . import needs

    try:
        plan = needs.plan_for(scene)
    except ForeseenError as error:
        _said[:] = [str(error)]
        return
    _said[:] = [f"{len(plan.bands)} bands in {plan.passes} passes"]
    choice = plan.choice
    _said.append(f"ΔE00 {choice.error.mean:.2f}, at most {choice.error.max:.2f}")
    if choice.held == "films":
        _said.append(f"thick films ΔE00 {choice.film_error:.2f}")
    if plan.disperses:
        _said.append(f"glass in steps of {choice.step_px:.1f} px")
