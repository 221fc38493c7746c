# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A CMake project outside the checkout builds against an installed Nacre."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from support.paths import ROOT, tool

CONSUMER = ROOT / "tests" / "consumer"


def build_folder() -> Path:
    """The build tree of the program that NACRE names, else the release build."""
    return tool().parents[1]


def run(*command) -> str:
    result = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, timeout=300, check=False
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory) -> Path:
    if not shutil.which("cmake"):
        pytest.skip("needs cmake")
    if not (build_folder() / "cmake_install.cmake").is_file():
        pytest.skip(f"needs a build tree in {build_folder()}")
    installed = tmp_path_factory.mktemp("consumer") / "installed"
    run("cmake", "--install", build_folder(), "--prefix", installed)
    # Under another name: the package must not remember where it was installed.
    return installed.rename(installed.with_name("moved"))


def test_project_finds_links_and_runs(prefix, tmp_path):
    run("cmake", "-S", CONSUMER, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", tmp_path)
    assert "error" in run(tmp_path / "consumer")


def test_package_names_no_folder_of_the_checkout(prefix):
    files = list(prefix.rglob("*.cmake"))
    assert {"NacreConfig.cmake", "NacreTargets.cmake"} <= {path.name for path in files}
    for path in files:
        assert str(ROOT) not in path.read_text(encoding="utf-8"), path


def test_every_public_header_is_installed(prefix):
    public = ROOT / "cpp_tools" / "include"
    wanted = {path.relative_to(public) for path in public.rglob("*.h")}
    include = prefix / "include"
    assert {path.relative_to(include) for path in include.rglob("*.h")} == wanted
