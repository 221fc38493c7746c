# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that suit materials, by name."""

from __future__ import annotations

from collections.abc import Callable

import bpy

from . import (
    animals,
    helmets,
    insects,
    liquids,
    metal,
    minerals,
    optics,
    paint,
    silicon,
    vessels,
    watch,
)
from .portrayed import Portrayed

_BUILDERS = (
    liquids.bubble, liquids.dome, liquids.puddle, liquids.pan, liquids.drop,
    vessels.vase, vessels.jar, vessels.bowl, vessels.cup, vessels.saucepan, vessels.bauble,
    vessels.pearls,
    metal.blade, metal.spring, metal.bolt, metal.exhaust, metal.carabiner, metal.ring, metal.coin,
    watch.watch,
    insects.beetle, insects.jewel_beetle, insects.butterfly, insects.wing, insects.fly_wing,
    animals.feather, animals.pigeon, animals.fish, animals.shell,
    minerals.brilliant, minerals.faceted, minerals.cabochon, minerals.crystal, minerals.druse,
    minerals.ore,
    optics.lens, optics.spectacles, optics.mirror, optics.filter, optics.pane, optics.lantern,
    optics.window, optics.ball, optics.disc,
    helmets.visor, helmets.helmet,
    paint.speedform, paint.guitar, paint.banknote,
    silicon.wafer, silicon.wafers, silicon.cell,
)  # fmt: skip

OBJECTS: dict[str, Callable[[bpy.types.Scene], Portrayed]] = {
    builder.__name__: builder for builder in _BUILDERS
}
