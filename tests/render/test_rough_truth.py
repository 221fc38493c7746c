# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The stored truth of rough films is what its generator computes today: one point of each, another one
in each run."""

from __future__ import annotations

import random

import numpy as np
import pytest

from support.stored_truth import entries, film_of


@pytest.mark.parametrize("name", sorted(entries()))
def test_a_point_computed_anew(name):
    entry = entries()[name]
    at = random.SystemRandom().randrange(len(entry["cosines"]))
    print("point", at)
    film = film_of(entry)
    assert entry["stack"] == film.stack, f"{film.material} has changed: ./dev refs -k rough"
    directions = {
        key: np.array(entry[key][at : at + 1]) for key in ("cosines", "azimuths") if key in entry
    }
    # The same random numbers; sums in another order on another processor differ a little.
    np.testing.assert_allclose(film.compute(**directions)[0], entry["rgb"][at], rtol=0, atol=1e-6)
