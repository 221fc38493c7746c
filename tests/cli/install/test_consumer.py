# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A CMake project outside the checkout builds against an installed Nacre."""

from __future__ import annotations

import subprocess

from support.paths import ROOT

CONSUMER = ROOT / "tests" / "consumer"


def run(*command) -> str:
    result = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, timeout=300, check=False
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


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
