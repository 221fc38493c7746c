# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders a scene by Mitsuba, four bands at a time, in a process of its own.

    python mitsuba_program.py SCENE.xml NODES STEP SAMPLES OUT.npy

NODES are wavelengths, a list of JSON; OUT.npy has the integral of the radiance over the hat on each. The scene
leaves its bands open: $band0 … $band3, and $samples.
"""

import importlib.util
import json
import sys
from pathlib import Path

import mitsuba as mi
import numpy as np


def main():
    file, nodes, step, samples, out = sys.argv[1:]
    nodes, step = json.loads(nodes), int(step)
    mi.set_variant("scalar_spectral")
    plugin = Path(file).with_name("nacre_film.py")
    if plugin.exists():  # where a film was exported
        spec = importlib.util.spec_from_file_location("nacre_film", plugin)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        module.register()
    passes = len(nodes) // 4
    found = [None] * len(nodes)
    for number in range(passes):
        chosen = range(number, len(nodes), passes)
        bands = {
            f"band{k}": f"{nodes[at] - step},{nodes[at]},{nodes[at] + step}"
            for k, at in enumerate(chosen)
        }
        scene = mi.load_file(file, **bands, samples=samples)
        rendered = np.array(mi.render(scene, seed=0))
        for k, at in enumerate(chosen):
            found[at] = rendered[..., k]
    np.save(out, np.stack(found, axis=-1))


main()
