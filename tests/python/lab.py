# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import colour
import numpy as np

_D65 = [0.3127, 0.3290]
_TO_XYZ = colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_RGB_to_XYZ


def lab(rgb) -> np.ndarray:
    """CIE L*a*b* under D65 of linear Rec. 709, shape (..., 3), by colour-science."""
    return colour.XYZ_to_Lab(np.asarray(rgb) @ _TO_XYZ.T, _D65)
