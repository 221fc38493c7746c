# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The shipped shaders compile without a word, and each keeps the promise of its effect."""

from __future__ import annotations

import re

from conftest import SHADERS, inline


def test_every_shader_compiles_without_warnings(blender):
    texts = {path.stem: inline(path.read_text(encoding="utf-8")) for path in SHADERS}
    assert len(texts) == 4
    answer = blender.compile(texts)
    assert not re.search(r"warning|error:", answer.pop("log"), re.I)
    assert set(answer) == set(texts)
