# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Differences between colours, apart from the tool's own."""

from __future__ import annotations

import numpy as np

REC709_TO_XYZ = np.array(
    [
        [0.4123907992659593, 0.357584339383878, 0.1804807884018343],
        [0.2126390058715103, 0.715168678767756, 0.0721923153607337],
        [0.0193308187155918, 0.119194779794626, 0.9505321522496607],
    ]
)


def lab(rgb) -> np.ndarray:
    """L*a*b* under D65 of linear Rec. 709, IEC 61966-2-1 primaries with (1, 1, 1) as the white."""
    relative = (np.asarray(rgb, float) @ REC709_TO_XYZ.T) / REC709_TO_XYZ.sum(axis=1)
    linear = relative * (24389 / 27) / 116 + 16 / 116
    f = np.where(relative > 216 / 24389, np.cbrt(relative), linear)
    return np.stack(
        [116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])],
        axis=-1,
    )


def delta_e(a, b) -> np.ndarray:
    """CIEDE2000 by colour-science between linear Rec. 709 pictures."""
    from colour.difference import delta_E_CIE2000

    return delta_E_CIE2000(lab(a), lab(b))
