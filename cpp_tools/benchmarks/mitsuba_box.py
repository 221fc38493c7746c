# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Noise and CPU time of the box of render_spectral.py in Mitsuba, by four wavelengths a path. Prints one line
of JSON.

Where colours come from differs, by each renderer's own way from RGB to spectra; noise is that of each from its
own picture of many samples.
"""

from __future__ import annotations

import argparse
import json
import math
import time

import mitsuba as mi
import numpy as np
from noise import noise
from room import ROOM

HALF_WIDTH = 1.33


def box(size: tuple[int, int]) -> dict:
    to_world = mi.ScalarTransform4f()
    a = HALF_WIDTH

    def matt(name: str) -> dict:
        return {"type": "diffuse", "reflectance": {"type": "rgb", "value": list(ROOM[name])}}

    def wall(name: str, place, axis, degrees: float, scale) -> dict:
        turned = to_world.translate(place).rotate(axis, degrees).scale(scale)
        both = {"type": "twosided", "bsdf": matt(name)}
        return {"type": "rectangle", "to_world": turned, "bsdf": both}

    return {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 10, "rr_depth": 1000},
        "sensor": {
            "type": "perspective",
            "fov": math.degrees(2.0 * math.atan(18.0 / 38.0)),
            "fov_axis": "x",
            "to_world": to_world.look_at(origin=[0, -4.2, 1], target=[0, 0, 1], up=[0, 0, 1]),
            "film": {
                "type": "hdrfilm",
                "width": size[0],
                "height": size[1],
                "pixel_format": "xyz",
                "component_format": "float32",
                "rfilter": {"type": "box"},  # neighbours share no samples, as in Cycles
            },
            "sampler": {"type": "multijitter"},
        },
        "floor": wall("white", [0, 0, 0], [1, 0, 0], 0, [a, 1, 1]),
        "ceiling": wall("white", [0, 0, 2], [1, 0, 0], 180, [a, 1, 1]),
        "back": wall("white", [0, 1, 1], [1, 0, 0], 90, [a, 1, 1]),
        "left": wall("red", [-a, 0, 1], [0, 1, 0], 90, [1, 1, 1]),
        "right": wall("green", [a, 0, 1], [0, 1, 0], -90, [1, 1, 1]),
        "ball": {
            "type": "sphere",
            "center": [-0.55, 0.1, 0.42],
            "radius": 0.42,
            "bsdf": matt("yellow"),
        },
        "block": {
            "type": "cube",
            "to_world": to_world.translate([0.55, 0.3, 0.35])
            .rotate([0, 0, 1], math.degrees(0.5))
            .scale(0.35),
            "bsdf": matt("blue"),
        },
        "lamp": {
            "type": "rectangle",
            "to_world": to_world.translate([0, 0, 1.98]).rotate([1, 0, 0], 180).scale(0.3),
            "emitter": {"type": "area", "radiance": {"type": "d65", "scale": 10.0}},
        },
    }


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--variant", default="scalar_spectral")
    parser.add_argument("--size", type=int, nargs=2, default=(160, 120))
    parser.add_argument("--samples", type=int, default=96)
    parser.add_argument("--many", type=int, default=2048)
    parser.add_argument("--repeats", type=int, default=2)
    options = parser.parse_args()
    mi.set_variant(options.variant)
    scene = mi.load_dict(box(tuple(options.size)))

    def rendered(samples: int, seed: int) -> tuple[np.ndarray, float]:
        start = time.process_time()
        picture = np.array(mi.render(scene, spp=samples, seed=seed))
        return picture, time.process_time() - start

    reference, _ = rendered(options.many, 1)
    pictures = [rendered(options.samples, 10 + seed) for seed in range(options.repeats)]
    both = [noise(picture, reference) for picture, _ in pictures]
    measured = {
        "luminance": float(np.mean([pair[0] for pair in both])),
        "chroma": float(np.mean([pair[1] for pair in both])),
        "seconds": min(seconds for _, seconds in pictures),
    }
    print("RESULT " + json.dumps({"measured": measured, "version": f"Mitsuba {mi.__version__}"}))


if __name__ == "__main__":
    main()
