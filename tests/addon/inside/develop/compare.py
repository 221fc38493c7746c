# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Two places of a picture that one light is in, under another; and that light exchanged."""

from __future__ import annotations

import json
import sys

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

load().register()
session = module("develop.session")
new_file()
settings = bpy.context.window_manager.nacre_develop
assert bpy.ops.nacre.develop(filepath=sys.argv[1]) == {"FINISHED"}
settings.side = 1
for x, y in ((3, 4), (20, 9)):
    assert bpy.ops.nacre.measure_spectrum(x=x, y=y) == {"FINISHED"}
settings.under = "A"
apart = session.shown().apart
before = session.shown().places[0].rgb
settings.lamps[0].light = "A"
assert not session.shown().problem
assert not np.allclose(session.shown().places[0].rgb, before, rtol=0.05)
# They are compared as they would be under that light, whatever lamps are now.
np.testing.assert_allclose(session.shown().apart.difference, apart.difference, rtol=1e-6)
print(json.dumps({"difference": apart.difference, "index": apart.index}))
