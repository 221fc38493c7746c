# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The extension's archive: built and validated by Blender's own program, installed by its operator."""

from __future__ import annotations

import io
import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
import pytest

from support.paths import ADDON, ROOT, STAGE_EXTENSION, materials_folder


def test_archive_carries_the_version_and_the_materials(archive):
    version = re.search(r"project\(Nacre VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
    with zipfile.ZipFile(archive) as files:
        names = set(files.namelist())
        manifest = tomllib.loads(files.read("blender_manifest.toml").decode())
    assert manifest["version"] == version.group(1)
    assert manifest["blender_version_min"] == "4.2.0"
    assert {
        "__init__.py",
        "background/render.py",
        "compiled/test_film/test_film_R.exr",
        "manual/blender.html",
    } <= names
    assert not any("__pycache__" in name for name in names)


def test_manual_is_whole(monkeypatch, tmp_path):
    """Every page that a panel opens is there, and every link within it leads somewhere."""
    monkeypatch.syspath_prepend(STAGE_EXTENSION.parent)
    import write_manual
    from nacre_extension.core.manual import PAGES

    write_manual.write_manual(tmp_path)
    pages = {path.name: path.read_text("utf-8") for path in tmp_path.glob("*.html")}
    assert {f"{name}.html" for name, _, _ in PAGES} <= set(pages)
    for name, text in pages.items():
        for picture in re.findall(r'<img src="([^"]+)"', text):
            assert (tmp_path / picture).is_file(), (name, picture)
        for link in re.findall(r'<a href="([^"]+)"', text):
            if link.startswith("http"):
                continue
            target, _, anchor = link.partition("#")
            assert (target or name) in pages, (name, link)
            assert not anchor or f'id="{anchor}"' in pages[target or name], (name, link)


@pytest.fixture(scope="module")
def shipped() -> Path:
    if "NACRE_EXTENSION" not in os.environ:
        pytest.skip("NACRE_EXTENSION names no archive with all materials and a wheel")
    return Path(os.environ["NACRE_EXTENSION"])


def test_shipped_archive_is_light(shipped):
    assert shipped.stat().st_size <= 25e6


def test_squeezed_tables_are_the_same(monkeypatch, tmp_path):
    """Those of films and of one row, whose only chunk is not deflated; what is no table is left alone."""
    monkeypatch.syspath_prepend(STAGE_EXTENSION.parent)
    from squeeze_exr import squeeze

    for name in ("soap_film_R", "soap_film_R_rough", "soap_film_R_bare"):
        table = materials_folder() / "soap_film" / f"{name}.exr"
        squeezed = Path(shutil.copy(table, tmp_path))
        squeeze(squeezed)
        before, after = oiio.ImageBuf(str(table)), oiio.ImageBuf(str(squeezed))
        np.testing.assert_array_equal(before.get_pixels(), after.get_pixels())
        assert before.spec().to_xml() == after.spec().to_xml()
        assert squeezed.stat().st_size <= table.stat().st_size
        if not name.endswith("_bare"):
            assert squeezed.stat().st_size < 0.995 * table.stat().st_size
    tiled = tmp_path / "tiled.exr"
    spec = oiio.ImageSpec(8, 8, 3, oiio.FLOAT)
    spec.tile_width = spec.tile_height = 4
    oiio.ImageBuf(spec).write(str(tiled))
    before = tiled.read_bytes()
    squeeze(tiled)
    assert tiled.read_bytes() == before


def test_shipped_archive_states_whose_libraries_it_carries(shipped):
    with zipfile.ZipFile(shipped) as extension:
        (wheel,) = [name for name in extension.namelist() if name.endswith(".whl")]
        with zipfile.ZipFile(io.BytesIO(extension.read(wheel))) as files:
            carried = {
                match[1]
                for name in files.namelist()
                if (match := re.search(r"\.libs/(lib\w+)", name))
            }
            (notices,) = [name for name in files.namelist() if name.endswith("THIRD_PARTY.md")]
            text = files.read(notices).decode()
    assert carried
    assert carried <= set(re.findall(r"\((lib\w+)\)", text))


def test_manifest_states_the_project_version():
    manifest = tomllib.loads((ADDON / "blender_manifest.toml").read_text("utf-8"))
    assert f"VERSION {manifest['version']} " in (ROOT / "CMakeLists.txt").read_text()


def test_wheels_name_their_platforms(monkeypatch):
    monkeypatch.syspath_prepend(STAGE_EXTENSION.parent)
    import stage_extension

    wheels = [Path("nacre-1.2.3-py3-none-manylinux_2_28_x86_64.whl")]
    text = stage_extension.filled_manifest('version = "0.0.0"\n', "1.2.3", wheels)
    assert tomllib.loads(text) == {
        "version": "1.2.3",
        "platforms": ["linux-x64"],
        "wheels": ["./wheels/nacre-1.2.3-py3-none-manylinux_2_28_x86_64.whl"],
    }


def test_archive_without_materials_is_refused(tmp_path):
    done = subprocess.run(
        [sys.executable, STAGE_EXTENSION, "--blender-ext", "unused",
         "--materials", tmp_path, "-o", tmp_path / "x.zip"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert "holds no compiled materials" in done.stderr
    assert not (tmp_path / "x.zip").exists()


def test_installs_through_the_operator(blender, archive):
    blender.with_environment(NACRE_MATERIALS=None).script_process(
        "extension/install", archive, "test_film"
    )
