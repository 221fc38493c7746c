# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the nodes of lamps come to in bands, for engines that do not look at them."""

from __future__ import annotations

import bpy
import numpy as np

from .attributes import BASIS, polynomial_variable
from .described import DAYLIGHT, Described
from .groups import LIGHT_OF_COLOUR, LIGHT_OF_MIXTURE
from .marks import LUMINANCE, MADE, SPECTRUM, UPSAMPLING
from .plan import Plan


def lamps_in_bands(plan: Plan) -> dict[bpy.types.Light, np.ndarray]:
    """In each band, of lamps whose colour is one that is known."""
    found = {}
    for light in bpy.data.lights:
        sources = [node for node in light.node_tree.nodes if MADE in node] if MADE in light else []
        values = _values(sources[0], plan) if len(sources) == 1 else None
        if values is not None:
            found[light] = values
    return found


def _values(node: bpy.types.ShaderNodeGroup, plan: Plan) -> np.ndarray | None:
    group = node.node_tree
    if SPECTRUM in group:
        spectrum = Described.parse(group[SPECTRUM])
        return plan.values[spectrum.attribute] * node.inputs[LUMINANCE].default_value
    colour, daylight = node.inputs["Color"], plan.values[DAYLIGHT.attribute]
    if group.get(UPSAMPLING) == LIGHT_OF_COLOUR:
        t = np.array([polynomial_variable(nm) for nm in plan.bands.wavelength_nm])
        x = np.polyval(node.inputs["Coefficients"].default_value, t)
        filtered = 0.5 + 0.5 * x / np.sqrt(1.0 + x * x)
        return filtered * daylight * node.inputs["Scale"].default_value
    if group.get(UPSAMPLING) == LIGHT_OF_MIXTURE and not colour.is_linked:
        parts = [
            plan.values[name] * c for name, c in zip(BASIS, colour.default_value, strict=False)
        ]
        return sum(parts) * daylight
    return None
