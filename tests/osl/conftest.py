# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs OSL inside real Blenders."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest

from blender.harness import Blender
from support.osl import probe


@dataclass(frozen=True)
class Shading:
    """OSL in one Blender."""

    blender: Blender

    @property
    def version(self) -> str:
        return self.blender.version

    @property
    def table_origin_top(self) -> int:
        """Cycles changed the direction of t after 5.1; see the test of nacre_table."""
        return int(self.version < "5.2")

    def compile(self, shaders: dict[str, str]) -> tuple[dict[str, str], str]:
        """Bytecode of shader texts by name, and all that the compiler said."""
        compiled, stdout, stderr = self.blender.ask("osl.compile_all", shaders=shaders)
        return compiled, stdout + stderr

    def run(self, osl: str, count: int) -> np.ndarray:
        """What a shader shows in its columns 0 … count − 1; shape (count, 3)."""
        return np.load(self.blender.call("osl.values", osl=osl, count=count))

    def values(self, headers: list[str], body: str, count: int) -> np.ndarray:
        """Runs `body` for i = 0 … count − 1; it sets `color value`. Shape (count, 3)."""
        return self.run(probe(headers, body), count)

    def write_table(self, rows: np.ndarray) -> str:
        """Path of an EXR with these colours, shape (height, width, 3), row 0 at the top."""
        return self.blender.call("osl.write_table", rows=np.asarray(rows).tolist())

    def render(self, **arguments) -> np.ndarray:
        """A picture of shape (height, width, 3), row 0 at the top."""
        return np.load(self.blender.call("osl.render", **arguments))


@pytest.fixture
def blender(blender, tmp_path) -> Shading:
    return Shading(replace(blender, folder=tmp_path))
