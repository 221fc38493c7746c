# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Wrong input is a NacreError that names the field, the value and what is allowed."""

from __future__ import annotations

import math
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest

import nacre
from support.paths import PACKAGE

GOOD = {"n": [1, 1.33, 1.5], "d_nm": [300], "angle_deg": 30, "wavelength_nm": 550}
nan, inf = math.nan, math.inf

STACK = {
    "negative-thickness": ({"d_nm": [-5]}, "d_nm[0]: must be finite and ≥ 0 (got -5) (item 0)"),
    "nan-thickness": ({"d_nm": [nan]}, "d_nm[0]: must be finite and ≥ 0 (got nan) (item 0)"),
    "infinite-thickness": ({"d_nm": [inf]}, "d_nm[0]: must be finite and ≥ 0 (got inf) (item 0)"),
    "zero-index": (
        {"n": [1, 0, 1.5]},
        "n[1]: real part must be > 0 (got 0+0i) (item 0)",
    ),
    "negative-index": (
        {"n": [1, 1.33, -1.5]},
        "n[2]: real part must be > 0 (got -1.5+0i) (item 0)",
    ),
    "nan-index": ({"n": [1, nan, 1.5]}, "n[1]: must be finite (got nan+0i) (item 0)"),
    "gain": (
        {"n": [1, 1.33 - 0.1j, 1.5]},
        "n[1]: imaginary part must be ≥ 0 (media with gain are not supported) (got 1.33-0.1i) (item 0)",
    ),
    "absorbing-ambient": (
        {"n": [1 + 0.1j, 1.33, 1.5]},
        "n[0]: the ambient must not absorb (imaginary part 0) (got 1+0.1i) (item 0)",
    ),
    "angle-90": ({"angle_deg": 90}, "angle_deg: must be in [0, 90) (got 90) (item 0)"),
    "angle-negative": (
        {"angle_deg": [0, 1, -1]},
        "angle_deg: must be in [0, 90) (got -1) (item 2)",
    ),
    "angle-nan": ({"angle_deg": nan}, "angle_deg: must be in [0, 90) (got nan) (item 0)"),
    "wavelength-zero": (
        {"wavelength_nm": 0},
        "wavelength_nm: must be finite and > 0 (got 0) (item 0)",
    ),
    "wavelength-nan": (
        {"wavelength_nm": [550, nan]},
        "wavelength_nm: must be finite and > 0 (got nan) (item 1)",
    ),
    "65-layers": (
        {"n": [1] * 67, "d_nm": [1] * 65},
        "d_nm: must have at most 64 layers (got 65)",
    ),
    "polarisation": ({"pol": "x"}, "pol: must be 's', 'p' or 'u' (got 'x')"),
    "media-missing": ({"n": [1, 1.5]}, "n: must list 3 media for 1 layers (got 2)"),
    "scalar-index": ({"n": 1.5}, "n, d_nm: must have an axis of media and one of layers"),
    "scalar-thickness": ({"d_nm": 3}, "n, d_nm: must have an axis of media and one of layers"),
    "flags": ({"coherent": [True, False]}, "coherent: must have 1 flags (got (2,))"),
}


@pytest.mark.parametrize("name", STACK)
def test_stack(name):
    change, message = STACK[name]
    with pytest.raises(nacre.NacreError) as caught:
        nacre.stack(**{**GOOD, **change})
    assert str(caught.value) == message
    assert isinstance(caught.value, ValueError)


WORDS = {
    "text-thickness": ({"d_nm": ["thin"]}, "d_nm: must be real numbers"),
    "text-index": ({"n": [1, "water", 1.5]}, "n: must be numbers"),
    "complex-angle": ({"angle_deg": 1j}, "angle_deg: must be real numbers"),
    "complex-array": ({"wavelength_nm": np.array([1 + 1j])}, "wavelength_nm: must be real numbers"),
    "ragged": ({"d_nm": [[1, 2], [3]]}, "d_nm: must be real numbers"),
    "none": ({"wavelength_nm": None}, "wavelength_nm: must be"),
    "shapes": (
        {"angle_deg": [0, 1], "wavelength_nm": [1, 2, 3]},
        "n, d_nm, angle_deg, wavelength_nm: ",
    ),
}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", WORDS)
def test_what_is_no_number(name):
    change, message = WORDS[name]
    with pytest.raises(nacre.NacreError) as caught:
        nacre.stack(**{**GOOD, **change})
    assert str(caught.value).startswith(message)


GRATING = {
    "pitch_nm": 1600,
    "grating_vector": [1, 0, 0],
    "normal": [0, 0, 1],
    "k_in": [0, 0, -1],
    "wavelength_nm": 550,
}
GRATINGS = {
    "pitch": ({"pitch_nm": 0}, "pitch_nm: must be finite and > 0"),
    "wavelength": ({"wavelength_nm": nan}, "wavelength_nm: must be finite and > 0"),
    "from-below": (
        {"k_in": [0, 0, 1]},
        "k_in: must point towards the surface (k_in · normal < 0)",
    ),
    "no-normal": ({"normal": [0, 0, 0]}, "normal: must be finite and not zero"),
    "along-normal": (
        {"grating_vector": [0, 0, 1]},
        "grating_vector: must not be parallel to the normal",
    ),
    "vector-shape": ({"k_in": [0, -1]}, "k_in: must have shape (3,) (got (2,))"),
    "duty": ({"duty": 1.5}, "profile.duty: must be in [0, 1]"),
    "profile": (
        {"profile": "square"},
        "profile.kind: must be sinusoidal, rectangular or blazed (got square)",
    ),
    "profile-type": ({"profile": 3}, "profile: must be text without null characters (got 3)"),
    "orders": ({"orders": (2, 1)}, "orders: must ascend and stay within ±100000 (got (2, 1))"),
    "too-many-orders": (
        {"orders": (-(10**9), 10**9)},
        "orders: must ascend and stay within ±100000 (got (-1000000000, 1000000000))",
    ),
    "far-orders": ({"orders": (10**5, 10**5 + 1)}, "orders: must ascend and stay within ±100000"),
}


@pytest.mark.parametrize("name", GRATINGS)
def test_grating(name):
    change, message = GRATINGS[name]
    with pytest.raises(nacre.NacreError) as caught:
        nacre.grating_orders(**{**GRATING, **change})
    assert str(caught.value) == message


FAR = 10**400


@pytest.mark.parametrize(
    "change", [{"orders": (0, FAR)}, {"orders": 3}, {"pitch_nm": "x"}, {"duty": None}]
)
def test_grating_numbers(change):
    with pytest.raises(nacre.NacreError):
        nacre.grating_orders(**{**GRATING, **change})


FILM = {
    "media": [1.0, 1.33, 1.5],
    "d_nm": [300],
    "varying": 0,
    "range_": (100, 300),
    "size": (5, 3),
}
FILMS = {
    "unknown-medium": ({"media": [1.0, "unobtainium/X", 1.5]}, "unobtainium/X"),
    "media-missing": ({"media": [1.0, 1.5]}, "media: must list 3 for 1 layers (got 2)"),
    "media-shape": (
        {"media": [1.0, [1.3] * 470, 1.5]},
        "471 numbers for 360-830 nm (got shape (470,))",
    ),
    "thickness": ({"d_nm": [nan]}, "d_nm[0]: must be finite and ≥ 0 (at 360 nm)"),
    "gain": ({"media": [1.0, 1.3 - 1j, 1.5]}, "n[1]: imaginary part must be ≥ 0"),
    "range": (
        {"range_": (300, 100)},
        "variation: must have 0 ≤ min < max, both finite (got 300 and 100)",
    ),
    "nan-range": ({"range_": (nan, 100)}, "variation: must have 0 ≤ min < max"),
    "varying": ({"varying": 1}, "varying: must be a layer, 'scale' or None (got 1)"),
    "varying-text": ({"varying": "all"}, "varying: must be a layer, 'scale' or None (got 'all')"),
    "tolerance": ({"tolerance": -1}, "tolerance: must be > 0 (got -1)"),
    "no-tolerance": ({"tolerance": 0, "size": None}, "tolerance: must be > 0 (got 0)"),
    "size": ({"size": (1, 3)}, "size: must be 2…16384 texels wide and 2…16384 high (got 1x3)"),
    "zero-size": ({"size": (0, 0)}, "size: must be"),
    "huge-size": ({"size": (2**40, 2)}, "size: must be"),
    "size-shape": ({"size": 5}, "size: must be"),
    "range-shape": ({"range_": 5}, "range_: must be"),
    "flags": ({"coherent": [True, False]}, "coherent: must have 1 flags (got (2,))"),
    "illuminant": ({"illuminant": "X"}, "D65"),
    "observer": ({"observer": "X"}, "cie1964"),
    "space": ({"space": "X"}, "lin_ap1_scene"),
    "65-layers": (
        {"media": [1.0] * 67, "d_nm": [1] * 65},
        "d_nm: must have at most 64 layers (got 65)",
    ),
    "out-of-reach": (
        {"media": [1.0, 2.5, 1.0], "range_": (0, 1e6), "size": None},
        "tolerance: a table of at most 4096 texels per axis reaches ΔE00",
    ),
}


@pytest.mark.parametrize("name", FILMS)
def test_film_lut(name):
    change, message = FILMS[name]
    with pytest.raises(nacre.NacreError) as caught:
        nacre.film_lut(**{**FILM, **change})
    assert message in str(caught.value)


COLOURS = {
    "kind": ({"kind": "light"}, "kind: must be 'reflectance' or 'emission' (got 'light')"),
    "lengths": ({"values": [1, 1, 1]}, "values: must have 2 samples on the last axis (got shape"),
    "item": ({"values": [[1, 1], [1, nan]]}, "(item 1)"),
    "adaptation": ({"adaptation": "X"}, "bradford, cat16, none"),
    "gamut": ({"gamut": "X"}, "keep, clip, desaturate, scale"),
    "gamut-xyz": ({"gamut": "clip", "space": "xyz_d65"}, "gamut: must be keep in a space"),
    "two-axes": ({"wavelength_nm": [[360, 830]]}, "wavelength_nm: must have one axis (got 2)"),
    "descending": ({"wavelength_nm": [830, 360]}, "wavelength_nm"),
    "outside": ({"wavelength_nm": [100, 200]}, "360"),
    "nan": ({"values": [1, nan]}, "values"),
    "illuminant": ({"illuminant": "X"}, "D65"),
    "observer": ({"observer": "X"}, "cie1931"),
    "space": ({"space": "X"}, "lin_rec709_scene"),
    "space-type": ({"space": None}, "space: must be text without null characters (got None)"),
    "null-character": ({"space": "a\0b"}, "space: must be text without null characters"),
}


@pytest.mark.parametrize("name", COLOURS)
def test_spectrum_to_colour(name):
    change, message = COLOURS[name]
    with pytest.raises(nacre.NacreError) as caught:
        nacre.spectrum_to_colour(**{"wavelength_nm": [360, 830], "values": [1, 1], **change})
    assert message in str(caught.value)


RGBS = {
    "kind": ({"kind": "light"}, "kind: must be 'emission' or 'reflectance' (got 'light')"),
    "channels": ({"rgb": [0.5, 0.5]}, "rgb: must have 3 channels on the last axis"),
    "text": ({"rgb": "red"}, "rgb: must be real numbers"),
    "nan": ({"rgb": [nan, 0, 0]}, "finite"),
    "too-bright": ({"rgb": [[0.5] * 3, [2] * 3]}, "(item 1)"),
    "smits": ({"rgb": [-0.1, 0, 0], "method": "smits"}, "must be in [0, 1]"),
    "method": ({"method": "X"}, "method: must be jakob-hanika or smits"),
    "space": ({"space": "xyz_d65"}, "space: must be an RGB space"),
}


@pytest.mark.parametrize("name", RGBS)
def test_rgb_to_spectrum(name):
    change, message = RGBS[name]
    with pytest.raises(nacre.NacreError) as caught:
        nacre.rgb_to_spectrum(**{"rgb": [0.2, 0.3, 0.4], **change})
    assert message in str(caught.value)


def test_library_names_near_media():
    with pytest.raises(nacre.NacreError, match="water/Daimon-20C"):
        nacre.library.medium("water/Daimon")


@pytest.mark.parametrize("wavelength", [100.0, 2e6, nan])
def test_library_wavelength_outside_the_data(wavelength):
    with pytest.raises(nacre.NacreError, match="Au/Johnson"):
        nacre.library.medium("Au/Johnson").index([550.0, wavelength])


def test_template_tolerance():
    with pytest.raises(nacre.NacreError):
        nacre.compile_template("schema = 1", tolerance="fine")


def failed_import(library) -> str:
    environment = {**os.environ, "NACRE_LIBRARY": str(library)}
    environment["PYTHONPATH"] = str(PACKAGE)
    done = subprocess.run(
        [sys.executable, "-c", "import nacre"],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stderr.splitlines()[-1]


def test_a_missing_library_is_an_import_error(tmp_path):
    library = tmp_path / "none.so"
    assert failed_import(library).startswith(
        f"ImportError: nacre: cannot load {library}: {library}: "
    )


@pytest.mark.skipif(not shutil.which("cc"), reason="needs a C compiler")
@pytest.mark.parametrize(
    ("system", "first", "newest", "words"),
    [
        ("libc.so.6", "GLIBC_2.98", "GLIBC_2.102", "needs glibc 2.102 or newer, and this system has "),
        ("libstdc++.so.6", "GLIBCXX_3.4.98", "GLIBCXX_3.4.99", "needs a libstdc++ with GLIBCXX_3.4.99"),
    ],
)  # fmt: skip
def test_a_system_that_is_too_old_is_told(tmp_path, system, first, newest, words):
    """A library that asks for symbols of a system to come: the loader names one of them."""

    def build(source: str, name: str, *options: str) -> None:
        (tmp_path / "source.c").write_text(source)
        command = ["cc", "-shared", "-nostdlib", "-o", name, "source.c", *options]
        subprocess.run(command, cwd=tmp_path, check=True)

    (tmp_path / "versions").write_text(f"{first} {{ one; }};\n{newest} {{ two; }};\n")
    build(
        "int one(void) { return 1; }\nint two(void) { return 2; }\n",
        system,
        f"-Wl,-soname,{system}",
        "-Wl,--version-script=versions",
    )
    build(
        "int one(void), two(void);\nint nacre_api_version(void) { return one() + two(); }\n",
        "libnacre.so",
        "-L.",
        f"-l:{system}",
    )
    said = failed_import(tmp_path / "libnacre.so")
    assert said.startswith(f"ImportError: nacre: cannot load {tmp_path / 'libnacre.so'}: {words}")
    assert f"(required by {tmp_path / 'libnacre.so'})" in said
    if system == "libc.so.6":
        assert f"this system has {os.confstr('CS_GNU_LIBC_VERSION')}; " in said
