# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Benchmarks against peers as ratios: `./dev bench`, or `run.py -o FOLDER [PART…]`.

Needs what `./dev` sets up: NACRE (the tool) for its start; NACRE_LIBRARY for the stacks; for the
renders NACRE_PYTHON (a Python with bpy), NACRE_BPY52 (one with Blender 5.2) where it is there, and
NACRE_MATERIALS (compiled materials); NACRE_FMA_PEAK (a program) for the scaling; the environment of
the render tests for the colours. A target that is missed is reported, not an error.
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

# Shares of the time of Blender's own thin film that ours may take.
TABLE_SHARE, EXACT_SHARE = 0.75, 1.9
# 16 layers beside one.
LAYERS_SHARE = 1.03
# Mean dE00 of at most 0.01, where Blender's own film is off by 0.4 or more.
COLOUR_TARGET = 40.0
# What bands may be worse than RGB with as many samples.
SPECTRAL_SHARES = {
    "bands": {"luminance": 1.08, "chroma": 1.35, "seconds": 1.12},
    "paths": {"chroma": 2.8, "seconds": 1.3},
}
PASS_SHARE = 2.0
SPECTRAL_WHAT = {
    "luminance": "noise of Y",
    "chroma": "noise of a* and b*",
    "seconds": "CPU seconds",
}
FORMS = {"svm": "nodes", "osl": "OSL"}
PEERS = {"principled": "Principled with thin film", "metallic": "Metallic with thin film"}


def stacks() -> list[Result]:
    import stacks as benchmark  # loads the library, which the other part does without

    return benchmark.results()


def start_up() -> list[Result]:
    import start_up as benchmark

    return benchmark.results()


def in_each_blender(script: str) -> list[dict]:
    """What a script prints in those that are here."""
    pythons = dict.fromkeys(
        os.environ[name] for name in ("NACRE_PYTHON", "NACRE_BPY52") if name in os.environ
    )
    measured = []
    for python in pythons:
        done = subprocess.run(
            [python, HERE / script, "--addon", ROOT / "addon"],
            capture_output=True, text=True, check=False,
            env={**os.environ, "PYTHONPATH": str(ROOT / "cpp_tools" / "python")},
        )  # fmt: skip
        lines = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
        # bpy may crash while Python takes it down, after all is done.
        if not lines:
            raise SystemExit(f"{script} failed:\n{done.stdout[-2000:]}{done.stderr[-4000:]}")
        measured.append(json.loads(lines[-1].removeprefix("RESULT ")))
    return measured


def in_mitsuba() -> dict:
    """By its faster variant where that runs; it needs a libLLVM that it knows."""
    for variant in ("llvm_ad_spectral", "scalar_spectral"):
        done = subprocess.run(
            [sys.executable, HERE / "mitsuba_box.py", "--variant", variant],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        lines = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
        if lines:
            return {**json.loads(lines[-1].removeprefix("RESULT ")), "variant": variant}
    raise SystemExit(f"mitsuba_box.py failed:\n{done.stdout[-2000:]}{done.stderr[-4000:]}")


def spectral() -> list[Result]:
    in_blender, peer = in_each_blender("render_spectral.py"), in_mitsuba()
    return [result for found in in_blender for result in _spectral(found, peer)]


def _spectral(found: dict, mitsuba: dict) -> list[Result]:
    version, many = found["blender"][:3], found["many"]
    beside_rgb = [
        Result(
            id=f"spectral-{mode}-{name}-{version}",
            what=f"{SPECTRAL_WHAT[name]} of a Cornell box by {mode} beside RGB, 96 samples each",
            ours=found["measured"][mode][name],
            peer=found["measured"]["rgb"][name],
            peer_version=f"RGB, Blender {found['blender']}",
            target=1 / share,
        )
        for mode, shares in SPECTRAL_SHARES.items()
        for name, share in shares.items()
    ]
    of_both = (found["measured"]["bands"], mitsuba["measured"])
    beside_mitsuba = [
        Result(
            id=f"spectral-mitsuba-{name}-{version}",
            what=f"{SPECTRAL_WHAT[name]} of a Cornell box, times the root of the CPU seconds",
            ours=of_both[0][name] * of_both[0]["seconds"] ** 0.5,
            peer=of_both[1][name] * of_both[1]["seconds"] ** 0.5,
            peer_version=f"{mitsuba['version']}, {mitsuba['variant']}",
            target=1.0,
        )
        for name in ("luminance", "chroma")
    ]
    a_pass = Result(
        id=f"spectral-pass-{version}",
        what="a pass of 1 M triangles beside a render in which nothing changed, seconds",
        ours=many["pass"],
        peer=many["same"],
        peer_version=f"Blender {found['blender']}",
        target=1 / PASS_SHARE,
    )
    return [*beside_rgb, *beside_mitsuba, a_pass]


def render() -> list[Result]:
    return [result for found in in_each_blender("render_film.py") for result in films(found)]


def films(measured: dict) -> list[Result]:
    seconds, version = measured["seconds"], measured["blender"]

    def compare(what: str, ours: str, peer: str, peer_name: str, share: float) -> Result:
        return Result(
            id=f"render-{ours}-{peer.partition('-')[2]}-{version[:3]}",
            what=f"sampling of a sphere with {what}, CPU seconds",
            ours=seconds[ours],
            peer=seconds[peer],
            peer_version=f"{peer_name}, Blender {version}",
            target=1 / share,
        )

    results = []
    for system, form in FORMS.items():
        for peer, peer_name in PEERS.items():
            if f"{system}-{peer}" not in seconds:
                continue
            film = (f"{system}-{peer}", peer_name)
            results.append(compare(f"a film as {form}", f"{system}-one", *film, TABLE_SHARE))
            if system == "osl":
                results.append(compare("an exact rough film", "osl-exact", *film, EXACT_SHARE))
        layers = (f"{system}-one", "one layer")
        results.append(compare(f"16 layers as {form}", f"{system}-sixteen", *layers, LAYERS_SHARE))
    return results


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


PARTS = {
    "start": start_up,
    "stacks": stacks,
    "render": render,
    "spectral": spectral,
    "colour": colour,
}


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
