# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the Python package is at hand that computes tables, colours and spectra."""

from __future__ import annotations

import importlib.util


def library_problem() -> str:
    """Why it is not and what to do, or nothing."""
    if importlib.util.find_spec("numpy") is None:
        return (
            "This Blender's Python has no numpy, which computing colours and editing a stack need: take "
            "Blender from blender.org, or install your system's package (python3-numpy)"
        )
    try:
        import nacre  # noqa: F401
    except ImportError as error:
        return f"Needs the Python package nacre: {error}"
    return ""
