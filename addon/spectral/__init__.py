# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral rendering in bands: passes whose three channels are three wavelengths.

Nodes read what changes from pass to pass from properties of the scene or view layer, so that nothing
has to be built anew between passes. Without those properties the same nodes give RGB.
"""
