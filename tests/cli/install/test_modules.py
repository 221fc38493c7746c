# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""OpenImageIO and OpenColorIO, which take longer to load than most commands to run, are loaded
where a command needs them and not before."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys

import pytest

from support.tool import Tool

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="asks the loader of Linux")

LAMP = '{"illuminant": "D65"}'
PANE = '{"n": [1, 1.5], "d_nm": [], "wavelength_nm": 550}'
CONFIG = """\
ocio_profile_version: 2
roles: {default: xyz, scene_linear: xyz, cie_xyz_d65_interchange: xyz}
displays: {d: [!<View> {name: v, colorspace: xyz}]}
colorspaces: [!<ColorSpace> {name: xyz}]
"""


def loaded(nacre, tmp_path, *arguments, stdin="") -> set[str]:
    """Of OpenImageIO and OpenColorIO, those that a run mapped."""
    log = tmp_path / "loader"
    nacre.ok(*arguments, stdin=stdin, env={"LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(log)})
    text = "".join(path.read_text() for path in tmp_path.glob("loader.*"))
    assert "libstdc++" in text  # else nothing was recorded
    return set(re.findall(r"lib(OpenImageIO|OpenColorIO)\b", text))


@pytest.mark.parametrize(
    ("arguments", "stdin"),
    [
        (["--version"], ""),
        (["--help"], ""),
        (["library", "list"], ""),
        (["library", "show", "water/Daimon-20C", "--at", "550"], ""),
        (["eval", "stack"], PANE),
        (["eval", "colour"], PANE.replace(', "wavelength_nm": 550', "")),
        (["eval", "spectrum"], LAMP),
        (["eval", "slits"], '{"width_nm": 1000, "wavelength_nm": 550}'),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_numbers_load_neither(nacre, tmp_path, arguments, stdin):
    assert loaded(nacre, tmp_path, *arguments, stdin=stdin) == set()


@pytest.mark.parametrize("name", ["cd", "n_bk7"])
def test_a_material_without_tables_loads_neither(nacre, tmp_path, templates, monkeypatch, name):
    monkeypatch.delenv(
        "NACRE_PYTHON", raising=False
    )  # its Cycles tries the shader and has both inside
    arguments = ("compile", templates / f"{name}.toml", "-o", tmp_path / "materials")
    assert loaded(nacre, tmp_path, *arguments) == set()


def test_text_textures_load_neither(nacre, tmp_path):
    assert loaded(nacre, tmp_path, "bake", "cmf", "-o", tmp_path / "cmf.ftxt") == set()


def test_images_load_open_image_io(nacre, tmp_path):
    assert "OpenImageIO" in loaded(nacre, tmp_path, "bake", "cmf", "-o", tmp_path / "cmf.exr")


def test_configs_load_open_color_io_alone(nacre, tmp_path):
    config = tmp_path / "config.ocio"
    config.write_text(CONFIG)
    arguments = ("eval", "spectrum", "--config", config)
    assert loaded(nacre, tmp_path, *arguments, stdin=LAMP) == {"OpenColorIO"}


# ---- Modules that are not as they should be ----------------------------------------------------


@pytest.fixture
def broken(prefix, tmp_path) -> Tool:
    """An installation to be broken."""
    return Tool(shutil.copytree(prefix, tmp_path / "broken", symlinks=True) / "bin" / "nacre")


def refusal(broken, tmp_path) -> str:
    """What the tool says that needs the module `images`; numbers go on as before."""
    target = tmp_path / "cmf.exr"
    errors = broken.fails("bake", "cmf", "-o", target)
    assert not target.exists()
    assert json.loads(broken.ok("eval", "stack", stdin=PANE))["R"] == pytest.approx(0.04)
    return errors


def test_a_missing_module(broken, tmp_path):
    module = broken.program.parents[1] / "lib" / "nacre" / "nacre_images.so"
    module.unlink()
    assert f"{module}: is missing: the installation is not complete" in refusal(broken, tmp_path)


def test_a_module_without_its_library(broken, tmp_path):
    """As on a machine that lacks OpenImageIO."""
    module = broken.program.parents[1] / "lib" / "nacre" / "nacre_images.so"
    # A name of the same length, inside the table of names that the loader reads.
    content, count = re.subn(rb"libOpenImageIO\.so", b"libOpenImageXX.so", module.read_bytes())
    assert count > 0
    module.write_bytes(content)
    assert re.search(
        re.escape(f"{module}: cannot be loaded (libOpenImageXX.so")
        + r".*cannot open shared object file.*\); it needs OpenImageIO \(Debian and Ubuntu: "
        r"apt-get install openimageio-tools\)",
        refusal(broken, tmp_path),
    )


@pytest.mark.skipif(not shutil.which("cc"), reason="needs a C compiler")
@pytest.mark.parametrize(
    "source", ["const void *nacre_module(const char *tool) { return 0; }", "int something_else;"]
)
def test_a_module_of_another_version(broken, tmp_path, source):
    module = broken.program.parents[1] / "lib" / "nacre" / "nacre_images.so"
    (tmp_path / "module.c").write_text(source)
    subprocess.run(["cc", "-shared", "-fPIC", "-o", module, tmp_path / "module.c"], check=True)
    version = broken.ok("--version").split()[1]
    assert f"{module}: is not of this nacre, {version}: install the tool anew" in refusal(
        broken, tmp_path
    )
