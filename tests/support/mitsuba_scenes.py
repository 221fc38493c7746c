# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes that are described once, for Blender and for Mitsuba, and what Mitsuba shows of them.

A scene is a `camera` (`at`, `to`, horizontal `angle_deg`; z is up), its `size` in pixels, `meshes` and the
`surfaces` that they have:

matt    a `reflectance` of the library
light   one of the library, of a radiance that has `luminance`, one-sided
film    a `material` with `values`; `template`: of one that the library lacks

Mitsuba gets spectra by colour-science, films and metals as `nacre export mitsuba` writes them.
"""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np

from support.spectral import light_at, observer_at, reflectance_at
from support.templates import write_toml
from support.tool import nacre

PROGRAM = Path(__file__).with_name("mitsuba_program.py")
EVERY_NM = np.arange(360, 831)

# ---- What is in them --------------------------------------------------------------------------------


def matt(reflectance: str) -> dict:
    return {"kind": "matt", "reflectance": f"colorchecker/{reflectance}"}


def light(name: str, luminance: float = 1.0) -> dict:
    return {"kind": "light", "light": name, "luminance": luminance}


def film(material: str, **values: float) -> dict:
    return {"kind": "film", "material": material, "values": {"roughness": 0.0, **values}}


def metal(name: str, medium: str) -> dict:
    """Bare, a stack of no layer."""
    template = {
        "schema": 1,
        "material": {
            "id": name,
            "name": name,
            "category": "Tests",
            "description": "A bare metal",
            "source": medium,
        },
        "ambient": {"medium": "air"},
        "layer": [],
        "substrate": {"medium": medium},
    }
    return {**film(name), "template": template}


def mesh(surface: str, vertices: list, faces: list) -> dict:
    """Faces are seen from where their vertices go round anticlockwise."""
    return {"surface": surface, "vertices": vertices, "faces": faces}


def quad(surface: str, *corners: tuple[float, float, float]) -> dict:
    return mesh(surface, list(corners), [(0, 1, 2, 3)])


def block(surface: str, centre: tuple, size: tuple, turned_deg: float) -> dict:
    """A cuboid that is turned about the vertical; it stands on something, and has no lower face."""
    c, s = math.cos(math.radians(turned_deg)), math.sin(math.radians(turned_deg))
    vertices = []
    x, y, z = (0.5 * side for side in size)
    for up in (-z, z):
        for right, away in ((-x, -y), (x, -y), (x, y), (-x, y)):
            at = (c * right - s * away, s * right + c * away, up)
            vertices.append([a + b for a, b in zip(centre, at, strict=True)])
    sides = [(k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k) for k in range(4)]
    return mesh(surface, vertices, [*sides, (4, 5, 6, 7)])


def room(low: tuple, high: tuple, **surfaces: str) -> list[dict]:
    """Walls that are seen from inside, those that have a surface."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    walls = {
        "floor": ((x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0)),
        "ceiling": ((x0, y0, z1), (x0, y1, z1), (x1, y1, z1), (x1, y0, z1)),
        "left": ((x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1)),
        "right": ((x1, y0, z0), (x1, y0, z1), (x1, y1, z1), (x1, y1, z0)),
        "back": ((x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)),
        "front": ((x0, y0, z0), (x0, y0, z1), (x1, y0, z1), (x1, y0, z0)),
    }
    return [quad(surface, *walls[name]) for name, surface in surfaces.items()]


def dome(surface: str, behind: str, centre: tuple, radius: float) -> list[dict]:
    """Flat facets that look to -y and to all sides, and what closes them behind."""
    rings, around = [math.radians(deg) for deg in (18.0, 42.0, 66.0)], 8
    vertices = []
    for polar in rings:
        for k in range(around):
            turn = 2.0 * math.pi * (k + 0.5) / around
            across = radius * math.sin(polar)
            at = (across * math.cos(turn), -radius * math.cos(polar), across * math.sin(turn))
            vertices.append([a + b for a, b in zip(centre, at, strict=True)])
    cap = tuple(range(around))
    sides = [
        (first + k, first + around + k, first + around + following, first + following)
        for first in range(0, around * (len(rings) - 1), around)
        for k in range(around)
        for following in ((k + 1) % around,)
    ]
    last = vertices[-around:]
    return [mesh(surface, vertices, [cap, *sides]), mesh(behind, last, [cap[::-1]])]


# ---- Mitsuba ----------------------------------------------------------------------------------------

STEP_NM = 7
NODES_NM = 383 + STEP_NM * np.arange(52)
"""Where hats stand, four a pass; beyond the last ones are a few ten-thousandths of what the eye sees."""


def observer_in_hats() -> np.ndarray:
    """How much of each hat X, Y and Z have, (N, 3), so that hats together are the observer.

    Their sum is a line between nodes, which cuts off the crests of curves: less a twelfth of the second
    difference at each node, smooth spectra have the integrals that they should nevertheless.
    """
    below, at, above = (observer_at(NODES_NM + shift) for shift in (-STEP_NM, 0, STEP_NM))
    return at - (below - 2.0 * at + above) / 12.0


def luminous(name: str) -> np.ndarray:
    """Each nanometre, of Y = 1, as an emission of 1 everywhere has."""
    fine, power = light_at(name)
    scale = np.sum(power * observer_at(fine)[:, 1]) / np.sum(observer_at(fine)[:, 1])
    return np.interp(EVERY_NM, fine, power) / scale


def white_of(name: str) -> np.ndarray:
    """XYZ of Y = 1."""
    fine, power = light_at(name)
    seen = power @ observer_at(fine)
    return seen / seen[1]


def picture(scene: dict, folder: Path, samples: int) -> np.ndarray:
    """XYZ, (height, width, 3), where a radiance of 1 everywhere has Y = 1.

    The film has hats 14 nm wide, whose sum is 1 at each wavelength: what the observer sees follows without
    tables or a white of Mitsuba's own. Each pass renders four of them, one for each of the four wavelengths
    of a path, and all passes have the same paths: noise has hardly a colour.
    """
    file = folder / "scene.xml"
    file.write_text(_xml(scene, folder), "utf-8")
    out = folder / "hats.npy"
    arguments = (file, json.dumps(NODES_NM.tolist()), STEP_NM, samples, out)
    result = subprocess.run(
        [sys.executable, PROGRAM, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    luminance = np.sum(observer_at(EVERY_NM)[:, 1])
    return np.load(out) @ observer_in_hats() / luminance


def _xml(scene: dict, folder: Path) -> str:
    surfaces = {
        name: _surface(name, surface, folder) for name, surface in scene["surfaces"].items()
    }
    included = [above for above, _ in surfaces.values()]
    shapes = []
    for number, item in enumerate(scene["meshes"]):
        file = folder / f"{number}.ply"
        file.write_text(_ply(item), "utf-8")
        shapes.append(
            f'<shape type="ply"><string name="filename" value="{file.name}"/>'
            f'<boolean name="face_normals" value="true"/>{surfaces[item["surface"]][1]}</shape>'
        )
    camera, (width, height) = scene["camera"], scene["size"]
    at, to = (",".join(map(str, camera[name])) for name in ("at", "to"))
    bands = "".join(
        f'<spectrum type="irregular" name="band{k}"><string name="wavelengths" value="$band{k}"/>'
        '<string name="values" value="0,1,0"/></spectrum>'
        for k in range(4)
    )
    return f"""<scene version="3.0.0">
  {"".join(included)}
  <integrator type="path"><integer name="max_depth" value="65"/></integrator>
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="{at}" target="{to}" up="0,0,1"/></transform>
    <float name="fov" value="{camera["angle_deg"]}"/><string name="fov_axis" value="x"/>
    <sampler type="multijitter"><integer name="sample_count" value="$samples"/></sampler>
    <film type="specfilm">
      <integer name="width" value="{width}"/><integer name="height" value="{height}"/>
      <string name="component_format" value="float32"/><rfilter type="box"/>{bands}
    </film>
  </sensor>
  {"".join(shapes)}
</scene>
"""


def _surface(name: str, surface: dict, folder: Path) -> tuple[str, str]:
    """What stands before all shapes, and what within each that has it."""
    if surface["kind"] == "light":
        values = surface["luminance"] * luminous(surface["light"])
        radiance = _spectrum("radiance", values, folder / f"{name}.spd")
        return "", f'<emitter type="area">{radiance}</emitter>{_BLACK}'
    if surface["kind"] == "matt":
        values = reflectance_at(surface["reflectance"], EVERY_NM)
        reflectance = _spectrum("reflectance", values, folder / f"{name}.spd")
        return "", f'<bsdf type="twosided"><bsdf type="diffuse">{reflectance}</bsdf></bsdf>'
    material = surface["material"]
    given = [
        word for pair in surface["values"].items() for word in ("--set", "{}={}".format(*pair))
    ]
    source = ["--material", material]
    if "template" in surface:
        source = [folder / f"{material}.toml"]
        write_toml(source[0], surface["template"])
    nacre("export", "mitsuba", *source, *given, "-o", folder / f"{material}.xml")
    return f'<include filename="{material}.xml"/>', f'<ref id="{material}"/>'


_BLACK = '<bsdf type="diffuse"><rgb name="reflectance" value="0"/></bsdf>'


def _spectrum(name: str, values: np.ndarray, file: Path) -> str:
    lines = (f"{nm} {value:.9g}\n" for nm, value in zip(EVERY_NM, values, strict=True))
    file.write_text("".join(lines), "utf-8")
    return f'<spectrum name="{name}" filename="{file.name}"/>'


def _ply(item: dict) -> str:
    """Of triangles."""
    triangles = [
        (face[0], face[k], face[k + 1]) for face in item["faces"] for k in range(1, len(face) - 1)
    ]
    head = (
        f"ply\nformat ascii 1.0\nelement vertex {len(item['vertices'])}\nproperty float x\n"
        f"property float y\nproperty float z\nelement face {len(triangles)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    rows = [*item["vertices"], *((3, *triangle) for triangle in triangles)]
    return head + "".join(" ".join(map(str, row)) + "\n" for row in rows)
