# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Pictures out of real Blenders, and how far two of them are apart.

NACRE_BPY45 and NACRE_BPY52 name Python programs that have `bpy` 4.5 and 5.2; NACRE names the
command-line tool, NACRE_MATERIALS the compiled materials (both default to the release build).
"""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
RELEASE = ROOT / "build" / "release"
VERSIONS = {"4.5": "NACRE_BPY45", "5.2": "NACRE_BPY52"}


def tool() -> Path:
    return Path(os.environ.get("NACRE", RELEASE / "bin" / "nacre"))


def materials_folder() -> Path:
    return Path(os.environ.get("NACRE_MATERIALS", RELEASE / "share" / "nacre" / "materials"))


def manifest(material: str) -> dict:
    return json.loads((materials_folder() / material / f"{material}.json").read_text("utf-8"))


def nacre(*arguments, stdin: str | None = None, env: dict | None = None) -> str:
    """Standard output of the tool, which must succeed."""
    done = subprocess.run(
        [tool(), *map(str, arguments)],
        input=stdin,
        capture_output=True,
        text=True,
        env={**os.environ, **(env or {})},
        timeout=900,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@dataclass(frozen=True)
class Blender:
    """One `bpy`."""

    version: str
    python: str
    folder: Path

    def render(self, name: str, *arguments) -> np.ndarray:
        """`nacre render ARGUMENTS`; shape (height, width, 3), row 0 at the top, scene-linear."""
        file = self.folder / f"{name}.exr"
        environment = {"NACRE_PYTHON": self.python, "NACRE_MATERIALS": str(materials_folder())}
        nacre("render", *arguments, "--quiet", "-o", file, env=environment)
        return read_image(file)

    def run(self, worker: str, jobs: list[dict], materials: Path | None = None) -> list[np.ndarray]:
        """The pictures of a script beside this file for several jobs in one process; of compiled
        materials elsewhere, if given."""
        listed = [{**job, "file": str(self.folder / f"{i}.exr")} for i, job in enumerate(jobs)]
        file = self.folder / "jobs.json"
        file.write_text(json.dumps(listed))
        done = subprocess.run(
            [self.python, HERE / worker, file],
            capture_output=True,
            text=True,
            env={**os.environ, "NACRE_MATERIALS": str(materials or materials_folder())},
            timeout=1800,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return [read_image(job["file"]) for job in listed]


def read_image(file: Path | str) -> np.ndarray:
    """RGB as float64, shape (height, width, 3)."""
    source = oiio.ImageInput.open(str(file))
    assert source, oiio.geterror()
    pixels = source.read_image(0, 0, 0, 3, oiio.FLOAT)
    source.close()
    return np.asarray(pixels, dtype=np.float64)


def write_image(file: Path, pixels: np.ndarray, kind: str = "half") -> None:
    """Scene-linear RGB as EXR."""
    height, width, channels = pixels.shape
    file.parent.mkdir(parents=True, exist_ok=True)
    target = oiio.ImageOutput.create(str(file))
    spec = oiio.ImageSpec(width, height, channels, kind)
    spec.attribute("compression", "zip")
    assert target.open(str(file), spec), target.geterror()
    assert target.write_image(pixels.astype(np.float32)), target.geterror()
    target.close()


def lab(rgb: np.ndarray) -> np.ndarray:
    """L*a*b* under D65 of linear Rec. 709, IEC 61966-2-1 primaries with (1, 1, 1) as the white."""
    to_xyz = np.array(
        [
            [0.4123907992659593, 0.357584339383878, 0.1804807884018343],
            [0.2126390058715103, 0.715168678767756, 0.0721923153607337],
            [0.0193308187155918, 0.119194779794626, 0.9505321522496607],
        ]
    )
    relative = (rgb @ to_xyz.T) / to_xyz.sum(axis=1)
    linear = relative * (24389 / 27) / 116 + 16 / 116
    f = np.where(relative > 216 / 24389, np.cbrt(relative), linear)
    return np.stack(
        [116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])],
        axis=-1,
    )


def delta_e(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """CIEDE2000 by colour-science between linear Rec. 709 pictures."""
    from colour.difference import delta_E_CIE2000

    return delta_E_CIE2000(lab(a), lab(b))


@dataclass(frozen=True)
class Limits:
    """idiff's three numbers, and ΔE00 as mean and at the 99th percentile of the pixels."""

    fail: float = 0.004
    failpercent: float = 2.0
    hardfail: float = 0.012
    delta_e_mean: float = 0.25
    delta_e_99: float = 1.5


@dataclass(frozen=True)
class Difference:
    failing_percent: float
    largest: float
    delta_e_mean: float
    delta_e_99: float

    def within(self, limits: Limits) -> bool:
        return (
            self.failing_percent <= limits.failpercent
            and self.largest <= limits.hardfail
            and self.delta_e_mean <= limits.delta_e_mean
            and self.delta_e_99 <= limits.delta_e_99
        )

    def __str__(self) -> str:
        return (
            f"{self.failing_percent:.2f} % of the pixels over the threshold, largest difference "
            f"{self.largest:.4f}, dE00 mean {self.delta_e_mean:.3f}, 99 % {self.delta_e_99:.3f}"
        )


def difference(new: np.ndarray, reference: np.ndarray, limits: Limits) -> Difference:
    """OpenImageIO's comparison (what idiff prints) and ΔE00. What is brighter than white counts
    relative to its brightness: a highlight of 100 has steps of 0.06 in a stored half."""
    scale = 1 / np.maximum(1.0, np.abs(reference))
    new, reference = new * scale, reference * scale
    new_buffer, reference_buffer = (
        oiio.ImageBuf(np.ascontiguousarray(image, dtype=np.float32)) for image in (new, reference)
    )
    result = oiio.ImageBufAlgo.compare(new_buffer, reference_buffer, limits.fail, limits.fail)
    errors = delta_e(new, reference)
    return Difference(
        failing_percent=100.0 * result.nfail / (new.shape[0] * new.shape[1]),
        largest=result.maxerror,
        delta_e_mean=float(errors.mean()),
        delta_e_99=float(np.percentile(errors, 99)),
    )
