# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Every example of the driver's `render --help` runs, in a folder that has what it names, with as few
pixels, samples and frames as there can be."""

from __future__ import annotations

import shlex

import numpy as np

from support.images import write_as
from support.typed import examples

FILM = """schema = 1
material = { id = "beetle", name = "Beetle", category = "Films", source = "an example" }
layer = [{ n = 2.0, thickness_nm = 300 }]
ambient = { medium = "air" }
substrate = { n = 1.5, k = 3.0 }
"""
# Given once more, the last one counts.
FEW = {"--frames": ("--frames", "1-2"), "-o": ("--size", "8x8", "--samples", "1")}


def test_every_example_runs(blender45, tmp_path):
    (tmp_path / "beetle.toml").write_text(FILM, "utf-8")
    (tmp_path / "looks.csv").write_text("output,material\na,soap_film\nb,oil_on_water\n", "utf-8")
    write_as(
        tmp_path / "spill.png", np.linspace(0, 1, 16, dtype=np.float32).reshape(4, 4, 1), "uint8"
    )
    blender45.call("user_scenes.make", kind="ring", file=str(tmp_path / "shot.blend"))
    blender = blender45.with_materials("soap_film", "oil_on_water", "tempered_steel")
    shown = examples(blender.render("--help").stdout)
    assert len(shown) > 10
    for text in shown:
        words = shlex.split(text)
        assert words[:2] == ["nacre", "render"]
        few = [word for option, more in FEW.items() if option in words for word in more]
        done = blender.render(*words[2:], *few)
        assert done.returncode == 0, f"{text}\n{done.stderr}"
        for name in [words[i + 1] for i, word in enumerate(words) if word == "-o"]:
            made = name.replace("##", "*").replace("**", "*").rstrip("/")
            assert list(tmp_path.glob(made)), f"{text}: makes no {name}"
