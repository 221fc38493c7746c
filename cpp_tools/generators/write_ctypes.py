# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Writes what the Python package declares of the C interface from the headers themselves.

usage: write_ctypes.py [-o FILE]

The C compiler (CC, else cc) reads the headers, pycparser takes them apart. Pointers to numbers are
addresses, as numpy gives them, but for counts in structures; so are pointers to rows of numbers,
structures of doubles alone. Structures are called as in C, without `nacre_` and in CamelCase.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path

from pycparser import c_ast, c_parser

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "cpp_tools" / "include"
OUTPUT = ROOT / "cpp_tools" / "python" / "nacre" / "_capi.py"
CONSTANTS = {"NACRE_API_VERSION": "API_VERSION", "NACRE_WAVELENGTHS": "WAVELENGTHS"}
NUMBERS = {
    "int": "c_int",
    "double": "c_double",
    "float": "c_float",
    "size_t": "c_size_t",
    "unsigned char": "c_ubyte",
}
PREFIX = "nacre_"

HEAD = '''# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The C interface as ctypes has it. Written by cpp_tools/generators/write_ctypes.py."""

from __future__ import annotations

from ctypes import {imports}
from typing import Any

# fmt: off
'''


def class_name(name: str) -> str:
    return "".join(part.capitalize() for part in name.removeprefix(PREFIX).split("_"))


def declarations(include: Path) -> c_ast.FileAST:
    """Of capi.h and what it includes of ours."""
    compiler = [os.environ.get("CC", "cc"), "-E", f"-I{include}", "-D__attribute__(x)="]
    text = subprocess.run(
        [*compiler, include / "nacre" / "capi.h"], check=True, capture_output=True, text=True
    ).stdout
    # Lines of other files, the system's, are left out; of those only size_t is needed.
    kept, ours = ["typedef unsigned long size_t;"], False
    for line in text.splitlines():
        if marker := re.match(r'# \d+ "(.*?)"', line):
            ours = Path(marker[1]).is_relative_to(include)
        elif ours:
            kept.append(line)
    return c_parser.CParser().parse("\n".join(kept))


class Interface:
    """Structures in the order of the headers, functions, constants."""

    def __init__(self, include: Path) -> None:
        self.structures: dict[str, list[c_ast.Decl]] = {}
        self.functions: dict[str, c_ast.FuncDecl] = {}
        self.enumerations: set[str] = set()
        for node in declarations(include).ext:
            if isinstance(node, c_ast.Typedef) and isinstance(node.type, c_ast.TypeDecl):
                self._add_type(node.name, node.type.type)
            elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
                self.functions[node.name] = node.type
        defines = (include / "nacre/capi/base.h").read_text("utf-8")
        self.constants = {
            name: int(re.findall(rf"^#define {macro} (\d+)", defines, re.M)[0])
            for macro, name in CONSTANTS.items()
        }

    def _add_type(self, name: str, what: c_ast.Node) -> None:
        if isinstance(what, c_ast.Enum):
            self.enumerations.add(name)
        elif isinstance(what, c_ast.Struct) and what.decls:
            self.structures[name] = what.decls

    def _is_row(self, name: str) -> bool:
        """A structure of doubles alone."""
        return all(
            self.value(field.type, True).startswith("c_double") for field in self.structures[name]
        )

    def value(self, node: c_ast.Node, field: bool) -> str:
        """The type of a field or an argument."""
        if isinstance(node, c_ast.ArrayDecl):
            return f"{self.value(node.type, field)} * {node.dim.value}"
        if isinstance(node, c_ast.PtrDecl):
            return self._pointer(node.type, field)
        name = " ".join(node.type.names)
        if name in self.structures:
            return class_name(name)
        return "c_int" if name in self.enumerations else NUMBERS[name]

    def _pointer(self, target: c_ast.Node, field: bool) -> str:
        if isinstance(target, c_ast.PtrDecl):
            return f"POINTER({self._pointer(target.type, field)})"
        name = " ".join(target.type.names)
        if name == "char":
            return "c_char_p"
        if name in self.structures and not self._is_row(name):
            return f"POINTER({class_name(name)})"
        return "POINTER(c_size_t)" if name == "size_t" and field else "c_void_p"

    def result(self, function: c_ast.FuncDecl) -> str:
        node = function.type
        if isinstance(node, c_ast.TypeDecl) and node.type.names == ["void"]:
            return "None"
        return self.value(node, False)

    def arguments(self, function: c_ast.FuncDecl) -> list[str]:
        given = [parameter.type for parameter in function.args.params]
        return [self.value(node, False) for node in given if not is_void(node)]


def is_void(node: c_ast.Node) -> bool:
    return isinstance(node, c_ast.TypeDecl) and node.type.names == ["void"]


def wrapped(start: str, items: list[str], end: str) -> str:
    return textwrap.fill(
        start + ", ".join(items) + end, 100, subsequent_indent=" " * 8, break_on_hyphens=False
    )


def text_of(interface: Interface) -> str:
    blocks = ["\n".join(f"{name} = {value}" for name, value in interface.constants.items())]
    for name, fields in interface.structures.items():
        lines = [f"class {class_name(name)}(Structure):", "    _fields_ = ["]
        lines += [f'        ("{f.name}", {interface.value(f.type, True)}),' for f in fields]
        blocks.append("\n" + "\n".join([*lines, "    ]"]))
    lines = ["\nSIGNATURES: dict[str, tuple[Any, list[Any]]] = {"]
    lines += [
        wrapped(
            f'    "{name}": ({interface.result(function)}, [', interface.arguments(function), "]),"
        )
        for name, function in interface.functions.items()
    ]
    body = "\n\n".join([*blocks, "\n".join([*lines, "}"])]) + "\n"
    used = sorted({"POINTER", "Structure", *re.findall(r"\bc_\w+", body)}, key=sort_key)
    return HEAD.format(imports=", ".join(used)) + "\n" + body


def sort_key(name: str) -> tuple[int, str]:
    """Constants, classes, then the rest, as isort has it."""
    return (0 if name.isupper() else 1 if name[0].isupper() else 2, name)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=OUTPUT)
    parser.parse_args(sys.argv[1:]).output.write_text(text_of(Interface(INCLUDE)), "utf-8")


if __name__ == "__main__":
    main()
