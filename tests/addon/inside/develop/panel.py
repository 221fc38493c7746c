# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Everything that the panel offers for a picture with light groups; what is refused leaves what is shown."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file, refused

load().register()
session = module("develop.session")
picture, folder = Path(sys.argv[1]), Path(sys.argv[2])
new_file()
settings = bpy.context.window_manager.nacre_develop

refused(lambda: bpy.ops.nacre.develop(filepath=str(folder / "none.exr")), "none.exr")
(folder / "text.exr").write_text("no picture")
refused(lambda: bpy.ops.nacre.develop(filepath=str(folder / "text.exr")), "cannot be read")
assert session.shown() is None
assert not bpy.ops.nacre.measure_spectrum.poll()
assert bpy.ops.nacre.develop(filepath=str(picture)) == {"FINISHED"}
image = bpy.data.images["shop developed"]
shown = []


def keep(name: str) -> None:
    assert not session.shown().problem, session.shown().problem
    pixels = np.array(image.pixels[:], np.float32).reshape(image.size[1], image.size[0], 4)
    np.save(folder / f"{name}.npy", pixels[::-1, :, :3])
    shown.append(name)


lamps = {lamp.layer: lamp for lamp in settings.lamps}
assert set(lamps) == {"", "Key", "Window"}
keep("as rendered")
settings.viewer = "cie1964"
keep("wide")
settings.viewer, settings.white, settings.exposure = "nikon-d5100", "A", 1.0
keep("camera")

# A file that is opened anew is shown as it was rendered.
assert bpy.ops.nacre.develop(filepath=str(picture)) == {"FINISHED"}
assert (settings.viewer, settings.white, settings.exposure) == ("FILE", "NONE", 0.0)
lamps = {lamp.layer: lamp for lamp in settings.lamps}
lamps["Key"].light, lamps["Window"].strength = "lamp/hps", 0.2
keep("evening")
assert lamps["Key"].light == "lamp/hps"

refused(lambda: bpy.ops.nacre.measure_spectrum(x=24, y=0), "24, 0 is not within 24 x 16 pixels")
settings.side = 1
for x, y in ((3, 4), (20, 9)):
    assert bpy.ops.nacre.measure_spectrum(x=x, y=y) == {"FINISHED"}
assert "several lights" in session.shown().why_not_compared
assert bpy.ops.nacre.save_spectra(filepath=str(folder / "own")) == {"FINISHED"}
place = session.shown().places[1]
np.testing.assert_allclose(
    place.rgb, np.array(image.pixels[:]).reshape(16, 24, 4)[15 - 9, 20, :3], rtol=1e-4
)
curve = place.curve(session.shown().picture.bands.wavelength_nm)
assert len(curve) == 471
assert max(curve) <= 0.951

lamps["Key"].light, lamps["Window"].strength = "KEEP", 1.0
settings.white = "PLACE"
keep("white place")

# What cannot be leaves the picture as it is, and says why.
before = image.pixels[:]
assert bpy.ops.nacre.forget_spectrum(index=-1) == {"FINISHED"}
assert "Measure what is white first" in session.shown().problem
settings.white = "NONE"
assert not session.shown().problem
lamps[""].strength, lamps["Key"].strength = 2.0, 0.5
assert "not both" in session.shown().problem
lamps[""].strength = lamps["Key"].strength = 1.0
assert not session.shown().problem

# A file of lights that is read puts its own first; what was chosen stays.
lamps["Key"].light = "F11"
table = folder / "led.csv"
table.write_text("nm,value\n400,0.1\n550,1\n700,0.4\n")
assert bpy.ops.nacre.read_spectra(filepath=str(table), is_light=True) == {"FINISHED"}
assert lamps["Key"].light == "F11"
lamps["Key"].light = f"{table}#led"
assert not session.shown().problem, session.shown().problem

# An image that a render left knows its file; undo does not close what is open.
operators = module("develop.operators")
assert operators.file_of(None) is None
assert operators.file_of(image) is None
image[module("core.spectral_image").FILE] = str(picture)
assert operators.file_of(image) == picture
print(json.dumps(shown))
