# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Blenders that tests talk to: one process a version, asked again and again.

NACRE_BPY45 and NACRE_BPY52 name Python programs that have `bpy` 4.5 and 5.2. A test that needs a
process of its own (it installs, crashes, is killed or ends with a status) takes Blender.process().
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Self

import numpy as np
import pytest

from support.images import read_image
from support.paths import DRIVER, materials_folder

HERE = Path(__file__).resolve().parent
VERSIONS = {"4.5": "NACRE_BPY45", "5.2": "NACRE_BPY52"}


class BlenderError(AssertionError):
    """A request ended in an exception inside Blender, or took Blender down."""


@dataclass
class Server:
    """A process of server.py; started by the first request and after one that left it unusable."""

    command: list[str]
    starts: int = 0
    _process: subprocess.Popen | None = None
    _folder: tempfile.TemporaryDirectory = field(
        default_factory=lambda: tempfile.TemporaryDirectory(prefix="nacre-blender-")
    )

    @property
    def log(self) -> Path:
        """What Blender prints between requests."""
        return Path(self._folder.name, "log")

    def request(self, call: str, arguments: dict, *, environment: Mapping[str, str], folder: Path,
                fresh: bool, timeout: float = 900.0) -> tuple[object, str, str]:  # fmt: skip
        """Result, standard output and standard error; raises BlenderError."""
        printed = [Path(self._folder.name, name) for name in ("stdout", "stderr")]
        for file in printed:
            file.write_bytes(b"")
        line = json.dumps(
            {
                "call": call,
                "arguments": arguments,
                "environment": dict(environment),
                "folder": str(folder),
                "stdout": str(printed[0]),
                "stderr": str(printed[1]),
                "fresh": fresh,
            }
        )
        answer = self._exchange(line, timeout)
        stdout, stderr = (file.read_text("utf-8", "replace") for file in printed)
        if not answer.get("reusable"):
            self.stop()
        if "error" in answer:
            raise BlenderError(f"{call}: {answer['error']}\n{stdout[-4000:]}\n{stderr[-8000:]}")
        return answer["result"], stdout, stderr

    def _exchange(self, line: str, timeout: float) -> dict:
        process = self._running()
        try:
            process.stdin.write(line + "\n")
            process.stdin.flush()
            text = self._read_line(process, timeout)
        except BrokenPipeError:
            text = ""
        if text is None:
            self.stop()
            return {"error": f"no answer within {timeout:g} s"}
        if not text:
            status = process.wait()
            died = signal.Signals(-status).name if status < 0 else f"status {status}"
            return {"error": f"Blender ended by {died}\n{self.log.read_text('utf-8', 'replace')}"}
        return json.loads(text)

    @staticmethod
    def _read_line(process: subprocess.Popen, timeout: float) -> str | None:
        """A line, nothing where the process ended, None where it did not answer in time."""
        end = time.monotonic() + timeout
        text = b""
        while not text.endswith(b"\n"):
            left = end - time.monotonic()
            if left <= 0 or not select.select([process.stdout], [], [], left)[0]:
                return None
            part = os.read(process.stdout.fileno(), 1 << 16)
            if not part:
                return ""
            text += part
        return text.decode()

    def _running(self) -> subprocess.Popen:
        if self._process is None or self._process.poll() is not None:
            self.starts += 1
            with self.log.open("wb") as log:
                self._process = subprocess.Popen(
                    self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log,
                    text=True, start_new_session=True,
                )  # fmt: skip
        return self._process

    def stop(self) -> None:
        """Ends the process, at once where it is at work, and all that it started."""
        process, self._process = self._process, None
        if process is None:
            return
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
        try:
            process.wait(timeout=2)
        except subprocess.TimeoutExpired:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        process.stdout.close()

    def close(self) -> None:
        self.stop()
        self._folder.cleanup()


class Pictures:
    """Pictures by what they show, each rendered when it is first asked for; one that Blender does not
    give fails whoever asks for it, and no other."""

    def __init__(self, blender: Blender, call: str, job: Callable[..., dict]):
        self._blender, self._call, self._job = blender, call, job
        self._found: dict[tuple, np.ndarray | BlenderError] = {}

    def __call__(self, *what) -> np.ndarray:
        if what not in self._found:
            self._found[what] = self._render(self._job(*what))
        found = self._found[what]
        if isinstance(found, BlenderError):
            raise found
        return found

    def _render(self, job: dict) -> np.ndarray | BlenderError:
        try:
            return self._blender.picture(self._call, **job)
        except BlenderError as failed:
            return failed


@dataclass
class Blender:
    """One version; `folder` is for its files, `environment` what differs from the tests' own."""

    version: str
    python: str
    server: Server
    folder: Path
    environment: dict[str, str | None] = field(default_factory=dict)

    @property
    def surroundings(self) -> dict[str, str]:
        """The variables of a process, without those that show it where the Python package is: a user
        has none of them."""
        given = {
            "NACRE_MATERIALS": str(materials_folder()),
            "NACRE_LIBRARY": None,
            "PYTHONPATH": None,
            "PYTHONWARNINGS": "ignore",
        }
        found = {**os.environ, **given, **self.environment}
        return {name: value for name, value in found.items() if value is not None}

    def see_in(self, version: str) -> None:
        """Skips a test that takes long and is alike in all versions, in all but this one."""
        if self.version != version and not os.environ.get("NACRE_SOAK"):
            pytest.skip(f"seen in {version}; NACRE_SOAK=1 sees it in both")

    def ask(self, call: str, *, fresh: bool = False, **arguments) -> tuple[object, str, str]:
        """Result of a function of jobs/, and what was printed meanwhile."""
        return self.server.request(
            call, arguments, environment=self.surroundings, folder=self.folder, fresh=fresh
        )

    def call(self, call: str, **arguments):
        return self.ask(call, **arguments)[0]

    def script(self, file: Path, *arguments: object) -> str:
        """Runs a script with factory settings, whose own asserts decide; returns what it printed."""
        words = [str(argument) for argument in arguments]
        return self.ask("program.script", fresh=True, file=str(file), arguments=words)[1]

    def render(self, *arguments: object, fresh: bool = True) -> subprocess.CompletedProcess:
        """`driver.py render ARGUMENTS`; with factory settings, or else those of the last request."""
        words = [str(argument) for argument in arguments]
        status, stdout, stderr = self.ask("program.render", fresh=fresh, arguments=words)
        return subprocess.CompletedProcess(words, status, stdout, stderr)

    def picture(self, call: str, **job) -> np.ndarray:
        """What a function of jobs/ renders into the `file` that it is given."""
        file = self.folder / "picture.exr"
        file.unlink(missing_ok=True)
        self.call(call, **job, file=str(file))
        return read_image(file)

    def pictures(
        self, call: str, job: Callable[..., dict], materials: Path | None = None
    ) -> Pictures:
        """Those of a function of jobs/, whose arguments `job` makes of what is asked for; of compiled
        materials elsewhere, if given."""
        blender = self.with_environment(NACRE_MATERIALS=str(materials)) if materials else self
        return Pictures(blender, call, job)

    def with_environment(self, **variables: str | None) -> Self:
        """The same Blender; what is None is not in its environment."""
        return replace(self, environment={**self.environment, **variables})

    def command(self, *arguments: object) -> list[str]:
        return [self.python, *map(str, arguments)]

    def process(self, *arguments: object, **options) -> subprocess.CompletedProcess:
        """Its Python with these arguments, in a process of its own."""
        return subprocess.run(
            self.command(*arguments), env=self.surroundings, capture_output=True, text=True,
            timeout=600, check=False, **options,
        )  # fmt: skip

    def render_process(self, *arguments: object, **options) -> subprocess.CompletedProcess:
        return self.process(DRIVER, "render", *arguments, **options)

    @cached_property
    def package(self) -> Path:
        """The folder of its `bpy`, found without starting it."""
        find = "import importlib.util as u; print(u.find_spec('bpy').submodule_search_locations[0])"
        return Path(self.process("-c", find).stdout.strip())

    @property
    def blender_ext(self) -> Path:
        """Blender's own program that builds and checks extensions."""
        return next(self.package.glob("*/scripts/addons_core/bl_pkg/cli/blender_ext.py"))


def server_command(python: str) -> list[str]:
    return [python, str(HERE / "server.py")]


def xvfb_command(python: str) -> list[str]:
    """A server with a display of its own, which EEVEE draws on."""
    return ["xvfb-run", "-a", "-s", "-screen 0 640x480x24", *server_command(python)]


class Blenders:
    """The Blenders of a run, each started when it is first asked."""

    def __init__(self) -> None:
        self._servers: dict[str, Server] = {}

    def get(self, version: str, folder: Path) -> Blender | None:
        """None where no Python has that version."""
        python = os.environ.get(VERSIONS[version])
        if not python:
            return None
        if version not in self._servers:
            self._servers[version] = Server(server_command(python))
        return Blender(version, python, self._servers[version], folder)

    def close(self) -> None:
        for server in self._servers.values():
            server.close()
