# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Files appear whole or not at all: full discs, unwritable folders, signals."""

from __future__ import annotations

import os
import resource
import shlex
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest


def run_limited(nacre, limit, *arguments):
    """Runs the tool where no file may grow beyond `limit` bytes, as on a disc that fills up."""

    def apply():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run(
        [nacre.program, *map(str, arguments)],
        capture_output=True,
        text=True,
        preexec_fn=apply,
        timeout=120,
        check=False,
    )


@pytest.fixture
def commands(film_json, templates, tmp_path):
    """Every command that writes, with its target."""
    (tmp_path / "records.json").write_text('[{"illuminant": "D65"}]')
    return {
        "cmf": (("bake", "cmf", "-o"), tmp_path / "out" / "cmf.exr"),
        "png": (("bake", "cmf", "-o"), tmp_path / "out" / "cmf.png"),
        "stack": (
            ("bake", "stack", film_json, "--size", "64x64", "-o"),
            tmp_path / "out" / "f.exr",
        ),
        "tx": (("bake", "stack", film_json, "--size", "64x64", "-o"), tmp_path / "out" / "f.tx"),
        "eval": (
            ("eval", "spectrum", tmp_path / "records.json", "-o"),
            tmp_path / "out" / "e.json",
        ),
    }


KINDS = ["cmf", "png", "stack", "tx", "eval"]


@pytest.mark.parametrize("kind", KINDS)
def test_full_disc_leaves_the_old_file(nacre, commands, kind):
    arguments, target = commands[kind]
    target.parent.mkdir()
    target.write_text("old")
    result = run_limited(nacre, 64, *arguments, target)
    assert result.returncode == 1
    assert str(target) in result.stderr
    assert "File too large" in result.stderr
    assert [path.name for path in target.parent.iterdir()] == [target.name]
    assert target.read_text() == "old"


@pytest.mark.skipif(os.geteuid() != 0, reason="mounting a small disc needs root")
@pytest.mark.parametrize("kind", KINDS)
def test_small_disc(nacre, commands, kind):
    arguments, target = commands[kind]
    disc = target.parent
    disc.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=4k,nr_inodes=8", "none", str(disc)]
    if subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("this machine does not allow mounting")
    try:
        (disc / "filler").write_bytes(b"x" * 4096)  # the one page that there is
        result = nacre(*arguments, target)
        assert result.returncode == 1
        assert "no space left on the disc" in result.stderr
        assert [path.name for path in disc.iterdir()] == ["filler"]
    finally:
        subprocess.run(["umount", str(disc)], check=True)


def test_full_disc_leaves_the_old_material(nacre, templates, tmp_path):
    source, output = templates / "tempered_steel.toml", tmp_path / "out"
    nacre.ok("compile", source, "--tolerance", "1", "-o", output)
    before = {path.name: path.read_bytes() for path in (output / "tempered_steel").iterdir()}
    result = run_limited(nacre, 64, "compile", source, "--tolerance", "2", "-o", output)
    assert result.returncode == 1
    assert "File too large" in result.stderr
    assert [path.name for path in output.iterdir()] == ["tempered_steel"]
    assert {
        path.name: path.read_bytes() for path in (output / "tempered_steel").iterdir()
    } == before


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_full_standard_output(nacre):
    with open("/dev/full", "w") as full:
        result = subprocess.run(
            [nacre.program, "library", "list"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert result.returncode == 1
    assert "standard output: cannot be written" in result.stderr


@pytest.mark.parametrize("kind", KINDS)
def test_missing_folder(nacre, commands, kind):
    arguments, target = commands[kind]
    errors = nacre.fails(*arguments, target)
    assert str(target) in errors
    assert not target.parent.exists()


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_in_the_way_of_the_folder(nacre, commands, kind):
    arguments, target = commands[kind]
    target.parent.write_text("a file")
    assert str(target) in nacre.fails(*arguments, target)
    assert target.parent.read_text() == "a file"


@pytest.mark.parametrize("kind", KINDS)
def test_a_folder_in_the_way_of_the_file(nacre, commands, kind):
    arguments, target = commands[kind]
    target.mkdir(parents=True)
    assert str(target) in nacre.fails(*arguments, target)
    assert list(target.iterdir()) == []


@pytest.mark.parametrize("kind", [*KINDS, "compile"])
def test_unwritable_folder(nacre, commands, templates, kind, tmp_path):
    if kind == "compile":
        target = tmp_path / "out" / "materials"
        arguments = ("compile", templates / "water.toml", "-o")
    else:
        arguments, target = commands[kind]
    target.parent.mkdir()
    target.parent.chmod(0o555)
    drop = []
    if os.geteuid() == 0:  # root may write anywhere; nobody may not
        if not shutil.which("setpriv"):
            pytest.skip("root needs setpriv to become nobody")
        drop = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        readable = subprocess.run([*drop, "test", "-x", nacre.program], check=False)
        # pytest's own folders, one more where several of its processes run.
        for folder in (tmp_path, *tmp_path.parents[:3]):
            folder.chmod(folder.stat().st_mode | 0o055)
        if readable.returncode != 0:
            pytest.skip("nobody may not run the program")
    result = subprocess.run(
        [*drop, nacre.program, *map(str, arguments), target],
        capture_output=True,
        text=True,
        check=False,
    )
    target.parent.chmod(0o755)
    assert result.returncode == 1
    assert str(target) in result.stderr or str(target.parent) in result.stderr
    assert "not writable" in result.stderr or "Permission denied" in result.stderr
    assert list(target.parent.iterdir()) == []


LONG = ("--size", "2048x2048")


def catches(pid, number):
    """Whether a process has a handler for a signal; see proc(5), SigCgt."""
    with open(f"/proc/{pid}/status") as status:
        mask = next(int(line.split()[1], 16) for line in status if line.startswith("SigCgt:"))
    return bool(mask >> (number - 1) & 1)


def start_long_bake(nacre, film_json, target):
    if not Path("/proc/self/status").exists():
        pytest.skip("needs /proc, which tells when the program is ready for signals")
    process = subprocess.Popen(
        [nacre.program, "bake", "stack", film_json, *LONG, "-o", target],
        stderr=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 20
    while not catches(process.pid, signal.SIGTERM):  # the program loads its libraries before
        assert time.monotonic() < deadline
        time.sleep(0.02)
    time.sleep(0.2)
    assert process.poll() is None, "the bake is over before it can be interrupted"
    return process


@pytest.mark.parametrize(("number", "code"), [(signal.SIGTERM, 143), (signal.SIGINT, 130)])
def test_interrupted_bake(nacre, film_json, tmp_path, number, code):
    target = tmp_path / "out" / "film.exr"
    target.parent.mkdir()
    target.write_text("old")
    process = start_long_bake(nacre, film_json, target)
    process.send_signal(number)
    assert process.wait(timeout=20) == code
    assert [path.name for path in target.parent.iterdir()] == ["film.exr"]
    assert target.read_text() == "old"


def test_killed_bake(nacre, film_json, tmp_path):
    target = tmp_path / "film.exr"
    process = start_long_bake(nacre, film_json, target)
    process.kill()
    process.wait(timeout=20)
    assert not target.exists()


def test_interrupted_while_a_child_compiles_shaders(nacre, templates, tmp_path):
    """Temporary folders exist at that time; they go, and the child goes too."""
    program = tmp_path / "bin" / "oslc"
    program.parent.mkdir()
    program.write_text(f"#!/bin/sh\ntouch {shlex.quote(str(tmp_path))}/started\nexec sleep 60\n")
    program.chmod(0o755)
    process = subprocess.Popen(
        [nacre.program, "compile", templates / "water.toml", "-o", tmp_path / "out"],
        env={**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"},
    )
    deadline = time.monotonic() + 20
    while not (tmp_path / "started").exists():
        assert time.monotonic() < deadline
        time.sleep(0.02)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=20) == 143
    assert list((tmp_path / "out").iterdir()) == []


def test_output_through_a_link_keeps_the_link(nacre, tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "cmf.exr").write_text("old")
    link = tmp_path / "link.exr"
    link.symlink_to(tmp_path / "real" / "cmf.exr")
    nacre.ok("bake", "cmf", "-o", link)
    assert link.is_symlink()
    assert (tmp_path / "real" / "cmf.exr").stat().st_size > 1000
