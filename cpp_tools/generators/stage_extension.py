# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Makes the Blender extension's archive: the add-on's files, wheel and compiled materials in one.

usage: stage_extension.py --blender-ext BLENDER_EXT.py --wheel FILE.whl --materials DIR -o FILE.zip

The version comes from the root's CMakeLists.txt, the platform from the wheel's name. The archive is
built and checked by Blender's own program, `bl_pkg/cli/blender_ext.py`, which is plain Python.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from squeeze_exr import squeeze
from write_manual import write_manual

ROOT = Path(__file__).resolve().parents[2]

# Platform tags of wheels (the part after the last dash) and what Blender calls them.
PLATFORMS = (
    (re.compile(r"linux.*x86_64"), "linux-x64"),
    (re.compile(r"linux.*aarch64"), "linux-arm64"),
    (re.compile(r"win_amd64"), "windows-x64"),
    (re.compile(r"win_arm64"), "windows-arm64"),
    (re.compile(r"macosx.*arm64"), "macos-arm64"),
    (re.compile(r"macosx.*x86_64"), "macos-x64"),
)


def project_version(root: Path) -> str:
    match = re.search(r"project\(Nacre VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text())
    if not match:
        sys.exit(f"{root / 'CMakeLists.txt'}: states no version of project Nacre")
    return match.group(1)


def platform_of(wheel: Path) -> str:
    tag = wheel.stem.rsplit("-", 1)[-1]
    for pattern, platform in PLATFORMS:
        if pattern.search(tag):
            return platform
    sys.exit(f"{wheel.name}: Blender knows no platform for the tag {tag!r}")


def filled_manifest(text: str, version: str, wheels: list[Path]) -> str:
    """The manifest with the project's version and, at its end, the wheels and their platforms."""
    filled, count = re.subn(r'(?m)^version = ".*"$', f'version = "{version}"', text)
    if count != 1:
        sys.exit("blender_manifest.toml: must have one line for the version")
    if wheels:
        platforms = sorted({platform_of(wheel) for wheel in wheels})
        filled += "platforms = [" + ", ".join(f'"{name}"' for name in platforms) + "]\n"
        filled += "wheels = [" + ", ".join(f'"./wheels/{w.name}"' for w in wheels) + "]\n"
    return filled


def _pack(manifest: Path) -> None:
    """Without the indent, which a fifth of its compressed bytes go into."""
    data = json.loads(manifest.read_text("utf-8"))
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False)
    manifest.write_text(text + "\n", "utf-8")


def stage(folder: Path, wheels: list[Path], materials: Path) -> None:
    ignored = shutil.ignore_patterns("__pycache__", "*.pyc", "compiled", "wheels", "manual")
    shutil.copytree(ROOT / "addon", folder, ignore=ignored)
    shutil.copytree(materials, folder / "compiled")
    for manifest in (folder / "compiled").glob("*/*.json"):
        _pack(manifest)
    for table in (folder / "compiled").glob("*/*.exr"):
        squeeze(table)
    write_manual(folder / "manual")
    (folder / "wheels").mkdir()
    for wheel in wheels:
        _squeeze(Path(shutil.copyfile(wheel, folder / "wheels" / wheel.name)), effort=4)
    blender_manifest = folder / "blender_manifest.toml"
    text = filled_manifest(blender_manifest.read_text("utf-8"), project_version(ROOT), wheels)
    blender_manifest.write_text(text, "utf-8")


def _squeeze(archive: Path, effort: int) -> None:
    """The same files, compressed as well as can be, which Blender's tool and pip do not try."""
    run("advzip", "--recompress", "--quiet", f"-{effort}", archive)


def run(*command: str | Path) -> None:
    try:
        done = subprocess.run(list(map(str, command)), check=False)
    except FileNotFoundError:
        sys.exit(f"{command[0]} is missing: ./dev setup installs it")
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: failed")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--blender-ext", type=Path, required=True)
    parser.add_argument("--wheel", type=Path, action="append", default=[])
    parser.add_argument("--materials", type=Path, required=True)
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args()
    if not any(options.materials.glob("*/*.json")):
        sys.exit(f"{options.materials}: holds no compiled materials")
    output = options.output.absolute()
    output.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="nacre-extension-", dir=output.parent) as scratch:
        folder, archive = Path(scratch, "nacre"), Path(scratch, output.name)
        stage(folder, options.wheel, options.materials)
        build = ("build", "--source-dir", str(folder), "--output-filepath", str(archive))
        run(sys.executable, options.blender_ext, *build)
        _squeeze(archive, effort=3)
        run(sys.executable, options.blender_ext, "validate", archive)
        archive.replace(output)


if __name__ == "__main__":
    main()
