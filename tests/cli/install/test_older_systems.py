# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Which glibc our own programs ask for.

A build takes the newest version of each symbol that the system it is made on has. Built on an older
one it takes an older: that holds for the names listed here, and for no function that glibc got later.
"""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

# Of manylinux_2_28, the oldest that wheels and archives are to be built for.
OLDEST = (2, 28)

BOTH_AGES = {
    # New versions of what was there before: https://sourceware.org/glibc/wiki/Release
    "exp", "log", "pow", "exp2f", "expf", "logf", "log2f", "powf",  # 2.29, without matherr
    "fmod", "fmodf", "hypot", "hypotf",  # 2.35, 2.38
    "stat", "fstat", "lstat", "fstatat", "stat64", "fstat64", "lstat64", "mknod",  # 2.33, inline
    "__libc_start_main", "dlopen", "dlsym", "dlerror", "dlclose",  # 2.34, moved into libc
    "__isoc23_strtol", "__isoc23_strtoul", "__isoc23_strtoll", "__isoc23_strtoull",  # 2.38, by macro
    # The compiler's run-time library calls these where glibc had them when it was built.
    "__libc_single_threaded", "_dl_find_object",
}  # fmt: skip
BOTH_AGES_PREFIXES = ("pthread_", "__pthread_", "sem_")  # 2.34, moved into libc

IMPORT = re.compile(r"\*UND\*\s+[0-9a-f]+\s+\(?GLIBC_([\d.]+)\)?\s+(\S+)")


@pytest.mark.skipif(not shutil.which("objdump"), reason="needs objdump")
def test_nothing_asks_for_a_function_that_older_systems_lack(nacre):
    build = nacre.program.parents[1]
    files = [nacre.program, *build.glob("lib/nacre/*.so"), *build.glob("lib/libnacre.so")]
    assert len(files) >= 3
    newer = {}
    for file in files:
        table = subprocess.run(
            ["objdump", "-T", file], capture_output=True, text=True, check=True
        ).stdout
        imports = IMPORT.findall(table)
        assert imports, f"{file}: objdump shows no imports"
        for version, name in imports:
            known = name in BOTH_AGES or name.startswith(BOTH_AGES_PREFIXES)
            if tuple(map(int, version.split("."))) > OLDEST and not known:
                newer.setdefault(f"{name} (glibc {version})", []).append(file.name)
    assert newer == {}
