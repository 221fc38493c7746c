# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the check of #include lines finds."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import includes

FILES = {
    includes.MODULES.as_posix(): "set(NACRE_MODULES core optics lut)\n"
    'set(NACRE_DEPENDS_core "")\nset(NACRE_DEPENDS_optics core)\nset(NACRE_DEPENDS_lut optics)\n',
    "cpp_tools/include/nacre/core/text.h": "#pragma once\n",
    "cpp_tools/include/nacre/optics/stack.h": '#include "nacre/core/text.h"\n',
    "cpp_tools/include/nacre/optics/film.h": '#include "nacre/optics/stack.h"\n',
    "cpp_tools/src/optics/stacks/stack.cpp": '#include "nacre/optics/stack.h"\n',
    "cpp_tools/src/optics/films/film.cpp": '#include "films/forms.h"\n#include <vector>\n',
    "cpp_tools/src/optics/films/forms.h": "",
    "cpp_tools/src/lut/table.cpp": '#include "nacre/optics/film.h"\n#include "nacre/core/text.h"\n',
    "cpp_tools/src/capi/film.cpp": '#include "nacre/lut/none.h"\n#include "nacre/capi.h"\n',
    "cpp_tools/include/nacre/capi.h": "",
    "cpp_tools/apps/nacre/eval/film.cpp": '#include "shared/session.h"\n',
    "cpp_tools/apps/nacre/shared/session.h": "",
    "tests/cpp/optics/film_test.cpp": '#include "films/forms.h"\n#include "nacre/capi.h"\n',
}


@pytest.fixture
def found(tmp_path):
    def check(changes: dict[str, str]) -> list[str]:
        for name, text in {**FILES, **changes}.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text)
        return list(includes.problems(tmp_path, [*FILES, *changes]))

    return check


def test_arrows_of_modules_go_on():
    allowed = includes.arrows(FILES[includes.MODULES.as_posix()])
    assert allowed["lut"] == {"core", "optics"}
    assert allowed["core"] == set()


def test_what_is_right_passes(found):
    assert found({}) == []


def test_a_module_upward(found):
    name = "cpp_tools/src/optics/films/film.cpp"
    upward = found({name: '#include "nacre/capi.h"\n'})
    assert upward == [f"{name}: module optics must not include cpp_tools/include/nacre/capi.h"]


def test_nothing_includes_the_tool(found):
    session = "cpp_tools/apps/nacre/shared/session.h"
    name = "tests/cpp/core/text_test.cpp"
    assert found({name: f'#include "../../../{session}"\n'}) == [
        f"{name}: module tests must not include {session}"
    ]


def test_the_tool_includes_none_of_the_c_interface(found):
    name = "cpp_tools/apps/nacre/shared/session.h"
    assert found({name: '#include "nacre/capi.h"\n'}) == [
        f"{name}: module tool must not include cpp_tools/include/nacre/capi.h"
    ]


def test_folders_in_a_circle(found):
    name = "cpp_tools/src/optics/stacks/stack.cpp"
    assert found({name: '#include "films/forms.h"\n'}) == [
        "folders include each other in a circle: optics/films -> optics/stacks -> optics/films"
    ]
    name = "cpp_tools/apps/nacre/shared/session.h"
    circle = found({name: '#include "eval/film.h"\n', "cpp_tools/apps/nacre/eval/film.h": ""})
    assert "folders include each other in a circle: tool/eval -> tool/shared -> tool/eval" in circle


def test_a_header_with_types_and_the_function_above_them(found):
    name = "cpp_tools/src/optics/films/forms.h"
    assert found({name: '#include "nacre/optics/film.h"\n'}) == [
        "files include each other in a circle: "
        "optics/films/film -> optics/films/forms -> optics/films/film"
    ]


def test_a_crowded_folder(found):
    more = {f"tests/cpp/optics/test_{i}.h": "" for i in range(includes.MOST_FILES)}
    assert found(more) == ["tests/cpp/optics: 26 C++ files; at most 25 in a folder"]
