# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Reads a config for `nacre`, by an OpenColorIO that is newer than its own. Lines of JSON:

  out  the version of PyOpenColorIO, null where there is none
  in   [config, space, interchange role]
  out  {"names", "is_known", "is_data", "has_interchange", "failure"}, or {"error"}

Then, until the input ends, colours as three numbers, which may be no JSON: "x y z" in, "r g b" out.
"""

import importlib.util
import json
import os
import sys
from pathlib import Path

# What the libraries print must not come between the answers.
answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
os.dup2(2, 1)


def say(answer):
    print(json.dumps(answer), file=answers, flush=True)


def first_line(error):
    return (str(error).splitlines() or [type(error).__name__])[0]


def open_color_io():
    """Of this Python, or the one inside its bpy, which need not be loaded for it."""
    bpy = importlib.util.find_spec("bpy")
    for folder in (bpy and bpy.submodule_search_locations) or ():
        sys.path += map(str, Path(folder).glob("*/python/lib/python3*/site-packages"))
    try:
        import PyOpenColorIO
    except Exception:  # for another Python, or libraries that are not there
        return None
    return PyOpenColorIO


def read(ocio, file, space, role):
    """The answer, and the processor where there is one."""
    ocio.SetLoggingLevel(ocio.LOGGING_LEVEL_NONE)
    config = ocio.Config.CreateFromFile(file)
    config.validate()
    found = config.getColorSpace(space)
    answer = {
        "names": [*config.getColorSpaceNames(), *config.getRoleNames()],
        "is_known": found is not None,
        "is_data": found is not None and found.isData(),
        "has_interchange": config.hasRole(role),
        "failure": "",
    }
    if not (answer["is_known"] and answer["has_interchange"]) or answer["is_data"]:
        return answer, None
    try:
        processor = config.getProcessor(role, space)
        return answer, processor.getOptimizedCPUProcessor(ocio.OPTIMIZATION_LOSSLESS)
    except ocio.Exception as error:
        return {**answer, "failure": first_line(error)}, None


def main():
    ocio = open_color_io()
    say(ocio and ocio.GetVersion())
    request = sys.stdin.readline()
    if not request:
        return
    try:
        answer, processor = read(ocio, *json.loads(request))
    except Exception as error:
        say({"error": first_line(error)})
        return
    say(answer)
    for line in sys.stdin:
        print(*processor.applyRGB([float(word) for word in line.split()]), file=answers, flush=True)


main()
