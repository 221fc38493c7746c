# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The check of imports and folders finds what it is there for, and nothing in what is allowed."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import imports

ALLOWED = {
    "addon/core/light.py": "import math\nfrom . import space\n",
    "addon/core/space.py": "KIND = 'film and glass'\n",
    "addon/materials/group.py": "import bpy\n\nfrom ..core.light import math\n",
    "addon/films/stack.py": "from ..materials import group\n\nKIND = 'film'\n",
    "addon/viewer/probe.py": "def read():\n    from ..films.stack import KIND\n",
    "addon/background/render.py": "from ..viewer import probe\nfrom .scenes import shape\n",
    "addon/background/scenes/shape.py": "from ...materials.group import bpy\n",
    "addon/registration.py": "from .background import render\nfrom .films import stack\n",
    "tests/support/truth.py": "",
    "tests/cpp/test_it.py": "from support import truth\nimport test_of_another_package\n",
}
for package in ("core", "materials", "films", "viewer", "background", "background/scenes"):
    ALLOWED[f"addon/{package}/__init__.py"] = ""


def found(folder: Path, **files: str) -> list[str]:
    """Problems of what is allowed and these files, whose names have / for __."""
    more = {f"{name.replace('__', '/')}.py": text for name, text in files.items()}
    for name, text in {**ALLOWED, **more}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    return imports.problems(folder)


def test_what_is_allowed_passes(tmp_path):
    assert found(tmp_path) == []


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("addon__core__up", "from ..films import stack", "core must not import films"),
        (
            "addon__core__up",
            "def f():\n    from ..films.stack import KIND",
            "core/up.py:2: core must not",
        ),
        ("addon__materials__up", "from .. import viewer", "materials must not import viewer"),
        ("addon__films__up", "from ..background.render import probe", "must not import background"),
        ("addon__viewer__up", "from ..registration import films", "must not import the modules of"),
        (
            "addon__films__round",
            "from ..viewer import probe",
            "import each other: films <- viewer <- films",
        ),
        ("addon__core__bound", "import bpy", "core works without Blender (imports bpy)"),
        ("addon__core__bound", "from mathutils import Vector", "(imports mathutils.Vector)"),
        ("addon__viewer__asks", "ok = kind == 'film'", "viewer/asks.py:1: 'film' is a kind"),
        ("addon__films__asks", "ok = kind == 'glass'", "'glass' is a kind"),
        ("tests__cpp__test_more", "from test_it import truth", "no test imports another (test_it)"),
        ("tests__cpp__test_more", "from . import test_it", "no test imports another (test_it)"),
    ],
)
def test_a_fault_is_found_and_nothing_else(tmp_path, name, text, problem):
    problems = found(tmp_path, **{name: text + "\n"})
    assert len(problems) == 1, problems
    assert problem in problems[0]


def test_a_folder_has_an_end(tmp_path):
    full = {f"tests__osl__number_{number}": "" for number in range(imports.MOST_FILES)}
    assert found(tmp_path, **full) == []
    assert found(tmp_path, tests__osl__fixtures__more="", tests__osl__one_more="") == [
        "tests/osl: 26 files of Python; at most 25 in a folder"
    ]
