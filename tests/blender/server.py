# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A Blender that answers one request after another; see harness.Server, which starts it.

A request is a line of JSON on standard input: `call` ("furnace.render": a function of a module in
jobs/), its `arguments`, `environment`, `folder` to work in, `stdout` and `stderr` (files that take
what is printed), `fresh` (factory settings, and the extension imported anew). The answer is a line on
what was standard output: `result` or `error`, and whether this Blender may be asked again.
"""

from __future__ import annotations

import contextlib
import ctypes
import importlib
import json
import os
import sys
import traceback
from collections.abc import Iterator
from pathlib import Path

# Before Blender comes, which may print while it is imported: nothing else answers or reads a request.
REQUESTS, ANSWERS = os.dup(0), os.dup(1)
os.dup2(os.open(os.devnull, os.O_RDWR), 0)
os.dup2(2, 1)

import bpy  # noqa: E402

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

from jobs import extension  # noqa: E402


def flush() -> None:
    """Python's buffers and those of C, which Blender prints through."""
    sys.stdout.flush()
    sys.stderr.flush()
    ctypes.CDLL(None).fflush(None)


@contextlib.contextmanager
def printing_to(stdout: str, stderr: str) -> Iterator[None]:
    """Turns both descriptors aside, since Blender writes from C++."""
    flush()
    kept = os.dup(1), os.dup(2)
    for descriptor, file in ((1, stdout), (2, stderr)):
        opened = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(opened, descriptor)
        os.close(opened)
    try:
        yield
    finally:
        flush()
        for descriptor, copy in zip((1, 2), kept, strict=True):
            os.dup2(copy, descriptor)
            os.close(copy)


@contextlib.contextmanager
def surroundings(environment: dict[str, str], folder: str) -> Iterator[None]:
    """The environment and folder of a request, as a process of its own would have them."""
    kept = dict(os.environ), Path.cwd(), sys.argv[:], sys.path[:], sys.unraisablehook
    os.environ.clear()
    os.environ.update(environment)
    os.chdir(folder)
    try:
        yield
    finally:
        os.environ.clear()
        os.environ.update(kept[0])
        os.chdir(kept[1])
        sys.argv[:], sys.path[:], sys.unraisablehook = kept[2:]


def answer(request: dict) -> dict:
    module, _, function = request["call"].rpartition(".")
    with (
        surroundings(request["environment"], request["folder"]),
        printing_to(request["stdout"], request["stderr"]),
    ):
        try:
            if request["fresh"]:
                extension.forget()
                bpy.ops.wm.read_factory_settings()
            called = getattr(importlib.import_module(f"jobs.{module}"), function)
            return {"result": called(**request["arguments"]), "reusable": extension.is_off()}
        except BaseException:  # sys.exit() among it
            # Whatever state that left behind, nobody should test in it.
            return {"error": traceback.format_exc(), "reusable": False}


def main() -> None:
    requests, answers = os.fdopen(REQUESTS), os.fdopen(ANSWERS, "w")
    for line in requests:
        print(json.dumps(answer(json.loads(line))), file=answers, flush=True)
    flush()
    os._exit(0)  # without what Blender prints when an interpreter ends


if __name__ == "__main__":
    main()
