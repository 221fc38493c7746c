# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wavelengths drawn by each path: one render instead of passes, in Open Shading Language.

The three channels are X, Y and Z, each with a wavelength of its own; what nodes read of a pass where bands are
rendered they read of those three wavelengths then.
"""
