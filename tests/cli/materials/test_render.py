# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The launcher of `nacre render`: which Blender it finds and what it passes on.

Programs that record how they were called stand for Python and Blender; pictures are the render
tests' business.
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

# A shell starts Python, whose path may have a blank in it; Python takes that line for a text.
RECORDER = """\
#!/bin/sh
''''exec {python} "$0" "$@" # '''
import json, os, sys
if sys.argv[1:2] == ["-c"]:  # the probe for bpy
    sys.exit({probe})
compiled = sys.argv[sys.argv.index("--compiled") + 1] if "--compiled" in sys.argv else None
print("Blender 9.9")
print("libfilm: odd film", file=sys.stderr)
report = os.fdopen(int(os.environ["NACRE_REPORT_FD"]), "w")
print(json.dumps({{
    "program": sys.argv[0],
    "arguments": sys.argv[1:],
    "materials": os.environ.get("NACRE_MATERIALS"),
    "compiled": sorted(os.listdir(compiled)) if compiled else None,
}}), file=report, flush=True)
sys.stdout.flush()
{ending}
"""


def recorder(path: Path, code=0, probe=0, ending="") -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    text = RECORDER.format(
        python=shlex.quote(sys.executable), probe=probe, ending=ending or f"sys.exit({code})"
    )
    path.write_text(text)
    path.chmod(0o755)
    return path


@pytest.fixture
def prefix(nacre, tmp_path) -> Path:
    """An installation without an environment of its own."""
    prefix = tmp_path / "prefix"
    for folder in ("bin", "share/nacre/addon/background", "share/nacre/materials"):
        (prefix / folder).mkdir(parents=True)
    shutil.copy(nacre.program, prefix / "bin" / "nacre")
    (prefix / "share/nacre/addon/background/driver.py").write_text("")
    return prefix


@pytest.fixture
def render(prefix, tmp_path):
    """Runs `nacre render` of that installation in an environment that holds only what is given."""

    def run(*arguments, before=(), **environment):
        base = {
            key: os.environ[key] for key in ("LD_LIBRARY_PATH", "ASAN_OPTIONS") if key in os.environ
        }
        return subprocess.run(
            [prefix / "bin" / "nacre", *before, "render", *map(str, arguments)],
            capture_output=True,
            text=True,
            env={"PATH": str(tmp_path / "path"), "TMPDIR": str(tmp_path), **base, **environment},
            check=False,
        )

    return run


ARGUMENTS = (
    "--material",
    "soap_film",
    "--size",
    "64x64",
    "--set",
    "thickness_nm=300",
    "-o",
    "x.exr",
)


def test_named_python(render, prefix, tmp_path):
    python = recorder(tmp_path / "my-python")
    result = render(*ARGUMENTS, NACRE_PYTHON=str(python), NACRE_BLENDER="/nonexistent")
    assert result.returncode == 0, result.stderr
    call = json.loads(result.stdout)
    assert call["arguments"] == [
        str(prefix / "share/nacre/addon/background/driver.py"),
        "render",
        *ARGUMENTS,
    ]
    assert call["materials"] == str(prefix / "share/nacre/materials")
    assert (
        result.stderr == f"nacre render: uses bpy of {python} (NACRE_PYTHON)\nlibfilm: odd film\n"
    )


QUIET = {"after": ((), ("--quiet",)), "before": (("--quiet",), ())}


@pytest.mark.parametrize("where", QUIET)
def test_quiet_says_nothing_but_what_went_wrong(render, tmp_path, where):
    """Not what Blender and its libraries say either; unless there is no picture: they may know why."""
    (before, after), fine = QUIET[where], recorder(tmp_path / "fine")
    result = render(*ARGUMENTS, *after, before=before, NACRE_PYTHON=str(fine))
    assert json.loads(result.stdout)["arguments"][-1] == "--quiet"
    assert result.stderr == ""
    broken = recorder(tmp_path / "broken", code=1)
    result = render(*ARGUMENTS, *after, before=before, NACRE_PYTHON=str(broken))
    assert result.returncode == 1
    assert result.stderr == "libfilm: odd film\n"
    dead = recorder(tmp_path / "dead", ending="os.kill(os.getpid(), 11)")
    result = render(*ARGUMENTS, *after, before=before, NACRE_PYTHON=str(dead))
    assert result.returncode == 128 + signal.SIGSEGV
    assert result.stderr == (
        "libfilm: odd film\n"
        "nacre render: Blender was ended by a signal: Segmentation fault\n"
    )  # fmt: skip


def test_verbose_has_the_chatter_of_blender_on_standard_error(render, tmp_path):
    python = recorder(tmp_path / "python")
    result = render(*ARGUMENTS, "-v", NACRE_PYTHON=str(python))
    assert json.loads(result.stdout)["arguments"][-1] == "-v"
    assert {"Blender 9.9", "libfilm: odd film"} <= set(result.stderr.splitlines())


def test_options_before_the_command_are_those_of_the_driver(render, tmp_path):
    python = recorder(tmp_path / "python")
    before = ("--json", "--threads", "3", "-v")
    result = render(*ARGUMENTS, before=before, NACRE_PYTHON=str(python))
    arguments = json.loads(result.stdout)["arguments"]
    assert arguments[-4:] == ["--verbose", "--json", "--threads", "3"]


def test_a_closed_standard_output_is_no_crash(prefix, tmp_path):
    python = recorder(tmp_path / "python")
    command = [
        "bash",
        "-c",
        'exec "$@" >&-',
        "bash",
        prefix / "bin" / "nacre",
        "render",
        *ARGUMENTS,
    ]
    done = subprocess.run(
        command, env={**os.environ, "NACRE_PYTHON": str(python)}, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert "Bad file descriptor" in done.stderr


def test_named_blender(render, prefix, tmp_path):
    blender = recorder(tmp_path / "my-blender")
    result = render(*ARGUMENTS, NACRE_BLENDER=str(blender))
    assert json.loads(result.stdout)["arguments"] == [
        "-b",
        "--factory-startup",
        "--python-exit-code",
        "1",
        "--python",
        str(prefix / "share/nacre/addon/background/driver.py"),
        "--",
        "render",
        *ARGUMENTS,
    ]
    assert f"uses {blender} (NACRE_BLENDER)" in result.stderr


def test_order_of_the_search(render, prefix, tmp_path):
    """The prefix's own environment, then python3, then blender on the path."""
    blender = recorder(tmp_path / "path" / "blender")
    assert json.loads(render(*ARGUMENTS).stdout)["program"] == str(blender)
    python = recorder(tmp_path / "path" / "python3")
    assert json.loads(render(*ARGUMENTS).stdout)["program"] == str(python)
    own = recorder(prefix / ".venv" / "bin" / "python")
    assert json.loads(render(*ARGUMENTS).stdout)["program"] == str(own)
    recorder(own, probe=1)  # an environment without bpy
    assert json.loads(render(*ARGUMENTS).stdout)["program"] == str(python)


def test_nothing_found_says_what_to_install(render):
    result = render(*ARGUMENTS)
    assert result.returncode == 1
    for word in ("NACRE_PYTHON", "NACRE_BLENDER", "bpy"):
        assert word in result.stderr


def test_a_named_program_that_does_not_work_is_an_error(render, tmp_path):
    recorder(tmp_path / "path" / "blender")
    without_bpy = recorder(tmp_path / "python", probe=1)
    for environment in (
        {"NACRE_PYTHON": "/nonexistent"},
        {"NACRE_PYTHON": str(without_bpy)},
        {"NACRE_BLENDER": "/nonexistent"},
    ):
        result = render(*ARGUMENTS, **environment)
        assert result.returncode == 1
        (name, value) = next(iter(environment.items()))
        assert f"{name}: must be" in result.stderr
        assert f"(got {value})" in result.stderr


@pytest.mark.parametrize("code", [0, 1, 2, 77])
def test_exit_code_passes_through(render, tmp_path, code):
    python = recorder(tmp_path / "python", code=code)
    assert render(*ARGUMENTS, NACRE_PYTHON=str(python)).returncode == code


def test_materials_folder_of_the_users_own(render, tmp_path):
    python = recorder(tmp_path / "python")
    result = render(*ARGUMENTS, NACRE_PYTHON=str(python), NACRE_MATERIALS="/somewhere")
    assert json.loads(result.stdout)["materials"] == "/somewhere"


@pytest.mark.parametrize("joined", [False, True])
def test_template_is_compiled_first(render, templates, tmp_path, joined):
    python = recorder(tmp_path / "python")
    source = templates / "water.toml"
    option = (f"--template={source}",) if joined else ("--template", source)
    result = render(*option, "-o", "x.exr", NACRE_PYTHON=str(python))
    assert result.returncode == 0, result.stderr
    call = json.loads(result.stdout)
    assert not any(argument.startswith("--template") for argument in call["arguments"])
    assert "water.json" in call["compiled"]
    assert "water.osl" in call["compiled"]
    assert not list(tmp_path.glob("nacre-render.*"))


def test_bad_template_starts_nothing(render, tmp_path):
    python = recorder(tmp_path / "python")
    bad = tmp_path / "bad.toml"
    bad.write_text("schema = 2\n")
    result = render("--template", bad, "-o", "x.exr", NACRE_PYTHON=str(python))
    assert result.returncode == 1
    assert result.stdout == ""
    assert f"nacre render: {bad}:1: schema" in result.stderr


def test_signals_reach_the_child(prefix, templates, tmp_path):
    child = tmp_path / "python"
    child.write_text(
        '#!/bin/sh\n[ "$1" = -c ] && exit 0\ncd "${0%/*}" || exit 1\n'
        "trap 'touch told; exit 5' TERM\ntouch started\nwhile :; do sleep 0.05; done\n"
    )
    child.chmod(0o755)
    arguments = ["render", "--template", templates / "water.toml", "-o", "x.exr"]
    process = subprocess.Popen(
        [prefix / "bin" / "nacre", *arguments],
        env={**os.environ, "NACRE_PYTHON": str(child), "TMPDIR": str(tmp_path)},
        stderr=subprocess.DEVNULL,
    )
    deadline = time.monotonic() + 20
    while not (tmp_path / "started").exists():
        assert time.monotonic() < deadline
        time.sleep(0.02)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=20) == 143
    assert (tmp_path / "told").exists()
    assert not list(tmp_path.glob("nacre-render.*"))
