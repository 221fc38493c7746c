# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Stages against stored pictures. Refresh one after review: ./dev refs -k NAME"""

from __future__ import annotations

import tomllib
from dataclasses import replace
from pathlib import Path

import pytest
from harness import HERE, Blender, Limits, difference, read_image, write_image

CASES = sorted(file.parent.name for file in HERE.glob("cases/*/case.toml"))
KNOWN = {"material", "stage", "form", "set", "samples", "size", "limits", "reason"}


def load(name: str) -> tuple[dict, Limits]:
    """`case.toml`: what to render; `limits` loosened only with a `reason`."""
    case = tomllib.loads((HERE / "cases" / name / "case.toml").read_text("utf-8"))
    assert set(case) <= KNOWN, set(case) - KNOWN
    assert ("limits" in case) == ("reason" in case), "loosened limits need a reason"
    assert max(map(int, case["size"].split("x"))) <= 128
    return case, replace(Limits(), **case.get("limits", {}))


def render(blender: Blender, name: str, case: dict):
    values = [
        part for pair in case.get("set", {}).items() for part in ("--set", "{}={}".format(*pair))
    ]
    return blender.render(
        name, "--material", case["material"], "--stage", case["stage"], "--form", case["form"],
        "--samples", case["samples"], "--size", case["size"], "--seed", 0, *values,
    )  # fmt: skip


def reference_files(name: str, version: str) -> tuple[Path, Path]:
    """What to compare with and what to store: `out.exr` is Blender 4.5's, a newer one that is right in
    another way has a variant of its own."""
    folder = HERE / "cases" / name / "ref"
    common = folder / "out.exr"
    variant = common if version == "4.5" else folder / f"out-{version}.exr"
    return variant if variant.exists() else common, variant


@pytest.mark.parametrize("name", CASES)
def test_matches_reference(blender, name, report, request):
    case, limits = load(name)
    new = render(blender, name, case)
    update = request.config.getoption("--update-refs")
    file, target = reference_files(name, blender.version)
    if not file.exists():
        assert update, f"no reference yet; after review: ./dev refs -k {name}"
        write_image(target, new)
        print(f"{target.relative_to(HERE)}: stored")
        return
    reference = read_image(file)
    found = difference(new, reference, limits)
    print(f"{name}, Blender {blender.version}: {found}")
    if found.within(limits):
        return
    if update:
        write_image(target, new)
        after = difference(new, read_image(target), limits)
        print(f"{target.relative_to(HERE)}: stored; before: {found}; after: {after}")
        return
    report.add(f"{name}-{blender.version}", name, new, reference, str(found))
    pytest.fail(f"{found}; see {report.folder / 'index.html'}; refresh: ./dev refs -k {name}")


def test_there_is_a_case_for_each_material():
    from harness import materials_folder

    shown = {load(name)[0]["material"] for name in CASES}
    assert {folder.name for folder in materials_folder().iterdir() if folder.is_dir()} <= shown
