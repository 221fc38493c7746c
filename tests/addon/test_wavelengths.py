# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`FIRST:LAST:STEP`: bands where a sensor has them, and what covers the rest."""

from __future__ import annotations

import numpy as np
import pytest
from nacre_extension.core.wavelengths import WavelengthsError, parse

from nacre import develop


@pytest.mark.parametrize(
    ("text", "count", "bands"),
    [
        ("400:700:10", 31, 33),
        ("400:700:5", 61, 63),
        ("450:650:100", 3, 6),
        ("550:550:1", 1, 3),
        ("362.5:827.5:5", 94, None),
        ("361:829:2", 235, None),
        ("360.5:829.5:1", 470, None),
        ("365:815:10", 46, 48),
        ("375:825:10", 46, 48),
    ],
)
def test_wavelengths_are_in_the_middle_of_bands_that_cover_all(text, count, bands):
    if bands is None:
        with pytest.raises(WavelengthsError, match=r"298 wavelengths at most|multiple of three"):
            parse(text)
        return
    found = parse(text)
    assert len(found.wanted) == count
    assert len(found.bands) == bands
    first, last, step = map(float, text.split(":"))
    np.testing.assert_allclose(found.wanted, np.linspace(first, last, count))
    edges = np.array(found.edges)
    assert (edges[0], edges[-1]) == (360.0, 830.0)
    assert np.diff(edges).min() > 0.0
    at = [found.bands.index(nm) for nm in found.wanted]
    np.testing.assert_allclose(edges[at], np.array(found.wanted) - step / 2)
    made = develop.bands_of(found.bands, found.edges)
    assert made.XYZ.sum(axis=0)[1] == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("400:700", "FIRST:LAST:STEP in nm, as 400:700:10 (got '400:700')"),
        ("blue:red:10", "FIRST:LAST:STEP in nm"),
        ("400:700:0", "must ascend by 0.5 nm or more"),
        ("700:400:10", "must ascend"),
        ("nan:700:10", "must ascend"),
        ("360:700:10", "within 360 … 830 nm (got 355 … 705)"),
        ("400:830:10", "within 360 … 830 nm (got 395 … 835)"),
        ("400:700:1", "298 wavelengths at most (got 301)"),
    ],
)
def test_what_is_none_is_refused(text, message):
    with pytest.raises(WavelengthsError) as caught:
        parse(text)
    assert message in str(caught.value)
