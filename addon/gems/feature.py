# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cut stones in EEVEE, as a part of the extension."""

from __future__ import annotations

from . import cut_stone

CLASSES = ()
PARTS = (cut_stone,)
