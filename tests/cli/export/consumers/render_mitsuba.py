# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A sphere with an exported BSDF under uniform white light, by Mitsuba.

    python render_mitsuba.py VARIANT FILE.xml MATERIAL SIZE SAMPLES OUT.npy

The camera is orthographic and the sphere fills the frame, so that a pixel's place gives its angle. The
picture is divided by that of the light itself: white is 1.
"""

import sys
from pathlib import Path

import mitsuba as mi
import numpy as np

SCENE = """<scene version="3.0.0">
  <include filename="{file}"/>
  <integrator type="path"><integer name="max_depth" value="{depth}"/></integrator>
  <emitter type="constant"/>
  <sensor type="orthographic">
    <transform name="to_world"><lookat origin="0,0,4" target="0,0,0" up="0,1,0"/></transform>
    <sampler type="independent"><integer name="sample_count" value="{samples}"/></sampler>
    <film type="hdrfilm">
      <integer name="width" value="{size}"/><integer name="height" value="{size}"/>
      <string name="pixel_format" value="rgb"/><string name="component_format" value="float32"/>
      <rfilter type="box"/>
    </film>
  </sensor>
  {shape}
</scene>"""
SPHERE = '<shape type="sphere"><ref id="{material}"/></shape>'


def main():
    variant, file, material, size, samples, out = sys.argv[1:]
    mi.set_variant(variant)
    sys.path.insert(0, str(Path(file).parent))
    import nacre_film

    nacre_film.register()
    mi.file_resolver().append(str(Path(file).parent))
    fill = {"file": file, "size": size, "samples": samples, "depth": 8}
    sphere = mi.load_string(SCENE.format(shape=SPHERE.format(material=material), **fill))
    light = mi.load_string(SCENE.format(shape="", **fill))
    white = np.array(mi.render(light)).mean(axis=(0, 1))
    np.save(out, np.array(mi.render(sphere)) / white)


main()
