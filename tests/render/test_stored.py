# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Stages against stored pictures, one for all Blenders. Refresh one after review: ./dev refs -k NAME"""

from __future__ import annotations

import itertools
import tomllib
from pathlib import Path

import numpy as np
import pytest

from blender.harness import VERSIONS
from support import noise
from support.images import read_channels, read_image, write_channels
from support.osl import SHADER_MATERIALS
from support.paths import materials_folder
from support.tool import nacre

HERE = Path(__file__).resolve().parent
CASES = sorted(file.parent.name for file in HERE.glob("cases/*/case.toml"))
KNOWN = {"material", "stage", "form", "set", "samples", "size"}
# Of each Blender for a reference. What is compared has seed 0; other seeds are used once, since the
# Blenders render nearly the same with one seed, which would hide the noise.
PICTURES = 8
COUNTED = ("pictures", "blenders", "failing_percent", "worst_block")
COLOURS, DEVIATIONS = ("R", "G", "B"), ("sigma.R", "sigma.G", "sigma.B")


def load(name: str) -> dict:
    """`case.toml`: what to render."""
    case = tomllib.loads((HERE / "cases" / name / "case.toml").read_text("utf-8"))
    assert set(case) <= KNOWN, set(case) - KNOWN
    assert max(map(int, case["size"].split("x"))) <= 128
    return case


def arguments(case: dict, seed: int) -> list:
    values = [
        part for pair in case.get("set", {}).items() for part in ("--set", "{}={}".format(*pair))
    ]
    return [
        "--material", case["material"], "--stage", case["stage"], "--form", case["form"],
        "--samples", case["samples"], "--size", case["size"], "--seed", seed, "--quiet", *values,
    ]  # fmt: skip


def render(blender, name: str, seed: int = 0) -> np.ndarray:
    """In the Blender that is up, as `nacre render` does it in one of its own."""
    file = blender.folder / "stored.exr"
    done = blender.render(*arguments(load(name), seed), "-o", file, fresh=False)
    assert done.returncode == 0, done.stderr
    return read_image(file)


def reference_file(name: str) -> Path:
    return HERE / "cases" / name / "reference.exr"


def stored(name: str) -> noise.Reference:
    values, attributes = read_channels(reference_file(name), COLOURS + DEVIATIONS)
    counted = {field: attributes[field] for field in COUNTED}
    return noise.Reference(values[..., :3], values[..., 3:], **counted)


def store(blenders, name: str, folder: Path) -> None:
    """Mean and deviation over pictures of every Blender, which have to agree."""
    pictures = []
    seeds = itertools.count(1)
    for version in VERSIONS:
        blender = blenders.get(version, folder)
        assert blender, f"{VERSIONS[version]} names no Python with bpy {version}"
        pictures.append([render(blender, name, next(seeds)) for _ in range(PICTURES)])
    made = noise.calibrated(pictures)
    write_channels(
        reference_file(name),
        np.concatenate([made.mean, made.sigma], axis=-1),
        COLOURS + DEVIATIONS,
        {field: getattr(made, field) for field in COUNTED},
    )
    print(f"{name}: stored")


@pytest.mark.parametrize("name", CASES)
def test_matches_reference(blender, blenders, name, report, update_refs):
    new = render(blender, name)
    if not reference_file(name).exists():
        assert update_refs, f"no reference yet; after review: ./dev refs -k {name}"
        store(blenders, name, blender.folder)
    found = noise.compare(new, stored(name))
    if update_refs and not found.passes:
        print(f"{name}, Blender {blender.version}, before: {found}")
        store(blenders, name, blender.folder)
        found = noise.compare(new, stored(name))
    print(f"{name}, Blender {blender.version}: {found}")
    if not found.passes:
        report.add(
            f"{name}-{blender.version}",
            name,
            new,
            noise.scene_linear(stored(name).mean),
            str(found),
        )
        pytest.fail(f"{found}; see {report.folder / 'index.html'}; refresh: ./dev refs -k {name}")


def test_there_is_a_case_for_each_template():
    """Hand-written shaders are held to truths, in test_hand_written.py and tests/osl/test_shaders.py."""
    shown = {load(name)["material"] for name in CASES}
    made = {folder.name for folder in materials_folder().iterdir() if folder.is_dir()}
    assert made - set(SHADER_MATERIALS) <= shown


def test_the_tool_renders_the_same(blender, tmp_path):
    """`nacre render` in a process of its own, as a user has it, beside the Blender that is up."""
    name = "tempered_steel"
    file = tmp_path / "tool.exr"
    nacre("render", *arguments(load(name), 0), "-o", file, env={"NACRE_PYTHON": blender.python})
    np.testing.assert_array_equal(read_image(file), render(blender, name))
