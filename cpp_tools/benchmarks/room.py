# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Paints of the Cornell box, for every renderer of it."""

from __future__ import annotations

ROOM = {
    "white": (0.73, 0.73, 0.73),
    "red": (0.6, 0.06, 0.05),
    "green": (0.1, 0.4, 0.12),
    "yellow": (0.75, 0.6, 0.05),
    "blue": (0.05, 0.08, 0.4),
}
