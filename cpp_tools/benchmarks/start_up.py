# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What it costs to start the tool, against the tool with OpenImageIO and OpenColorIO loaded from the
start, as it is where they are linked to it."""

from __future__ import annotations

import os
import resource
import subprocess
from pathlib import Path

from measure import Result

REPEATS = 15
TARGET = 10.0
COMMANDS = {
    "version": (["--version"], ""),
    "help": (["--help"], ""),
    "eval": (["eval", "stack"], '{"n": [1, 1.5], "d_nm": [], "wavelength_nm": 550}'),
    "list": (["library", "list"], ""),  # which reads every file of the library
}


def cpu_seconds(command: list[str], stdin: str, preload: str) -> float:
    environment = {**os.environ, "LD_PRELOAD": preload}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        command, input=stdin, text=True, env=environment, stdout=subprocess.DEVNULL, check=True
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def results() -> list[Result]:
    program = os.environ["NACRE"]
    modules = sorted((Path(program).parents[1] / "lib" / "nacre").glob("*.so"))
    if len(modules) != 2:
        raise SystemExit(f"{program}: has {len(modules)} modules beside it, not 2")
    preloads = ("", ":".join(map(str, modules)))
    measured = []
    for name, (arguments, stdin) in COMMANDS.items():
        best = [float("inf")] * 2
        for _ in range(REPEATS):  # in turns, so that a busy machine troubles both alike
            for i, preload in enumerate(preloads):
                best[i] = min(best[i], cpu_seconds([program, *arguments], stdin, preload))
        measured.append(
            Result(
                id=f"start-{name}",
                what=f"nacre {' '.join(arguments)}, CPU seconds",
                ours=best[0],
                peer=best[1],
                peer_version="with OpenImageIO and OpenColorIO loaded",
                target=TARGET,
            )
        )
    return measured
