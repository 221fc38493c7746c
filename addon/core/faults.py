# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong in ways that are foreseen: operators report it and `render` ends with it."""

from __future__ import annotations


class ForeseenError(Exception):
    """One line for each thing that is wrong."""


class RecipeError(ForeseenError):
    """What a material is to be compiled from is not known, or damaged."""
