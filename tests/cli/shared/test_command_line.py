# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The command line itself: help, versions, exit codes, the head of messages."""

from __future__ import annotations

import os
import pty
import re
import subprocess

import pytest

from support.paths import ROOT

COMMANDS = [
    ("eval",),
    ("eval", "stack"),
    ("eval", "spectrum"),
    ("eval", "film"),
    ("eval", "grating"),
    ("eval", "slits"),
    ("bake",),
    ("bake", "cmf"),
    ("bake", "stack"),
    ("compile",),
    ("library",),
    ("library", "list"),
    ("library", "show"),
    ("library", "check"),
    ("library", "schema"),
    ("info",),
    ("compare",),
    ("render",),
]


def test_version_is_that_of_the_project(nacre):
    version = re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    assert nacre.ok("--version") == f"nacre {version}\n"


def test_help_lists_every_command(nacre):
    text = nacre.ok("--help")
    for command in COMMANDS:
        assert re.search(rf"^\s+{command[0]}\b", text, re.MULTILINE)
    assert "Exit status" in text


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_every_command_has_help(nacre, command):
    text = nacre.ok(*command, "--help")
    assert re.search(r"^usage: ", text, re.IGNORECASE | re.MULTILINE)
    if len(command) > 1 and command[1] != "schema":
        assert f"nacre {' '.join(command)}" in text  # an example


def test_defaults_are_in_the_help(nacre):
    text = nacre.ok("bake", "stack", "--help")
    for default in ("0.1", "D65", "cie1931", "lin_rec709_scene", "reflectance", "float"):
        assert default in text


@pytest.mark.parametrize(
    ("arguments", "head"),
    [
        ((), "nacre: "),
        (("frobnicate",), "nacre: "),
        (("bake",), "nacre bake: "),
        (("bake", "noise"), "nacre bake: "),
        (("bake", "cmf"), "nacre bake cmf: "),
        (("eval", "sound"), "nacre eval: "),
        (("eval", "stack", "a", "b"), "nacre eval stack: "),
        (("compile", "x.toml"), "nacre compile: "),
        (("compare", "a.exr"), "nacre compare: "),
        (("library", "show"), "nacre library show: "),
        (("--threads", "many", "info", "x"), "nacre"),
    ],
)
def test_usage_errors(nacre, arguments, head):
    result = nacre(*arguments)
    assert result.returncode == 1
    assert result.stdout == ""
    assert result.stderr.startswith(head)
    assert "--help" in result.stderr


def test_global_options_stand_before_or_after_the_command(nacre):
    assert nacre.ok("--json", "library", "list") == nacre.ok("library", "list", "--json")


def test_silent_in_a_pipe(nacre, film_json, tmp_path):
    result = nacre("bake", "stack", film_json, "-o", tmp_path / "film.exr")
    assert (result.stdout, result.stderr) == ("", "")


def test_verbose_says_what_was_written(nacre, film_json, tmp_path):
    result = nacre("-v", "bake", "stack", film_json, "--size", "8x8", "-o", tmp_path / "film.exr")
    assert f"nacre bake stack: {tmp_path}/film.exr: 8 x 8 texels, ΔE00 max " in result.stderr


@pytest.mark.parametrize("quiet", [False, True])
def test_progress_on_a_terminal(nacre, templates, tmp_path, quiet):
    try:
        ours, theirs = pty.openpty()
    except OSError as error:
        pytest.skip(f"this machine gives no pseudo-terminal: {error}")
    command = [
        nacre.program,
        "bake",
        "stack",
        templates / "soap_film.toml",
        "-o",
        tmp_path / "x.exr",
    ]
    process = subprocess.Popen([*command, *(["--quiet"] if quiet else [])], stderr=theirs)
    os.close(theirs)
    text = b""
    while True:
        try:
            block = os.read(ours, 4096)
        except OSError:  # the other end is closed
            break
        if not block:
            break
        text += block
    os.close(ours)
    assert process.wait(timeout=60) == 0
    assert (b"%" in text) is not quiet
