# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What holds for the package as a whole: docstrings, memory, threads, the wheel."""

from __future__ import annotations

import inspect
import os
import re
import subprocess
import sys
import threading

import numpy as np
import pytest

import nacre
from nacre._native import lib
from support.paths import ROOT


def public_functions():
    for module in (nacre, nacre.develop, nacre.library, nacre.shapes, nacre.textures):
        for name, value in vars(module).items():
            if not inspect.isfunction(value) or name.startswith("_"):
                continue
            if module is nacre or value.__module__ == module.__name__:
                yield pytest.param(value, id=f"{module.__name__}.{name}")


@pytest.mark.parametrize("function", public_functions())
def test_docstrings_say_what_is_needed(function):
    words = inspect.getdoc(function)
    assert words
    parameters = inspect.signature(function).parameters
    assert "Raises" in words or not parameters
    for name, parameter in parameters.items():
        if "Parameters\n---" in words:
            assert re.search(rf"\b{name}\b", words), name
        if "ArrayLike" in str(parameter.annotation):
            assert "shape" in words or "(N,)" in words, name


def test_arrays_that_fit_are_not_copied(monkeypatch):
    """The addresses that reach the library are those of the caller's arrays."""
    seen = []

    def spy(name):
        real = getattr(lib, name)

        def call(*arguments):
            seen.extend(value for value in arguments if isinstance(value, int))
            return real(*arguments)

        monkeypatch.setattr(lib, name, call)

    nm = np.arange(360.0, 831.0)
    values = np.random.default_rng(1).random((3, 471))
    spy("nacre_spectra_to_colours")
    nacre.spectrum_to_colour(nm, values)
    assert {nm.ctypes.data, values.ctypes.data} <= set(seen)
    seen.clear()
    nacre.spectrum_to_colour(nm, values.astype(np.float32))
    assert values.ctypes.data not in seen
    seen.clear()
    spy("nacre_colour_temperature")
    white = np.array([[0.95, 1.0, 1.09]])
    nacre.colour_temperature(white)
    assert white.ctypes.data in seen
    seen.clear()
    spy("nacre_pack_spectra")
    spectra = np.ones((2, 512))
    nacre.textures.pack_spectra(spectra)
    assert spectra.ctypes.data in seen


def test_stacks_read_the_grid_where_it_lies():
    """A transposed and a broadcast array have strides of their own, which the library follows."""
    angle, nm = np.linspace(0, 80, 7), np.linspace(400, 700, 5)
    n = np.array([[1, 1.5 + 0.01j * i, 1.5] for i in range(5)])
    plain = nacre.stack(n, [200.0], angle[:, None], nm)
    grid = np.broadcast_to(angle[:, None], (7, 5))
    turned = nacre.stack(n, [200.0], np.asfortranarray(grid), np.broadcast_to(nm, (7, 5)))
    np.testing.assert_array_equal(plain.R, turned.R)
    with pytest.raises(ValueError, match="read-only"):
        grid[0, 0] = 1  # nobody wrote to the caller's view


def long_call():
    index = [1, 2.2 + 0.01j, 1.4, 1.5]
    return nacre.film_lut(
        index, [100, 200], varying=0, range_=(0, 1000), tolerance=None, size=(64, 64)
    )


def test_other_threads_run_while_the_library_computes():
    """With the interpreter held, the main thread would first run when the call has ended."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(60.0)  # nothing else makes a thread give way
    try:
        for _attempt in range(20):
            started, done = threading.Event(), threading.Event()

            def work(started=started, done=done):
                started.set()
                long_call()
                done.set()

            thread = threading.Thread(target=work)
            thread.start()
            started.wait()
            during = not done.is_set()
            thread.join()
            if during:
                return
        pytest.fail("no other thread ran during twenty calls")
    finally:
        sys.setswitchinterval(interval)


PYTHONS = {"own": sys.executable, "NACRE_BPY52": os.environ.get("NACRE_BPY52")}


@pytest.mark.parametrize("which", PYTHONS)
def test_the_wheel_installs_and_works(which, tmp_path):
    wheels = sorted((ROOT / "build" / "wheel").glob("*.whl"))
    if not wheels:
        pytest.skip("no wheel: ./dev test builds one")
    python = PYTHONS[which]
    if python is None:
        pytest.skip(f"{which} names no Python")
    assert "-py3-none-" in wheels[-1].name
    pip = [python, "-m", "pip", "--disable-pip-version-check"]
    subprocess.run(
        [*pip, "install", "-q", "--no-deps", "--target", tmp_path, wheels[-1]], check=True
    )
    program = (
        "import nacre, numpy; print(nacre.__file__);"
        "print(nacre.stack([1, 1.33, 1], [200.0], 45.0, 550.0, pol='u').R.round(4))"
    )
    environment = {key: value for key, value in os.environ.items() if key != "NACRE_LIBRARY"}
    environment["PYTHONPATH"] = str(tmp_path)
    result = subprocess.run(
        [python, "-c", program], env=environment, capture_output=True, text=True, check=True
    )
    file, value = result.stdout.split()
    assert file.startswith(str(tmp_path))
    assert float(value) == 0.0332
