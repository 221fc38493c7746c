# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Compiles every hand-written shader with the OSL compiler inside Blender, for Cycles and as other renderers
take it.

That compiler passes no include path of ours, so the headers lie beside the shader.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

import bpy  # noqa: F401  # makes Cycles' own module importable


def main() -> int:
    import _cycles

    shaders = sorted(Path("osl/shaders").rglob("*.osl"))
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree("osl/include", folder, dirs_exist_ok=True)
        for shader in shaders:
            for heading in ("", "#define NACRE_I_TO_SURFACE\n"):
                source = Path(folder, shader.name)
                source.write_text(heading + shader.read_text("utf-8"), "utf-8")
                if not _cycles.osl_compile(str(source), str(source.with_suffix(".oso"))):
                    failed.append(shader)
                    print(f"{shader}: does not compile (see above)")
    print(f"{len(shaders)} shaders, {len(set(failed))} failed")
    return 1 if failed or not shaders else 0


if __name__ == "__main__":
    sys.exit(main())
