# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Benchmarks against peers as ratios: `./dev bench`, or `run.py -o FOLDER [PART…]`.

Needs what `./dev` sets up: NACRE_LIBRARY for the stacks; NACRE_PYTHON (a Python with bpy) and
NACRE_MATERIALS (compiled materials) for the renders; NACRE_FMA_PEAK (a program) for the
scaling; the environment of the render tests for the
colours. A target that is missed is reported, not an error.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "cpp_tools" / "python"))

from measure import Result  # noqa: E402
from page import page  # noqa: E402

# At most 0.75 of the time of Principled with its thin film.
RENDER_TARGET = 1 / 0.75
# Mean dE00 of at most 0.01, where Blender's own film is off by 0.4 or more.
COLOUR_TARGET = 40.0
FILMS = {"oil_on_water": "one film", "jewel_beetle": "16 layers"}
FORMS = {"nodes": "as nodes", "osl": "as OSL"}


def stacks() -> list[Result]:
    import stacks as benchmark  # loads the library, which the other part does without

    return benchmark.results()


def render() -> list[Result]:
    done = subprocess.run(
        [os.environ["NACRE_PYTHON"], HERE / "render_film.py", "--addon", ROOT / "addon"],
        capture_output=True,
        text=True,
        check=False,
    )
    lines = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
    if done.returncode != 0 or not lines:
        raise SystemExit(f"render_film.py failed:\n{done.stdout[-2000:]}{done.stderr[-4000:]}")
    measured = json.loads(lines[-1].removeprefix("RESULT "))
    seconds = measured["seconds"]
    return [
        Result(
            id=f"render-{film}-{form}",
            what=f"sampling of a render with a film by table, {words}, {how}, CPU seconds",
            ours=seconds[f"{film}-{form}"],
            peer=seconds["principled"],
            peer_version=f"Principled with thin film, Blender {measured['blender']}",
            target=RENDER_TARGET,
        )
        for film, words in FILMS.items()
        for form, how in FORMS.items()
    ]


def colour() -> list[Result]:
    script = ROOT / "tests" / "render" / "compare_blender_film.py"
    done = subprocess.run(
        [os.environ["NACRE_PYTHON"], script], capture_output=True, text=True, check=False
    )
    *table, last = done.stdout.splitlines() or [""]
    if done.returncode != 0 or not last.startswith("RESULT "):
        raise SystemExit(f"{script.name} failed:\n{done.stdout[-2000:]}{done.stderr[-4000:]}")
    print("\n".join(table))
    return [
        Result(
            id=f"colour-{record['id']}-{record['blender']}",
            what=f"mean dE00 against the exact spectrum, {record['what']}, 200-1600 nm, by table",
            ours=record["ours"],
            peer=record["peer"],
            peer_version=f"thin film of Blender {record['blender']}",
            target=COLOUR_TARGET,
        )
        for record in json.loads(last.removeprefix("RESULT "))
    ]


PARTS = {"stacks": stacks, "render": render, "colour": colour}


def scaling(folder: Path) -> str:
    """Draws `scaling.svg`; the figures as text."""
    import scaling as benchmark

    data = benchmark.measure()
    benchmark.draw(data, folder / "scaling.svg")
    return benchmark.report(data)


def machine() -> str:
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.is_file():
        names = [line for line in info.read_text().splitlines() if line.startswith("model name")]
        model = names[0].partition(":")[2].strip() if names else model
    return f"{model}, {os.cpu_count()} threads"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    names = [*PARTS, "scaling"]
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(names)}; all")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FOLDER")
    options = parser.parse_args()
    if unknown := set(options.parts) - set(names):
        parser.error(f"PART: must be one of {', '.join(names)} (got {', '.join(sorted(unknown))})")

    parts = options.parts or names
    options.output.mkdir(parents=True, exist_ok=True)
    figures = scaling(options.output) if "scaling" in parts else None
    if figures:
        print(figures)
    records = []
    for name in (part for part in parts if part in PARTS):
        for result in PARTS[name]():
            record = result.record()
            records.append(record)
            verdict = "met" if record["met"] else "not met"
            print(
                f"{record['id']:28} ×{record['ratio']:<8.3g} target {record['target']:.3g} {verdict}"
            )
    (options.output / "results.json").write_text(json.dumps(records, indent=2) + "\n", "utf-8")
    (options.output / "index.html").write_text(page(records, machine(), figures), "utf-8")


if __name__ == "__main__":
    main()
