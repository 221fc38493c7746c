# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""How the kernel's time goes with layers, angles and threads, and how near it comes to the machine's
peak: `scaling.py -o FILE.svg`, or `scaling.py --seconds LAYERS ANGLES` for one figure."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "cpp_tools" / "python"))

import numpy as np  # noqa: E402
from measure import best_seconds  # noqa: E402
from stacks import ANGLES_DEG, WAVELENGTHS_NM, Job, with_nacre  # noqa: E402

LAYERS = (1, 2, 4, 8, 16, 32, 64)
ANGLES = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)

# Sums and products (a fused pair counts as two; a root or a quotient as one) of both polarisations
# together, counted in lane_fields.cpp. A layer: root of q² 20, phase and decay 85, interface and
# passage 65, bound on the error 6. Once a point: root in the substrate, its interface, R and T.
FLOPS_A_LAYER, FLOPS_A_POINT = 176, 130


def job(layers: int, angles: int) -> Job:
    return Job(layers, np.linspace(0.0, ANGLES_DEG[-1], angles), WAVELENGTHS_NM)


def seconds(layers: int, angles: int) -> float:
    grid = job(layers, angles)
    return best_seconds([lambda: with_nacre(grid)])[0]


def points(angles: int) -> int:
    return angles * WAVELENGTHS_NM.size


def on_threads(threads: int, layers: int, angles: int) -> float:
    """A process that may use only so many processors: the library takes what it is given."""
    processors = sorted(os.sched_getaffinity(0))[:threads]
    done = subprocess.run(
        [sys.executable, __file__, "--seconds", str(layers), str(angles)],
        check=True,
        capture_output=True,
        text=True,
        preexec_fn=lambda: os.sched_setaffinity(0, processors),
    )
    return float(done.stdout)


def gflops(layers: int, angles: int, taken: float) -> float:
    return (FLOPS_A_LAYER * layers + FLOPS_A_POINT) * points(angles) / taken * 1e-9


def peak(threads: int) -> float:
    done = subprocess.run(
        [os.environ["NACRE_FMA_PEAK"], str(threads)], check=True, capture_output=True, text=True
    )
    return float(done.stdout)


def measure() -> dict:
    """ns per angle, wavelength and layer over layers and angles; GFLOP/s over threads."""
    angles = ANGLES_DEG.size
    threads = range(1, len(os.sched_getaffinity(0)) + 1)
    return {
        "layers": [
            (layers, seconds(layers, angles) / points(angles) / layers * 1e9) for layers in LAYERS
        ],
        "angles": [(count, seconds(16, count) / points(count) / 16 * 1e9) for count in ANGLES],
        "threads": [
            (count, gflops(16, angles, on_threads(count, 16, angles)), peak(count))
            for count in threads
        ],
    }


def draw(data: dict, file: Path) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    mpl.rcParams["svg.hashsalt"] = "nacre"
    figure, (over_layers, over_angles, over_threads) = plt.subplots(
        1, 3, figsize=(10, 3), layout="constrained"
    )
    for axes, key, word in (
        (over_layers, "layers", "layers"),
        (over_angles, "angles", "angles, 16 layers"),
    ):
        axes.plot(*zip(*data[key], strict=True), "o-", color="#0a7d72")
        axes.set_xscale("log", base=2)
        axes.xaxis.set_major_formatter("{x:.0f}")
        axes.set(xlabel=word, ylabel="ns per point and layer", ylim=(0, None))
    threads, ours, peaks = zip(*data["threads"], strict=True)
    over_threads.plot(threads, peaks, "s--", color="#999", label="peak of multiply-adds")
    over_threads.plot(threads, ours, "o-", color="#0a7d72", label="kernel, 16 layers")
    over_threads.set(xlabel="threads", ylabel="GFLOP/s", ylim=(0, None), xticks=threads)
    over_threads.legend()
    figure.savefig(file, metadata={"Date": None})


def report(data: dict) -> str:
    lines = ["layers  ns per point and layer"]
    lines += [f"{layers:6} {ns:7.2f}" for layers, ns in data["layers"]]
    lines += ["angles  ns per point and layer, 16 layers"]
    lines += [f"{angles:6} {ns:7.2f}" for angles, ns in data["angles"]]
    lines += ["threads  GFLOP/s  peak"]
    lines += [
        f"{threads:7} {ours:8.2f} {most:7.2f}  {ours / most:.0%}"
        for threads, ours, most in data["threads"]
    ]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", nargs=2, type=int, metavar=("LAYERS", "ANGLES"))
    parser.add_argument("-o", "--output", type=Path, metavar="FILE.svg")
    options = parser.parse_args()
    if options.seconds:
        print(seconds(*options.seconds))
        return
    data = measure()
    print(report(data))
    if options.output:
        draw(data, options.output)


if __name__ == "__main__":
    main()
